/* sin, cos, tan.
 *
 * a = k pi/128 + r, |r| <= pi/256; then a table of sin(k pi/128) and short polynomials. Up to 2^20 the multiple
 * of pi/128 is subtracted in 128 bits. Above, a / (2 pi) modulo 1 comes from the 192 bits of 1/(2 pi) that
 * matter (M. Payne and R. Hanek, "Radian reduction for trigonometric functions", SIGNUM 18, 1983): any
 * argument has an exact meaning, so sin(1e15) is as good as sin(1). */
#include "num/func.h"
#include "num/trig_core.h"

/* The fraction of a turn, Q128, of m * 2^e for e > -64 (error below 2^-127). */
static wide_u_t turns(uint64_t m, int32_t e) {
    /* Word i of 1/(2 pi) from bit e on (bits in front of the point are zero). */
    uint64_t w[3];
    for (int i = 0; i < 3; i++) {
        int32_t at = e + 64 * i, word = at >> 6, bit = at & 63;
        uint64_t hi = word < 0 ? 0 : func_tables_turn[word], lo = word + 1 < 0 ? 0 : func_tables_turn[word + 1];
        w[i] = hi << bit | (lo >> 1) >> (63 - bit);
    }
    wide_u_t p1 = wide_mul_u64(m, w[1]);
    uint64_t p2 = wide_mulhi_u64(m, w[2]);
    wide_u_t r = {m * w[0] + p1.hi, p1.lo + p2};
    r.hi += r.lo < p2;
    return r;
}

static uint32_t reduce_large(num_t a, wide_t *r) {
    wide_u_t t = turns((uint64_t)a.m, a.e);
    uint32_t k = (uint32_t)((t.hi + ((uint64_t)1 << 55)) >> 56) & 255;
    wide_t phi = {(int64_t)(t.hi - ((uint64_t)k << 56)), t.lo}; /* Q128, |phi| <= 2^-9 */
    int64_t sign = phi.hi;
    if (sign < 0) phi = wide_neg(phi);
    int n = phi.hi != 0 ? ints_clz64((uint64_t)phi.hi) : phi.lo != 0 ? 64 + ints_clz64(phi.lo) : 0;
    phi = wide_shl(phi, n);
    /* times 2 pi in Q61: Q(128 + n + 61 - 64) in a product of 128 bits above a dropped word */
    wide_u_t p = wide_mul_u64((uint64_t)phi.hi, 0xc90fdaa22168c235u);
    uint64_t low = wide_mulhi_u64(phi.lo, 0xc90fdaa22168c235u);
    p.lo += low;
    p.hi += p.lo < low;
    /* to Q126: n - 1 more bits down than the top bit allows a signed number; n >= 9 unless phi is 0 */
    *r = n == 0 ? (wide_t){0, 0} : wide_sar((wide_t){(int64_t)(p.hi >> 1), p.hi << 63 | p.lo >> 1}, n - 2);
    if (sign < 0) *r = wide_neg(*r);
    return k;
}

/* |a| = r + k pi/128 for |a| >= 2^-32, |r| <= 0.0126 in Q126; k modulo 256. */
static uint32_t reduce(num_t a, wide_t *r) {
    a.m = (int64_t)ints_abs64(a.m);
    if (a.e + 62 >= 20) return reduce_large(a, r);
    const uint32_t k = trig_nearest((uint64_t)a.m, a.e);
    *r = wide_sub(wide_shl(wide_from_s64(a.m), a.e + 126), trig_steps(k));
    return k & 255;
}

static trig_small_t small_angle(wide_t r126) {
    return trig_small((int64_t)wide_sar(r126, 57).lo);
}

/* sin(k pi/128 + r), or its negative when sign < 0. */
static num_t sine_at(uint32_t k, wide_t r126, trig_small_t s, int64_t sign) {
    if (k & 128) sign = ~sign;
    if ((k & 127) == 0) { /* relative to r: a zero of the function may be near */
        num_t r = num_from_wide(r126, 126);
        r = num_sub(r, num_mul(r, num_from_fixed((int64_t)s.u, 74)));
        return sign < 0 ? num_neg(r) : r;
    }
    return num_fast_normal(trig_sine_q62(k, s), -62, sign);
}

/* Below 2^-32, sin a is a and cos a is 1 to 2^-64. */
static bool is_tiny(num_t a) {
    return a.e + 62 < -32;
}

num_t func_sin(num_t a) {
    if (a.m == 0 || is_tiny(a)) return a;
    wide_t r;
    uint32_t k = reduce(a, &r);
    return sine_at(k, r, small_angle(r), a.m);
}

num_t func_cos(num_t a) {
    if (a.m == 0 || is_tiny(a)) return a.undef ? a : num_from_i64(1);
    wide_t r;
    uint32_t k = reduce(a, &r);
    return sine_at(k + 64, r, small_angle(r), 0);
}

void func_sincos(num_t a, num_t *sine, num_t *cosine) {
    *sine = a;
    *cosine = num_from_i64(1);
    if (a.m == 0 || is_tiny(a)) return;
    wide_t r;
    uint32_t k = reduce(a, &r);
    trig_small_t s = small_angle(r);
    *sine = sine_at(k, r, s, a.m);
    *cosine = sine_at(k + 64, r, s, 0);
}

num_t func_tan(num_t a) {
    num_t s, c;
    func_sincos(a, &s, &c);
    return num_div(s, c);
}
