/* horizon.c - profiles against the horizons, front to back.
 *
 * All points of a profile are equally far away, so in the frame of the cutting planes the chart is one multiplication
 * per coordinate, and a fraction of the way in the chart is the same fraction in space. */
#include "hidden/surface/horizon.h"

#include "error.h"
#include "hidden/surface/horizons.h"
#include "hidden/surface/runs.h"
#include "view/plane.h"
#include <string.h>

#define NEAREST_BITS 6 /* profiles nearer than 2^-6 of the farthest are left out */

typedef struct drawing {
    const profiles_t *src;
    const hidden_pause_t *pause;
    horizons_t horizons;
    runs_t runs;
    run_t run;
    plane_t plane;
    num_t eye[3];       /* in the frame of the profiles: u, v, z */
    num_t nearest;      /* least v that is drawn (perspective) */
    int32_t line, cell; /* the segment being clipped */
    int64_t segments;
    bool flat; /* seen from straight above or below: nothing hides anything */
} drawing_t;

static num_t dot(const num_t a[2], const num_t p[]) {
    return num_add(num_mul(a[0], p[0]), num_mul(a[1], p[1]));
}

static int take_part(void *ctx, envelope_part_t part, bool first) {
    drawing_t *d = ctx;
    int64_t at = d->cell * INK_ONE;
    (void)first;
    return runs_add(&d->runs, &d->run, INK_PROFILE, d->line, at + part.from_q30, at + part.to_q30);
}

/* The depth of profile k, if it has any points and is in front of the eye. */
static bool depth_of(const drawing_t *d, int32_t k, num_t *v) {
    num_t p[3];
    if (d->src->points(d->src->ctx, k) < 2) return false;
    d->src->point(d->src->ctx, k, 0, p);
    *v = dot(d->src->away, p);
    return d->nearest.undef || num_cmp(*v, d->nearest) >= 0;
}

static void stretch(num_t range[2], num_t a, bool first) {
    if (first || num_cmp(a, range[0]) < 0) range[0] = a;
    if (first || num_cmp(a, range[1]) > 0) range[1] = a;
}

/* Measures the box of what is drawn, and chooses the scales. */
static int measure(drawing_t *d, const camera_t *cam) {
    const profiles_t *src = d->src;
    num_t u[2], v[2], z[2], depth;
    bool any = false;
    d->eye[0] = cam->perspective ? dot(src->side, cam->eye) : num_from_i64(0);
    d->eye[1] = dot(src->away, cam->eye);
    d->eye[2] = cam->eye[2];
    d->nearest = num_undef();
    d->flat = !cam->perspective && num_cmp(num_abs(d->eye[1]), num_ldexp(num_abs(d->eye[2]), -40)) <= 0;
    for (int32_t k = src->count - 1; k >= 0 && cam->perspective; k--) {
        if (!depth_of(d, k, &depth)) continue;
        num_t way = num_sub(depth, d->eye[1]);
        if (num_sign(way) <= 0) return ERR_EMPTY;
        d->nearest = num_add(d->eye[1], num_ldexp(way, -NEAREST_BITS));
        break;
    }
    for (int32_t k = 0; k < src->count; k++) {
        if (!depth_of(d, k, &depth)) continue;
        int32_t n = src->points(src->ctx, k);
        for (int32_t i = 0; i < n; i++) {
            num_t p[3];
            src->point(src->ctx, k, i, p);
            if (p[2].undef) continue;
            stretch(u, dot(src->side, p), !any);
            stretch(v, depth, !any);
            stretch(z, p[2], !any);
            any = true;
        }
    }
    if (!any) return ERR_EMPTY;
    if (!d->flat) plane_init(&d->plane, cam->perspective, u, v, z, d->eye);
    return 0;
}

static int draw_profile(drawing_t *d, int32_t k, num_t depth) {
    const profiles_t *src = d->src;
    const plane_t *plane = &d->plane;
    const int32_t n = src->points(src->ctx, k);
    const int32_t q = d->flat ? 0 : plane_u_of_v(plane, depth), s = d->flat ? 0 : plane_z_of_v(plane, depth);
    const uint32_t r = plane->perspective ? plane_reciprocal(plane, depth) : 0;
    pencil_t last = {0, 0};
    bool defined = false;
    int err = 0;
    d->line = k;
    for (int32_t i = 0; i < n && err == 0; i++) {
        num_t p[3];
        src->point(src->ctx, k, i, p);
        const bool joins = defined;
        defined = !p[2].undef;
        if (!defined) continue;
        pencil_t at = {0, 0};
        if (!d->flat) {
            at = (pencil_t){plane_u(plane, dot(src->side, p)) + q, plane_z(plane, p[2]) + s};
            if (plane->perspective) at = (pencil_t){plane_project(at.a, r), plane_project(at.w, r)};
        }
        d->cell = i - 1;
        if (joins) {
            d->segments++;
            err = hidden_pause(d->pause);
            if (err == 0)
                err = d->flat ? take_part(d, (envelope_part_t){.to_q30 = 1 << 30}, false)
                              : horizons_clip(&d->horizons, last, at);
        }
        last = at;
    }
    return err != 0 ? err : runs_flush(&d->runs, &d->run, INK_PROFILE, k);
}

size_t horizon_bytes(int32_t vertices) {
    return HIDDEN_LENT(drawing_t) + (size_t)vertices * sizeof(pencil_t);
}

int horizon_draw(const profiles_t *src, const camera_t *cam, bool infinite, const hidden_job_t *job,
                 hidden_stats_t *stats) {
    hidden_job_t rest = *job;
    HIDDEN_STATE(drawing_t, d, rest);
    if (d == NULL) return ERR_FULL;
    memset(d, 0, sizeof *d);
    d->src = src;
    d->pause = job->pause;
    d->runs.sink = job->sink;
    *stats = (hidden_stats_t){0};
    int err = horizons_init(&d->horizons, true, !infinite, rest.mem, rest.bytes / sizeof(pencil_t), take_part, d);
    if (err == 0) err = measure(d, cam);
    int32_t k = 0;
    for (; k < src->count && err == 0; k++) {
        num_t depth;
        if (depth_of(d, k, &depth)) err = draw_profile(d, k, depth);
        if (err == 0 && job->tick != NULL) job->tick(job->tick_ctx, k + 1, src->count);
    }
    stats->facets = stats->edges = d->segments;
    stats->tests = d->horizons.count.tests;
    stats->crossings = d->horizons.count.crossings;
    stats->pieces = d->runs.pieces;
    stats->peak_upper = d->horizons.upper.peak;
    stats->peak_lower = infinite ? 0 : d->horizons.lower.peak;
    if (err == ERR_FULL && k > 0) /* horizons grow slower and slower */
        stats->needs =
            job->bytes + (size_t)((uint64_t)job->bytes * (uint32_t)(src->count - k) / (uint32_t)(src->count + k));
    stats->bytes = (size_t)(stats->peak_upper + stats->peak_lower) * sizeof(pencil_t) + HIDDEN_LENT(drawing_t);
    return err;
}
