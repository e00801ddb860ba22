/* motion_rig.c - see motion_rig.h. */
#include "tests/oracle/motion_rig.h"
#include "host/trace_path.h"
#include "sim/sim.h"
#include <math.h>
#include <stdlib.h>

#define REACH 400 /* lines looked ahead while following a path: closely cut curves have many in a step */

static void *grown(void *p, size_t count, size_t *room, size_t size) {
    if (count < *room) return p;
    *room = *room ? *room * 2 : 256;
    p = realloc(p, *room * size);
    if (!p) abort();
    return p;
}

static double on_lattice(double mm) {
    return round(mm * LAT_PER_MM) / LAT_PER_MM;
}

void rig_draw(rig_drawing_t *d, double x, double y) {
    d->point = grown(d->point, d->points, &d->point_room, sizeof *d->point);
    d->point[d->points++] = (motion_ref_point_t){on_lattice(x), on_lattice(y)};
}

void rig_move(rig_drawing_t *d, double x, double y) {
    d->stroke = grown(d->stroke, d->strokes, &d->stroke_room, sizeof *d->stroke);
    d->stroke[d->strokes++] = d->points;
    rig_draw(d, x, y);
}

void rig_free(rig_drawing_t *d) {
    free(d->point);
    free(d->stroke);
    *d = (rig_drawing_t){0};
}

static size_t stroke_end(const rig_drawing_t *d, size_t s) {
    return s + 1 < d->strokes ? d->stroke[s + 1] : d->points;
}

double rig_ideal_s(const rig_drawing_t *d, const machine_t *m) {
    motion_ref_limits_t draw = {m->draw_speed_um_s * 1e-3, m->accel_um_s2 * 1e-3, m->junction_um * 1e-3}, travel = draw;
    travel.speed = m->travel_speed_um_s * 1e-3;
    double time = m->enable_us * 1e-6;
    motion_ref_point_t at = {0, 0};
    for (size_t s = 0; s < d->strokes; s++) {
        const motion_ref_point_t *p = &d->point[d->stroke[s]];
        size_t n = stroke_end(d, s) - d->stroke[s];
        time += motion_ref_travel(hypot(p->x - at.x, p->y - at.y), &travel);
        time += m->lower_us * 1e-6 + motion_ref_run(p, n, &draw, NULL) + m->lift_us * 1e-6;
        at = p[n - 1];
    }
    return time + motion_ref_travel(hypot(at.x, at.y), &travel);
}

typedef struct tape {
    trace_t *trace;
    size_t room;
    uint64_t hash;
} tape_t;

static void record(void *ctx, uint64_t tick, uint32_t pins, uint32_t changed) {
    tape_t *tape = ctx;
    trace_t *t = tape->trace;
    t->events = grown(t->events, t->count, &tape->room, sizeof *t->events);
    t->events[t->count++] =
        (trace_event_t){.time_ps = tick * 62500, .pins = (uint8_t)pins, .changed = (uint8_t)changed};
    tape->hash = (tape->hash ^ tick) * 1099511628211u;
    tape->hash = (tape->hash ^ pins) * 1099511628211u;
}

int rig_feed(const rig_drawing_t *d, motion_t *motion) {
    pen_sink_t sink = motion_pen_sink(motion);
    int e = 0;
    for (size_t s = 0; s < d->strokes; s++)
        for (size_t i = d->stroke[s]; i < stroke_end(d, s) && !e; i++) {
            page_point_t p = {(int32_t)lround(d->point[i].x * LAT_PER_MM), (int32_t)lround(d->point[i].y * LAT_PER_MM)};
            e = i == d->stroke[s] ? sink.move(sink.ctx, p) : sink.draw(sink.ctx, p);
        }
    return e;
}

rig_run_t rig_run(const rig_drawing_t *d, const machine_t *m, size_t bytes, void (*prepare)(void)) {
    rig_run_t run = {.prepared = prepare != NULL,
                     .trace = {.has_pen = true, .has_enable = true, .unit_ps = 62500, .machine = *m}};
    tape_t tape = {.trace = &run.trace, .hash = 14695981039346656037u};
    motion_t motion;
    void *memory = malloc(bytes);
    sim_reset();
    if (prepare) prepare();
    run.error = motion_init(&motion, m, memory, bytes);
    sim_record(record, &tape);
    if (!run.error) {
        rig_feed(d, &motion);
        run.error = motion_finish(&motion, &run.stats);
    }
    sim_record(NULL, NULL);
    run.trace.end_ps = sim_now() * 62500;
    run.hash = tape.hash;
    free(memory);
    return run;
}

double rig_estimate_s(const rig_drawing_t *d, const machine_t *m, size_t bytes) {
    motion_t motion;
    motion_stats_t stats = {0};
    void *memory = malloc(bytes);
    if (!motion_init_estimate(&motion, m, memory, bytes)) {
        rig_feed(d, &motion);
        motion_finish(&motion, &stats);
    }
    free(memory);
    return (double)stats.ticks / HAL_TICK_HZ;
}

static double distance(const motion_ref_point_t *a, const motion_ref_point_t *b, double x, double y) {
    double dx = b->x - a->x, dy = b->y - a->y, square = dx * dx + dy * dy;
    double t = square > 0 ? ((x - a->x) * dx + (y - a->y) * dy) / square : 0;
    t = fmin(fmax(t, 0), 1);
    return hypot(a->x + t * dx - x, a->y + t * dy - y);
}

/* Distance from the stroke, and where on it the pen is now: on the first line within a step, from where it was. */
static double follow(const rig_drawing_t *d, size_t *line, size_t end, const double page[2], double step_mm) {
    double nearest = INFINITY;
    for (size_t k = *line; k + 1 < end && k < *line + REACH; k++) {
        double far = distance(&d->point[k], &d->point[k + 1], page[0], page[1]);
        nearest = fmin(nearest, far);
        if (nearest > step_mm) continue;
        *line = k;
        if (k + 2 < end) nearest = fmin(nearest, distance(&d->point[k + 1], &d->point[k + 2], page[0], page[1]));
        break;
    }
    return nearest;
}

static double coarsest_mm(const machine_t *m) {
    return 65536.0 / fmin(m->steps_per_mm_q16[0], m->steps_per_mm_q16[1]);
}

double rig_deviation_steps(const rig_drawing_t *d, const machine_t *m, const trace_t *t) {
    double step_mm = coarsest_mm(m), worst = 0, motor[2] = {0, 0}, page[2] = {0, 0};
    uint8_t pins = t->initial;
    size_t stroke = 0, line = 0, end = 0;
    for (size_t i = 0; i < t->count; i++) {
        const trace_event_t *e = &t->events[i];
        uint8_t rises = e->changed & e->pins;
        if (rises & HAL_X_STEP) motor[0] += e->pins & HAL_X_DIR ? 1 : -1;
        if (rises & HAL_Y_STEP) motor[1] += e->pins & HAL_Y_DIR ? 1 : -1;
        trace_path_page(m, motor, page);
        if (rises & HAL_PEN) {
            if (stroke == d->strokes) return INFINITY;
            line = d->stroke[stroke];
            end = stroke_end(d, stroke++);
        }
        if ((rises & (HAL_X_STEP | HAL_Y_STEP)) && (pins & HAL_PEN))
            worst = fmax(worst, follow(d, &line, end, page, step_mm));
        if ((e->changed & HAL_PEN) && (pins & HAL_PEN))
            worst = fmax(worst, hypot(page[0] - d->point[end - 1].x, page[1] - d->point[end - 1].y));
        pins = e->pins;
    }
    return stroke == d->strokes ? worst / step_mm : INFINITY;
}

/* Index of the event at which the pen goes up after event i. */
static size_t pen_up_after(const trace_t *t, size_t i) {
    while (i < t->count && (t->events[i].pins & HAL_PEN)) i++;
    return i;
}

double rig_timed_deviation_steps(const rig_drawing_t *d, const machine_t *m, const trace_t *t) {
    motion_ref_limits_t limits = {m->draw_speed_um_s * 1e-3, m->accel_um_s2 * 1e-3, m->junction_um * 1e-3};
    motion_ref_line_t *lines = malloc((d->points + 1) * sizeof *lines);
    double step_mm = coarsest_mm(m), worst = 0, motor[2] = {0, 0}, start = 0, stretch = 0;
    size_t stroke = 0, line = 0, n = 0;
    const motion_ref_point_t *p = NULL;
    uint8_t pins = t->initial;
    for (size_t i = 0; i < t->count; i++) {
        const trace_event_t *e = &t->events[i];
        uint8_t rises = e->changed & e->pins;
        double now = (double)e->time_ps * 1e-12, middle[2] = {motor[0], motor[1]}, page[2];
        for (int k = 0; k < 2; k++) {
            if (!(rises & (k ? HAL_Y_STEP : HAL_X_STEP))) continue;
            int way = e->pins & (k ? HAL_Y_DIR : HAL_X_DIR) ? 1 : -1;
            middle[k] += 0.5 * way;
            motor[k] += way;
        }
        if ((rises & HAL_PEN) && stroke < d->strokes) {
            p = &d->point[d->stroke[stroke]];
            n = stroke_end(d, stroke) - d->stroke[stroke];
            stroke++;
            line = 0;
            start = now + m->lower_us * 1e-6;
            double took = (double)t->events[pen_up_after(t, i)].time_ps * 1e-12 - start;
            double ideal = motion_ref_run(p, n, &limits, lines);
            stretch = took > 0 ? ideal / took : 0;
        }
        if ((rises & (HAL_X_STEP | HAL_Y_STEP)) && (pins & HAL_PEN)) {
            double when = (now - start) * stretch;
            while (line + 2 < n && lines[line + 1].start_s <= when) line++;
            double s = motion_ref_where(&lines[line], limits.accel, when) / fmax(lines[line].length, 1e-12);
            double x = p[line].x + s * (p[line + 1].x - p[line].x), y = p[line].y + s * (p[line + 1].y - p[line].y);
            trace_path_page(m, middle, page);
            worst = fmax(worst, hypot(page[0] - x, page[1] - y));
        }
        pins = e->pins;
    }
    free(lines);
    return worst / step_mm;
}
