/* Square root and rounding divisions of 64-bit integers. */
#include "num/ints.h"
#include "num/wide.h"

/* 256 / sqrt(i/256) - 256 for i = 64..255, such that the error over [i, i+1]/256 is least: 2^-7.7. */
static const uint8_t rsqrt_table[192] = {
    254, 250, 246, 243, 239, 235, 232, 228, 225, 222, 219, 215, 212, 209, 206, 203, 201, 198, 195, 192, 190, 187,
    184, 182, 179, 177, 175, 172, 170, 168, 165, 163, 161, 159, 157, 155, 153, 151, 149, 147, 145, 143, 141, 139,
    137, 135, 134, 132, 130, 128, 127, 125, 123, 122, 120, 119, 117, 116, 114, 113, 111, 110, 108, 107, 105, 104,
    103, 101, 100, 99,  97,  96,  95,  93,  92,  91,  90,  88,  87,  86,  85,  84,  82,  81,  80,  79,  78,  77,
    76,  75,  74,  72,  71,  70,  69,  68,  67,  66,  65,  64,  63,  62,  61,  60,  60,  59,  58,  57,  56,  55,
    54,  53,  52,  51,  51,  50,  49,  48,  47,  46,  46,  45,  44,  43,  42,  42,  41,  40,  39,  38,  38,  37,
    36,  35,  35,  34,  33,  33,  32,  31,  30,  30,  29,  28,  28,  27,  26,  26,  25,  24,  24,  23,  22,  22,
    21,  20,  20,  19,  19,  18,  17,  17,  16,  16,  15,  14,  14,  13,  13,  12,  11,  11,  10,  10,  9,   9,
    8,   8,   7,   6,   6,   5,   5,   4,   4,   3,   3,   2,   2,   1,   1,   0,
};

uint32_t ints_rsqrt(uint32_t x) {
    /* Two Newton steps r (1 + e/2) with e = 1 - x r^2: 2^-7.7, 2^-14.8, 2^-29. They come from below, so r stays
     * below 2 and r^2 below 4. */
    uint32_t r = 256 + (uint32_t)rsqrt_table[(x >> 24) - 64]; /* Q8 */
    int64_t e = ((int64_t)1 << 48) - (int64_t)wide_mul_u32(x, r * r);
    r = (r << 22) + (uint32_t)(((int32_t)r * (int32_t)(e >> 20)) >> 7);        /* Q30; 9 + 22 bits */
    uint32_t square = (uint32_t)(wide_mul_u32(r, r) >> 30);                    /* Q30 */
    e = ((int64_t)1 << 62) - (int64_t)wide_mul_u32(x, square);                 /* Q62, below 2^48 */
    return r + (uint32_t)(wide_mul_s32((int32_t)r, (int32_t)(e >> 18)) >> 45); /* 31 + 30 bits */
}

uint32_t ints_sqrt_u64(uint64_t a) {
    if (a == 0) return 0;
    int shift = ints_clz64(a) & ~1; /* floor(sqrt(a 4^n)) / 2^n rounds down to floor(sqrt(a)) */
    a <<= shift;
    uint32_t x = (uint32_t)(a >> 32), r = ints_rsqrt(x);
    uint64_t y = wide_mul_u32(x, r) >> 30; /* Q32 within 2^4 */
    if (y >> 32) y = UINT32_MAX;
    int64_t rest = (int64_t)(a - wide_mul_u32((uint32_t)y, (uint32_t)y)); /* below 2^37 */
    y += (uint64_t)(wide_mul_s32((int32_t)(rest >> 7), (int32_t)r) >> 56);
    /* now one off at most */
    if (y >> 32) y = UINT32_MAX;
    rest = (int64_t)(a - wide_mul_u32((uint32_t)y, (uint32_t)y));
    if (rest < 0)
        y--;
    else if ((uint64_t)rest > 2 * y)
        y++;
    return (uint32_t)y >> (shift / 2);
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
