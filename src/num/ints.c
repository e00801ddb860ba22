/* Square root and rounding divisions of 64-bit integers. */
#include "num/ints.h"
#include "num/wide.h"

uint32_t ints_sqrt_u64(uint64_t a) {
    if (a == 0) return 0;
    /* Digit by digit, two bits of a per bit of the root: `root` holds the root so far in the place where
     * the next trial subtraction needs it, so that a step is a comparison, a subtraction and shifts. */
    uint64_t bit = (uint64_t)1 << ((63 - ints_clz64(a)) & ~1), root = 0;
    while (bit != 0) {
        if (a >= root + bit) {
            a -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
        bit >>= 2;
    }
    return (uint32_t)root;
}

int64_t ints_div_round(int64_t a, int64_t b) {
    uint64_t n = ints_abs64(a), d = ints_abs64(b), q = n / d, r = n - q * d;
    q += r >= d - r;
    return ints_with_sign(q, a ^ b);
}

int64_t ints_muldiv_round(int64_t a, int64_t b, int64_t c) {
    int64_t sign = a ^ b ^ c;
    uint64_t d = ints_abs64(c), q, r;
    wide_u_t p = wide_mul_u64(ints_abs64(a), ints_abs64(b));
    if (p.hi == 0) {
        q = p.lo / d;
        r = p.lo - q * d;
    } else {
        if (p.hi >= d) return ints_with_sign(INT64_MAX, sign);
        q = wide_div_u64(p.hi, p.lo, d, &r);
    }
    q += r >= d - r;
    if (q > INT64_MAX) q = INT64_MAX;
    return ints_with_sign(q, sign);
}
