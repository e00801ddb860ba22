/* exp, and its even and odd parts; exp_core.h says how. */
#include "num/exp_core.h"
#include "num/func.h"
#include "num/func_inner.h"
#include "num/num_fast.h"
#include <stddef.h>

static __attribute__((noinline)) num_t reduced(int32_t k, words_t rest) {
    const exp_core_t r = exp_reduced(k, rest);
    return num_fast_make((int64_t)words_join(r.m), r.e);
}

num_t func_exp(num_t a) {
    if (NUM_FAST_RARE(a.m == 0)) return a.undef ? num_undef() : num_from_i64(1);
    if (NUM_FAST_RARE(a.e > -53)) return a.m > 0 ? num_undef() : num_from_i64(0); /* |a| >= 1024 */
    const int32_t k = exp_steps(a.m, a.e);
    return reduced(k, exp_rest(a.m, a.e, k));
}

num_t func_exp_wide(wide_t a) {
    if (a.hi >> 62 != a.hi >> 63) return a.hi > 0 ? num_undef() : num_from_i64(0);
    int32_t k = exp_steps_q21((int32_t)(a.hi >> 31));
    /* ln2/64 in Q116 is 0x00002c5c85fdf473'de6af278ece600fd; its lower word counts as negative here */
    wide_t step = wide_mul_s64(k, (int64_t)0xde6af278ece600fdu);
    step.hi += k * (int64_t)0x00002c5c85fdf474;
    return reduced(k, words_of(wide_sar(wide_sub(a, step), 46).lo));
}

/* sinh(a) / a - 1 for |a| < 1: the series in a^2, coefficients 1/(2i+1)! in Q64. */
static num_t sinh_series(num_t a) {
    static const uint64_t inverse_factorial[] = {0x0000000000000098u, 0x000000000000ca96u, 0x0000000000d73f9fu,
                                                 0x00000000b092309du, 0x0000006b99159fd5u, 0x00002e3bc74aad8eu,
                                                 0x000d00d00d00d00du, 0x0222222222222222u, 0x2aaaaaaaaaaaaaabu};
    int64_t f = num_to_fixed(a, 62, NULL);
    uint64_t z = wide_mulhi_u64(ints_abs64(f) << 1, ints_abs64(f) << 1); /* Q62 */
    uint64_t p = 0;
    for (int i = 0; i < 9; i++) p = inverse_factorial[i] + (wide_mulhi_u64(p, z) << 2);
    return num_from_fixed((int64_t)(wide_mulhi_u64(p, z)), 62);
}

num_t func_sinh(num_t a) {
    if (a.m == 0) return a;
    if (a.e < -62) return num_add(a, num_mul(a, sinh_series(a)));
    num_t t = func_exp(num_abs(a)), s = num_ldexp(num_sub(t, num_div(num_from_i64(1), t)), -1);
    return a.m < 0 ? num_neg(s) : s;
}

num_t func_cosh(num_t a) {
    num_t t = func_exp(num_abs(a));
    return num_ldexp(num_add(t, num_div(num_from_i64(1), t)), -1);
}

num_t func_tanh(num_t a) {
    if (a.m == 0) return a;
    if (a.e < -62) return num_div(func_sinh(a), func_cosh(a));
    num_t one = num_from_i64(1), t = one;
    if (a.e < -57) t = num_sub(one, num_div(num_from_i64(2), num_add(func_exp(num_ldexp(num_abs(a), 1)), one)));
    return a.m < 0 ? num_neg(t) : t;
}
