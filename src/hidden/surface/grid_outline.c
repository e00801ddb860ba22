/* grid_outline.c - see grid_outline.h. */
#include "hidden/surface/grid_outline.h"

#include "config.h"

#if CONFIG_AREA

static bool vertex(const line_space_t *s, int32_t i, int32_t j, page_point_t *p) {
    page_h_t h;
    if (!s->at(s->ctx, INK_ROW, j, i * INK_GRID_ONE, &h)) return false;
    if (s->perspective && h.e < s->near_e) return false;
    *p = line_space_divide(s, &h);
    return true;
}

static int64_t turn(page_point_t a, page_point_t b, page_point_t c) {
    return ((int64_t)b.x_lat - a.x_lat) * ((int64_t)c.y_lat - a.y_lat) -
           ((int64_t)b.y_lat - a.y_lat) * ((int64_t)c.x_lat - a.x_lat);
}

/* Which way the facet of cell (i, j) runs on the page, 0: there is none. */
static int side_of(const grid_outline_t *o, int32_t surface, int32_t i, int32_t j) {
    const line_space_t *s = &o->lines[surface];
    page_point_t p[4];
    if (i < 0 || j < 0 || i + 1 >= o->grid[surface].nx || j + 1 >= o->grid[surface].ny) return 0;
    if (!vertex(s, i, j, &p[0]) || !vertex(s, i + 1, j, &p[1]) || !vertex(s, i + 1, j + 1, &p[2]) ||
        !vertex(s, i, j + 1, &p[3]))
        return 0;
    return turn(p[0], p[1], p[2]) / 2 + turn(p[0], p[2], p[3]) / 2 < 0 ? -1 : 1;
}

static bool is_outline(const grid_outline_t *o, const ink_piece_t *p, int32_t cell) {
    const bool row = p->family == INK_ROW;
    const int32_t i = row ? cell : p->line, j = row ? p->line : cell;
    return side_of(o, p->surface, i, j) != side_of(o, p->surface, row ? i : i - 1, row ? j - 1 : j);
}

static int take(void *ctx, const ink_piece_t *p) {
    const grid_outline_t *o = ctx;
    if (p->family != INK_ROW && p->family != INK_COL) return o->next.piece(o->next.ctx, p);
    ink_piece_t run = *p;
    run.to = run.from;
    for (int64_t at = p->from, to; at < p->to; at = to) {
        to = ink_next(p->family, at, p->to);
        const bool keep = is_outline(o, p, (int32_t)(at >> INK_GRID_BITS));
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
