/* Adapters only: profiles from arrays of points. */
#include "tests/oracle/run_horizon.h"

#include <stdlib.h>

#include "hidden/surface/horizon.h"

static int32_t points(void *ctx, int32_t k) {
    const horizon_ref_t *r = ctx;
    return r->first[k + 1] - r->first[k];
}

static void point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    const horizon_ref_t *r = ctx;
    int at = r->first[k] + v;
    xyz[0] = run_num(r->point[at].x);
    xyz[1] = run_num(r->point[at].y);
    xyz[2] = r->gap && r->gap[at] ? num_undef() : run_num(r->point[at].z);
}

int run_horizon(const horizon_ref_t *r, const double away[2], run_drawing_t *d, hidden_stats_t *stats) {
    horizon_ref_t ref = *r;
    profiles_t p = {.count = r->count, .ctx = &ref, .points = points, .point = point};
    for (int i = 0; i < 2; i++) {
        p.away[i] = run_num(away[i]);
        p.side[i] = run_num(i ? -away[0] : away[1]);
    }
    camera_t cam = run_camera(&r->eye);
    ink_sink_t sink = run_sink(d);
    int total = r->first[r->count];
    for (int k = 0; k < r->count; k++)
        if (points(&ref, k) > p.max_points) p.max_points = points(&ref, k);
    size_t bytes = horizon_bytes(8 * total + 1000);
    hidden_job_t job = {.mem = malloc(bytes), .bytes = bytes, .sink = &sink};
    if (!job.mem) abort();
    *stats = (hidden_stats_t){0};
    int err = horizon_draw(&p, &cam, r->infinite, &job, stats);
    for (size_t i = 0; i < d->n; i++) d->piece[i].family = 0;
    free(job.mem);
    return err;
}
