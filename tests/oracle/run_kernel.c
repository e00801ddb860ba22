/* Adapters only: surfaces from arrays of doubles, a collecting sink. */
#include "tests/oracle/run_kernel.h"

#include <math.h>
#include <stdlib.h>

#include "hidden/surface/perimeter.h"
#include "scene/grid.h"

void run_drawing_free(run_drawing_t *d) {
    free(d->piece);
    *d = (run_drawing_t){0};
}

num_t run_num(double v) {
    int e;
    double f = frexp(v, &e);
    return num_ldexp(num_from_i64((int64_t)ldexp(f, 53)), e - 53);
}

camera_t run_camera(const exact_eye_t *eye) {
    camera_t c = {.perspective = eye->h != 0};
    c.eye[0] = run_num(eye->x);
    c.eye[1] = run_num(eye->y);
    c.eye[2] = run_num(eye->z);
    return c;
}

static int take(void *ctx, const ink_piece_t *p) {
    run_drawing_t *d = ctx;
    if (d->n == d->cap) {
        d->cap = d->cap ? 2 * d->cap : 256;
        d->piece = realloc(d->piece, d->cap * sizeof *d->piece);
        if (!d->piece) abort();
    }
    const double one = (double)ink_one(p->family);
    int family = p->family == INK_ROW ? REF_ROW : p->family == INK_COL ? REF_COL : p->family;
    d->piece[d->n++] = (judge_piece_t){family, p->line, (double)p->from / one, (double)p->to / one};
    return 0;
}

ink_sink_t run_sink(run_drawing_t *d) {
    return (ink_sink_t){d, take};
}

static num_t x_of(void *ctx, int32_t i) {
    return run_num(((const surface_ref_t *)ctx)->x[i]);
}
static num_t y_of(void *ctx, int32_t j) {
    return run_num(((const surface_ref_t *)ctx)->y[j]);
}
static num_t z_of(void *ctx, int32_t i, int32_t j) {
    const surface_ref_t *r = ctx;
    return r->hole && r->hole[j * r->nx + i] ? num_undef() : run_num(r->z[j * r->nx + i]);
}

static int take_of_several(void *ctx, const ink_piece_t *p) {
    return take((run_drawing_t *)ctx + p->surface, p);
}

int run_several(const surface_ref_t *sheet, int n, run_drawing_t *d, hidden_stats_t *stats) {
    enum { MOST = 4 };
    surface_ref_t ref[MOST];
    surface_t surface[MOST];
    grid_t g[MOST], *grid[MOST];
    camera_t cam = run_camera(&sheet[0].eye);
    ink_sink_t sink = {d, take_of_several};
    *stats = (hidden_stats_t){0};
    for (int k = 0; k < n && k < MOST; k++) {
        ref[k] = sheet[k];
        surface[k] = (surface_t){ref[k].nx, ref[k].ny, &ref[k], x_of, y_of, z_of, NULL, NULL};
        grid[k] = &g[k];
        int err = grid_measure(&g[k], &surface[k], NULL, NULL, NULL, NULL, NULL);
        if (err) return err;
    }
    size_t bytes = perimeter_bytes(ref[0].nx, 800 * n * (ref[0].nx + ref[0].ny) + 1000);
    hidden_job_t job = {.mem = malloc(bytes), .bytes = bytes, .sink = &sink};
    if (!job.mem) abort();
    int err = perimeter_draw_several(grid, n, &cam, &job, stats);
    free(job.mem);
    return err;
}

hidden_strips_t run_strips;

int run_perimeter_in(const scene_t *s, run_drawing_t *d, size_t bytes, hidden_stats_t *stats) {
    surface_ref_t ref = s->ref;
    surface_t surface = {ref.nx, ref.ny, &ref, x_of, y_of, z_of, NULL, NULL};
    camera_t cam = run_camera(&ref.eye);
    ink_sink_t sink = run_sink(d);
    grid_t g;
    *stats = (hidden_stats_t){0};
    int err = grid_measure(&g, &surface, NULL, NULL, NULL, NULL, NULL);
    if (err) return err;
    hidden_job_t job = {.mem = malloc(bytes ? bytes : 1), .bytes = bytes, .sink = &sink};
    if (run_strips.ends) job.strips = &run_strips;
    if (!job.mem) abort();
    err = perimeter_draw(&g, &cam, &job, stats);
    free(job.mem);
    return err;
}

int run_perimeter(const scene_t *s, run_drawing_t *d, hidden_stats_t *stats) {
    int32_t vertices = 40 * (s->ref.nx + s->ref.ny) + 1000;
    if (s->ref.hole) vertices += 760 * (s->ref.nx + s->ref.ny) + 8 * s->ref.nx * s->ref.ny; /* windows take more */
    return run_perimeter_in(s, d, perimeter_bytes(s->ref.nx, vertices), stats);
}
