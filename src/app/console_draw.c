/* console_draw.c - from a plot command to the machine. Nothing moves before it is known that the drawing fits, into the
 * memory and onto the machine. */
#include "app/console_parts.h"
#include "app/say.h"
#include "error.h"
#include "hal/hal.h"
#include "hidden/surface/horizon.h"

static void on_progress(void *ctx, enum picture_stage stage, int32_t done, int32_t of) {
    console_t *c = ctx;
    (void)stage, (void)done, (void)of;
    realtime_poll(&c->realtime);
}

static void say_int(int64_t v) {
    char buf[24];
    text_t t = text_start(buf, sizeof buf);
    text_add_int(&t, v);
    say_line(buf);
}

/* A drawing may reach all of the paper but its margin. */
static bool fits_machine(const settings_t *s) {
    const machine_t *m = &s->machine;
    int32_t x_um = s->paper.width_um - s->paper.margin_um, y_um = s->paper.height_um - s->paper.margin_um;
    return (!m->width_um || x_um <= m->width_um) && (!m->height_um || y_um <= m->height_um);
}

/* Horizons grow with the points of a profile: fewer are tried until they fit, and half of those. */
static size_t measure_profiles(console_t *c, const plot_t *plot, void *memory, picture_hooks_t *hooks) {
    int32_t *samples = &c->session.settings.samples[0]; /* the plot's */
    const int32_t all = *samples;
    const hidden_stats_t *found = &c->picture.stats.hidden;
    int64_t peak = 0, more = 10 * all;
    int err = ERR_FULL;
    while (err == ERR_FULL && (*samples /= 2) > 8)
        err = picture_try(&c->picture, plot, memory, c->picture_bytes, hooks);
    if (!err) {
        const int32_t fit = *samples;
        peak = found->peak_upper + found->peak_lower;
        *samples /= 2;
        picture_try(&c->picture, plot, memory, c->picture_bytes, hooks);
        more = (peak - found->peak_upper - found->peak_lower) * (all - fit) / (fit - *samples);
    }
    *samples = all;
    return horizon_bytes((int32_t)(peak + more)) + picture_rest(&c->picture);
}

/* After a trial that did not get through. */
static int too_large(console_t *c, const plot_t *plot, void *memory, picture_hooks_t *hooks) {
    const picture_stats_t *stats = &c->picture.stats;
    const hidden_stats_t *found = &stats->hidden;
    const enum hidden_mode hidden = plot->settings->hidden;
    size_t needs;
    say("The scene does not fit: ");
    if (CONFIG_HALO && hidden == HIDDEN_HALO && found->edges > 0) { /* both are counted to the end, if begun */
        say_int(found->edges);
        say(" lines");
        if (found->crossings > 0) {
            say(" with ");
            say_int(found->crossings);
            say(" crossings");
        }
        const size_t solids =
            plot->kind == PLOT_SOLIDS ? stats->map_bytes : 0; /* of surfaces they can be done without */
        needs = stats->kernel_bytes + solids + picture_rest(&c->picture);
    } else {
        say("it");
        needs = hidden == HIDDEN_HORIZON && plot->kind == PLOT_SURFACES ? measure_profiles(c, plot, memory, hooks)
                                                                        : picture_needs(&c->picture);
    }
    if (needs <= c->picture_bytes) needs = c->picture_bytes + c->picture_bytes / 16; /* it was not enough */
    say(" may need ");
    say_int((int64_t)needs);
    say(" bytes of memory, ");
    say_int((int64_t)c->picture_bytes);
    say(" are free. Nothing was drawn.\n");
    return ERR_FULL;
}

/* The first division of the memory that the scene gets through with. */
static int find_share(console_t *c, const plot_t *plot, void *memory, picture_hooks_t *hooks) {
    if (picture_pauses(plot)) hooks->waiting = CONFIG_WAITING;
    if (hooks->waiting == 0 && picture_is_safe(plot, c->picture_bytes)) return 0;
    if (CONFIG_WAITING == 0 && picture_is_safe_whole(plot, c->picture_bytes)) {
        int err = picture_measure(&c->picture, plot, memory, c->picture_bytes, hooks);
        if (c->realtime.cancelled) return ERR_STOPPED;
        if (err != ERR_FULL) return err;
    }
    for (int share = 0; share < PICTURE_SHARES;) {
        hooks->share = (enum picture_share)share;
        int err = picture_try(&c->picture, plot, memory, c->picture_bytes, hooks);
        if (c->realtime.cancelled) return ERR_STOPPED;
        hooks->measured = true;
        hooks->strips = c->picture.strips.ends;
        if (!err && c->picture.pieces_most > hooks->waiting)
            hooks->waiting = c->picture.pieces_most; /* once more, to see whether they have room */
        else if (err != ERR_FULL)
            return err;
        else
            share += share < PICTURE_SHARE_HIDING && c->picture.gave_all ? PICTURE_SHARE_STRIPS - share : 1;
    }
    return too_large(c, plot, memory, hooks);
}

#if CONFIG_AREA
/* One holder for all pens: drawing goes on when the right one is in it. */
static int on_pen(void *ctx, int number) {
    console_t *c = ctx;
    if (number == c->other_pen + 1) return 0;
    say("Pen ");
    say_int(number);
    say(": put it in, then ~\n");
    realtime_busy(&c->realtime, false);
    int err = carriage_change(&c->carriage);
    realtime_busy(&c->realtime, true);
    if (!err) c->other_pen = (uint8_t)(number - 1);
    return err;
}
#endif

/* What path_feed_t has to know of the machine. */
static path_feed_t feed_of(console_t *c, const machine_t *m) {
    const int32_t lat_per_ms = (int32_t)(((int64_t)m->draw_speed_um_s * LAT_PER_MM / 1000 + 999) / 1000);
    return (path_feed_t){&c->carriage,   carriage_ready, carriage_rest,
                         CONFIG_OUTBOX,  lat_per_ms,     (int32_t)(m->lift_us + m->lower_us),
                         CONFIG_ORDER_US};
}

static int draw(console_t *c, const plot_t *plot) {
    const path_feed_t feed = feed_of(c, &plot->settings->machine);
    picture_hooks_t hooks = {.ctx = c, .progress = on_progress, .feed = &feed};
#if CONFIG_AREA
    hooks.pen = on_pen;
#endif
    void *memory = console_free_memory(c, &c->picture_bytes);
    int err = find_share(c, plot, memory, &hooks);
    if (err) return err;
    err = carriage_begin(&c->carriage, &plot->settings->machine);
    if (err == ERR_MACHINE && carriage_closed(&plot->settings->machine))
        say("A limit switch or the emergency stop is closed.\n");
    if (err) return err;
    pen_sink_t pen = carriage_pen(&c->carriage);
    c->realtime.picture = &c->picture;
    err = picture_draw(&c->picture, plot, memory, c->picture_bytes, &pen, &hooks);
    if (err == ERR_FULL && c->picture.path.stats.strokes > 0)
        say("The memory ran out: a part was drawn.\n");
    else if (err == ERR_FULL)
        too_large(c, plot, memory, &hooks);
    err = carriage_end(&c->carriage, err, &c->stats);
    c->realtime.picture = NULL;
    return err;
}

int console_draw(console_t *c, const plot_t *plot) {
    if (carriage_alarm(&c->carriage)) {
        say("Locked: the position is unknown. home, or put the pen to its origin and unlock.\n");
        return ERR_MACHINE;
    }
    if (!fits_machine(plot->settings)) {
        say("The paper reaches beyond the machine: set paper, or set machine size. Nothing was drawn.\n");
        return ERR_MACHINE;
    }
    bool data = c->realtime.data;
    c->realtime.data = false;
    c->realtime.cancelled = false;
    realtime_busy(&c->realtime, true);
    int err = draw(c, plot);
    realtime_busy(&c->realtime, false);
    c->realtime.cancelled = false;
    c->realtime.data = data;
    return err;
}
