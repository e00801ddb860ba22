/* runs.c - see runs.h. */
#include "hidden/runs.h"

int runs_flush(runs_t *r, run_t *run, uint8_t family, int32_t line) {
    if (run->from_q30 == run->to_q30) return 0;
    const ink_piece_t piece = {
        .family = family, .surface = r->surface, .line = line, .from_q30 = run->from_q30, .to_q30 = run->to_q30};
    *run = (run_t){0, 0};
    r->pieces++;
    return r->sink->piece(r->sink->ctx, &piece);
}
