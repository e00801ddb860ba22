/* run.h - a run: a maximal visible interval of one line, packed into 20 bytes.
 *
 * Runs are what the pool holds instead of points: an interval of a grid line costs the same whether it crosses
 * one cell or two thousand, and its vertices are computed again when the pen gets there.
 * Ranges: 0 <= t < 2^52 (q30, so a line has up to 2^22 vertices), family < 16. */
#ifndef RUN_H
#define RUN_H

#include "hidden/ink.h"
#include <stdbool.h>
#include <stddef.h>

#define RUN_T_LIMIT ((int64_t)1 << 52)
#define RUN_HI_BITS 20

typedef struct run {
    uint32_t from_lo;
    uint32_t from_hi; /* bits 0-19 of the parameter, then surface (8), then family (4) */
    uint32_t to_lo;
    uint32_t to_hi; /* bits 0-19 of the parameter, then flags */
    int32_t line;
} run_t;

_Static_assert(sizeof(run_t) == 20, "the pool's arithmetic counts on 20 bytes to a run");

#define RUN_SEEN (1u << 31)  /* flag in to_hi: passed by the walk that is going on */
#define RUN_DRAWN (1u << 30) /* flag in to_hi: has been drawn, may be forgotten */

static inline run_t run_pack(const ink_piece_t *p) {
    run_t r;
    r.from_lo = (uint32_t)p->from_q30;
    r.from_hi =
        (uint32_t)(p->from_q30 >> 32) | (uint32_t)p->surface << RUN_HI_BITS | (uint32_t)p->family << (RUN_HI_BITS + 8);
    r.to_lo = (uint32_t)p->to_q30;
    r.to_hi = (uint32_t)(p->to_q30 >> 32);
    r.line = p->line;
    return r;
}

static inline uint8_t run_family(const run_t *r) {
    return (uint8_t)(r->from_hi >> (RUN_HI_BITS + 8));
}
static inline uint8_t run_surface(const run_t *r) {
    return (uint8_t)(r->from_hi >> RUN_HI_BITS);
}

/* The parameter of an end: side 0 is `from`, 1 is `to`. */
static inline int64_t run_t_of(const run_t *r, int side) {
    uint32_t hi = (side ? r->to_hi : r->from_hi) & ((1u << RUN_HI_BITS) - 1);
    return (int64_t)((uint64_t)hi << 32 | (side ? r->to_lo : r->from_lo));
}

static inline void run_set_t(run_t *r, int side, int64_t t) {
    uint32_t keep = ~((1u << RUN_HI_BITS) - 1);
    if (side) {
        r->to_lo = (uint32_t)t;
        r->to_hi = (r->to_hi & keep) | (uint32_t)(t >> 32);
    } else {
        r->from_lo = (uint32_t)t;
        r->from_hi = (r->from_hi & keep) | (uint32_t)(t >> 32);
    }
}

/* Are two runs intervals of one and the same line? */
static inline bool run_same_line(const run_t *a, const run_t *b) {
    return a->line == b->line && a->from_hi >> RUN_HI_BITS == b->from_hi >> RUN_HI_BITS;
}

#endif
