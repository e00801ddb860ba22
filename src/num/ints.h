/* ints.h - small helpers on 64-bit integers: leading zeros, rounding divisions, square root.
 *
 * Rounding is to nearest with ties away from zero, so that f(-a) == -f(a): a drawing turned by half a turn
 * stays the same drawing. Context: any. */
#ifndef INTS_H
#define INTS_H

#include <stdint.h>

/* Leading zero bits of a; a != 0. */
static inline int ints_clz64(uint64_t a) {
    return __builtin_clzll(a);
}
static inline int ints_clz32(uint32_t a) {
    return __builtin_clz(a);
}

/* n, how far something is to be shifted. On x86 clang computes it in the lowest eight bits of a register, and then
 * waits for whatever was in the others: the points of a row one after the other, which are under way side by side. */
static inline int ints_count(int n) {
#if defined __clang__ && defined __x86_64__
    __asm("" : "+r"(n));
#endif
    return n;
}

/* |a| as an unsigned number, INT64_MIN included. */
static inline uint64_t ints_abs64(int64_t a) {
    uint64_t sign = (uint64_t)(a >> 63);
    return ((uint64_t)a ^ sign) - sign;
}

/* a with the sign of s (0 counts as positive); needs a < 2^63. */
static inline int64_t ints_with_sign(uint64_t a, int64_t s) {
    uint64_t sign = (uint64_t)(s >> 63);
    return (int64_t)((a ^ sign) - sign);
}

/* 1 / sqrt(x / 2^32) in Q30 for x >= 2^30, within 2^-28.5 relative. */
uint32_t ints_rsqrt(uint32_t x);

/* floor(sqrt(a)). No division. */
uint32_t ints_sqrt_u64(uint64_t a);

/* a / b to nearest; b != 0, and not INT64_MIN / -1. A 64-bit division. */
int64_t ints_div_round(int64_t a, int64_t b);

/* a * b / c to nearest, exact through 128 bits; c != 0; saturates to +-INT64_MAX when it does not fit.
 * Cost: one 64-bit division when a * b fits 63 bits, otherwise wide_div_u64. */
int64_t ints_muldiv_round(int64_t a, int64_t b, int64_t c);

#endif
