/* edges_segment.c - a line of a facet's hatching against what is covered so far; see edges.h. */
#include "hidden/surface/edges_parts.h"

/* Where a value that goes from v0 to v1 is zero, if it changes its sign in between. */
static int64_t change(int64_t v0, int64_t v1) {
    if ((v0 < 0) == (v1 < 0) || v0 == 0 || v1 == 0) return 0;
    const uint64_t n = (uint64_t)(v0 < 0 ? -v0 : v0), m = (uint64_t)(v1 < 0 ? -v1 : v1);
    return edges_fraction(n, n + m);
}

/* Cut where it passes from one quarter of the compass into the next. */
static int look_around(edges_t *e, const edges_segment_t *s) {
    const edges_place_t p = {s->x[0], s->y[0], s->z[0]}, q = {s->x[1], s->y[1], s->z[1]};
    int64_t cut[3] = {change((int64_t)p.x - p.y, (int64_t)q.x - q.y), change((int64_t)p.x + p.y, (int64_t)q.x + q.y),
                      INK_GRID_ONE};
    if (cut[0] > cut[1]) {
        int64_t keep = cut[0];
        cut[0] = cut[1], cut[1] = keep;
    }
    edges_place_t from = p;
    int64_t at = 0;
    for (int k = 0; k < 3; k++) {
        if (cut[k] <= at) continue;
        edges_place_t to = q;
        if (cut[k] != INK_GRID_ONE) { /* exactly on the diagonal */
            to = (edges_place_t){(int32_t)(p.x + edges_scale((int64_t)q.x - p.x, cut[k])),
                                 (int32_t)(p.y + edges_scale((int64_t)q.y - p.y, cut[k])),
                                 p.z + edges_scale(q.z - p.z, cut[k])};
            to.y = (to.x < 0) == (to.y < 0) ? to.x : -to.x;
        }
        int err = edges_clip_in_sector(e, from, to, at, cut[k]);
        if (err != 0) return err;
        from = to;
        at = cut[k];
    }
    return 0;
}

int edges_look_at(edges_t *e, const edges_segment_t *s, const ink_sink_t *sink) {
    const runs_t keep = e->runs;
    const edges_edge_t edge = e->edge;
    const enum edges_work work = e->work;
    run_t run = {0, 0};
    e->runs = (runs_t){.sink = sink};
    e->edge = (edges_edge_t){.family = INK_CURVE, .run = &run, .g0 = s->g[0], .g1 = s->g[1], .way_q46 = INK_GRID_ONE};
    e->work = EDGES_LOOK;
    e->horizons.in_plane = false;
    int err = e->chart.kind == CHART_AROUND ? look_around(e, s) : edges_clip_line(e, s->at[0], s->at[1]);
    if (err == 0) err = runs_flush(&e->runs, &run, INK_CURVE, 0);
    e->work = work;
    e->edge = edge;
    e->runs = keep;
    return err;
}
