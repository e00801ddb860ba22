/* eval_row_narrow.c - see eval_row_arith.h. */
#include "lang/eval_row_arith.h"
#include "num/double_words.h"

#if EVAL_ROW_MAX > 1 && !CONFIG_64BIT

/* Zeros and what is undefined are told by the upper word alone. */
static inline bool is_rare(const value_t *a, const value_t *b) {
    return NUM_FAST_RARE((a->kind | b->kind) != VALUE_REAL || num_double_rare(eval_row_num(a), eval_row_num(b)));
}

#define EACH_BINARY(expression)                                                                                        \
    for (int k = 0; k < w->n; k++, a.at += a.step, b.at += b.step, to++) {                                             \
        if (is_rare(a.at, b.at))                                                                                       \
            eval_row_slow(w, k, op, a.at, b.at, to);                                                                   \
        else if (NUM_FAST_RARE(eval_row_put(to, expression)))                                                          \
            w->dead |= (eval_row_points_t)1 << k;                                                                      \
    }

/* Functions of their own: a small core keeps more in registers. */
static __attribute__((noinline)) num_t add_cancelling(int64_t am, int32_t ae, int64_t bm, int32_t be) {
    return num_double_difference_narrow((num_t){am, ae, false}, (num_t){bm, be, false});
}
static inline num_t sum(int64_t am, int32_t ae, int64_t bm, int32_t be) {
    if ((am ^ bm) < 0) return add_cancelling(am, ae, bm, be);
    return num_double_sum_narrow((num_t){am, ae, false}, (num_t){bm, be, false});
}
/* One copy serves both. */
void eval_row_sum(eval_row_work_t *w, uint8_t op, eval_row_operand_t a, eval_row_operand_t b, value_t *to) {
    EACH_BINARY(sum(a.at->m, a.at->e, op == OP_SUB ? -b.at->m : b.at->m, b.at->e));
}
static __attribute__((noinline)) void multiply(eval_row_work_t *w, uint8_t op, eval_row_operand_t a,
                                               eval_row_operand_t b, value_t *to) {
    EACH_BINARY(num_double_mul(eval_row_num(a.at), eval_row_num(b.at)));
}
void eval_row_quotient(eval_row_work_t *w, eval_row_operand_t a, eval_row_operand_t b, value_t *to) {
    const uint8_t op = OP_DIV;
    EACH_BINARY(EVAL_ROW_WORDS ? double_words_div(eval_row_num(a.at), eval_row_num(b.at))
                               : num_double_div(eval_row_num(a.at), eval_row_num(b.at)));
}

/* The products of a number that is the same for all points and short, as 5 or 0.25. */
static __attribute__((noinline)) void multiply_by_word(eval_row_work_t *w, uint8_t op, eval_row_operand_t a,
                                                       eval_row_operand_t b, value_t *to) {
    EACH_BINARY(double_words_mul_short(eval_row_num(a.at), eval_row_num(b.at)));
}
static bool is_short(eval_row_operand_t b) {
    return EVAL_ROW_WORDS && b.step == 0 && (uint32_t)b.at->m == 0;
}
void eval_row_product(eval_row_work_t *w, eval_row_operand_t a, eval_row_operand_t b, value_t *to) {
    if (is_short(b))
        multiply_by_word(w, OP_MUL, a, b, to);
    else if (is_short(a))
        multiply_by_word(w, OP_MUL, b, a, to);
    else
        multiply(w, OP_MUL, a, b, to);
}

#endif
