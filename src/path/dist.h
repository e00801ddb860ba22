/* dist.h - lengths, quickly and without division.
 *
 * Ordering compares many distances and needs none of them exactly. The sum of squares is normalised to 7 bits by a
 * shift, its root read from a table and interpolated. Worst error: 1 part in 8,000, plus 1 unit (proved by
 * tests/unit/test_order.c). Cost: two 32x32 products, a count of leading zeros, one more product. */
#ifndef DIST_H
#define DIST_H

#include "view/page.h"

extern const uint16_t DIST_ROOT_Q14[97]; /* 2^14 sqrt(1 + k / 32) */

/* 2^up sqrt(square), to the nearest or its neighbour; 0 <= up <= 31 and the result must fit. */
static inline uint32_t dist_root_up(uint32_t square, int up) {
    if (square == 0) return 0;
    int shift = __builtin_clz(square) & ~1;
    uint32_t v = square << shift; /* in [2^30, 2^32), its root in 2^15 [1, 2) */
    uint32_t k = (v >> 25) - 32, part = (v >> 17) & 0xff;
    uint32_t root_q22 = ((uint32_t)DIST_ROOT_Q14[k] << 8) + (uint32_t)(DIST_ROOT_Q14[k + 1] - DIST_ROOT_Q14[k]) * part;
    int down = 22 - 15 + shift / 2 - up;
    return down > 0 ? (root_q22 + (1u << (down - 1))) >> down : root_q22 << -down;
}
/* Square root of a sum of squares, to the nearest integer or its neighbour. */
static inline uint32_t dist_root(uint32_t square) {
    return dist_root_up(square, 0);
}
/* Length of (dx, dy), |dx| and |dy| < 2^31, in their unit. */
uint32_t dist_of(int32_t dx, int32_t dy);
uint32_t dist_between(page_point_t a, page_point_t b);

#endif
