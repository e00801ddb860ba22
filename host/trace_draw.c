/* trace_draw.c - the ink of a trace: steps to strokes, straight runs of steps to single lines.
 *
 * A staircase of steps is replaced by lines that pass every pen position within TRACE_INK_STEPS: from the last point
 * kept, each further position narrows the sector of directions that still pass all of them. When none is left, the line
 * ends at the position before, moved sideways into the sector, and the next one begins there. */
#include "error.h"
#include "hal/hal.h"
#include "host/drawing.h"
#include "host/trace_path.h"
#include "host/writer.h"
#include <math.h>

#define A4_WIDTH_UM 297000
#define A4_HEIGHT_UM 210000

typedef struct inker {
    pen_sink_t sink;
    double tolerance;
    double from[2], last[2]; /* last point kept, latest position */
    double lo[2], hi[2];     /* directions that bound the sector: clockwise and counterclockwise end */
    double reach;            /* greatest distance from there, once narrowed */
    bool narrowed;           /* the sector is smaller than everything */
    int error;
} inker_t;

static page_point_t lat(const double p[2]) {
    return (page_point_t){(int32_t)lround(p[0] * LAT_PER_MM), (int32_t)lround(p[1] * LAT_PER_MM)};
}

static double cross(const double a[2], const double b[2]) {
    return a[0] * b[1] - a[1] * b[0];
}

/* Ends a line at the point nearest to the latest position in a direction that passes all. */
static void keep(inker_t *k) {
    double d[2] = {k->last[0] - k->from[0], k->last[1] - k->from[1]};
    const double *edge = !k->narrowed ? NULL : cross(k->lo, d) < 0 ? k->lo : cross(d, k->hi) < 0 ? k->hi : NULL;
    if (edge) {
        double along = (d[0] * edge[0] + d[1] * edge[1]) / (edge[0] * edge[0] + edge[1] * edge[1]);
        d[0] = along * edge[0];
        d[1] = along * edge[1];
    }
    k->from[0] += d[0];
    k->from[1] += d[1];
    k->narrowed = false;
    if (!k->error) k->error = k->sink.draw(k->sink.ctx, lat(k->from));
}

static void put_down(inker_t *k, const double p[2]) {
    if (!k->error) k->error = k->sink.move(k->sink.ctx, lat(p));
    k->from[0] = k->last[0] = p[0];
    k->from[1] = k->last[1] = p[1];
    k->narrowed = false;
}

/* Narrows the sector to the directions that pass p; false, and the sector as it was, if none is left or p turns back.
 */
static bool narrow(inker_t *k, const double p[2]) {
    double d[2] = {p[0] - k->from[0], p[1] - k->from[1]};
    double far = hypot(d[0], d[1]);
    if (far <= k->tolerance) return !k->narrowed; /* near the start anything passes, as long as it has not left it */
    if (k->narrowed && far < k->reach - k->tolerance) return false;
    double s = k->tolerance / far, c = sqrt(1 - s * s);
    double lo[2] = {d[0] * c + d[1] * s, d[1] * c - d[0] * s}, hi[2] = {d[0] * c - d[1] * s, d[1] * c + d[0] * s};
    if (k->narrowed) {
        if (d[0] * k->lo[0] + d[1] * k->lo[1] < 0) return false;
        const double *low = cross(k->lo, lo) > 0 ? lo : k->lo, *high = cross(hi, k->hi) > 0 ? hi : k->hi;
        if (cross(low, high) < 0) return false;
        lo[0] = low[0], lo[1] = low[1];
        hi[0] = high[0], hi[1] = high[1];
    }
    for (int i = 0; i < 2; i++) k->lo[i] = lo[i], k->hi[i] = hi[i];
    k->reach = k->narrowed ? fmax(k->reach, far) : far;
    k->narrowed = true;
    return true;
}

static void go(inker_t *k, const double p[2]) {
    if (!narrow(k, p)) {
        keep(k);
        narrow(k, p);
    }
    k->last[0] = p[0];
    k->last[1] = p[1];
}

int trace_ink(const trace_t *t, const machine_t *m, pen_sink_t sink) {
    static const uint8_t STEP[2] = {HAL_X_STEP, HAL_Y_STEP}, DIR[2] = {HAL_X_DIR, HAL_Y_DIR};
    double finest = 65536.0 / fmax(m->steps_per_mm_q16[0], m->steps_per_mm_q16[1]);
    inker_t k = {.sink = sink, .tolerance = TRACE_INK_STEPS * finest};
    double motor[2] = {0, 0}, page[2] = {0, 0};
    uint8_t pins = t->initial;
    if (pins & HAL_PEN) put_down(&k, page);
    for (size_t i = 0; i < t->count && !k.error; i++) {
        const trace_event_t *e = &t->events[i];
        uint8_t rises = (uint8_t)(e->changed & e->pins);
        for (int a = 0; a < 2; a++)
            if (rises & STEP[a]) motor[a] += e->pins & DIR[a] ? 1 : -1;
        if (rises & (HAL_X_STEP | HAL_Y_STEP)) {
            trace_path_page(m, motor, page);
            if (pins & HAL_PEN) go(&k, page);
        }
        if (rises & HAL_PEN)
            put_down(&k, page);
        else if (e->changed & HAL_PEN)
            keep(&k);
        pins = e->pins;
    }
    if ((pins & HAL_PEN) && !k.error) keep(&k);
    return k.error;
}

int trace_draw(const trace_t *t, const machine_t *m, const char *name) {
    drawing_t d;
    drawing_init(&d);
    drawing_set_title(&d, name);
    int e = trace_ink(t, m, drawing_sink(&d));
    d.width_um = A4_WIDTH_UM;
    d.height_um = A4_HEIGHT_UM;
    for (size_t i = 0; i < d.points; i++) {
        int32_t x_um = (int32_t)((int64_t)d.point[i].x_lat * 1000 / LAT_PER_MM);
        int32_t y_um = (int32_t)((int64_t)d.point[i].y_lat * 1000 / LAT_PER_MM);
        if (x_um > d.width_um) d.width_um = x_um;
        if (y_um > d.height_um) d.height_um = y_um;
    }
    if (!e) e = writer_write(&d, m, name);
    drawing_free(&d);
    return e;
}
