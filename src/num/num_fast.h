/* num_fast.h - the hot operations of num.h, inline, for the inner loops (interpreter, projection).
 *
 * Same values bit for bit as the functions of num.h, which are these. Each use costs code (about 150 bytes
 * on a Cortex-M0), so cold code calls num.h.
 *
 * The usual path has no branch that depends on the data's size or sign: a mispredicted one costs more than
 * the whole addition. Bit budgets are in the comments; u64 arithmetic, nothing wraps unless it says so. */
#ifndef NUM_FAST_H
#define NUM_FAST_H

#include "num/ints.h"
#include "num/num.h"
#include "num/wide.h"

/* The exponents e for which m * 2^e, |m| in [2^62, 2^63), is inside the limits. */
#define NUM_FAST_E_MIN (-NUM_EXP_LIMIT - 62)
#define NUM_FAST_E_MAX (NUM_EXP_LIMIT - 63)
#define NUM_FAST_RARE(condition) __builtin_expect(!!(condition), 0)

/* What the operations do with a zero, an undefined operand or an exponent outside: out of line, so that the
 * usual path stays short. */
num_t num_fast_outside(int32_t e);         /* undefined above the limit, zero below */
num_t num_fast_add_rare(num_t a, num_t b); /* a or b without significand */
num_t num_fast_mul_rare(num_t a, num_t b);

/* m * 2^e for a normalised m; any e: undefined above the limit, zero below. */
static inline num_t num_fast_make(int64_t m, int32_t e) {
    if (NUM_FAST_RARE((uint32_t)(e - NUM_FAST_E_MIN) > (uint32_t)(NUM_FAST_E_MAX - NUM_FAST_E_MIN)))
        return num_fast_outside(e);
    return (num_t){m, e, false};
}

/* sign(s) * u * 2^e for any u < 2^64, truncated to 63 bits. */
static inline num_t num_fast_normal(uint64_t u, int32_t e, int64_t s) {
    if (NUM_FAST_RARE(u == 0)) return (num_t){0, 0, false};
    int n = ints_clz64(u);
    return num_fast_make(ints_with_sign((u << n) >> 1, s), e + 1 - n);
}

static inline num_t num_fast_neg(num_t a) {
    a.m = -a.m;
    return a;
}

/* Always inline: a call would copy both operands. */
static inline __attribute__((always_inline)) num_t num_fast_add(num_t a, num_t b) {
    if (NUM_FAST_RARE(a.m == 0 || b.m == 0)) return num_fast_add_rare(a, b);
    int32_t d = a.e - b.e, e = d < 0 ? b.e : a.e;
    int64_t big = d < 0 ? b.m : a.m, small = d < 0 ? a.m : b.m;
    d = d < 0 ? -d : d;
    if (NUM_FAST_RARE(d > 63)) return (num_t){big, e, false}; /* small is below half a unit of big */
    /* With the sign of `big` divided out, and 64 bits more below the point: B in [2^62, 2^63), |S| < 2^63. */
    int64_t sign = big >> 63, S = (small ^ sign) - sign;
    uint64_t u = ints_abs64(big) + (uint64_t)(S >> d), lo = ((uint64_t)S << 1) << (63 - d);
    /* 0 <= u < 2^64, except when d == 0 and B < -S: then it is the other's sign, and lo is 0 */
    int64_t flip = (S & (int64_t)u) >> 63;
    u = (u ^ (uint64_t)flip) - (uint64_t)flip;
    sign ^= flip;
    if (NUM_FAST_RARE(u == 0)) return num_fast_normal(lo, e - 64, sign); /* cancelled: d <= 1 */
    int n = ints_clz64(u);
    u = u << n | (lo >> 1) >> (63 - n);
    u = (u >> 1) + (u & 1);
    if (NUM_FAST_RARE(u >> 63)) return num_fast_make(ints_with_sign(u >> 1, sign), e + 2 - n);
    return num_fast_make(ints_with_sign(u, sign), e + 1 - n);
}

static inline num_t num_fast_sub(num_t a, num_t b) {
    return num_fast_add(a, num_fast_neg(b));
}

static inline num_t num_fast_mul(num_t a, num_t b) {
    if (NUM_FAST_RARE(a.m == 0 || b.m == 0)) return num_fast_mul_rare(a, b);
    /* |a.m| |b.m| is in [2^124, 2^126): four times it has its top at bit 126 or 127. */
    wide_u_t p = wide_mul_u64(ints_abs64(a.m) << 1, ints_abs64(b.m) << 1);
    uint64_t h = p.hi + (p.lo >> 63); /* no carry out: p.hi <= 2^64 - 4 */
    int t = (int)(h >> 63);
    uint64_t r = (h + (uint64_t)t) >> t; /* rounded twice: within 3/4 ulp */
    return num_fast_make(ints_with_sign(r, a.m ^ b.m), a.e + b.e + 62 + t);
}

static inline int64_t num_fast_to_fixed(num_t a, int frac_bits, bool *ok) {
    int32_t n = -(a.e + frac_bits); /* drop n bits */
    if (NUM_FAST_RARE((uint32_t)(n - 1) > 62)) {
        if (n > 63 && !a.undef) return 0;
        if (a.m != 0 && n == 0) return a.m;
        if (ok && (a.undef || a.m != 0)) *ok = false;
        return a.m == 0 ? 0 : ints_with_sign(INT64_MAX, a.m);
    }
    if (NUM_FAST_RARE(a.undef) && ok) *ok = false;
    uint64_t u = ints_abs64(a.m);                                    /* below 2^63 */
    return ints_with_sign((u + ((uint64_t)1 << (n - 1))) >> n, a.m); /* sum below 2^63 + 2^62 */
}

static inline int num_fast_cmp(num_t a, num_t b) {
    /* Different signs, a zero, or the same exponent: the significands decide. */
    if ((a.m ^ b.m) < 0 || a.m == 0 || b.m == 0 || a.e == b.e) return (a.m > b.m) - (a.m < b.m);
    return (a.e > b.e) == (a.m > 0) ? 1 : -1;
}

#endif
