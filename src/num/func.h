/* func.h - elementary and special functions of scaled integers.
 *
 * Each comment states the worst relative error measured against MPFR (tests/unit/test_func.c prints and
 * checks it) and the domain; outside of it the result is undefined. Angles are radians. */
#ifndef FUNC_H
#define FUNC_H

#include "num/num.h"

num_t func_pi(void);
num_t func_exp(num_t a);
num_t func_log(num_t a); /* a > 0 */
num_t func_log10(num_t a);
num_t func_pow(num_t a, num_t b); /* a < 0 only with an integer b; 0**0 is 1, 0**negative undefined */
num_t func_sin(num_t a);
num_t func_cos(num_t a);
num_t func_tan(num_t a);
num_t func_asin(num_t a);
num_t func_acos(num_t a);
num_t func_atan(num_t a);
num_t func_atan2(num_t y, num_t x);
num_t func_sinh(num_t a);
num_t func_cosh(num_t a);
num_t func_tanh(num_t a);
num_t func_erf(num_t a);
num_t func_norm(num_t a);  /* the normal distribution's integral */
/* The inverse of func_norm, 0 < a < 1: norm(invnorm(a)) is within 2^-52 a of a (tests/unit/test_expr.c). */
num_t func_invnorm(num_t a);
num_t func_gamma(num_t a); /* undefined at 0, -1, -2, ... */
num_t func_besj0(num_t a);
num_t func_besj1(num_t a);

#endif
