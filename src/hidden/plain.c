/* plain.c - see plain.h. */
#include "hidden/plain.h"

static int emit(const ink_sink_t *sink, const ink_piece_t *line, int32_t from, int32_t to) {
    if (to <= from) return 0; /* a single defined point between holes is no line */
    ink_piece_t p = *line;
    p.from_q30 = from * INK_ONE;
    p.to_q30 = to * INK_ONE;
    return sink->piece(sink->ctx, &p);
}

/* One line with holes: the runs of defined points. */
static int draw_interrupted(grid_t *g, const ink_piece_t *line, int32_t points, const ink_sink_t *sink) {
    int32_t start = -1;
    for (int32_t k = 0; k < points; k++) {
        int32_t zi;
        bool defined =
            line->family == INK_ROW ? grid_height(g, k, line->line, &zi) : grid_height(g, line->line, k, &zi);
        if (defined && start < 0) start = k;
        if (!defined && start >= 0) {
            int err = emit(sink, line, start, k - 1);
            if (err) return err;
            start = -1;
        }
    }
    return start < 0 ? 0 : emit(sink, line, start, points - 1);
}

int plain_draw(grid_t *g, uint8_t family, uint8_t surface, const ink_sink_t *sink) {
    int32_t lines = family == INK_ROW ? g->ny : g->nx, points = family == INK_ROW ? g->nx : g->ny;
    for (int32_t k = 0; k < lines; k++) {
        ink_piece_t line = {.family = family, .surface = surface, .line = k};
        int err = g->holes ? draw_interrupted(g, &line, points, sink) : emit(sink, &line, 0, points - 1);
        if (err) return err;
    }
    return 0;
}
