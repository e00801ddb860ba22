/* test_eval_row.c - rows of sums, products, quotients, and functions are what their points are one by one, bit for bit,
 * whatever the operands are: doubles with runs of bits, near cancellation, near the ends of the range, numbers of more
 * bits than a double, integers, nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "lang/eval_row_arith.h"
#include "num/func.h"
#include "num/num_double.h"

enum { POINTS = EVAL_ROW_MAX, ROWS = 40000 };

static uint64_t random_state = 88172645463325252u;
static uint64_t draw(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    return random_state ^= random_state << 17;
}

static uint64_t odd_bits(void) {
    const uint64_t bits = draw() >> 11;
    switch (draw() % 4) {
    case 0:
        return bits & ~(uint64_t)0 << draw() % 53;
    case 1:
        return bits | (((uint64_t)1 << draw() % 53) - 1);
    case 2:
        return ((uint64_t)1 << draw() % 53) + draw() % 3;
    default:
        return bits;
    }
}

/* How a row's values are: exponents close together or far apart; every so many are no doubles. */
typedef struct kind {
    int around, apart, odd;
} kind_t;

static value_t operand(const kind_t *kind) {
    const int64_t sign = draw() % 2 ? -1 : 1;
    if (kind->odd && draw() % (unsigned)kind->odd == 0) {
        switch (draw() % 5) {
        case 0:
            return value_undef();
        case 1:
            return value_int((int64_t)(draw() % 7) - 3);
        case 2:
            return value_int((int64_t)draw());
        case 3:
            return value_real(num_from_i64(0));
        default: /* more bits than a double has */
            return value_real((num_t){sign * (int64_t)(draw() >> 2 | (uint64_t)1 << 62), kind->around - 62, false});
        }
    }
    int e = kind->around - 62 + (int)(draw() % (unsigned)(2 * kind->apart + 1)) - kind->apart;
    if (e < NUM_DOUBLE_E_MIN) e = NUM_DOUBLE_E_MIN;
    if (e > NUM_DOUBLE_E_MAX) e = NUM_DOUBLE_E_MAX;
    const uint64_t m = (uint64_t)1 << 62 | (odd_bits() << 10 & (((uint64_t)1 << 62) - 1));
    return value_real((num_t){sign * (int64_t)m, e, false});
}

static kind_t any_kind(void) {
    static const int APART[] = {0, 1, 2, 12, 70, 1000};
    const int apart = APART[draw() % 6];
    return (kind_t){draw() % 8 ? (int)(draw() % 20) - 10 : (int)(draw() % 2000) - 1000, apart, draw() % 3 ? 0 : 5};
}

/* One or POINTS of them. */
static eval_row_operand_t row_of(value_t *at, bool same) {
    kind_t kind = any_kind();
    for (int k = 0; k < POINTS; k++) at[k] = operand(&kind);
    if (same && draw() % 2)
        at[0] = value_real((num_t){(draw() % 2 ? 1 : -1) * ((int64_t)1 << 62), kind.around - 62, false});
    return (eval_row_operand_t){at, same ? 0 : 1};
}

static void assert_point(const value_t *got, const value_t *want, const eval_row_work_t *w, bool dead, int k) {
    if ((w->dead >> k & 1) != dead || got->kind != want->kind || (!dead && (got->m != want->m || got->e != want->e)))
        fail_msg("point %d: kind %d, %lld * 2^%d, not %d, %lld * 2^%d", k, got->kind, (long long)got->m, (int)got->e,
                 want->kind, (long long)want->m, (int)want->e);
}

static void operators_are_those_of_points(void **state) {
    (void)state;
    static const uint8_t OPS[] = {OP_ADD, OP_SUB, OP_MUL, OP_DIV};
    int64_t real = 0;
    for (int row = 0; row < ROWS; row++) {
        value_t first[POINTS], second[POINTS], to[POINTS];
        const uint8_t op = OPS[row % 4];
        const eval_row_operand_t a = row_of(first, draw() % 3 == 0), b = row_of(second, draw() % 3 == 0);
        eval_row_work_t w = {.n = POINTS - (int)(draw() % 3)};
        if (op == OP_MUL)
            eval_row_product(&w, a, b, to);
        else if (op == OP_DIV)
            eval_row_quotient(&w, a, b, to);
        else
            eval_row_sum(&w, op, a, b, to);
        for (int k = 0; k < w.n; k++) {
            value_t want = a.at[k * a.step];
            const bool dead = arith_binary(op, &want, b.at[k * b.step]) != NULL;
            assert_point(&to[k], &want, &w, dead, k);
            real += want.kind == VALUE_REAL;
        }
        assert_false(w.failed);
    }
    print_message("# %lld real results\n", (long long)real);
    assert_true(real > (int64_t)ROWS * POINTS / 2);
}

static void functions_are_those_of_points(void **state) {
    (void)state;
    static num_t (*const FUNCTIONS[])(num_t) = {func_sin, func_cos, func_exp, num_double_sqrt, func_atan};
    for (int row = 0; row < ROWS; row++) {
        value_t args[POINTS], to[POINTS];
        num_t (*f)(num_t) = FUNCTIONS[row % 5];
        const eval_row_operand_t a = row_of(args, draw() % 8 == 0);
        eval_row_work_t w = {.n = POINTS};
        eval_row_real(&w, f, a, to);
        for (int k = 0; k < POINTS; k++) {
            const value_t *arg = &a.at[k * a.step];
            value_t want = *arg;
            if (arg->kind != VALUE_UNDEF) want = value_real(num_double(f(value_num(*arg))));
            assert_point(&to[k], &want, &w, arg->kind != VALUE_UNDEF && want.kind == VALUE_UNDEF, k);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operators_are_those_of_points),
        cmocka_unit_test(functions_are_those_of_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
