/* func_tables.h - tables and constants shared by the elementary functions; private to src/num/func_*.c.
 * 4.5 KB of read-only data. */
#ifndef FUNC_TABLES_H
#define FUNC_TABLES_H

#include "num/wide.h"

extern const uint64_t func_tables_exp2[64];       /* 2^(j/64) * 2^62 */
extern const uint64_t func_tables_sin[65];        /* sin(j pi/128) * 2^62 */
extern const uint16_t func_tables_log_factor[65]; /* c_j = 2048 / (1 + j/64), an integer */
extern const wide_t func_tables_log[65];    /* (-log(c_j / 2048) - (j >= FUNC_TABLES_LOG_HALF ? log 2 : 0)) * 2^116 */
extern const uint64_t func_tables_atan[65]; /* atan(j/64) * 2^62 */
extern const uint64_t func_tables_turn[20]; /* 1 / (2 pi), the 1280 bits behind the binary point */

#define FUNC_TABLES_LOG_HALF 27 /* 1 + 27/64 is the first above sqrt(2) */

#endif
