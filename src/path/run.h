/* run.h - a run: a maximal visible interval of one line, packed into 20 bytes.
 *
 * Runs are what the pool holds instead of points: an interval of a grid line costs the same whether it crosses
 * one cell or two thousand, and its vertices are computed again when the pen gets there.
 * Ranges: 0 <= t < 2^62 (hidden/ink.h), |line| < 2^25, family < 8, surface < 32. */
#ifndef RUN_H
#define RUN_H

#include "hidden/ink.h"
#include <stdbool.h>
#include <stddef.h>

#define RUN_T_LIMIT ((int64_t)1 << 62)
#define RUN_HI_BITS 30
#define RUN_HI_MASK ((1u << RUN_HI_BITS) - 1)
#define RUN_KIND_BITS 6 /* of family and surface: what does not fit above the line number is above `from` */
#define RUN_LINE_LIMIT (INT32_C(1) << (31 - RUN_KIND_BITS))
#define RUN_SURFACES 32

typedef struct run {
    uint32_t from_lo;
    uint32_t from_hi; /* 30 bits of the parameter, then the upper two of family * 32 + surface */
    uint32_t to_lo;
    uint32_t to_hi; /* 30 bits of the parameter, then flags */
    uint32_t what;  /* the lower 6 bits of family * 32 + surface, then the line, signed */
} run_t;

_Static_assert(sizeof(run_t) == 20, "the pool's arithmetic counts on 20 bytes to a run");

#define RUN_SEEN (1u << 31)  /* flag in to_hi: passed by the walk that is going on */
#define RUN_DRAWN (1u << 30) /* flag in to_hi: has been drawn, may be forgotten */

/* Does a piece keep to the ranges? */
static inline bool run_fits(const ink_piece_t *p) {
    return p->from >= 0 && p->from <= p->to && p->to < RUN_T_LIMIT && p->family <= INK_SEGMENT &&
           p->surface < RUN_SURFACES && p->line < RUN_LINE_LIMIT && p->line >= -RUN_LINE_LIMIT;
}

static inline run_t run_pack(const ink_piece_t *p) {
    const uint32_t kind = (uint32_t)p->family * RUN_SURFACES + p->surface;
    return (run_t){.from_lo = (uint32_t)p->from,
                   .from_hi = (uint32_t)(p->from >> 32) | kind >> RUN_KIND_BITS << RUN_HI_BITS,
                   .to_lo = (uint32_t)p->to,
                   .to_hi = (uint32_t)(p->to >> 32),
                   .what = (uint32_t)p->line << RUN_KIND_BITS | (kind & ((1u << RUN_KIND_BITS) - 1))};
}

static inline uint8_t run_family(const run_t *r) {
    return (uint8_t)((r->from_hi >> RUN_HI_BITS << 1) | ((r->what >> 5) & 1));
}
static inline uint8_t run_surface(const run_t *r) {
    return (uint8_t)(r->what & (RUN_SURFACES - 1));
}
static inline int32_t run_line(const run_t *r) {
    return (int32_t)r->what >> RUN_KIND_BITS;
}

/* The parameter of an end: side 0 is `from`, 1 is `to`. */
static inline int64_t run_t_of(const run_t *r, int side) {
    uint32_t hi = (side ? r->to_hi : r->from_hi) & RUN_HI_MASK;
    return (int64_t)((uint64_t)hi << 32 | (side ? r->to_lo : r->from_lo));
}

/* Is there no vertex between its ends? */
static inline bool run_is_plain(const run_t *r) {
    const int bits = ink_bits(run_family(r));
    return ((run_t_of(r, 0) >> bits) + 1) << bits >= run_t_of(r, 1);
}

static inline ink_piece_t run_unpack(const run_t *r) {
    return (ink_piece_t){run_family(r), run_surface(r), run_line(r), run_t_of(r, 0), run_t_of(r, 1)};
}

static inline void run_set_t(run_t *r, int side, int64_t t) {
    if (side) {
        r->to_lo = (uint32_t)t;
        r->to_hi = (r->to_hi & ~RUN_HI_MASK) | (uint32_t)(t >> 32);
    } else {
        r->from_lo = (uint32_t)t;
        r->from_hi = (r->from_hi & ~RUN_HI_MASK) | (uint32_t)(t >> 32);
    }
}

/* Are two runs intervals of one and the same line? */
static inline bool run_same_line(const run_t *a, const run_t *b) {
    return a->what == b->what && a->from_hi >> RUN_HI_BITS == b->from_hi >> RUN_HI_BITS;
}

#endif
