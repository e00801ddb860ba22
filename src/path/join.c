/* join.c - a table of open runs, two to a line. See join.h. */
#include "path/join.h"

/* Gaps of less than this part of an edge (2^-4) are worth asking the map about: a gap that is wider has a quarter
 * step on the page only where a whole cell has four steps, and there nobody sees it. */
#define JOIN_GAP_BITS 4

static bool is_empty(const join_run_t *r) {
    return r->from > r->to;
}

static void make_empty(join_run_t *r) {
    r->from = 1;
    r->to = 0;
    r->line = -1;
    r->recent = false;
}

void join_init(join_t *j, void *mem, uint32_t pairs, int32_t gap_lat, const ink_map_t *map, ink_sink_t out) {
    j->run = mem;
    j->pairs = pairs;
    j->gap_lat = gap_lat;
    j->map = map;
    j->out = out;
    j->pieces = 0;
    for (uint32_t i = 0; i < 2 * (JOIN_ROW_PAIRS + pairs); i++) make_empty(&j->run[i]);
}

/* Are two parameters of p's line within the gap on the page? */
static bool is_near(const join_t *j, const ink_piece_t *p, int64_t s, int64_t t) {
    page_point_t a, b;
    if (!j->map->point(j->map->ctx, p->family, p->surface, p->line, s, &a)) return false;
    if (!j->map->point(j->map->ctx, p->family, p->surface, p->line, t, &b)) return false;
    int64_t dx = (int64_t)a.x_lat - b.x_lat, dy = (int64_t)a.y_lat - b.y_lat;
    return dx >= -j->gap_lat && dx <= j->gap_lat && dy >= -j->gap_lat && dy <= j->gap_lat &&
           dx * dx + dy * dy <= (int64_t)j->gap_lat * j->gap_lat;
}

/* Is a gap from s to t that is not wide to be closed? A node inside of it becomes a vertex of the run, so it has to be
 * near both ends: a spike that leaves the paper goes out and comes back within a quarter step of each other. */
static __attribute__((noinline)) bool is_gap_near(const join_t *j, const ink_piece_t *p, int64_t s, int64_t t) {
    const int64_t node = ink_next(p->family, s, t);
    if (node == t) return is_near(j, p, s, t);
    return is_near(j, p, s, node) && is_near(j, p, node, t);
}

static inline bool is_gap_small(const join_t *j, const ink_piece_t *p, int64_t s, int64_t t) {
    return (t - s) >> (ink_bits(p->family) - JOIN_GAP_BITS) == 0 && is_gap_near(j, p, s, t);
}

/* Extends r by p if it continues r at either end. */
static bool extend(const join_t *j, join_run_t *r, const ink_piece_t *p) {
    if (r->line != p->line || r->family != p->family || r->surface != p->surface || is_empty(r)) return false;
    if (p->from > r->to && !is_gap_small(j, p, r->to, p->from)) return false;
    if (r->from > p->to && !is_gap_small(j, p, p->to, r->from)) return false;
    if (p->from < r->from) r->from = p->from;
    if (p->to > r->to) r->to = p->to;
    return true;
}

static int close_run(join_t *j, join_run_t *r) {
    ink_piece_t p = {r->family, r->surface, r->line, r->from, r->to};
    if (is_empty(r)) return 0;
    make_empty(r);
    return j->out.piece(j->out.ctx, &p);
}

int join_piece(join_t *j, const ink_piece_t *p) {
    uint32_t pair = p->family == INK_ROW ? (uint32_t)p->line & (JOIN_ROW_PAIRS - 1)
                                         : JOIN_ROW_PAIRS + ((uint32_t)p->line & (j->pairs - 1));
    join_run_t *r = &j->run[2 * pair];
    j->pieces++;
    for (int side = 0; side < 2; side++) {
        if (!extend(j, &r[side], p)) continue;
        r[side].recent = true;
        r[1 - side].recent = false;
        return 0;
    }
    join_run_t *old = r[0].recent ? &r[1] : &r[0];
    int err = close_run(j, old);
    r[0].recent = r[1].recent = false;
    *old = (join_run_t){p->from, p->to, p->line, p->family, p->surface, true};
    return err;
}

int join_finish(join_t *j) {
    for (uint32_t i = 0; i < 2 * (JOIN_ROW_PAIRS + j->pairs); i++) {
        int err = close_run(j, &j->run[i]);
        if (err) return err;
    }
    return 0;
}
