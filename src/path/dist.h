/* dist.h - lengths, quickly and without division.
 *
 * Ordering compares many distances and needs none of them exactly. The sum of squares is normalised to 7 bits by a
 * shift, its root read from a table and interpolated. Worst error: 1 part in 8,000, plus 1 unit (proved by
 * tests/unit/test_order.c). Cost: two 32x32 products, a count of leading zeros, one more product. */
#ifndef DIST_H
#define DIST_H

#include "view/page.h"

/* Square root of a sum of squares, to the nearest integer or its neighbour. */
uint32_t dist_root(uint32_t square);
/* Length of (dx, dy), |dx| and |dy| < 2^31, in their unit. */
uint32_t dist_of(int32_t dx, int32_t dy);
uint32_t dist_between(page_point_t a, page_point_t b);

#endif
