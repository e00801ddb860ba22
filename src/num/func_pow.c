/* The power function.
 *
 * a^b = exp(b log|a|) through 128 bits: the product may be 763 with exp's error relative to its argument's
 * absolute one, so the logarithm has to be ten bits better than the result. Small integer exponents are
 * multiplied out: what people type is x**2, and integers stay exact. */
#include "num/func.h"
#include "num/func_inner.h"
#include "num/num_fast.h"

/* b * l in Q116, saturated to +-2^11 (which func_exp_wide takes as out of range). */
static wide_t scaled(wide_t l, num_t b) {
    int64_t sign = l.hi ^ b.m;
    if (l.hi < 0) l = wide_neg(l);
    if (l.hi == 0 && l.lo == 0) return l;
    int n = l.hi != 0 ? ints_clz64((uint64_t)l.hi) : 64 + ints_clz64(l.lo);
    l = wide_shl(l, n);
    /* p in [2^125, 2^127): product = p * 2^(64 - n + b.e) */
    wide_u_t p = wide_mul_u64((uint64_t)l.hi, ints_abs64(b.m));
    uint64_t low = wide_mulhi_u64(l.lo, ints_abs64(b.m));
    p.lo += low;
    p.hi += p.lo < low;
    int shift = n - 64 - b.e;
    wide_t r = {(int64_t)1 << 62, 0};
    if (shift > 127)
        r = (wide_t){0, 0};
    else if (shift >= 0)
        r = wide_sar((wide_t){(int64_t)p.hi, p.lo}, shift);
    return sign < 0 ? wide_neg(r) : r;
}

/* Whether a defined integer is odd. */
static bool is_odd(num_t b) {
    return b.e <= 0 && b.e > -63 && (ints_abs64(b.m) >> -b.e & 1) != 0;
}

/* Any but a small whole b. */
static num_t power(num_t a, num_t b) {
    if (a.undef || b.undef) return num_undef();
    if (b.m == 0) return num_from_i64(1);
    if (a.m == 0) return b.m > 0 ? a : num_undef();
    if (a.m < 0 && !num_is_integer(b)) return num_undef();
    if (ints_abs64(b.m) == (uint64_t)1 << 62 && b.e == -63) { /* +-1/2 */
        num_t root = num_sqrt(a);
        return b.m > 0 ? root : num_div(num_from_i64(1), root);
    }
    num_t r = func_exp_wide(scaled(func_log_wide(num_abs(a)), b));
    return a.m < 0 && is_odd(b) ? num_neg(r) : r;
}

num_t func_pow(num_t a, num_t b) {
    /* 1 <= |b| < 128 and whole: its low -e bits are zero */
    if (b.e <= -56 && b.e >= -62 && (b.m & (((int64_t)1 << -b.e) - 1)) == 0) return num_ipow(a, (int32_t)(b.m >> -b.e));
    return power(a, b);
}
