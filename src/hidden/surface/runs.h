/* runs.h - visible intervals of grid lines, joined while the sweep goes on.
 *
 * The sweep meets a grid line one edge after the other, outward from the eye's cell. An interval that begins where
 * the last one of its line ended (or ends where it began) makes that one longer; only what cannot be joined is
 * given to the sink. One open run per column, two per row of facets. */
#ifndef RUNS_H
#define RUNS_H

#include "hidden/ink.h"

/* from == to: no run is open. */
typedef struct run {
    int64_t from, to;
} run_t;

typedef struct runs {
    const ink_sink_t *sink;
    uint8_t surface; /* what pieces are marked with */
    int64_t pieces;  /* given to the sink */
} runs_t;

/* Closes the run and gives it to the sink. Returns 0 or the sink's error. */
int runs_flush(runs_t *r, run_t *run, uint8_t family, int32_t line);

/* Adds the interval [from, to), from < to. Returns 0 or the sink's error. */
static inline int runs_add(runs_t *r, run_t *run, uint8_t family, int32_t line, int64_t from, int64_t to) {
    if (run->to == from && run->from != run->to) {
        run->to = to;
        return 0;
    }
    if (run->from == to && run->from != run->to) {
        run->from = from;
        return 0;
    }
    int err = runs_flush(r, run, family, line);
    *run = (run_t){from, to};
    return err;
}

#endif
