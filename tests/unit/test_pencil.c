/* pencil_divide against the fraction by division that it stands for (on the desktop). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define DICE_SEED 0x9e3779b97f4a7c15u
#include "dice.h"
#include "view/pencil.h"

static void check(uint64_t num, uint64_t den) {
    if (pencil_divide(num, den) != pencil_fraction(num, den))
        fail_msg("%llu / %llu", (unsigned long long)num, (unsigned long long)den);
}

#define MOST ((UINT64_C(1) << 34) - 1)

static void every_short_divisor(void **state) {
    (void)state;
    for (uint64_t den = 1; den < 1 << 17; den++) {
        check(0, den);
        check(1, den);
        check(den / 3, den);
        check(den - 1, den);
        check(den, den);
        check((den << 17) - 1, den << 17); /* and with these upper bits */
        check((den << 17) / 2 + 1, (den << 17) - 1);
    }
}

static void long_ones(void **state) {
    (void)state;
    for (int k = 0; k < 2000000; k++) {
        const uint64_t den = (dice() & MOST) >> (dice() % 33) | 1;
        const uint64_t num = dice() % (den + 1), quotient = dice() & ((1 << 30) - 1);
        check(num, den);
        /* where the quotient steps */
        const uint64_t step = (quotient * (den >> 15)) >> 15;
        check(step, den);
        if (step > 0) check(step - 1, den);
    }
    for (int k = 0; k < 1000000; k++) {
        const uint64_t den = dice() >> (dice() % 31) | 1;
        check(dice() % den, den);
        check(den, den);
    }
    for (uint64_t k = 0; k < 100000; k++) {
        check(MOST - k, MOST);
        check(MOST - k, MOST - k);
        check(k, MOST - k);
        check(((MOST + 1) >> 1) - k, (MOST + 1) >> 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_short_divisor), cmocka_unit_test(long_ones)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
