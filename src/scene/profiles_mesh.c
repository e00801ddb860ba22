/* profiles_mesh.c - see profiles_mesh.h. */
#include "scene/profiles_mesh.h"

#include "error.h"

/* One triangle's part of a profile, from left to right. */
typedef struct profiles_cut {
    int64_t u[2];       /* across the view, in units of 2^-bits */
    packed_t end[2][3]; /* x, y, z */
} profiles_cut_t;

_Static_assert(sizeof(profiles_cut_t) + 3 * sizeof(int32_t) == PROFILES_MESH_SEGMENT, "what the header promises");

static num_t coordinate(const profiles_mesh_t *s, int32_t v, int axis) {
    return packed_num(s->mesh->vertex[v][axis]);
}

static num_t dot(const num_t a[2], num_t x, num_t y) {
    return num_add(num_mul(a[0], x), num_mul(a[1], y));
}

/* Depth of profile k, in units: nearest + range * (2 k + 1) / (2 count). range < 2^60, so it is divided first. */
static int64_t depth_of(const profiles_mesh_t *s, int32_t k) {
    int64_t part = s->range / (2 * (int64_t)s->count), rest = s->range % (2 * (int64_t)s->count);
    int64_t odd = 2 * (int64_t)k + 1;
    return s->nearest + part * odd + rest * odd / (2 * (int64_t)s->count);
}

/* Where the plane at depth d crosses the edge between vertices a and b; a is before it, b not. The same edge gives the
 * same point from either of its triangles. */
static void cross_edge(const profiles_mesh_t *s, int64_t d, int32_t a, int32_t b, profiles_cut_t *c, int end) {
    num_t t = num_div(num_from_i64(d - s->depth[a]), num_from_i64(s->depth[b] - s->depth[a]));
    num_t at[3];
    for (int axis = 0; axis < 3; axis++) {
        num_t from = coordinate(s, a, axis);
        at[axis] = num_add(from, num_mul(t, num_sub(coordinate(s, b, axis), from)));
        c->end[end][axis] = packed_from_num(at[axis]);
    }
    c->u[end] = num_to_fixed(dot(s->side, at[0], at[1]), s->bits, NULL);
}

static bool cut_triangle(const profiles_mesh_t *s, int64_t d, const int32_t v[3], profiles_cut_t *c) {
    int ends = 0;
    for (int k = 0; k < 3; k++) {
        int32_t a = v[k], b = v[(k + 1) % 3];
        bool a_before = s->depth[a] < d, b_before = s->depth[b] < d;
        if (a_before == b_before) continue;
        cross_edge(s, d, a_before ? a : b, a_before ? b : a, c, ends++);
    }
    if (ends == 0) return false;
    if (c->u[1] < c->u[0]) {
        profiles_cut_t turned = *c;
        for (int end = 0; end < 2; end++) {
            c->u[end] = turned.u[1 - end];
            for (int axis = 0; axis < 3; axis++) c->end[end][axis] = turned.end[1 - end][axis];
        }
    }
    return c->u[0] < c->u[1];
}

/* Shell sort by the left end: no recursion, no extra memory. */
static void sort_cuts(profiles_cut_t *c, int32_t n) {
    for (int32_t gap = n / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11) {
        for (int32_t i = gap; i < n; i++) {
            profiles_cut_t moved = c[i];
            int32_t j = i;
            for (; j >= gap && c[j - gap].u[0] > moved.u[0]; j -= gap) c[j] = c[j - gap];
            c[j] = moved;
        }
    }
}

/* Makes profile k the one at hand. */
static void cut_mesh(profiles_mesh_t *s, int32_t k) {
    if (s->at == k) return;
    const int64_t d = depth_of(s, k);
    s->at = k;
    s->segments = s->vertices = 0;
    mesh_walk_t w = mesh_walk(s->mesh);
    for (int32_t f[3]; s->segments < s->capacity && mesh_triangle(&w, f);)
        s->segments += cut_triangle(s, d, f, &s->cut[s->segments]);
    sort_cuts(s->cut, s->segments);
    for (int32_t m = 0; m < s->segments; m++) {
        const profiles_cut_t *c = &s->cut[m];
        const int32_t last = s->vertices > 0 ? s->vertex[s->vertices - 1] : -1;
        if (last >= 0 && c->u[0] < s->cut[last / 2].u[1]) continue; /* overlaps: the file's mistake */
        if (last < 0 || c->u[0] != s->cut[last / 2].u[1]) {
            if (last >= 0) s->vertex[s->vertices++] = -1;
            s->vertex[s->vertices++] = 2 * m;
        }
        s->vertex[s->vertices++] = 2 * m + 1;
    }
}

static int32_t mesh_points(void *ctx, int32_t k) {
    profiles_mesh_t *s = ctx;
    cut_mesh(s, k);
    return s->vertices;
}

static void mesh_point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    profiles_mesh_t *s = ctx;
    cut_mesh(s, k);
    const bool gap = s->vertex[v] < 0;
    const int32_t at = gap ? s->vertex[v - 1] : s->vertex[v]; /* a gap is where the segment before it ended */
    for (int axis = 0; axis < 3; axis++) xyz[axis] = packed_num(s->cut[at / 2].end[at % 2][axis]);
    if (gap) xyz[2] = num_undef();
}

/* The most triangles that one plane meets; starts[0..count] is scratch. */
static int32_t fullest_profile(const profiles_mesh_t *s, int32_t *starts) {
    int32_t now = 0, most = 0;
    for (int32_t k = 0; k <= s->count; k++) starts[k] = 0;
    mesh_walk_t w = mesh_walk(s->mesh);
    for (int32_t f[3]; mesh_triangle(&w, f);) {
        int64_t lo = INT64_MAX, hi = INT64_MIN;
        for (int e = 0; e < 3; e++) {
            int64_t d = s->depth[f[e]];
            lo = d < lo ? d : lo;
            hi = d > hi ? d : hi;
        }
        /* The planes with lo < depth <= hi: found by bisection, since depth_of rounds. */
        int32_t first = 0, beyond = 0;
        for (int32_t step = 1 << 30; step > 0; step >>= 1) {
            if (first + step <= s->count && depth_of(s, first + step - 1) <= lo) first += step;
            if (beyond + step <= s->count && depth_of(s, beyond + step - 1) <= hi) beyond += step;
        }
        if (first < beyond) {
            starts[first]++;
            starts[beyond]--;
        }
    }
    for (int32_t k = 0; k < s->count; k++) {
        now += starts[k];
        most = now > most ? now : most;
    }
    return most;
}

/* Scale of depths and of positions across: the largest coordinate, and twice that, in less than 2^60 units. */
static int16_t scale_of(const profiles_t *p, const num_t lo[2], const num_t hi[2]) {
    num_t most = num_from_i64(0);
    for (int k = 0; k < 4; k++) {
        num_t x = k & 1 ? hi[0] : lo[0], y = k >> 1 ? hi[1] : lo[1];
        num_t d = num_abs(dot(p->away, x, y)), u = num_abs(dot(p->side, x, y));
        most = num_cmp(d, most) > 0 ? d : most;
        most = num_cmp(u, most) > 0 ? u : most;
    }
    return (int16_t)(most.m == 0 ? 0 : 59 - 63 - most.e);
}

int profiles_from_mesh(profiles_t *p, profiles_mesh_t *s, const mesh_t *mesh, const camera_t *cam, int32_t count,
                       void *mem, size_t bytes) {
    num_t lo[2], hi[2];
    if (count < 1) return ERR_VALUE;
    if (mesh->faces < 1) return ERR_EMPTY;
    *s = (profiles_mesh_t){.mesh = mesh, .count = count, .at = -1};
    const size_t depths = (size_t)mesh->nv * sizeof(int64_t), scratch = ((size_t)count + 1) * sizeof(int32_t);
    if (bytes < depths + scratch) return ERR_FULL;
    s->depth = mem;
    for (int32_t v = 0; v < mesh->nv; v++) {
        for (int axis = 0; axis < 2; axis++) {
            num_t a = coordinate(s, v, axis);
            if (v == 0 || num_cmp(a, lo[axis]) < 0) lo[axis] = a;
            if (v == 0 || num_cmp(a, hi[axis]) > 0) hi[axis] = a;
        }
    }
    *p = (profiles_t){.count = count, .ctx = s};
    p->points = mesh_points;
    p->point = mesh_point;
    profiles_frame(p, cam, (const num_t[2]){lo[0], hi[0]}, (const num_t[2]){lo[1], hi[1]});
    for (int k = 0; k < 2; k++) {
        s->side[k] = p->side[k];
        s->away[k] = p->away[k];
    }
    s->bits = scale_of(p, lo, hi);
    int64_t farthest = INT64_MIN;
    s->nearest = INT64_MAX;
    for (int32_t v = 0; v < mesh->nv; v++) {
        int64_t d = num_to_fixed(dot(s->away, coordinate(s, v, 0), coordinate(s, v, 1)), s->bits, NULL);
        s->depth[v] = d;
        s->nearest = d < s->nearest ? d : s->nearest;
        farthest = d > farthest ? d : farthest;
    }
    s->range = farthest - s->nearest;
    if (s->range <= 0) return ERR_EMPTY;
    uint8_t *rest = (uint8_t *)mem + depths;
    s->capacity = fullest_profile(s, (int32_t *)(void *)rest);
    if (bytes - depths < (size_t)s->capacity * PROFILES_MESH_SEGMENT) return ERR_FULL;
    s->cut = (profiles_cut_t *)(void *)rest;
    s->vertex = (int32_t *)(void *)(rest + (size_t)s->capacity * sizeof(profiles_cut_t));
    p->max_points = 3 * s->capacity;
    return 0;
}
