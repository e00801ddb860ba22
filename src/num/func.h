/* func.h - elementary and special functions of scaled integers.
 *
 * Each comment states the worst relative error that tests/unit/test_func.c measured against MPFR over 10^5 random
 * and hard arguments per domain (it checks a slightly wider limit on every run), and the instructions that a
 * call takes on average on a Cortex-M0 (QEMU, -O2). Arguments outside of the domain, and results above
 * 2^NUM_EXP_LIMIT, are undefined; results below 2^-NUM_EXP_LIMIT are zero. Angles are radians.
 *
 * Symmetric functions are symmetric to the last bit: f(-a) is f(a) or -f(a), so that a symmetric surface has
 * symmetric heights. Results are the same bits on every machine. Context: main loop only. */
#ifndef FUNC_H
#define FUNC_H

#include "num/num.h"

num_t func_pi(void);                /* to the last bit */
num_t func_exp(num_t a);            /* 2^-54.4; 720 */
num_t func_log(num_t a);            /* a > 0; 2^-61, next to 1 too; 1,560 */
num_t func_log10(num_t a);          /* a > 0; 2^-61, exact for powers of ten; 1,700 */
num_t func_pow(num_t a, num_t b);   /* 2^-54.3; 3,050. a < 0 only with an integer b; 0**0 is 1, 0**negative undefined.
                                     * |b| < 128 and whole is multiplied out, b = +-1/2 is a square root. */
num_t func_sin(num_t a);            /* 2^-55.7 for every a: next to multiples of pi, at 1e15, at 1e300; 1,820 */
num_t func_cos(num_t a);            /* likewise */
num_t func_sin_degrees(num_t a);    /* of an angle in degrees: exact at whole quarter turns, 2^-52 */
num_t func_tan(num_t a);            /* 2^-55.7 for every a; 3,950 */
num_t func_asin(num_t a);           /* |a| <= 1; 2^-57; 5,500 */
num_t func_acos(num_t a);           /* |a| <= 1; 2^-57, next to 1 too */
num_t func_atan(num_t a);           /* 2^-57; 3,800 */
num_t func_atan2(num_t y, num_t x); /* 2^-57; the quadrants of C; 0 for two zeros; 3,400 */
num_t func_sinh(num_t a);           /* 2^-54; 2,900 */
num_t func_cosh(num_t a);           /* 2^-54 */
num_t func_tanh(num_t a);           /* 2^-54.5 */
num_t func_erf(num_t a);            /* 2^-56; 9,400 */
num_t func_norm(num_t a);           /* the normal distribution's integral; 2^-53 down to a = -38 */
num_t func_invnorm(num_t a);        /* 0 < a < 1; norm(invnorm(a)) is within 2^-52 a of a (tests/unit/test_expr.c) */
num_t func_gamma(num_t a);          /* 2^-56; undefined at 0, -1, -2, ...; exact for small factorials. |a| factors. */
num_t func_besj0(num_t a);          /* absolute error 2^-56; 4,500 up to 8, 18,000 above */
num_t func_besj1(num_t a);          /* absolute error 2^-53, relative 2^-56 below 1 */

#endif
