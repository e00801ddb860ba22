/* What the judge can be asked about: grid surfaces and profiles. */
#include "tests/oracle/judge.h"

static int surface_lines(const void *ref, int family) {
    const surface_ref_t *r = ref;
    return family == REF_ROW ? r->ny : r->nx;
}
static int surface_edges(const void *ref, int family, int line) {
    (void)line;
    return surface_lines(ref, !family) - 1;
}
static bool surface_exists(const void *ref, int family, int line, int k) {
    return surface_ref_edge_exists(ref, family, line, k);
}
static void surface_ends(const void *ref, int family, int line, int k, exact_point_t end[2]) {
    surface_ref_edge_ends(ref, family, line, k, end);
}
static void surface_look(const void *ref, int family, int line, int k, spans_t *hidden, spans_t *either) {
    surface_ref_edge(ref, family, line, k, hidden, either);
}
static void surface_moved(const void *ref, int family, int line, int k, const exact_point_t at[2], spans_t *hidden) {
    surface_ref_moved(ref, family, line, k, at, hidden);
}
static void surface_doubled(const void *ref, int family, int line, int k, const exact_point_t at[2],
                            const exact_point_t other[2], spans_t *out) {
    surface_ref_doubled(ref, family, line, k, at, other, out);
}

judge_subject_t judge_surface(const surface_ref_t *r) {
    return (judge_subject_t){.ref = r,
                             .lines = surface_lines,
                             .edges = surface_edges,
                             .exists = surface_exists,
                             .ends = surface_ends,
                             .look = surface_look,
                             .moved = surface_moved,
                             .doubled = surface_doubled};
}

static int profile_lines(const void *ref, int family) {
    return family ? 0 : ((const horizon_ref_t *)ref)->count;
}
static int profile_edges(const void *ref, int family, int line) {
    const horizon_ref_t *r = ref;
    (void)family;
    return r->first[line + 1] - r->first[line] - 1;
}
static bool profile_exists(const void *ref, int family, int line, int k) {
    (void)family;
    return horizon_ref_edge_exists(ref, line, k);
}
static void profile_ends(const void *ref, int family, int line, int k, exact_point_t end[2]) {
    const horizon_ref_t *r = ref;
    (void)family;
    for (int s = 0; s < 2; s++) end[s] = r->point[r->first[line] + k + s];
}
static void profile_look(const void *ref, int family, int line, int k, spans_t *hidden, spans_t *either) {
    exact_point_t end[2];
    profile_ends(ref, family, line, k, end);
    horizon_ref_segment(ref, line, end, hidden);
    spans_clear(either);
}
static void profile_moved(const void *ref, int family, int line, int k, const exact_point_t at[2], spans_t *hidden) {
    (void)family, (void)k;
    horizon_ref_segment(ref, line, at, hidden);
}
static void profile_doubled(const void *ref, int family, int line, int k, const exact_point_t at[2],
                            const exact_point_t other[2], spans_t *out) {
    exact_point_t end[2];
    profile_ends(ref, family, line, k, end);
    horizon_ref_doubled(ref, line, end, at, other, out);
}

judge_subject_t judge_horizon(const horizon_ref_t *r) {
    return (judge_subject_t){.ref = r,
                             .lines = profile_lines,
                             .edges = profile_edges,
                             .exists = profile_exists,
                             .ends = profile_ends,
                             .look = profile_look,
                             .moved = profile_moved,
                             .doubled = profile_doubled};
}
