/* picture.c - see picture.h: what all kinds of scenes have in common. */
#include "app/picture.h"

#include "app/picture_stages.h"
#include "config.h"
#include "error.h"
#include "hidden/surface/horizon.h"
#include "hidden/surface/perimeter.h"
#include "num/ints.h"
#include "view/autoscale.h"
#include <string.h>

#define SMALL_ARENA ((size_t)256 * 1024)
#define LARGE_ARENA ((size_t)16 << 20)

void picture_tell(picture_t *p, enum picture_stage stage, int32_t done, int32_t of) {
    p->stage = stage;
    p->stage_done = done;
    p->stage_of = of;
    if (p->hooks && p->hooks->progress) p->hooks->progress(p->hooks->ctx, stage, done, of);
}

static size_t kernel_part(size_t arena_bytes) {
    return arena_bytes < SMALL_ARENA ? 2 : 4;
}

/* Vertices of horizons for each line of a grid: 3 for smooth surfaces (measured: 2.2), 10 for random ones (5.6 at
 * 60 x 60, 7.7 at 250 x 250). */
enum { EACH_SMOOTH = 3, EACH_ROUGH = 10 };

/* Both horizons' vertices for a point of a profile: 17 for 60 random profiles, 25 for 150, 38 for 400, 56 for 1000
 * (measured). Of a terrain it is only known that a profile has no more points than there are corners. */
static size_t profiles_bytes(const plot_t *plot, int32_t each) {
    const settings_t *s = plot->settings;
    const int32_t points = plot->kind == PLOT_SOLIDS ? plot->item[0].mesh.corners : s->samples[0];
    if (each > EACH_SMOOTH) each += 2 * (int32_t)ints_sqrt_u64((uint64_t)s->isosamples[1]);
    return horizon_bytes(each * points);
}

/* Where memory is small a scene of solids is, too, and is hidden on trial soon enough: bounds would take 0.4 KB of
 * code.
 */
#define TRIES_SOLIDS (!CONFIG_AREA)
#define TRY_IT (SIZE_MAX / 2)

/* What hiding needs with so many vertices of horizons for each line of the grid or point of a profile; 0: nothing that
 * depends on the scene. Holes, which are not known beforehand, or several surfaces take three times as much a vertex.
 */
static size_t hiding_bytes(const plot_t *plot, int32_t each, bool holes) {
    const settings_t *s = plot->settings;
    if ((!CONFIG_SOLIDS && plot->kind == PLOT_SOLIDS) || (!CONFIG_HALO && s->hidden == HIDDEN_HALO)) return 0;
    if (TRIES_SOLIDS && (picture_wants_solids(plot) || s->hidden == HIDDEN_HALO)) return TRY_IT;
    if (picture_wants_solids(plot)) return picture_solids_bytes(plot);
    if (plot->kind == PLOT_CURVES || s->hidden == HIDDEN_NONE) return 0;
    if (s->hidden == HIDDEN_HORIZON) return profiles_bytes(plot, each);
    if (s->hidden == HIDDEN_HALO) return picture_halo_bytes(plot, each);
    const surface_t *f = &plot->item[0].surface;
    size_t one = perimeter_bytes(f->nx, each * (f->nx + f->ny) * (holes || plot->n > 1 ? 3 : 1));
    return one * (size_t)plot->n;
}

static bool is_grid(const plot_t *plot) {
    const enum hidden_mode hidden = plot->settings->hidden;
    return plot->kind == PLOT_SURFACES && !picture_wants_solids(plot) && hidden != HIDDEN_NONE &&
           hidden != HIDDEN_HORIZON && hidden != HIDDEN_HALO;
}

size_t picture_rest(const picture_t *p) {
    return PATH_BYTES_MIN + 32 + (p->hooks ? WAITING_BYTES(p->hooks->waiting) + 16 : 0);
}

size_t picture_spare(const picture_t *p, size_t share) {
    const size_t left = arena_left(&p->arena), rest = picture_rest(p), spare = left > rest ? left - rest : 0;
    return spare < left / share ? spare : left / share;
}

void *picture_kernel_memory(picture_t *p, size_t *bytes) {
    const size_t left = arena_left(&p->arena), least = picture_rest(p);
    enum picture_share share = p->hooks ? p->hooks->share : PICTURE_SHARE_USUAL;
    *bytes = left / kernel_part(p->arena.bytes);
    if (p->arena.bytes >=
        LARGE_ARENA) { /* horizons grow from both ends: what lies between costs time where it is touched */
        const size_t want = hiding_bytes(p->plot, 4 * EACH_ROUGH, true), little = left / 64;
        const bool sparing = is_grid(p->plot) && !(p->hooks && p->hooks->generous);
        if (sparing && want < *bytes) *bytes = want > little ? want : little;
    }
    if (share != PICTURE_SHARE_USUAL && left > 2 * least) {
        size_t most = left - least;
        size_t want = share == PICTURE_SHARE_SMOOTH ? hiding_bytes(p->plot, EACH_SMOOTH, false) : most;
        if (want > most) want = most;
        if (want > *bytes) *bytes = want;
        p->gave_all = *bytes == most;
    }
    return arena_take(&p->arena, *bytes);
}

/* gnuplot's xyplane: how far the base lies below where the z axis begins, as a part of its range, or at a height of its
 * own. */
static void add_base_plane(const settings_t *s, bool reverse, num_t *lo, num_t *hi) {
    num_t below = num_mul(s->xyplane, num_sub(*hi, *lo));
    num_t base = s->xyplane_at ? s->xyplane : reverse ? num_add(*hi, below) : num_sub(*lo, below);
    if (num_cmp(base, *lo) < 0) *lo = base;
    if (num_cmp(base, *hi) > 0) *hi = base;
}

int picture_camera(picture_t *p, const num_t lo[3], const num_t hi[3]) {
    const settings_t *s = p->plot->settings;
    const range_t *range[3] = {&s->x, &s->y, &s->z};
    view_box_t box = {.solid = picture_is_solid(p->plot)};
    for (int k = 0; k < 3; k++) {
        box.lo[k] = lo[k];
        box.hi[k] = hi[k];
        box.reverse[k] = !box.solid && range[k]->reverse;
        if (s->view.from || box.solid) continue;
        int err = autoscale_range(range[k], autoscale_tics(s, k), &box.lo[k], &box.hi[k]);
        if (err) return err;
    }
    bool base = s->border_base || (s->tics & (SETTINGS_TICS_X | SETTINGS_TICS_Y));
    if (!s->view.from && base && !box.solid) add_base_plane(s, box.reverse[2], &box.lo[2], &box.hi[2]);
    int err = camera_setup(&p->camera, s, &box);
    if (err) return err;
    if (p->hooks && p->hooks->begin) p->hooks->begin(p->hooks->ctx, &p->camera);
    return 0;
}

static bool ink_point(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t, page_point_t *out) {
    const picture_t *p = ctx;
    return line_space_point(&p->lines[surface], family, line, t, out);
}

#if CONFIG_FETCH
static bool ink_span(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t from, int64_t to,
                     page_point_t out[2]) {
    const picture_t *p = ctx;
    return line_space_span(&p->lines[surface], family, line, from, to, out);
}
#endif

static int drop_ink(void *ctx, const ink_piece_t *piece) {
    picture_t *p = ctx;
    (void)piece;
    if (++p->pieces > p->pieces_most && p->pauses) p->pieces_most = p->pieces;
    return 0;
}

ink_sink_t picture_drop(picture_t *p) {
    return (ink_sink_t){p, drop_ink};
}

static int pause_kernel(void *ctx) {
    picture_t *p = ctx;
    p->pieces = 0;
    return p->trial ? 0 : waiting_pause(&p->waiting);
}

const hidden_pause_t *picture_pause(picture_t *p) {
    if (CONFIG_WAITING == 0 || !p->hooks || p->hooks->waiting == 0) return NULL;
    p->pauses = true;
    p->pause = (hidden_pause_t){p->trial ? &p->trial : &p->waiting.some, pause_kernel, p};
    return &p->pause;
}

#if CONFIG_TELL_ORDER
static void order_tick(void *ctx, int32_t done, int32_t of) {
    picture_tell(ctx, PICTURE_DRAW, done, of);
}
#endif

int picture_open(picture_t *p, const pen_sink_t *pen, int32_t growing, int64_t runs) {
    const machine_t *machine = &p->plot->settings->machine;
    uint32_t coarse = machine->steps_per_mm_q16[0] < machine->steps_per_mm_q16[1] ? machine->steps_per_mm_q16[0]
                                                                                  : machine->steps_per_mm_q16[1];
    path_config_t config;
    path_default(&config, coarse);
    config.lines = growing;
#if CONFIG_TELL_ORDER
    config.tell = order_tick;
    config.tell_ctx = p;
#endif
#if CONFIG_FETCH
    config.fetch = p->fetch;
    config.span = ink_span;
#endif
    if (p->hooks && !p->trial) config.feed = p->hooks->feed;
    if (p->pauses) {
        const int32_t cap = p->hooks->waiting;
        p->waiting = (waiting_t){.run = arena_take(&p->arena, WAITING_BYTES(cap)), .cap = cap};
        if (!p->waiting.run) return ERR_FULL;
    }
    size_t bytes = arena_left(&p->arena) - 15;
    if (runs < (int64_t)(bytes / PATH_BYTES_PER_RUN)) {
        size_t enough = PATH_BYTES((size_t)runs + POOL_RUNS_MIN, (size_t)growing * 2) * 8 / 7;
        if (enough < bytes) bytes = enough;
    }
    p->map_ink = (ink_map_t){p, ink_point};
    void *mem = arena_take(&p->arena, bytes);
    if (!mem) return ERR_FULL;
    int err = path_init(&p->path, mem, bytes, &config, &p->map_ink, pen);
    if (err) return err;

    bool inside = true;
    for (int32_t k = 0; k < p->spaces; k++) inside = inside && p->lines[k].all_inside;
    p->cut = (cut_t){p->lines, p->trial ? picture_drop(p) : path_sink(&p->path)};
#if CONFIG_AREA
    if (p->pens.now) p->cut.next = pens_ink(&p->pens, p->cut.next);
#endif
    p->sink = inside || p->trial ? p->cut.next : cut_sink(&p->cut);
    if (p->pauses && !p->trial) {
        p->waiting.next = p->sink;
        p->sink = waiting_sink(&p->waiting);
    }
    picture_tell(p, PICTURE_HIDE, 0, 1);
    return 0;
}

void picture_hidden(picture_t *p, int32_t done, int32_t of, int32_t facets) {
    picture_tell(p, PICTURE_HIDE, done, of);
    if (!p->trial) path_advance(&p->path, facets * CONFIG_FACET_US);
}

int picture_close(picture_t *p) {
    picture_tell(p, PICTURE_DRAW, 0, 1);
    if (p->trial) return 0;
    int err = p->pauses ? waiting_pause(&p->waiting) : 0;
    if (!err) err = path_finish(&p->path, &p->stats.path);
    p->stats.path_bytes = p->stats.path.bytes;
    return err;
}

static int run(picture_t *p, const pen_sink_t *pen) {
    const plot_t *plot = p->plot;
    picture_tell(p, PICTURE_MEASURE, 0, 1);
    int err;
    if (plot->kind == PLOT_CURVES)
        err = picture_curves(p, pen);
    else if (picture_wants_solids(plot))
        err = CONFIG_SOLIDS ? picture_solids(p, pen) : ERR_UNSUPPORTED;
    else if (plot->settings->hidden == HIDDEN_HORIZON)
        err = picture_profiles(p, pen);
    else
        err = picture_surfaces(p, pen);
    picture_tell(p, PICTURE_DONE, 1, 1);
    return err;
}

#if CONFIG_AREA
/* One pass of several. */
static int run_pen(picture_t *p, int pen_number, const pen_sink_t *pen) {
    const uint8_t *pen_of = p->plot->settings->pen;
    p->pens = (pens_t){.now = (uint8_t)pen_number};
    if (p->hooks) p->pens.announce = p->hooks->pen, p->pens.ctx = p->hooks->ctx;
    memset(p->pens.of_space, pen_of[LINE_CREASE], sizeof p->pens.of_space);
    if (picture_wants_solids(p->plot)) memcpy(p->pens.of_space, pen_of, LINE_CLASSES);
    const pen_sink_t sink = pens_sink(&p->pens, pen);
    return run(p, &sink);
}

static int run_pens(picture_t *p, const pen_sink_t *pen) {
    const plot_t *plot = p->plot;
    const picture_hooks_t *hooks = p->hooks;
    const arena_t arena = p->arena;
    const uint32_t wanted = pens_wanted(p->plot);
    picture_stats_t stats = {0};
    int err = 0;
    for (int n = 1; n <= PENS_MAX && !err; n++) {
        if (!(wanted >> n & 1)) continue;
        if (wanted == 1u << n) { /* the usual case */
            if (p->hooks && p->hooks->pen) err = p->hooks->pen(p->hooks->ctx, n);
            return err ? err : run(p, pen);
        }
        *p = (picture_t){.plot = plot, .hooks = hooks, .arena = arena};
        err = run_pen(p, n, pen);
        pens_add(&stats, &p->stats);
    }
    p->stats = stats;
    return err;
}
#else
static int run_pens(picture_t *p, const pen_sink_t *pen) {
    return run(p, pen);
}
#endif

/* Leaves what is known of the first surface. */
static void start(picture_t *p, const plot_t *plot, void *mem, size_t bytes, const picture_hooks_t *hooks) {
    const bool measured = hooks && hooks->measured && is_grid(plot);
    const size_t from = offsetof(picture_t, grid), to = from + (measured ? sizeof p->grid[0] : 0);
    memset(p, 0, from);
    memset((char *)p + to, 0, sizeof *p - to);
    p->plot = plot;
    p->hooks = hooks;
    p->arena = (arena_t){mem, bytes, 0};
}

int picture_draw(picture_t *p, const plot_t *plot, void *mem, size_t bytes, const pen_sink_t *pen,
                 const picture_hooks_t *hooks) {
    start(p, plot, mem, bytes, hooks);
    return run_pens(p, pen);
}

int picture_try(picture_t *p, const plot_t *plot, void *mem, size_t bytes, const picture_hooks_t *hooks) {
    start(p, plot, mem, bytes, hooks);
    p->trial = true;
    return run(p, NULL);
}

int picture_measure(picture_t *p, const plot_t *plot, void *mem, size_t bytes, picture_hooks_t *hooks) {
    hooks->only_measure = true;
    int err = picture_try(p, plot, mem, bytes, hooks);
    hooks->only_measure = false;
    hooks->measured = !err;
    return !err && p->grid[0].holes > 0 ? ERR_FULL : err;
}

bool picture_pauses(const plot_t *plot) {
    const enum hidden_mode hidden = plot->settings->hidden;
    if (plot->kind == PLOT_CURVES || hidden == HIDDEN_NONE || hidden == HIDDEN_HALO) return false;
    return hidden == HIDDEN_HORIZON || !picture_wants_solids(plot);
}

bool picture_is_safe(const plot_t *plot, size_t bytes) {
    return hiding_bytes(plot, EACH_ROUGH, true) <= bytes / kernel_part(bytes);
}

bool picture_is_safe_whole(const plot_t *plot, size_t bytes) {
    return is_grid(plot) && plot->n == 1 && hiding_bytes(plot, EACH_ROUGH, false) <= bytes / kernel_part(bytes);
}

size_t picture_needs(const picture_t *p) {
    const plot_t *plot = p->plot;
    const enum hidden_mode hidden = plot->settings->hidden;
    const size_t rest = picture_rest(p);
    const bool boxes = CONFIG_SOLIDS && plot->kind == PLOT_SOLIDS && hidden != HIDDEN_HORIZON &&
                       (CONFIG_AREA || hidden != HIDDEN_AREA);
    if (p->stats.hidden.needs) return p->stats.hidden.needs + rest;
    if (boxes) return picture_solids_needs(p);
    return hiding_bytes(plot, EACH_ROUGH, false) + rest;
}

picture_progress_t picture_progress(const picture_t *p) {
    const path_t *path = &p->path;
    picture_progress_t g = {.vertices_drawn = path->stats.vertices, .strokes_drawn = path->stats.strokes};
    int64_t left = path->drawing ? path->drawing - path->drawn : path->pool.n;
    g.vertices = path->vertices;
    g.strokes = g.strokes_drawn + left;
    if (p->stage == PICTURE_HIDE && p->stage_done > 0) {
        g.vertices = g.vertices * p->stage_of / p->stage_done;
        g.strokes = g.strokes * p->stage_of / p->stage_done;
    }
    if (g.vertices < g.vertices_drawn) g.vertices = g.vertices_drawn;
    return g;
}

size_t picture_bytes(const plot_t *plot) {
    const size_t LEAST = (size_t)1 << 22, MOST = (size_t)1 << 30;
    size_t points = 0;
    for (int32_t k = 0; k < plot->n; k++) {
        const plot_item_t *item = &plot->item[k];
        if (plot->kind == PLOT_SURFACES) points += (size_t)item->surface.nx * (size_t)item->surface.ny;
        if (plot->kind == PLOT_CURVES) points += (size_t)item->curve.n;
    }
    if (picture_wants_solids(plot)) points += hiding_bytes(plot, EACH_ROUGH, true) / sizeof(int32_t);
    if (plot->settings->hidden == HIDDEN_HORIZON)
        points += (size_t)plot->settings->samples[0] * (size_t)plot->settings->isosamples[1];
    /* A run a point covers all but the roughest surfaces; a quarter of the rest goes to the kernel. */
    size_t bytes = LEAST + points * (sizeof(int32_t) + PATH_BYTES_PER_RUN) * 3 / 2;
    return bytes > MOST ? MOST : bytes;
}
