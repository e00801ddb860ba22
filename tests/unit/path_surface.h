/* path_surface.h - the ink of a surface, recorded behind the perimeter kernel, for tests and benches of src/path. */
#ifndef PATH_SURFACE_H
#define PATH_SURFACE_H

#include "hidden/surface/perimeter.h"
#include "lang/settings.h"
#include "path/path.h"
#include "view/camera.h"
#include "view/page_map.h"
#include <math.h>
#include <stdlib.h>

/* A surface's ink, and its map to the page, moved and scaled if asked for. */
typedef struct surface_ink {
    int32_t n;
    double half; /* the surface is on [-half, half]^2 */
    double *z;   /* n * n heights */
    settings_t settings;
    surface_t surface;
    grid_t grid;
    camera_t camera;
    page_map_t map;
    int32_t *cache;
    void *table, *work;
    ink_piece_t *piece;
    int pieces, room;
    double scale; /* 1: as the view has it */
    page_point_t corner;
} surface_ink_t;

static inline num_t num_of(double v) {
    int e;
    double m = frexp(v, &e);
    return num_ldexp(num_from_i64((int64_t)ldexp(m, 53)), e - 53);
}

static inline double surface_ink_at(const surface_ink_t *s, int32_t i) {
    return s->half * (2.0 * i / (s->n - 1) - 1);
}
static inline num_t surface_ink_coordinate(void *ctx, int32_t i) {
    return num_of(surface_ink_at(ctx, i));
}
static inline num_t surface_ink_height(void *ctx, int32_t i, int32_t j) {
    surface_ink_t *s = ctx;
    return num_of(s->z[(size_t)j * (size_t)s->n + (size_t)i]);
}

static inline int surface_ink_keep(void *ctx, const ink_piece_t *p) {
    surface_ink_t *s = ctx;
    if (s->pieces == s->room) {
        s->room = s->room ? 2 * s->room : 1024;
        s->piece = realloc(s->piece, sizeof *s->piece * (size_t)s->room);
    }
    s->piece[s->pieces++] = *p;
    return 0;
}

static inline bool surface_ink_point(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t,
                                     page_point_t *out) {
    surface_ink_t *s = ctx;
    page_point_t p;
    (void)surface;
    if (!line_space_point(&s->map.lines, family, line, t, &p)) return false;
    if (s->scale == 1) {
        *out = p;
        return true;
    }
    out->x_lat = (int32_t)lround((p.x_lat - s->corner.x_lat) * s->scale);
    out->y_lat = (int32_t)lround((p.y_lat - s->corner.y_lat) * s->scale);
    return true;
}

/* Runs the kernel once, seen from (6,8,3) or as gnuplot sees it. f of the distance from the middle; NULL: random.
 * Returns 0 or an error. */
static inline int surface_ink_make(surface_ink_t *s, int32_t n, double half, double (*f)(double), bool perspective) {
    const size_t points = (size_t)n * (size_t)n, work = (size_t)n * 1000 + 65536;
    const ink_sink_t sink = {s, surface_ink_keep};
    hidden_stats_t stats;
    uint32_t seed = 7;
    *s = (surface_ink_t){.n = n, .half = half, .scale = 1};
    s->z = malloc(points * sizeof *s->z);
    for (int32_t j = 0; j < n; j++) {
        for (int32_t i = 0; i < n; i++) {
            seed = seed * 1664525u + 1013904223u;
            double *z = &s->z[(size_t)j * (size_t)n + (size_t)i];
            *z = f ? f(hypot(surface_ink_at(s, i), surface_ink_at(s, j))) : (seed >> 8) / 16777216.0;
        }
    }
    s->surface = (surface_t){n, n, s, surface_ink_coordinate, surface_ink_coordinate, surface_ink_height, NULL, NULL};
    settings_default(&s->settings);
    s->settings.view.from = perspective;
    for (int k = 0; k < 3; k++) s->settings.view.eye[k] = num_from_i64("\6\10\3"[k]);
    s->cache = malloc(points * sizeof *s->cache);
    s->table = malloc(PAGE_MAP_BYTES(n, n));
    s->work = malloc(work);
    int err = grid_measure(&s->grid, &s->surface, NULL, NULL, s->cache, NULL, NULL);
    view_box_t box = {.lo = {num_of(-half), num_of(-half), s->grid.z_min},
                      .hi = {num_of(half), num_of(half), s->grid.z_max}};
    if (!err) err = camera_setup(&s->camera, &s->settings, &box);
    if (!err) err = page_map_setup(&s->map, &s->grid, &s->camera, s->table);
    const hidden_job_t job = {.mem = s->work, .bytes = work, .sink = &sink};
    return err ? err : perimeter_draw(&s->grid, &s->camera, &job, &stats);
}

static inline void surface_ink_free(surface_ink_t *s) {
    free(s->z);
    free(s->cache);
    free(s->table);
    free(s->work);
    free(s->piece);
}

#endif
