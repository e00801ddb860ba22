/* root.h - square roots without division: what lengths, directions and times of motion are made of.
 *
 * Method: 1/sqrt of the normalised argument from a table of 96, two Newton steps y (3 - v y^2) / 2 (relative error
 * 8e-3, 9e-5, 1.2e-8), then one residual correction of the root itself, which makes it exact. A Cortex-M0 has neither
 * a divider nor a 32x32->64 multiply: this takes eight products where bitwise roots take 32 rounds of 64-bit compares.
 */
#ifndef ROOT_H
#define ROOT_H

#include <stdint.h>

/* floor(sqrt(x)), exact for all x. */
uint32_t root_u64(uint64_t x);

/* floor(sqrt(x << 2s)) in [2^31, 2^32) for x > 0, s (returned through *s) the largest that does not overflow:
 * sqrt(x) to 31 significant bits whatever its size. */
uint32_t root_normal(uint64_t x, unsigned *s);

/* Length and direction of (dx, dy), not both 0, |dx|, |dy| <= 2^28: returns sqrt(dx^2 + dy^2) in eighths, rounded to
 * nearest; *ux and *uy are the unit vector in q30, worst error 4 units of 2^-30. */
uint32_t root_vector(int32_t dx, int32_t dy, int32_t *ux_q30, int32_t *uy_q30);

#endif
