/* eval_row_real.h - functions of one real number at several points; and what the operations of eval_row.c share.
 * Internal to both. */
#ifndef EVAL_ROW_REAL_H
#define EVAL_ROW_REAL_H

#include "lang/arith.h"
#include "lang/eval_row.h"

typedef struct operand {
    const value_t *at;
    int32_t step;
} eval_row_operand_t;

static inline num_t eval_row_num(const value_t *v) {
    return (num_t){v->m, v->e, false};
}
static inline bool eval_row_put(value_t *to, num_t r) {
    to->m = r.m;
    to->e = r.e;
    to->kind = r.undef; /* VALUE_REAL or VALUE_UNDEF */
    return r.undef;
}

/* Rows without calls are worth their bytes where heights are evaluated again and again. */
#define EVAL_ROW_WORDS (CONFIG_ROW_FUNCTIONS && CONFIG_DOUBLE_WORDS)

/* One bit a point. */
#if EVAL_ROW_MAX > 32
typedef uint64_t eval_row_points_t;
#else
typedef uint32_t eval_row_points_t;
#endif

/* What all operations share: a result for each point, and which of them are undefined as a whole. */
typedef struct work {
    int n;
    eval_row_points_t dead; /* by points */
    bool failed;
} eval_row_work_t;

static inline void eval_row_note(eval_row_work_t *w, int k, const char *fault) {
    if (!fault) return;
    w->dead |= (eval_row_points_t)1 << k;
    w->failed |= fault != ARITH_UNDEFINED;
}

/* f of each point: the double nearest to f's value, as expr_run has it. exp, sin and cos have ways of their own. */
void eval_row_real(eval_row_work_t *w, num_t (*f)(num_t), eval_row_operand_t a, value_t *to);

#endif
