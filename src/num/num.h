/* num.h - scaled integers: a 64-bit significand and a binary exponent, in integer instructions only.
 *
 * A value is m * 2^e. It is normalised: |m| in [2^62, 2^63), or m == 0 and e == 0. The type carries
 * about 19 decimal digits over a range no plot leaves, so a person may type 1e10/1e8, gamma(15)/gamma(14) or
 * set xrange [0:1e-9] and get what gnuplot gives; the plain Q32.32 we tried first overflowed at 2e9.
 *
 * Undefined (0/0, sqrt(-1), log(0), overflow) is the flag `undef`, never a number. It travels: any
 * operation on an undefined value is undefined. Its reason is not kept.
 *
 * Overflow: |value| >= 2^NUM_EXP_LIMIT is undefined; below 2^-NUM_EXP_LIMIT it is zero.
 * Rounding: + - * / and sqrt are within 1 unit in the last place of the 63-bit significand.
 * Context: main loop only; no function allocates, recurses or uses floating point. */
#ifndef NUM_H
#define NUM_H

#include <stdbool.h>
#include <stdint.h>

#define NUM_EXP_LIMIT 1100 /* a little wider than double, so that whatever gnuplot prints we can hold */

typedef struct num {
    int64_t m;   /* significand, normalised */
    int16_t e;   /* binary exponent: value = m * 2^e */
    bool undef;  /* true: no value; m and e are then 0 */
} num_t;

num_t num_undef(void);
num_t num_from_i64(int64_t v);
/* v / 2^frac_bits. */
num_t num_from_fixed(int64_t v, int frac_bits);
/* mantissa * 10^exp10, correctly rounded to within 1 ulp: what a decimal literal means. */
num_t num_from_decimal(uint64_t mantissa, int32_t exp10);
/* Nearest integer to a * 2^frac_bits, ties away from zero. *ok (may be NULL) becomes false, and the result
 * saturates, when a is undefined (result 0) or the result does not fit int64_t. */
int64_t num_to_fixed(num_t a, int frac_bits, bool *ok);
/* The pair of a defined value: *exp10 and up to 18 digits, rounded: a = digits * 10^exp10 (for printing). */
int64_t num_to_decimal(num_t a, int digits, int32_t *exp10);

num_t num_add(num_t a, num_t b);
num_t num_sub(num_t a, num_t b);
num_t num_mul(num_t a, num_t b);
num_t num_div(num_t a, num_t b); /* undefined for b == 0 */
num_t num_neg(num_t a);
num_t num_abs(num_t a);
num_t num_ldexp(num_t a, int shift); /* a * 2^shift */
num_t num_sqrt(num_t a);             /* undefined for a < 0 */
/* -1, 0, 1 as a <, ==, > b; both must be defined. */
int num_cmp(num_t a, num_t b);
int num_sign(num_t a); /* -1, 0, 1 */
num_t num_floor(num_t a);
num_t num_ceil(num_t a);
num_t num_trunc(num_t a);
bool num_is_integer(num_t a);

#endif
