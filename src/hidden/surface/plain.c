/* plain.c - see plain.h. */
#include "hidden/surface/plain.h"

static int emit(const ink_sink_t *sink, const ink_piece_t *line, int32_t from, int32_t to) {
    ink_piece_t p = *line;
    p.from = from * INK_GRID_ONE;
    p.to = to * INK_GRID_ONE;
    return sink->piece(sink->ctx, &p);
}

/* Is point `at` of line `line` defined? False beyond the grid. */
static bool is_defined(grid_t *g, uint8_t family, int32_t line, int32_t at) {
    int32_t i = family == INK_ROW ? at : line, j = family == INK_ROW ? line : at, zi;
    return i >= 0 && j >= 0 && i < g->nx && j < g->ny && grid_height(g, i, j, &zi);
}

static bool edge_is_defined(grid_t *g, uint8_t family, int32_t line, int32_t at) {
    return is_defined(g, family, line, at) && is_defined(g, family, line, at + 1);
}

/* The part of the edge from point `at` on that is drawn. Of one with a point beyond the limits of heights it is that up
 * to the limit; none of one with two, as gnuplot has it: through a pole no line is drawn. */
static bool edge_part(grid_t *g, const ink_piece_t *line, int32_t at, int64_t *from, int64_t *to) {
    bool row = line->family == INK_ROW, a_in = is_defined(g, line->family, line->line, at),
         b_in = is_defined(g, line->family, line->line, at + 1);
    const int32_t a[2] = {row ? at : line->line, row ? line->line : at}, b[2] = {a[0] + row, a[1] + !row};
    *from = at * INK_GRID_ONE;
    *to = *from + INK_GRID_ONE;
    if (a_in && b_in) return true;
    num_t limit;
    int64_t s_q46;
    if (a_in == b_in || !grid_edge_limit(g, a_in ? a : b, a_in ? b : a, &limit, &s_q46)) return false;
    if (a_in)
        *to = *from + s_q46;
    else
        *from = *to - s_q46;
    return s_q46 > 0;
}

/* One line that goes on to the limits which it crosses. */
static int draw_to_limits(grid_t *g, const ink_piece_t *line, int32_t points, const ink_sink_t *sink) {
    ink_piece_t p = *line;
    int64_t from, to;
    p.from = p.to = 0; /* the run under way; none if equal */
    for (int32_t k = 0; k < points - 1; k++) {
        if (!edge_part(g, line, k, &from, &to)) continue;
        if (from == p.to && p.from < p.to) {
            p.to = to;
            continue;
        }
        int err = p.from < p.to ? sink->piece(sink->ctx, &p) : 0;
        if (err) return err;
        p.from = from;
        p.to = to;
    }
    return p.from < p.to ? sink->piece(sink->ctx, &p) : 0;
}

/* One line with holes: the runs of edges that exist. */
static int draw_interrupted(grid_t *g, const ink_piece_t *line, int32_t points, bool facets, const ink_sink_t *sink) {
    int32_t start = -1;
    for (int32_t k = 0; k < points; k++) {
        bool edge = k < points - 1 && edge_is_defined(g, line->family, line->line, k);
        if (edge && facets)
            edge = edge_is_defined(g, line->family, line->line - 1, k) ||
                   edge_is_defined(g, line->family, line->line + 1, k);
        if (edge && start < 0) start = k;
        if (edge || start < 0) continue;
        int err = emit(sink, line, start, k);
        if (err) return err;
        start = -1;
    }
    return 0;
}

int plain_draw(grid_t *g, uint8_t family, bool facets, uint8_t surface, const ink_sink_t *sink) {
    int32_t lines = family == INK_ROW ? g->ny : g->nx, points = family == INK_ROW ? g->nx : g->ny;
    for (int32_t k = 0; k < lines; k++) {
        ink_piece_t line = {.family = family, .surface = surface, .line = k};
        int err = !g->holes ? emit(sink, &line, 0, points - 1)
                  : g->to_limits && !facets && (g->below || g->above)
                      ? draw_to_limits(g, &line, points, sink)
                      : draw_interrupted(g, &line, points, facets, sink);
        if (err) return err;
    }
    return 0;
}
