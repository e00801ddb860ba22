/* grid_outline.c - see grid_outline.h. */
#include "hidden/surface/grid_outline.h"

#include "config.h"
#include "num/ints.h"

#if CONFIG_AREA

static bool vertex(const line_space_t *s, int32_t i, int32_t j, page_point_t *p, int64_t *e) {
    page_h_t h;
    if (!s->at(s->ctx, INK_ROW, j, i * INK_GRID_ONE, &h)) return false;
    if (s->perspective && h.e < s->near_e) return false;
    *p = line_space_divide(s, &h);
    *e = h.e;
    return true;
}

/* > 0: c is to the left of the way from a to b. */
static int64_t turn(page_point_t a, page_point_t b, page_point_t c) {
    return ((int64_t)b.x_lat - a.x_lat) * ((int64_t)c.y_lat - a.y_lat) -
           ((int64_t)b.y_lat - a.y_lat) * ((int64_t)c.x_lat - a.x_lat);
}

/* Of a cell at an edge: which way its facet runs on the page, as seen beside the edge, before `split` and behind it.
 * Both 0: there is no facet. A cell that is twisted enough shows as two triangles tip to tip, of which one runs the
 * other way; where the edge passes through the tip it is at both. */
typedef struct cell_side {
    int before, behind;
    int64_t split; /* q46 of the edge; 0: all is behind */
} cell_side_t;

typedef struct edge_at {
    int32_t i, j, surface;
    bool row;
    page_point_t p[2]; /* its ends */
    int64_t e[2];
} edge_at_t;

static bool grid_corner(const grid_outline_t *o, const edge_at_t *e, int32_t along, int32_t across, page_point_t *p,
                        int64_t *at_e) {
    const grid_t *g = &o->grid[e->surface];
    const int32_t i = e->i + (e->row ? along : across), j = e->j + (e->row ? across : along);
    return i >= 0 && j >= 0 && i < g->nx && j < g->ny && vertex(&o->lines[e->surface], i, j, p, at_e);
}

static int sign_of(int64_t turn) {
    return turn < 0 ? -1 : 1;
}

/* The place on the edge that divides its picture as p to q, which have one sign. */
static int64_t place_of(const edge_at_t *e, int64_t p, int64_t q) {
    const int64_t u = ints_muldiv_round(INK_ONE, p, p + q);
    return line_space_share(u, INK_ONE - u, e->e[0], e->e[1], INK_GRID_ONE);
}

/* across: 1 for the cell behind the edge's line, -1 for the one before it. Apart for the stack. */
static __attribute__((noinline)) cell_side_t side_of(const grid_outline_t *o, const edge_at_t *e, int32_t across) {
    const page_point_t a = e->p[0], b = e->p[1];
    page_point_t c, d;
    int64_t any;
    if (!grid_corner(o, e, 1, across, &c, &any) || !grid_corner(o, e, 0, across, &d, &any))
        return (cell_side_t){0, 0, 0};
    const int64_t abc = turn(a, b, c) / 2, abd = turn(a, b, d) / 2, acd = turn(a, c, d) / 2, bcd = turn(b, c, d) / 2;
    const int up = e->row ? across : -across; /* 1: a b c d runs like the columns and rows */
    if ((abc < 0) != (abd < 0) && (acd < 0) != (bcd < 0))
        return (cell_side_t){up * sign_of(abd), up * sign_of(abc), place_of(e, acd, -bcd)};
    const bool tip_to_tip = (bcd < 0) != (abc < 0) && (abd < 0) != (acd < 0);
    const int side = up * sign_of(tip_to_tip ? abc : abc + acd);
    return (cell_side_t){side, side, 0};
}

/* The cells on both sides of an edge. */
static void look_at(const grid_outline_t *o, const ink_piece_t *p, int32_t cell, cell_side_t side[2]) {
    const bool row = p->family == INK_ROW;
    edge_at_t e = {.i = row ? cell : p->line, .j = row ? p->line : cell, .surface = p->surface, .row = row};
    side[0] = side[1] = (cell_side_t){0, 0, 0};
    for (int k = 0; k < 2; k++)
        if (!grid_corner(o, &e, k, 0, &e.p[k], &e.e[k])) return;
    for (int k = 0; k < 2; k++) side[k] = side_of(o, &e, k ? -1 : 1);
}

/* Parts shorter than this are rounding. */
#define LEAST_PART (INK_GRID_ONE >> 12)

/* Is the part of the edge that begins at t, from one split to the next, an outline? *to: where it ends. */
static bool is_outline(const cell_side_t side[2], int64_t t, int64_t *to) {
    int runs[2];
    for (int k = 0; k < 2; k++) {
        const cell_side_t *s = &side[k];
        const bool before = t + LEAST_PART < s->split;
        runs[k] = before ? s->before : s->behind;
        if (before && s->split + LEAST_PART < *to) *to = s->split;
    }
    return runs[0] != runs[1];
}

static int take(void *ctx, const ink_piece_t *p) {
    const grid_outline_t *o = ctx;
    if (p->family != INK_ROW && p->family != INK_COL) return o->next.piece(o->next.ctx, p);
    ink_piece_t run = *p;
    run.to = run.from;
    cell_side_t side[2] = {{0, 0, 0}, {0, 0, 0}};
    int64_t known = -1;
    for (int64_t at = p->from, to; at < p->to; at = to) {
        const int64_t cell = at >> INK_GRID_BITS, start = cell << INK_GRID_BITS;
        if (cell != known) look_at(o, p, (int32_t)cell, side), known = cell;
        int64_t end = ink_next(p->family, at, p->to) - start;
        const bool keep = is_outline(side, at - start, &end);
        to = start + end;
        if (keep) run.to = to;
        if (run.to > run.from && (!keep || to == p->to)) {
            int err = o->next.piece(o->next.ctx, &run);
            if (err) return err;
        }
        if (!keep) run.from = run.to = to;
    }
    return 0;
}

ink_sink_t grid_outline_sink(grid_outline_t *o) {
    return (ink_sink_t){o, take};
}

#endif
