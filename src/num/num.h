/* num.h - scaled integers: a 63-bit significand with sign and a binary exponent, in integer instructions only.
 *
 * A value is m * 2^e. It is normalised: |m| in [2^62, 2^63), or m == 0 and e == 0. The type carries
 * about 19 decimal digits over a range no plot leaves, so a person may type 1e10/1e8, gamma(15)/gamma(14) or
 * set xrange [0:1e-9] and get what gnuplot gives; the plain Q32.32 we tried first overflowed at 2e9.
 *
 * Undefined (0/0, sqrt(-1), log(0), overflow) is the flag `undef`, never a number. It travels: any
 * operation on an undefined value is undefined. Its reason is not kept. An undefined value has m == 0 and
 * e == 0, so that one test for zero finds both rare cases.
 *
 * Overflow: |value| >= 2^NUM_EXP_LIMIT is undefined; below 2^-NUM_EXP_LIMIT it is zero.
 * Rounding: + - * / and sqrt are within 1 unit in the last place of the 63-bit significand, exact when the
 * result is representable, and symmetric: f(-a) == -f(a). Results are the same bits on every machine.
 * Context: main loop only; no function allocates, recurses or uses floating point.
 * The inner loops that cannot afford a call take the same functions inline from num_fast.h. */
#ifndef NUM_H
#define NUM_H

#include <stdbool.h>
#include <stdint.h>

#include "num/wide.h"

#define NUM_EXP_LIMIT 1100 /* a little wider than double, so that whatever gnuplot prints we can hold */

typedef struct num {
    wide_s64_t m; /* significand, normalised */
    int32_t e;    /* binary exponent: value = m * 2^e */
    bool undef;   /* true: no value; m and e are then 0 */
} num_t;

num_t num_undef(void);
num_t num_from_i64(int64_t v);
/* v / 2^frac_bits; |frac_bits| <= 10000. */
num_t num_from_fixed(int64_t v, int frac_bits);
/* v / 2^frac_bits, to nearest. */
num_t num_from_wide(wide_t v, int frac_bits);
/* mantissa * 10^exp10, within 1 ulp: what a decimal literal means. */
num_t num_from_decimal(uint64_t mantissa, int32_t exp10);
/* Nearest integer to a * 2^frac_bits, ties away from zero; |frac_bits| <= 10000. *ok (may be NULL) becomes
 * false, and the result saturates to +-INT64_MAX, when a is undefined (result 0) or the result does not fit. */
int64_t num_to_fixed(num_t a, int frac_bits, bool *ok);
/* The decimal form of a defined value, for printing: a = result * 10^exp10 with |result| of exactly `digits`
 * digits (1..18), rounded to nearest; 0 and exp10 = 0 for zero. */
int64_t num_to_decimal(num_t a, int digits, int32_t *exp10);

num_t num_add(num_t a, num_t b);
num_t num_sub(num_t a, num_t b);
num_t num_mul(num_t a, num_t b);
num_t num_div(num_t a, num_t b); /* undefined for b == 0 */
num_t num_neg(num_t a);
num_t num_abs(num_t a);
num_t num_ldexp(num_t a, int shift); /* a * 2^shift; |shift| <= 10000 */
num_t num_sqrt(num_t a);             /* undefined for a < 0 */
/* a^n by repeated squaring: exact where the result is representable, otherwise within n ulp; 0^0 is 1,
 * 0^negative undefined. */
num_t num_ipow(num_t a, int32_t n);
/* Place i of n, 0 to n - 1, evenly from end[0] to end[1], which are met exactly. */
num_t num_between(const num_t end[2], int32_t i, int32_t n);
/* -1, 0, 1 as a <, ==, > b; both must be defined. */
int num_cmp(num_t a, num_t b);
int num_sign(num_t a); /* -1, 0, 1 */
num_t num_floor(num_t a);
num_t num_ceil(num_t a);
num_t num_trunc(num_t a);
bool num_is_integer(num_t a);

#endif
