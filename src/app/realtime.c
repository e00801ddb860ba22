/* realtime.c - see realtime.h. */
#include "app/realtime.h"

#include "app/line_edit.h"
#include "app/say.h"
#include "hal/hal.h"
#include "said.h"

enum { CTRL_X = 24 };

#define HIGH_WATER (CONFIG_TYPED / 2)
#define LOW_WATER (CONFIG_TYPED / 4)
#define SHORT_WAY_US 100000 /* with the pen up, from a stroke to the next */

void realtime_init(realtime_t *r, carriage_t *carriage) {
    *r = (realtime_t){.carriage = carriage, .line_start = true};
}

static uint16_t waiting(const realtime_t *r) {
    return (uint16_t)(r->head - r->tail);
}

static void flow(realtime_t *r) {
    bool off = r->busy || waiting(r) > (r->off ? LOW_WATER : HIGH_WATER);
    if (off == r->off) return;
    r->off = off;
    hal_console_hold(off);
}

void realtime_busy(realtime_t *r, bool busy) {
    r->busy = busy;
    flow(r);
}

int realtime_read(realtime_t *r) {
    if (r->head == r->tail) return -1;
    int byte = r->ring[r->tail++ % CONFIG_TYPED];
    flow(r);
    return byte;
}

static void keep(realtime_t *r, uint8_t byte) {
    if (waiting(r) + r->lost >= CONFIG_TYPED) {
        r->lost = true;
        return;
    }
    if (r->lost) r->ring[r->head++ % CONFIG_TYPED] = LINE_EDIT_LOST;
    r->lost = false;
    r->ring[r->head++ % CONFIG_TYPED] = byte;
    if (waiting(r) > r->most) r->most = waiting(r);
}

/* mm with three decimals, always: a program may read it. */
static void add_mm(text_t *t, int32_t lat) {
    int64_t um = ((int64_t)lat * 1000 + LAT_PER_MM / 2) >> LAT_PER_MM_BITS;
    if (um < 0) text_add(t, "-");
    uint32_t mag = (uint32_t)(um < 0 ? -um : um), part = mag % 1000;
    text_add_int(t, mag / 1000);
    text_add(t, part < 10 ? ".00" : part < 100 ? ".0" : ".");
    text_add_int(t, part);
}

/* The time still to come: strokes not yet drawn cost what the pen and a short way take, and vertices what they have
 * cost so far, in ticks. Negative: cannot be told. */
static int64_t ticks_left(const realtime_t *r, int64_t used) {
    const machine_t *m = r->carriage->machine;
    const picture_progress_t g = picture_progress(r->picture);
    const int64_t lift = (int64_t)(m->lift_us + m->lower_us + SHORT_WAY_US) * (HAL_TICK_HZ / 1000000);
    if (g.vertices_drawn == 0) return -1;
    int64_t drawing = used - g.strokes_drawn * lift;
    if (drawing < 0) drawing = 0;
    int64_t per_vertex = drawing / g.vertices_drawn;
    return (g.vertices - g.vertices_drawn) * per_vertex + (g.strokes - g.strokes_drawn) * lift;
}

static void add_progress(const realtime_t *r, text_t *t) {
    int64_t used = r->carriage->motion.tracer.clock_q16 >> 16; /* planned so far */
    int64_t left = ticks_left(r, used);
    text_add(t, "|Done:");
    text_add_int(t, left < 0 || used + left == 0 ? 0 : used * 100 / (used + left));
    text_add(t, "%|Left:");
    if (left < 0) {
        text_add(t, "?");
    } else {
        text_add_int(t, (left + HAL_TICK_HZ - 1) / HAL_TICK_HZ);
        text_add(t, "s");
    }
}

void realtime_status(const realtime_t *r, text_t *t) {
    static const char *const STATE[] = {[CARRIAGE_IDLE] = "Idle",
                                        [CARRIAGE_RUN] = "Run",
                                        [CARRIAGE_HOLD] = "Hold",
                                        [CARRIAGE_HOME] = "Home",
                                        [CARRIAGE_ALARM] = "Alarm"};
    const carriage_t *c = r->carriage;
    page_point_t at = carriage_place(c);
    text_add(t, "<");
    text_add(t, STATE[carriage_state(c)]);
    text_add(t, "|MPos:");
    add_mm(t, at.x_lat);
    text_add(t, ",");
    add_mm(t, at.y_lat);
    text_add(t, carriage_pen_is_down(c) ? "|Pen:down" : "|Pen:up");
    if (r->picture) add_progress(r, t);
    text_add(t, ">");
}

static void answer_status(const realtime_t *r) {
    char line[REALTIME_STATUS_MAX];
    text_t t = text_start(line, sizeof line - 1);
    realtime_status(r, &t);
    t.size++; /* kept back for the line feed */
    text_add(&t, "\n");
    say_line(line);
}

static bool obey(realtime_t *r, uint8_t byte) {
    if (byte == CTRL_X) {
        carriage_stop(r->carriage);
        r->tail = r->head;
        r->lost = false;
        r->line_start = true;
        r->cancelled = true;
        return true;
    }
    if (!r->line_start || r->data) return false;
    if (byte == '?')
        answer_status(r);
    else if (byte == '!')
        carriage_hold(r->carriage);
    else if (byte == '~')
        carriage_resume(r->carriage);
    else
        return false;
    return true;
}

static void tell_alarm(realtime_t *r) {
    static const char *const WHY[] = {
        [CARRIAGE_NO_ALARM] = "",
        [CARRIAGE_LIMIT] = SAID("a limit switch closed"),
        [CARRIAGE_ESTOP] = SAID("emergency stop, motors off"),
        [CARRIAGE_NO_SWITCH] = SAID("homing found no limit switch, or one that stays closed"),
        [CARRIAGE_BROKEN_OFF] = SAID("homing was stopped"),
    };
    enum carriage_alarm alarm = carriage_alarm(r->carriage);
    if (alarm == (enum carriage_alarm)r->alarm_said) return;
    r->alarm_said = (uint8_t)alarm;
    if (!alarm) return;
    say("\nALARM: ");
    say(WHY[alarm]);
    say("; position unknown: home, or put the pen to its origin and unlock\n");
}

void realtime_poll(realtime_t *r) {
    if (!hal_stack_ok()) hal_fault("the stack has run over", 0, 0);
    hal_watchdog_feed();
    for (int c; (c = hal_console_read()) >= 0;) {
        uint8_t byte = (uint8_t)c;
        if (obey(r, byte)) continue;
        keep(r, byte);
        r->line_start = byte == '\r' || byte == '\n';
    }
    if (hal_console_errors()) r->lost = true;
    flow(r);
    tell_alarm(r);
}
