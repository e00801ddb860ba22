/* runs.c - see runs.h. */
#include "hidden/surface/runs.h"

int runs_flush(runs_t *r, run_t *run, uint8_t family, int32_t line) {
    if (run->from == run->to) return 0;
    const ink_piece_t piece = {.family = family, .surface = r->surface, .line = line, .from = run->from, .to = run->to};
    *run = (run_t){0, 0};
    r->pieces++;
    return r->sink->piece(r->sink->ctx, &piece);
}
