/* eval_row_real.c - see eval_row_real.h. Functions apart: a small core keeps more in registers. */
#include "lang/eval_row_real.h"
#include "num/double_words.h"
#include "num/exp_core.h"
#include "num/func.h"
#include "num/sin_core.h"
#include "num/trig_core.h"

#if EVAL_ROW_MAX > 1

static __attribute__((noinline)) void real_one(eval_row_work_t *w, int k, num_t (*f)(num_t), const value_t *a,
                                               value_t *to) {
    if (a->kind == VALUE_UNDEF) {
        *to = *a;
        return;
    }
    if (eval_row_put(to, num_double(f(value_num(*a))))) w->dead |= (eval_row_points_t)1 << k;
}

/* The points whose operand is a real number have `expression`; all others, and those of which it says !usual, f. */
#define EACH_REAL(usual, expression)                                                                                   \
    for (int k = 0; k < w->n; k++, a.at += a.step, to++) {                                                             \
        if (NUM_FAST_RARE(a.at->kind != VALUE_REAL || !(usual)))                                                       \
            real_one(w, k, f, a.at, to);                                                                               \
        else if (NUM_FAST_RARE(eval_row_put(to, expression)))                                                          \
            w->dead |= (eval_row_points_t)1 << k;                                                                      \
    }

static __attribute__((noinline)) void real_any(eval_row_work_t *w, num_t (*f)(num_t), eval_row_operand_t a,
                                               value_t *to) {
    EACH_REAL(true, num_double(f(eval_row_num(a.at))))
}

static __attribute__((noinline)) void real_root(eval_row_work_t *w, num_t (*f)(num_t), eval_row_operand_t a,
                                                value_t *to) {
    EACH_REAL(true, EVAL_ROW_WORDS ? double_words_sqrt(eval_row_num(a.at)) : num_double_sqrt(eval_row_num(a.at)))
}

#if CONFIG_ROW_FUNCTIONS

static inline num_t exponential_of(const value_t *a) {
    const int32_t steps = exp_steps(a->m, a->e);
    const exp_core_t r = exp_reduced(steps, exp_rest(a->m, a->e, steps));
    return num_double_round_words(r.m, r.e, 0);
}
static __attribute__((noinline)) void exponential(eval_row_work_t *w, num_t (*f)(num_t), eval_row_operand_t a,
                                                  value_t *to) {
    EACH_REAL(a.at->m >> 32 != 0 && a.at->e <= -53, exponential_of(a.at))
}

/* sin, or a quarter of a turn on and whatever the sign, cos. */
static __attribute__((noinline)) void circular_words(eval_row_work_t *w, num_t (*f)(num_t), eval_row_operand_t a,
                                                     value_t *to) {
    const uint32_t quarter = f == func_cos ? 64 : 0;
    sin_core_t r;
    uint32_t sign;
    EACH_REAL((sign = words_sign(words_of((uint64_t)a.at->m)),
               r = sin_core(words_with_sign(words_of((uint64_t)a.at->m), sign), a.at->e, quarter), r.sure),
              num_double_round_words(r.m, r.e, quarter ? r.sign : r.sign ^ sign))
}

static inline num_t sine_of(const value_t *a, uint32_t steps, uint32_t quarter) {
    const int64_t turned = -(int64_t)((steps + quarter) >> 7 & 1), sign = quarter ? turned : turned ^ a->m;
    const trig_small_t s = trig_small(trig_rest_q69(ints_abs64(a->m), a->e, steps));
    const uint64_t u = trig_sine_q62(steps + quarter, s); /* not 0, below 2^63 */
    const int n = ints_clz64(u);
    return num_double_round(u << n, -62 - n, sign);
}
/* The same with products of 64 bits, as func_sin and func_cos do it but for a multiple of pi, where a zero may be. */
static __attribute__((noinline)) void circular(eval_row_work_t *w, num_t (*f)(num_t), eval_row_operand_t a,
                                               value_t *to) {
    const uint32_t quarter = f == func_cos ? 64 : 0;
    uint32_t steps;
    EACH_REAL(TRIG_WHOLE(a.at->e) &&
                  (steps = trig_nearest(ints_abs64(a.at->m), a.at->e), ((steps + quarter) & 127) != 0),
              sine_of(a.at, steps, quarter))
}

#endif

void eval_row_real(eval_row_work_t *w, num_t (*f)(num_t), eval_row_operand_t a, value_t *to) {
    if (f == num_double_sqrt) real_root(w, f, a, to);
#if CONFIG_ROW_FUNCTIONS
    else if (f == func_exp)
        exponential(w, f, a, to);
    else if (f == func_sin || f == func_cos)
        NUM_DOUBLE_NARROW ? circular_words(w, f, a, to) : circular(w, f, a, to);
#endif
    else
        real_any(w, f, a, to);
}

#endif
