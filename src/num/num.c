/* Scaled integers. The four hot operations are in num_fast.h; here are their callable forms and the rest. */
#include "num/num.h"
#include "num/num_fast.h"

_Static_assert(-1 >> 1 == -1, "right shift of a negative number must be arithmetic");
_Static_assert(sizeof(num_t) == 16, "num_t must travel in two registers");

num_t num_fast_outside(int32_t e) {
    return (num_t){0, 0, e > 0};
}

num_t num_fast_add_rare(num_t a, num_t b) {
    if (a.undef || b.undef) return (num_t){0, 0, true};
    return a.m == 0 ? b : a;
}

num_t num_fast_mul_rare(num_t a, num_t b) {
    return (num_t){0, 0, a.undef || b.undef};
}

num_t num_undef(void) {
    return (num_t){0, 0, true};
}

num_t num_from_i64(int64_t v) {
    return num_from_fixed(v, 0);
}

num_t num_from_fixed(int64_t v, int frac_bits) {
    return num_fast_normal(ints_abs64(v), -frac_bits, v);
}

num_t num_from_wide(wide_t v, int frac_bits) {
    int64_t sign = v.hi;
    if (sign < 0) v = wide_neg(v);
    uint64_t u = (uint64_t)v.hi;
    if (u == 0) return num_fast_normal(v.lo, -frac_bits, sign);
    int n = ints_clz64(u);
    u = u << n | (v.lo >> 1) >> (63 - n);
    uint64_t r = (u >> 1) + (u & 1);
    int carry = (int)(r >> 63);
    return num_fast_make(ints_with_sign(r >> carry, sign), 65 - n + carry - frac_bits);
}

int64_t num_to_fixed(num_t a, int frac_bits, bool *ok) {
    return num_fast_to_fixed(a, frac_bits, ok);
}

num_t num_add(num_t a, num_t b) {
    return num_fast_add(a, b);
}

num_t num_sub(num_t a, num_t b) {
    return num_add(a, num_fast_neg(b));
}

num_t num_mul(num_t a, num_t b) {
    return num_fast_mul(a, b);
}

num_t num_div(num_t a, num_t b) {
    if (a.undef || b.m == 0) return num_undef();
    if (a.m == 0) return a;
    uint64_t n = ints_abs64(a.m), d = ints_abs64(b.m), r;
    int t = n >= d; /* so that the quotient has 63 bits */
    uint64_t q = wide_div_u64(n >> (1 + t), n << (63 - t), d, &r);
    q += r >= d - r; /* stays below 2^63: q + 1 == 2^63 would need n / d > 2 - 2^-63 */
    return num_fast_make(ints_with_sign(q, a.m ^ b.m), a.e - b.e - 63 + t);
}

num_t num_neg(num_t a) {
    return num_fast_neg(a);
}

num_t num_abs(num_t a) {
    a.m = a.m < 0 ? -a.m : a.m;
    return a;
}

num_t num_ldexp(num_t a, int shift) {
    if (a.m == 0) return a;
    return num_fast_make(a.m, a.e + shift);
}

num_t num_sqrt(num_t a) {
    if (NUM_FAST_RARE(a.m <= 0)) return a.m == 0 ? a : num_undef();
    /* s = sqrt(u 2^62) in [2^62, 2^63), u = m or 2 m such that the exponent halves. */
    int odd = a.e & 1;
    uint64_t u = (uint64_t)a.m << odd;
    uint32_t x = (uint32_t)(u >> 32), r = ints_rsqrt(x);
    uint64_t s = wide_mul_u32(x, r) >> 31;                                            /* Q31, good to 2^-28 */
    int64_t rest = (int64_t)(u - (wide_mul_u32((uint32_t)s, (uint32_t)s) << 2));      /* Q64: 2^38 at most */
    s = (s << 32) + (uint64_t)(wide_mul_s32((int32_t)(rest >> 7), (int32_t)r) >> 25); /* Q63, good to 2^-56 */
    /* The second correction, from the exact remainder, is to nearest: exact for squares. */
    wide_u_t square = wide_mul_u64(s, s);
    wide_t left = wide_sub((wide_t){(int64_t)(u >> 2), u << 62}, (wide_t){(int64_t)square.hi, square.lo});
    int32_t left42 = (int32_t)wide_sar(left, 42).lo; /* below 2^32 */
    s += (uint64_t)((wide_mul_s32(left42, (int32_t)r) + ((int64_t)1 << 51)) >> 52);
    s -= s >> 63; /* sqrt(2^64 - 2) is within 2^-32 of a tie */
    return num_fast_make((int64_t)s, (a.e - 62 - odd) / 2);
}

num_t num_ipow(num_t a, int32_t n) {
    num_t r = num_from_i64(1);
    if (a.undef) return a;
    bool first = true;
    for (uint32_t k = n < 0 ? 0u - (uint32_t)n : (uint32_t)n; k != 0; k >>= 1) {
        if (k & 1) {
            r = first ? a : num_mul(r, a);
            first = false;
        }
        if (k > 1) a = num_mul(a, a);
    }
    if (n < 0) return r.undef ? num_from_i64(0) : num_div(num_from_i64(1), r);
    return r;
}

num_t num_between(const num_t end[2], int32_t i, int32_t n) {
    if (i == n - 1) return end[1];
    return num_add(end[0], num_div(num_mul(num_sub(end[1], end[0]), num_from_i64(i)), num_from_i64(n - 1)));
}

int num_cmp(num_t a, num_t b) {
    return num_fast_cmp(a, b);
}

int num_sign(num_t a) {
    return (a.m > 0) - (a.m < 0);
}

num_t num_trunc(num_t a) {
    if (a.e >= 0) return a;
    if (a.e <= -63) return (num_t){0, 0, false};
    uint64_t u = ints_abs64(a.m) >> -a.e << -a.e;
    return (num_t){ints_with_sign(u, a.m), a.e, false};
}

num_t num_floor(num_t a) {
    num_t t = num_trunc(a);
    return a.m < 0 && t.m != a.m ? num_sub(t, num_from_i64(1)) : t;
}

num_t num_ceil(num_t a) {
    return num_neg(num_floor(num_neg(a)));
}

bool num_is_integer(num_t a) {
    return !a.undef && num_trunc(a).m == a.m;
}
