/* path_scene.h - what the tests of src/path share: a flat map, and a pen that remembers. */
#ifndef PATH_SCENE_H
#define PATH_SCENE_H

#include "path/path.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
/* cmocka wants those four before it */
#include <cmocka.h>

/* A flat grid: column i, row j lies at (i, j) * cell. */
typedef struct flat {
    int32_t cell_lat;
    int64_t asked;
} flat_t;

static inline bool flat_point(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t, page_point_t *out) {
    flat_t *f = ctx;
    const int bits = ink_bits(family);
    int32_t along = (int32_t)(((t >> (bits - 30)) * f->cell_lat + INK_ONE / 2) >> 30), across = line * f->cell_lat;
    (void)surface;
    f->asked++;
    *out = family == INK_COL ? (page_point_t){across, along} : (page_point_t){along, across};
    return true;
}

/* A pen that keeps every vertex; down is false at the start of a stroke. */
typedef struct drawn {
    page_point_t *p;
    bool *down;
    int n, cap, strokes;
} drawn_t;

static inline int drawn_add(drawn_t *d, page_point_t p, bool down) {
    if (d->n == d->cap) {
        d->cap = d->cap ? 2 * d->cap : 1024;
        d->p = realloc(d->p, sizeof *d->p * (size_t)d->cap);
        d->down = realloc(d->down, sizeof *d->down * (size_t)d->cap);
    }
    d->p[d->n] = p;
    d->down[d->n++] = down;
    d->strokes += !down;
    return 0;
}
static inline int drawn_move(void *ctx, page_point_t p) {
    return drawn_add(ctx, p, false);
}
static inline int drawn_draw(void *ctx, page_point_t p) {
    return drawn_add(ctx, p, true);
}
static inline pen_sink_t drawn_sink(drawn_t *d) {
    return (pen_sink_t){d, drawn_move, drawn_draw};
}
static inline void drawn_free(drawn_t *d) {
    free(d->p);
    free(d->down);
    memset(d, 0, sizeof *d);
}

/* Millimetres with the pen down, or up: from home to home. */
static inline double drawn_mm(const drawn_t *d, bool down) {
    double lat = 0;
    page_point_t at = {0, 0};
    for (int i = 0; i <= d->n; i++) {
        const page_point_t to = i < d->n ? d->p[i] : (page_point_t){0, 0};
        if ((i < d->n && d->down[i]) == down) lat += hypot((double)to.x_lat - at.x_lat, (double)to.y_lat - at.y_lat);
        at = to;
    }
    return lat / LAT_PER_MM;
}

static inline uint32_t next_random(uint32_t *s) {
    *s ^= *s << 13;
    *s ^= *s >> 17;
    *s ^= *s << 5;
    return *s;
}

#endif
