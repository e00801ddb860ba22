/* Grids too large to be judged whole: a few of their lines are. What breaks at 10^6 facets and not at 10^3 is the sum
 * of small errors, a horizon of thousands of pieces, and cells of less than a step. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/run_cases.h"

typedef struct large_case {
    const char *name;
    enum scene_shape shape;
    int n;
    exact_eye_t eye;
    bool holes; /* a third of the points */
} large_case_t;

static const large_case_t list[] = {
    {"smooth 500x500", SHAPE_SMOOTH, 500, {6, 8, 3, 1}, false},
    {"random 400x400", SHAPE_RANDOM, 400, {6, 8, 3, 1}, false},
    {"random 400x400, grazing", SHAPE_RANDOM, 400, {4, 5, 1.02, 1}, false},
    {"walk 400x400, inside", SHAPE_WALK, 400, {.4, -.3, 3, 1}, false},
    {"sinc 300x300, parallel", SHAPE_SINC, 300, {.5, -.866, .577, 0}, false},
    {"random 1500x3", SHAPE_RANDOM, 1500, {6, 8, 3, 1}, false},
    {"random 400x400 with holes", SHAPE_RANDOM, 400, {6, 8, 3, 1}, true},
    {"the same from above", SHAPE_RANDOM, 400, {.1, .2, 9, 1}, true},
    {"the same, parallel and steep", SHAPE_RANDOM, 400, {.03, -.07, 1, 0}, true},
};

static void test_large(void **state) {
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        const large_case_t *l = &list[i];
        cases_t c = {.name = l->name};
        uint64_t rng = 11;
        scene_t s;
        scene_init(&s, l->n, l->n > 1000 ? 3 : l->n);
        scene_shape(&s, l->shape, &rng);
        if (l->holes) {
            s.ref.hole = calloc((size_t)l->n * (size_t)l->n, 1);
            assert_non_null(s.ref.hole);
            for (int k = 0; k < l->n * l->n; k++) s.ref.hole[k] = scene_below(&rng, 3) == 0;
        }
        s.ref.eye = l->eye;
        scene_aim(&s);
        snprintf(s.what, sizeof s.what, "%s", l->name);
        c.every = l->n > 1000 ? 0 : l->holes ? l->n / 10 : l->n / 2;
        if (!cases_surface(&c, &s, 0, false)) failed++;
        cases_summary(&c);
        scene_free(&s);
    }
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_large)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
