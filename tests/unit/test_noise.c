/* test_noise.c - the generator is L'Ecuyer's, in the numbers that C's doubles give; places have numbers of their own.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "num/noise.h"
#include <math.h>

static double as_double(num_t a) {
    assert_false(a.undef);
    return ldexp((double)a.m, a.e);
}

/* The generator as it is written down, by division. */
static double reference(int64_t s[2]) {
    s[0] = s[0] * 40014 % NOISE_M1;
    s[1] = s[1] * 40692 % NOISE_M2;
    int64_t z = s[0] - s[1];
    if (z < 1) z += NOISE_M1 - 1;
    return (double)z * 4.656613057e-10;
}

static void follows(int32_t a, int32_t b, int count) {
    int32_t seed[2] = {a, b};
    int64_t s[2] = {a, b};
    for (int k = 0; k < count; k++) {
        const double want = reference(s), got = as_double(noise_next(seed));
        if (want != got || s[0] != seed[0] || s[1] != seed[1])
            fail_msg("seeds %d, %d, number %d: %.17g instead of %.17g", (int)a, (int)b, k, got, want);
        assert_true(got > 0 && got < 1);
    }
}

static void numbers_are_those_of_division(void **state) {
    (void)state;
    follows(1, 1, 100000);
    follows(NOISE_START, NOISE_START, 100000);
    for (int32_t k = 1; k < 1000; k++) {
        follows(k, k * 7919, 100);
        follows(NOISE_M1 - k, NOISE_M2 - k, 100);
        follows(NOISE_M1 - k, k, 100);
    }
}

/* Neighbours of any spacing, and seeds, share nothing: over the lattice numbers are even, and pairs do not go together.
 */
static void places_are_even_and_apart(void **state) {
    (void)state;
    enum { N = 200 };
    for (int scale = -40; scale <= 40; scale += 20) {
        double sum = 0, along = 0, across = 0, squares = 0, row[N] = {0};
        for (int j = 0; j < N; j++) {
            double left = 0;
            for (int i = 0; i < N; i++) {
                const num_t at[2] = {num_from_fixed(i - N / 2, scale), num_from_fixed(j - N / 2, scale)};
                int32_t seed[2] = {1, 2};
                noise_seeds(noise_at(noise_at(noise_hash(seed), at[0]), at[1]), seed);
                assert_in_range(seed[0], 1, NOISE_M1 - 1);
                assert_in_range(seed[1], 1, NOISE_M2 - 1);
                const double v = as_double(noise_next(seed)) - 0.5;
                sum += v;
                squares += v * v;
                along += v * left;
                across += v * row[i];
                left = row[i] = v;
            }
        }
        const double n = N * N, sigma = sqrt(n) / 12; /* of a sum of products */
        if (fabs(sum) > 4 * sqrt(n / 12) || fabs(along) > 4 * sigma || fabs(across) > 4 * sigma)
            fail_msg("scale %d: %g %g %g", scale, sum / n, along / sigma, across / sigma);
        assert_true(fabs(squares / n - 1.0 / 12) < 0.002);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_those_of_division),
        cmocka_unit_test(places_are_even_and_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
