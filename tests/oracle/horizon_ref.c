/* Segments against segments: the part of one that is to the right of the other's left end, to the left of its right
 * end, and below (above) the plane through the eye and the other. Each condition is linear along the segment. */
#include "tests/oracle/horizon_ref.h"

bool horizon_ref_edge_exists(const horizon_ref_t *r, int profile, int k) {
    int at = r->first[profile] + k;
    return !r->gap || (!r->gap[at] && !r->gap[at + 1]);
}

/* Visits each segment c of the nearer profiles with the part `at` of the segment that it is in front of. */
typedef void visit_fn(const horizon_ref_t *r, const exact_point_t c[2], span_t at, void *ctx);

static void visit_nearer(const horizon_ref_t *r, int profile, const exact_point_t end[2], visit_fn *visit, void *ctx) {
    for (int q = 0; q < profile; q++)
        for (int k = 0; k + 1 < r->first[q + 1] - r->first[q]; k++) {
            if (!horizon_ref_edge_exists(r, q, k)) continue;
            const exact_point_t *c = r->point + r->first[q] + k;
            long double l0 = exact_side(&r->eye, &c[0], &end[0]), l1 = exact_side(&r->eye, &c[0], &end[1]);
            if (l0 >= 0 && l1 >= 0) break; /* the rest of this profile is further to the right */
            span_t at = {0, 1};
            span_keep_positive(&at, -l0, -l1);
            span_keep_positive(&at, exact_side(&r->eye, &c[1], &end[0]), exact_side(&r->eye, &c[1], &end[1]));
            if (at.a < at.b) visit(r, c, at, ctx);
        }
}

typedef struct bands {
    const exact_point_t *end;
    spans_t below, above;
} bands_t;

static void visit_bands(const horizon_ref_t *r, const exact_point_t c[2], span_t at, void *ctx) {
    bands_t *b = ctx;
    long double v0 = exact_plane(&r->eye, &c[0], &c[1], &b->end[0]),
                v1 = exact_plane(&r->eye, &c[0], &c[1], &b->end[1]);
    span_t low = at, high = at;
    span_keep_positive(&low, v0, v1);
    span_keep_positive(&high, -v0, -v1);
    spans_add(&b->below, low.a, low.b);
    spans_add(&b->above, high.a, high.b);
}

void horizon_ref_segment(const horizon_ref_t *r, int profile, const exact_point_t end[2], spans_t *hidden) {
    bands_t b = {.end = end};
    visit_nearer(r, profile, end, visit_bands, &b);
    spans_tidy(&b.below);
    spans_tidy(&b.above);
    if (r->infinite)
        spans_copy(&b.below, hidden);
    else
        spans_intersect(&b.below, &b.above, hidden);
    spans_free(&b.below);
    spans_free(&b.above);
}

typedef struct doubling {
    const exact_point_t *moved, *other;
    spans_t *out;
} doubling_t;

static void visit_doubled(const horizon_ref_t *r, const exact_point_t c[2], span_t at, void *ctx) {
    const doubling_t *d = ctx;
    long double u[2], v[2];
    for (int s = 0; s < 2; s++) {
        u[s] = exact_plane(&r->eye, &c[0], &c[1], &d->moved[s]);
        v[s] = exact_plane(&r->eye, &c[0], &c[1], &d->other[s]);
    }
    for (int s = -1; s <= 1; s += 2) {
        span_t t = at;
        span_keep_positive(&t, s * u[0], s * u[1]);
        span_keep_positive(&t, -s * v[0], -s * v[1]);
        spans_add(d->out, t.a, t.b);
    }
}

void horizon_ref_doubled(const horizon_ref_t *r, int profile, const exact_point_t end[2], const exact_point_t moved[2],
                         const exact_point_t other[2], spans_t *out) {
    doubling_t d = {moved, other, out};
    spans_clear(out);
    visit_nearer(r, profile, end, visit_doubled, &d);
    spans_tidy(out);
}
