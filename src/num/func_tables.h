/* func_tables.h - tables and constants shared by the elementary functions; private to src/num/func_*.c.
 * 6 KB of read-only data. */
#ifndef FUNC_TABLES_H
#define FUNC_TABLES_H

#include "num/wide.h"

extern const uint64_t func_tables_exp2[64];       /* 2^(j/64) * 2^62 */
extern const uint64_t func_tables_sin[65];        /* sin(j pi/128) * 2^62 */
extern const uint16_t func_tables_log_factor[65]; /* c_j = 2048 / (1 + j/64), an integer */
extern const wide_t func_tables_log[65];    /* (-log(c_j / 2048) - (j >= FUNC_TABLES_LOG_HALF ? log 2 : 0)) * 2^116 */
extern const uint64_t func_tables_atan[65]; /* atan(j/64) * 2^64 */
extern const uint64_t func_tables_turn[20]; /* 1 / (2 pi), the 1280 bits behind the binary point */

/* Chebyshev coefficients in Q60: f(t) = sum of c[k] T_k(t), |t| <= 1, from the values at the Chebyshev nodes
 * and cut where they fall below 2^-61. For x >= 8, with t = 2 (8/x)^2 - 1 and chi = x - (2 n + 1) pi/4:
 *     sqrt(pi x / 2) Jn(x) = Pn cos(chi) - Qn sin(chi),   sqrt(pi x / 2) Yn(x) = Pn sin(chi) + Qn cos(chi)
 * (Abramowitz and Stegun, 9.2.5 and 9.2.6). */
extern const int64_t func_tables_erf[13];    /* erf(x) / x, t = 2 x^2 - 1 */
extern const int64_t func_tables_erfc[23];   /* (x + 5/2) exp(x^2) erfc(x), t = 1 - 7 / (x + 5/2) */
extern const int64_t func_tables_rgamma[16]; /* 1 / gamma(1 + f), t = 2 f - 1 */
extern const int64_t func_tables_j0[17];     /* J0(x), t = x^2/32 - 1 */
extern const int64_t func_tables_j1[16];     /* J1(x) / x, t = x^2/32 - 1 */
extern const int64_t func_tables_p0[15];     /* Pn */
extern const int64_t func_tables_q0[16];     /* x Qn */
extern const int64_t func_tables_p1[15];     /* Pn */
extern const int64_t func_tables_q1[16];     /* x Qn */

#define FUNC_TABLES_LOG_HALF 27 /* 1 + 27/64 is the first above sqrt(2) */

#endif
