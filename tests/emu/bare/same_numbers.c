/* same_numbers.c - what has ways of its own on a core of 32 bits: products, arithmetic of doubles, exp, sin. Nothing
 * of it can be left out. */
#include "num/func.h"
#include "num/num_double.h"
#include "num/sin_core.h"
#include "tests/emu/bare/bare.h"
#include "tests/emu/bare/same.h"

static uint32_t word(uint64_t *state) {
    static const uint32_t HARD[8] = {0, 1, 0xffff, 0x10000, 0x7fffffff, 0x80000000, 0xffff0000, 0xffffffff};
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return *state >> 61 ? (uint32_t)(*state >> 24) : HARD[*state >> 40 & 7];
}

static void enter(same_t *s, num_t a, const char *after) {
    same_enter(s, a.m, " ");
    same_enter(s, a.e + a.undef, after);
}

void same_scene(uint64_t seed, same_t *s) {
    for (int k = 0; k < 16; k++) {
        const uint32_t a = word(&seed), b = word(&seed), c = word(&seed), d = word(&seed);
        same_enter(s, (int64_t)wide_mul_u32(a, b), " ");
        same_enter(s, wide_mul_s32((int32_t)a, (int32_t)b), " products\n");
        const num_t x = num_from_fixed((int64_t)((uint64_t)a << 32 | c), (int)(b & 63)),
                    y = num_from_fixed((int64_t)((uint64_t)d << 32 | b), (int)(c & 127));
        enter(s, num_double_add(num_double(x), y), " sum\n");
        enter(s, num_double_mul(x, y), " product\n");
        const wide_u_t wide = wide_mul_u64((uint64_t)a << 32 | c, (uint64_t)d << 32 | b);
        same_enter(s, (int64_t)wide.hi, " ");
        same_enter(s, (int64_t)wide.lo, " wide product\n");
        enter(s, num_double_div(x, y), " quotient\n");
        enter(s, num_double_sqrt(y), " root\n");
        const sin_core_t sine = sin_core(words_of(ints_abs64(y.m)), -53 - (int)(c & 31), b & 64);
        same_enter(s, sine.sure ? (int64_t)words_join(sine.m) : 0, " sine\n");
        enter(s, func_exp(num_ldexp(x, -54)), " exp\n");
    }
}
