/* plain.c - see plain.h. */
#include "hidden/plain.h"

static int emit(const ink_sink_t *sink, const ink_piece_t *line, int32_t from, int32_t to) {
    ink_piece_t p = *line;
    p.from_q30 = from * INK_ONE;
    p.to_q30 = to * INK_ONE;
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
        int err = g->holes ? draw_interrupted(g, &line, points, facets, sink) : emit(sink, &line, 0, points - 1);
        if (err) return err;
    }
    return 0;
}
