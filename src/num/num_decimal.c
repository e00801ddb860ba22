/* Decimal to scaled integer and back.
 *
 * Powers of five are multiplied together from 5^(2^k) with 128-bit significands: at most 9 factors, each
 * within 3 units of 2^-127, so that the result is good to about 2^-122. What is rounded to 63 bits or to 18
 * digits (60 bits) is therefore the nearest value, except for operands within 2^-58 of a tie. */
#include "num/num.h"
#include "num/num_fast.h"

/* s * 2^e with s in [2^127, 2^128). */
typedef struct big {
    wide_u_t s;
    int16_t e;
} big_t;

/* 5^(2^k) and 5^-(2^k), to nearest; test_num.c verifies them against MPFR through their use. */
static const big_t power5[2][9] = {{
                                       {{0xa000000000000000u, 0x0000000000000000u}, -125}, /* 5^1 */
                                       {{0xc800000000000000u, 0x0000000000000000u}, -123}, /* 5^2 */
                                       {{0x9c40000000000000u, 0x0000000000000000u}, -118}, /* 5^4 */
                                       {{0xbebc200000000000u, 0x0000000000000000u}, -109}, /* 5^8 */
                                       {{0x8e1bc9bf04000000u, 0x0000000000000000u}, -90},  /* 5^16 */
                                       {{0x9dc5ada82b70b59du, 0xf020000000000000u}, -53},  /* 5^32 */
                                       {{0xc2781f49ffcfa6d5u, 0x3cbf6b71c76b25fbu}, 21},   /* 5^64 */
                                       {{0x93ba47c980e98cdfu, 0xc66f336c36b10137u}, 170},  /* 5^128 */
                                       {{0xaa7eebfb9df9de8du, 0xddbb901b98feeab8u}, 467},  /* 5^256 */
                                   },
                                   {
                                       {{0xccccccccccccccccu, 0xcccccccccccccccdu}, -130}, /* 5^-1 */
                                       {{0xa3d70a3d70a3d70au, 0x3d70a3d70a3d70a4u}, -132}, /* 5^-2 */
                                       {{0xd1b71758e219652bu, 0xd3c36113404ea4a9u}, -137}, /* 5^-4 */
                                       {{0xabcc77118461cefcu, 0xfdc20d2b36ba7c3du}, -146}, /* 5^-8 */
                                       {{0xe69594bec44de15bu, 0x4c2ebe687989a9b4u}, -165}, /* 5^-16 */
                                       {{0xcfb11ead453994bau, 0x67de18eda5814af2u}, -202}, /* 5^-32 */
                                       {{0xa87fea27a539e9a5u, 0x3f2398d747b36224u}, -276}, /* 5^-64 */
                                       {{0xddd0467c64bce4a0u, 0xac7cb3f6d05ddbdfu}, -425}, /* 5^-128 */
                                       {{0xc0314325637a1939u, 0xfa911155fefb5309u}, -722}, /* 5^-256 */
                                   }};

typedef struct scaled {
    wide_u_t s;
    int32_t e;
} scaled_t;

/* |m| * 2^e * 10^n for m != 0, |n| < 512. */
static scaled_t scaled_by_ten(uint64_t m, int32_t e, int32_t n) {
    int shift = ints_clz64(m);
    scaled_t r = {{m << shift, 0}, e - shift - 64 + n};
    const big_t *table = power5[n < 0];
    for (uint32_t k = n < 0 ? (uint32_t)-n : (uint32_t)n; k != 0; k >>= 1, table++) {
        if (!(k & 1)) continue;
        wide_u_t p = wide_mul_u64(r.s.hi, table->s.hi);
        uint64_t a = wide_mulhi_u64(r.s.hi, table->s.lo), b = wide_mulhi_u64(r.s.lo, table->s.hi);
        uint64_t lo = p.lo + a;
        p.hi += lo < a;
        p.lo = lo + b;
        p.hi += p.lo < b;
        r.e += table->e + 128;
        if (!(p.hi >> 63)) {
            p.hi = p.hi << 1 | p.lo >> 63;
            p.lo <<= 1;
            r.e--;
        }
        r.s = p;
    }
    return r;
}

num_t num_from_decimal(uint64_t mantissa, int32_t exp10) {
    /* with 20 digits before the point, 10^-400 is below the least number and 10^400 above the largest */
    if (mantissa == 0 || exp10 < -400) return (num_t){0, 0, false};
    if (exp10 > 400) return num_undef();
    scaled_t v = scaled_by_ten(mantissa, 0, exp10);
    uint64_t m = (v.s.hi >> 1) + (v.s.hi & 1);
    int carry = (int)(m >> 63);
    return num_fast_make((int64_t)(m >> carry), v.e + 65 + carry);
}

int64_t num_to_decimal(num_t a, int digits, int32_t *exp10) {
    *exp10 = 0;
    if (a.m == 0) return 0;
    uint64_t least = 1;
    for (int i = 1; i < digits; i++) {
        least *= 10;
    }
    const uint64_t limit = 10 * least;
    /* 2^(e+62) <= |a|, so this is the decimal exponent or one less: 78913/2^18 is log10(2) to 1e-6, and its
     * floor is the true one for every exponent we hold. */
    int32_t first = (a.e + 62) * 78913 >> 18;
    for (;; first++) {
        scaled_t v = scaled_by_ten(ints_abs64(a.m), a.e, digits - 1 - first);
        int drop = -v.e - 64; /* bits of s.hi behind the point: the value is in [1, 10^19) */
        uint64_t whole = v.s.hi >> drop, part = drop == 0 ? v.s.lo : v.s.hi << (64 - drop) | v.s.lo >> drop;
        if (whole >= limit) continue;
        whole += part >= ((uint64_t)1 << 63) - 16; /* a tie may have come out a little low */
        if (whole == limit) {
            whole = least;
            first++;
        }
        *exp10 = first - digits + 1;
        return ints_with_sign(whole, a.m);
    }
}
