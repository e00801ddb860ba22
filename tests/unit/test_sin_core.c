/* test_sin_core.c - where sin_core is sure, its double is that of func_sin and func_cos. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "num/func.h"
#include "num/num_double.h"
#include "num/sin_core.h"

static uint64_t random_state = 88172645463325252u;
static uint64_t draw(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    return random_state ^= random_state << 17;
}

/* A double near a multiple of pi/256, where what is left is zero or largest, or anywhere below 1024. */
static num_t angle(void) {
    const num_t step = num_ldexp(num_from_fixed(0x1921fb54442d1846, 59), -8);
    if (draw() % 2) return num_double(num_mul(step, num_from_i64((int64_t)(draw() % 83443 + 1))));
    return (num_t){(int64_t)(draw() >> 2 & ~(uint64_t)0x3FF) | (int64_t)1 << 62, -53 - (int)(draw() % 24), false};
}

static void doubles_are_those_of_the_functions(void **state) {
    (void)state;
    enum { ANGLES = 1000000 };
    int sure = 0;
    int64_t most = 0;
    for (int i = 0; i < ANGLES; i++) {
        const num_t a = angle();
        const uint32_t quarter = draw() & 64;
        const num_t f = quarter ? func_cos(a) : func_sin(a);
        const sin_core_t s = sin_core(words_of((uint64_t)a.m), a.e, quarter);
        if (!s.sure) continue;
        sure++;
        const int64_t m = (int64_t)words_join(words_with_sign(s.m, s.sign)), apart = f.e == s.e ? llabs(m - f.m) : 0;
        if (apart >> (-62 - s.e) > most) most = apart >> (-62 - s.e);
        const num_t want = num_double(f), got = num_double_round_words(s.m, s.e, s.sign);
        if (got.m != want.m || got.e != want.e)
            fail_msg("%lld * 2^%d, quarter %u", (long long)a.m, (int)a.e, (unsigned)quarter);
    }
    print_message("# %d angles: sure of %d, at most %lld units of 2^-62 apart (%d are allowed for)\n", ANGLES, sure,
                  (long long)most, (int)SIN_CORE_OFF);
    assert_true(most <= SIN_CORE_OFF && sure > ANGLES * 3 / 4);
}

/* What it has no way for, it leaves. */
static void rare_ones_are_left(void **state) {
    (void)state;
    static const struct {
        int64_t m;
        int32_t e;
        uint32_t quarter;
    } RARE[] = {
        {0, 0, 0},
        {0, 0, 64},
        {(int64_t)1 << 62, -52, 0}, /* 1024 */
        {(int64_t)1 << 62, 300, 64},
        {(int64_t)1 << 62, -74, 64}, /* 2^-12 */
        {(int64_t)1 << 62, -1100, 0},
        {0x6487ed5110b46000, -61, 0},  /* pi */
        {0x6487ed5110b46000, -62, 64}, /* pi/2 */
    };
    for (size_t i = 0; i < sizeof RARE / sizeof *RARE; i++)
        assert_false(sin_core(words_of((uint64_t)RARE[i].m), RARE[i].e, RARE[i].quarter).sure);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(doubles_are_those_of_the_functions),
        cmocka_unit_test(rare_ones_are_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
