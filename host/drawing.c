/* drawing.c - two growing arrays. They double, so a point costs amortised constant time, and a page that is
 * drawn again reuses them. */
#include "host/drawing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"

void drawing_init(drawing_t *d) {
    memset(d, 0, sizeof *d);
    drawing_clear(d);
    d->width_um = 297000;
    d->height_um = 210000;
    for (int i = 0; i < 2; i++) d->camera_mm[i][i] = 1;
    d->camera_mm[2][3] = 1;
}

void drawing_clear(drawing_t *d) {
    d->points = d->strokes = 0;
    d->lifted = true;
    d->over = (page_point_t){0, 0};
}

void drawing_free(drawing_t *d) {
    free(d->point);
    free(d->first);
    memset(d, 0, sizeof *d);
}

static double double_from_num(num_t a) {
    return a.undef ? (double)NAN : ldexp((double)a.m, a.e);
}

void drawing_set_camera(drawing_t *d, const camera_t *c) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            double v = double_from_num(c->m[i][j]);
            d->camera_mm[i][j] = i < 2 ? v / LAT_PER_MM : v;
        }
}

void drawing_set_title(drawing_t *d, const char *title) {
    size_t n = strlen(title);
    if (n >= sizeof d->title) n = sizeof d->title - 1;
    memcpy(d->title, title, n);
    d->title[n] = 0;
}

/* Makes *array hold at least one item more than `used`. */
static bool make_room(void **array, size_t used, size_t *room, size_t item) {
    if (used < *room) return true;
    size_t want = *room ? *room * 2 : 1024;
    if (want > SIZE_MAX / item) return false;
    void *p = realloc(*array, want * item);
    if (!p) return false;
    *array = p;
    *room = want;
    return true;
}

static int add_point(drawing_t *d, page_point_t p) {
    if (d->points == d->point_room && !make_room((void **)&d->point, d->points, &d->point_room, sizeof *d->point))
        return ERR_FULL;
    d->point[d->points++] = p;
    return 0;
}

static int sink_move(void *ctx, page_point_t to) {
    drawing_t *d = ctx;
    d->lifted = true;
    d->over = to;
    return 0;
}

static int sink_draw(void *ctx, page_point_t to) {
    drawing_t *d = ctx;
    if (d->lifted) {
        if (d->strokes == d->stroke_room &&
            !make_room((void **)&d->first, d->strokes, &d->stroke_room, sizeof *d->first))
            return ERR_FULL;
        int err = add_point(d, d->over);
        if (err) return err;
        d->first[d->strokes++] = d->points - 1;
        d->lifted = false;
    }
    return add_point(d, to);
}

pen_sink_t drawing_sink(drawing_t *d) {
    return (pen_sink_t){.ctx = d, .move = sink_move, .draw = sink_draw};
}

const page_point_t *drawing_stroke(const drawing_t *d, size_t s, size_t *n) {
    size_t end = s + 1 < d->strokes ? d->first[s + 1] : d->points;
    *n = end - d->first[s];
    return d->point + d->first[s];
}

static double distance_mm(page_point_t a, page_point_t b) {
    double x = (double)b.x_lat - a.x_lat, y = (double)b.y_lat - a.y_lat;
    return sqrt(x * x + y * y) / LAT_PER_MM;
}

drawing_length_t drawing_measure(const drawing_t *d) {
    drawing_length_t len = {0};
    page_point_t at = {0, 0};
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *p = drawing_stroke(d, s, &n);
        len.up_mm += distance_mm(at, p[0]);
        for (size_t i = 1; i < n; i++) len.down_mm += distance_mm(p[i - 1], p[i]);
        at = p[n - 1];
    }
    if (d->strokes) len.up_mm += distance_mm(at, (page_point_t){0, 0});
    return len;
}
