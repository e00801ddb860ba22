/* halo_meet.h - two edges: do they cross, which is nearer, what does it take of the other; not for others. */
#ifndef HALO_MEET_H
#define HALO_MEET_H

#include "hidden/halo/halo.h"
#include "num/wide.h"
#include <stdbool.h>

#define HALO_TICK 1024  /* edges after which the caller is told; a power of two */
#define HALO_JOINED_P 1 /* in halo_t.joined */
#define HALO_JOINED_Q 2
#define HALO_OTHER ((UINT32_C(1) << 24) - 1) /* the bits of halo_crossing_t.other that are an index */

/* Edge a crosses edge b at a's `a` / `of` and b's `b` / `of` of the way, all >= 0. */
typedef struct halo_meeting {
    int64_t a, b, of;
} halo_meeting_t;

/* Do they have exactly one point in common? */
static inline bool halo_crosses(const halo_edge_t *a, const halo_edge_t *b, halo_meeting_t *m) {
    const int32_t ax = a->q.x - a->p.x, ay = a->q.y - a->p.y, bx = b->q.x - b->p.x, by = b->q.y - b->p.y;
    const int32_t x = b->p.x - a->p.x, y = b->p.y - a->p.y;
    /* |differences| <= 2^30: products 2^60, sums 2^61 */
    const int64_t of = wide_mul_s32(ax, by) - wide_mul_s32(ay, bx), sign = of >> 63;
    const int64_t on_a = wide_mul_s32(x, by) - wide_mul_s32(y, bx), on_b = wide_mul_s32(x, ay) - wide_mul_s32(y, ax);
    m->of = (of ^ sign) - sign;
    m->a = (on_a ^ sign) - sign;
    m->b = (on_b ^ sign) - sign;
    /* unsigned: what is negative is large */
    return (uint64_t)m->a <= (uint64_t)m->of && (uint64_t)m->b <= (uint64_t)m->of && m->of != 0;
}

/* Notes what edge i and edge j of h take of each other. */
void halo_take(halo_t *h, uint32_t i, uint32_t j, const halo_meeting_t *m);
/* The same for edges that do not cross but come closer than h->reach. Needs to know which ends meet, so that a finely
 * cut curve is not eaten by its own halo: before, halo_join must have been called for all pairs. */
void halo_take_near(halo_t *h, uint32_t i, uint32_t j, const halo_meeting_t *m);
/* Notes which ends of the two are one point in space. */
void halo_join(halo_t *h, uint32_t i, uint32_t j);

static inline void halo_meet(halo_t *h, uint32_t i, uint32_t j) {
    halo_meeting_t m;
    if (halo_crosses(&h->edge[i], &h->edge[j], &m)) {
        halo_take(h, i, j, &m);
    } else if (h->joined != NULL) {
        halo_take_near(h, i, j, &m);
    }
}

/* The part of `far` that is within `width` of `near`, or beyond one of its ends by no more: halfwidth and overhang of a
 * rectangle. False if there is none. */
bool halo_strip(const halo_edge_t *far, const halo_edge_t *near, int32_t width, uint32_t *from_q30, uint32_t *to_q30);

#endif
