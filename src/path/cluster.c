/* cluster.c - see cluster.h. */
#include "path/cluster.h"
#include "path/dist.h"

#define STRAIGHT (1 << 29)
#define UNIT_BITS 13 /* of direction vectors */

/* The point that follows e into its run; false if the map does not know it. */
static bool point_ahead(const chain_t *c, int32_t e, page_point_t *out) {
    const run_t *r = &c->pool->run[e >> 1];
    int64_t t = run_t_of(r, e & 1), end = run_t_of(r, 1 - (e & 1));
    return c->map->point(c->map->ctx, run_family(r), run_surface(r), run_line(r), ink_next(run_family(r), t, end), out);
}

/* Unit vector (q13) from an end into its run. */
static void direction(const chain_t *c, int32_t e, int32_t v[2]) {
    page_point_t p;
    v[0] = v[1] = 0;
    if (!point_ahead(c, e, &p)) return;
    int32_t dx = p.x_lat - c->point[e].x_lat, dy = p.y_lat - c->point[e].y_lat;
    uint32_t length = dist_of(dx, dy);
    if (length == 0) return;
    v[0] = (int32_t)((int64_t)dx * (1 << UNIT_BITS) / length);
    v[1] = (int32_t)((int64_t)dy * (1 << UNIT_BITS) / length);
}

/* How straight it goes from run to run through the ends e and f: larger is straighter. */
static int32_t straightness(const chain_t *c, int32_t e, int32_t f, const int32_t ve[2], const int32_t vf[2]) {
    const run_t *a = &c->pool->run[e >> 1], *b = &c->pool->run[f >> 1];
    int32_t score = -(ve[0] * vf[0] + ve[1] * vf[1]);
    return run_same_line(a, b) && (e & 1) != (f & 1) ? score + STRAIGHT : score;
}

static void link_ends(pool_t *p, int32_t e, int32_t f) {
    p->mate[e] = f;
    p->mate[f] = e;
}

static bool goes_on(const chain_t *c, int32_t e, int32_t f) {
    return (e & 1) != (f & 1) && e >> 1 != f >> 1 && run_same_line(&c->pool->run[e >> 1], &c->pool->run[f >> 1]);
}

/* The only end of the cluster that goes on the line of end[i], or -1. */
static int line_mate(const chain_t *c, const int32_t *end, int n, int i) {
    int mate = -1;
    for (int j = 0; j < n; j++) {
        if (!goes_on(c, end[i], end[j])) continue;
        if (mate >= 0) return -1;
        mate = j;
    }
    return mate;
}

/* Pairs those that go on in one line, as long as there is no choice, which need no directions. Returns how many ends
 * are left. */
static int pair_lines(const chain_t *c, int32_t *end, int n) {
    for (int i = 0; i < n; i++) {
        int j = line_mate(c, end, n, i);
        if (j < i || line_mate(c, end, n, j) != i) continue;
        link_ends(c->pool, end[i], end[j]);
        int left = 0;
        for (int k = 0; k < n; k++) {
            if (k != i && k != j) end[left++] = end[k];
        }
        n = left;
        i--;
    }
    return n;
}

/* Pairs the ends of a cluster, straightest first. */
static void pair_straight(const chain_t *c, int32_t *end, int n) {
    int32_t v[CHAIN_CLUSTER][2];
    for (int i = 0; i < n; i++) direction(c, end[i], v[i]);
    for (;;) {
        int32_t best = INT32_MIN;
        int bi = -1, bj = -1;
        for (int i = 0; i < n; i++) {
            for (int j = i + 1; j < n; j++) {
                if (end[i] < 0 || end[j] < 0 || end[j] == pool_other_end(end[i])) continue;
                int32_t s = straightness(c, end[i], end[j], v[i], v[j]);
                if (s > best) best = s, bi = i, bj = j;
            }
        }
        if (bi < 0) return;
        link_ends(c->pool, end[bi], end[bj]);
        end[bi] = end[bj] = -1;
    }
}

void cluster_pair(const chain_t *c, int32_t *cluster, int n) {
    if (n > 2) n = pair_lines(c, cluster, n);
    if (n == 2 && cluster[0] != pool_other_end(cluster[1])) link_ends(c->pool, cluster[0], cluster[1]);
    if (n > 2) pair_straight(c, cluster, n);
}
