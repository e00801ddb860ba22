/* trace_judge.c - is a trace legal for a machine? Edges first (widths, set-up, settling), then the motion behind them.
 *
 * Speeds and accelerations are differences of the position over TRACE_WINDOW_S. Differences of single intervals would
 * be sharper, but say nothing about a plotter whose generator rounds steps to a common clock, and the judge has to take
 * traces of any origin: one step of jitter is 4 / window^2 = 10^4 steps/s^2, 125 mm/s^2 at 80 steps/mm. */
#include "error.h"
#include "hal/hal.h"
#include "host/trace_place.h"
#include <math.h>

#define STRIDES 4            /* samples per window */
#define PAUSE_PS 50000000000 /* a longer interval is a stop, not a speed */

typedef struct axis { /* one motor's edges so far */
    int64_t pos;
    uint64_t rise_ps, dir_ps;
    bool rose, turned; /* the times above are valid; turned: DIR changed and no pulse came since */
    bool has_interval, forward;
    double speed_mm_s;
    double mm; /* per step */
} axis_t;

static const uint8_t STEP[2] = {HAL_X_STEP, HAL_Y_STEP}, DIR[2] = {HAL_X_DIR, HAL_Y_DIR};

static void lower_to(uint64_t *least, uint64_t value) {
    if (*least == 0 || value < *least) *least = value;
}

/* The beginning of a pulse at `now`. */
static void step(axis_t *a, trace_axis_judgement_t *j, trace_judgement_t *all, const machine_t *m, uint64_t now,
                 bool forward) {
    j->steps++;
    a->pos += forward ? 1 : -1;
    if (a->pos < j->min_steps) j->min_steps = a->pos;
    if (a->pos > j->max_steps) j->max_steps = a->pos;
    if (a->turned) {
        uint64_t setup = now - a->dir_ps;
        lower_to(&j->min_setup_ps, setup ? setup : 1);
        if (setup + TRACE_GRACE_PS < (uint64_t)m->dir_setup_ns * 1000) all->short_setups++;
    }
    if (a->rose) {
        uint64_t interval = now - a->rise_ps;
        lower_to(&j->min_interval_ps, interval ? interval : 1);
        double speed = a->mm / ((double)(interval ? interval : 1) * 1e-12);
        bool goes_on = forward == a->forward && interval < PAUSE_PS;
        double jump = fabs(speed - a->speed_mm_s);
        if (goes_on && a->has_interval && jump > j->max_jump_mm_s) j->max_jump_mm_s = jump;
        a->has_interval = goes_on;
        a->speed_mm_s = speed;
    }
    a->forward = forward;
    a->rise_ps = now;
    a->rose = true;
    a->turned = false;
}

static void fall(axis_t *a, trace_axis_judgement_t *j, trace_judgement_t *all, const machine_t *m, uint64_t now) {
    if (!a->rose) return;
    uint64_t width = now - a->rise_ps;
    lower_to(&j->min_pulse_ps, width ? width : 1);
    if (width > j->max_pulse_ps) j->max_pulse_ps = width;
    if (width + TRACE_GRACE_PS < (uint64_t)m->pulse_ns * 1000) all->short_pulses++;
}

static double accel_mm_s2(const machine_t *m) {
    return m->accel_um_s2 * 1e-3;
}

#define STOP_LEAST_S 0.02 /* shorter delays, or those of a few slow steps, are not told from motion */

/* Is this as long as a stop for the pen: the delay, and half a step from and to rest? */
static bool is_pen_stop(const machine_t *m, uint32_t delay_us, uint64_t stood_ps) {
    double coarsest = 65536.0 / fmin(m->steps_per_mm_q16[0], m->steps_per_mm_q16[1]);
    double slowest = fmin(m->draw_speed_um_s, m->travel_speed_um_s) * 1e-3;
    double rest = sqrt(coarsest / accel_mm_s2(m)), delay = delay_us * 1e-6, stood = (double)stood_ps * 1e-12;
    if (delay < STOP_LEAST_S || delay < 8 * fmax(rest, coarsest / slowest)) return false;
    return stood >= delay && stood <= delay + 3 * rest;
}

/* The stops of the machine since the pen changed last, as far as they are as long as one for the pen. A change that is
 * missing leaves two, since the next one changes nothing either; one alone may be a hold. */
typedef struct stops {
    int count;
    uint64_t first_ps;
} stops_t;

static void judge_stop(stops_t *s, trace_judgement_t *all, const machine_t *m, bool down, uint64_t last, uint64_t now) {
    uint32_t delay_us = down == (s->count == 0) ? m->lift_us : m->lower_us;
    if (!is_pen_stop(m, delay_us, now - last)) return;
    if (s->count++ == 0) {
        s->first_ps = last;
        return;
    }
    if (!all->unchanged++) all->unchanged_at_s = (double)s->first_ps * 1e-12;
    s->count = 0;
}

/* Edges; fills in the knots of both motors. */
static int judge_edges(const trace_t *t, const machine_t *m, trace_judgement_t *out, trace_knots_t knots[2]) {
    axis_t axis[2] = {0};
    for (int i = 0; i < 2; i++) axis[i].mm = 65536.0 / m->steps_per_mm_q16[i];
    uint64_t pen_ps = 0, down_ps = 0, grace = TRACE_GRACE_PS, last_ps = 0; /* last_ps: of any step; 0: none */
    stops_t stops = {0};
    bool pen_moved = false, first_step = false;
    uint8_t pins = t->initial;
    for (size_t i = 0; i < t->count; i++) {
        const trace_event_t *e = &t->events[i];
        uint64_t now = e->time_ps;
        for (int k = 0; k < 2; k++) {
            bool high = pins & STEP[k];
            if ((e->changed & DIR[k]) && high && !(e->changed & STEP[k])) out->turned_high++;
            if (e->changed & DIR[k]) {
                axis[k].dir_ps = now;
                axis[k].turned = true;
            }
            if (!(e->changed & STEP[k])) continue;
            if (high) {
                fall(&axis[k], &out->axis[k], out, m, now);
                continue;
            }
            bool forward = e->pins & DIR[k];
            if (last_ps && pen_ps < last_ps && t->has_pen) judge_stop(&stops, out, m, pins & HAL_PEN, last_ps, now);
            last_ps = now;
            step(&axis[k], &out->axis[k], out, m, now, forward);
            if (!trace_knots_add(&knots[k], (double)now * 1e-12, (double)axis[k].pos + (forward ? -0.5 : 0.5)))
                return ERR_FULL;
            if (t->has_enable && !(pins & HAL_ENABLE)) out->disabled++;
            if (!pen_moved) continue;
            bool down = pins & HAL_PEN;
            uint64_t wait = (uint64_t)(down ? m->lower_us : m->lift_us) * 1000000;
            if (now - pen_ps + grace < wait) out->unsettled++;
            double settled = (double)(now - pen_ps) * 1e-12, *least = down ? &out->settle_lower_s : &out->settle_lift_s;
            if (first_step && (*least == 0 || settled < *least)) *least = settled;
            first_step = false;
        }
        if (e->changed & HAL_PEN) {
            if (e->pins & HAL_PEN)
                out->lifts++;
            else
                down_ps += now - pen_ps;
            pen_ps = now;
            stops.count = 0;
            pen_moved = first_step = true;
        }
        pins = e->pins;
    }
    for (int k = 0; k < 2; k++) out->axis[k].end_steps = axis[k].pos;
    if (t->count) out->duration_s = (double)(t->events[t->count - 1].time_ps - t->events[0].time_ps) * 1e-12;
    out->down_s = (double)down_ps * 1e-12;
    out->ends_up = !(pins & HAL_PEN);
    out->ends_disabled = !(pins & HAL_ENABLE);
    out->ends_home = axis[0].pos == 0 && axis[1].pos == 0;
    return 0;
}

/* Times at which the pen changes, read along with the samples. */
typedef struct pen_reader {
    const trace_t *t;
    size_t next;
    bool down;
} pen_reader_t;

static bool pen_down(pen_reader_t *p, double time_s) {
    while (p->next < p->t->count && (double)p->t->events[p->next].time_ps * 1e-12 <= time_s)
        p->down = p->t->events[p->next++].pins & HAL_PEN;
    return p->down;
}

/* Time of the next step of either motor; infinity after the last. */
static double next_knot(const trace_knots_t knots[2], const size_t cursor[2]) {
    double next = INFINITY;
    for (int k = 0; k < 2; k++)
        if (cursor[k] < knots[k].count) next = fmin(next, knots[k].time_s[cursor[k]]);
    return next;
}

static void judge_motion(const trace_t *t, const machine_t *m, trace_judgement_t *out, const trace_knots_t knots[2]) {
    const double stride = TRACE_WINDOW_S / STRIDES;
    double history[2 * STRIDES + 1][2] = {{0}};
    size_t cursor[2] = {0, 0};
    pen_reader_t begin = {.t = t, .down = t->initial & HAL_PEN}, end = begin; /* of the speed's window */
    double time = -INFINITY;
    for (;;) {
        double next = next_knot(knots, cursor), motor[2];
        bool jump = next > time + 4 * TRACE_WINDOW_S; /* a pause, however long, is the same as a short one */
        if (jump && isinf(next)) return;
        time = jump ? next - 2 * TRACE_WINDOW_S : time + stride;
        for (int k = 0; k < 2; k++) motor[k] = trace_knots_at(&knots[k], &cursor[k], time);
        for (int h = 0; h < 2 * STRIDES; h++)
            for (int k = 0; k < 2; k++) history[h][k] = history[h + 1][k];
        for (int h = jump ? 0 : 2 * STRIDES; h <= 2 * STRIDES; h++) trace_path_page(m, motor, history[h]);
        const double *p0 = history[0], *p1 = history[STRIDES], *p2 = history[2 * STRIDES];
        const double *a = history[STRIDES / 2], *b = history[STRIDES / 2 + STRIDES];
        double speed = hypot(b[0] - a[0], b[1] - a[1]) / TRACE_WINDOW_S;
        double accel = hypot(p0[0] - 2 * p1[0] + p2[0], p0[1] - 2 * p1[1] + p2[1]) / (TRACE_WINDOW_S * TRACE_WINDOW_S);
        double middle = time - TRACE_WINDOW_S;
        bool down = pen_down(&begin, middle - TRACE_WINDOW_S / 2),
             still = pen_down(&end, middle + TRACE_WINDOW_S / 2) == down;
        double *fastest = down ? &out->max_speed_down : &out->max_speed_up;
        if (still && speed > *fastest) *fastest = speed;
        if (accel > out->max_accel) {
            out->max_accel = accel;
            out->max_accel_at_s = middle;
        }
    }
}

/* Length of the path through the knots of both motors. */
static void judge_lengths(const trace_t *t, const machine_t *m, trace_judgement_t *out, const trace_knots_t knots[2]) {
    size_t next[2] = {0, 0}, cursor[2] = {0, 0};
    pen_reader_t pen = {.t = t, .down = t->initial & HAL_PEN};
    double last[2] = {0, 0};
    for (bool first = true;; first = false) {
        int k = next[0] == knots[0].count ? 1 : 0;
        if (next[k] == knots[k].count) return;
        if (k == 0 && next[1] < knots[1].count && knots[1].time_s[next[1]] < knots[0].time_s[next[0]]) k = 1;
        double time = knots[k].time_s[next[k]++], motor[2], page[2];
        for (int i = 0; i < 2; i++) motor[i] = trace_knots_at(&knots[i], &cursor[i], time);
        trace_path_page(m, motor, page);
        double length = first ? 0 : hypot(page[0] - last[0], page[1] - last[1]);
        *(pen_down(&pen, time) ? &out->down_mm : &out->up_mm) += length;
        last[0] = page[0];
        last[1] = page[1];
    }
}

/* The change of velocity that the junction deviation d allows at one vertex: 2 v sin(t/2) with v^2 = a d s/(1-s),
 * s = cos(t/2), is below 2 sqrt(2 a d) whatever the turn t. */
static double vertex_jump(const machine_t *m) {
    double speed = fmax(m->draw_speed_um_s, m->travel_speed_um_s) * 1e-3;
    return fmin(2 * sqrt(2 * accel_mm_s2(m) * m->junction_um * 1e-3), 2 * speed);
}

/* Along and across the path at once, and at one vertex. */
static double accel_limit(const machine_t *m) {
    return accel_mm_s2(m) * sqrt(2) + vertex_jump(m) / TRACE_WINDOW_S;
}

static void judge_places(const machine_t *m, trace_judgement_t *out, const trace_knots_t knots[2]) {
    for (int k = 0; k < 2; k++) {
        trace_axis_judgement_t *a = &out->axis[k];
        trace_place_t p = trace_place(&knots[k], 65536.0 / m->steps_per_mm_q16[k], accel_mm_s2(m), vertex_jump(m));
        a->misplaced = p.count;
        a->misplaced_at_s = p.at_s;
        a->misplaced_s = p.off_s;
    }
}

bool trace_is_legal(const trace_judgement_t *j) {
    return j->accel_ok && j->speed_ok && j->ends_home && j->ends_up && j->ends_disabled && !j->axis[0].misplaced &&
           !j->axis[1].misplaced && !j->unchanged && !j->unsettled && !j->disabled && !j->short_pulses &&
           !j->short_setups && !j->turned_high;
}

int trace_judge(const trace_t *t, const machine_t *m, trace_judgement_t *out) {
    *out = (trace_judgement_t){.has_pen = t->has_pen, .has_enable = t->has_enable};
    trace_knots_t knots[2] = {{0}, {0}};
    int e = judge_edges(t, m, out, knots);
    if (!e) {
        judge_motion(t, m, out, knots);
        judge_lengths(t, m, out, knots);
        judge_places(m, out, knots);
    }
    trace_knots_free(&knots[0]);
    trace_knots_free(&knots[1]);
    if (e) return e;

    double coarsest = 65536.0 / fmin(m->steps_per_mm_q16[0], m->steps_per_mm_q16[1]);
    double jitter = coarsest / TRACE_WINDOW_S;
    out->accel_limit = accel_limit(m);
    out->accel_ok = out->max_accel <= out->accel_limit + 4 * jitter / TRACE_WINDOW_S;
    out->speed_ok = out->max_speed_down <= m->draw_speed_um_s * 1e-3 * TRACE_SPEED_FACTOR + jitter &&
                    out->max_speed_up <= m->travel_speed_um_s * 1e-3 * TRACE_SPEED_FACTOR + jitter;
    out->legal = trace_is_legal(out);
    return 0;
}

static void finding(FILE *f, bool ok, const char *what) {
    fprintf(f, "%s%s", ok ? "  " : "! ", what);
}

void trace_print(const trace_judgement_t *j, const machine_t *m, FILE *f) {
    finding(f, true, "time            ");
    fprintf(f, "%.6f s, %.6f s with the pen down, %lu lifts\n", j->duration_s, j->down_s, j->lifts);
    finding(f, true, "length          ");
    fprintf(f, "%.2f mm pen down, %.2f mm pen up\n", j->down_mm, j->up_mm);
    for (int k = 0; k < 2; k++) {
        const trace_axis_judgement_t *a = &j->axis[k];
        fprintf(f,
                "  %c steps         %llu, from %lld to %lld, shortest interval %.3f us, largest speed jump %.2f mm/s\n",
                "xy"[k], (unsigned long long)a -> steps, (long long)a -> min_steps, (long long)a -> max_steps,
                (double)a -> min_interval_ps * 1e-6, a -> max_jump_mm_s);
    }
    bool in_place = !j->axis[0].misplaced && !j->axis[1].misplaced;
    finding(f, in_place, "steps in place  ");
    fprintf(f, in_place ? "all, as their neighbours have it\n" : "not all:");
    for (int k = 0; k < 2; k++)
        if (j->axis[k].misplaced)
            fprintf(f, " %c %lu places, the first at %.6f s by %.3f ms;", "xy"[k], j -> axis[k].misplaced,
                    j->axis[k].misplaced_at_s, j->axis[k].misplaced_s * 1e3);
    if (!in_place) fprintf(f, "\n");
    finding(f, j->ends_home, "end position    ");
    fprintf(f, "%lld %lld steps%s\n", (long long)j->axis[0].end_steps, (long long)j->axis[1].end_steps,
            j->ends_home ? ": home" : ", not home");
    finding(f, j->ends_up, "pen at the end  ");
    fprintf(f, "%s%s\n", j->ends_up ? "up" : "down", j->has_pen ? "" : " (no such signal)");
    finding(f, j->ends_disabled, "motors at end   ");
    fprintf(f, "%s%s\n", j->ends_disabled ? "off" : "on", j->has_enable ? "" : " (no such signal)");
    finding(f, !j->short_pulses, "pulse width     ");
    fprintf(f, "x %.3f..%.3f us, y %.3f..%.3f us (at least %.3f), %lu too short\n",
            (double)j->axis[0].min_pulse_ps * 1e-6, (double)j->axis[0].max_pulse_ps * 1e-6,
            (double)j->axis[1].min_pulse_ps * 1e-6, (double)j->axis[1].max_pulse_ps * 1e-6, m->pulse_ns * 1e-3,
            j->short_pulses);
    finding(f, !j->short_setups && !j->turned_high, "DIR set-up      ");
    fprintf(f, "x %.3f us, y %.3f us (at least %.3f), %lu too short, %lu changes during a pulse\n",
            (double)j->axis[0].min_setup_ps * 1e-6, (double)j->axis[1].min_setup_ps * 1e-6, m->dir_setup_ns * 1e-3,
            j->short_setups, j->turned_high);
    finding(f, !j->unsettled, "pen settling    ");
    fprintf(f, "%.6f s after lifting (at least %.6f), %.6f s after lowering (%.6f), %lu steps too early\n",
            j->settle_lift_s, m->lift_us * 1e-6, j->settle_lower_s, m->lower_us * 1e-6, j->unsettled);
    finding(f, !j->unchanged, "pen changes     ");
    if (j->unchanged)
        fprintf(f, "%lu missing, at the stop of its length at %.6f s first\n", j->unchanged, j->unchanged_at_s);
    else
        fprintf(f, "none is missing\n");
    finding(f, !j->disabled, "motors off      ");
    fprintf(f, "%lu steps\n", j->disabled);
    finding(f, j->speed_ok, "speed           ");
    fprintf(f, "%.2f mm/s pen down (limit %.2f), %.2f mm/s pen up (%.2f)\n", j->max_speed_down,
            m->draw_speed_um_s * 1e-3, j->max_speed_up, m->travel_speed_um_s * 1e-3);
    finding(f, j->accel_ok, "acceleration    ");
    fprintf(f, "%.0f mm/s^2 at %.3f s (limit %.0f: along, across and at a vertex at once)\n", j->max_accel,
            j->max_accel_at_s, j->accel_limit);
    fprintf(f, "%s\n", j->legal ? "legal" : "NOT LEGAL");
}
