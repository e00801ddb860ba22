/* eval_row_arith.h - sums, products and quotients at several points. Internal to eval_row.c; for a core with registers
 * of 64 bits in eval_row_wide.c, for others in eval_row_narrow.c. */
#ifndef EVAL_ROW_ARITH_H
#define EVAL_ROW_ARITH_H

#include "lang/eval_row_real.h"

/* a op b of each point, op being OP_ADD or OP_SUB. */
void eval_row_sum(eval_row_work_t *w, uint8_t op, eval_row_operand_t a, eval_row_operand_t b, value_t *to);
/* a b of each point; a may be b. */
void eval_row_product(eval_row_work_t *w, eval_row_operand_t a, eval_row_operand_t b, value_t *to);
/* a / b of each point. */
void eval_row_quotient(eval_row_work_t *w, eval_row_operand_t a, eval_row_operand_t b, value_t *to);

/* Point k's a op b, whatever they are. */
void eval_row_slow(eval_row_work_t *w, int k, uint8_t op, const value_t *a, const value_t *b, value_t *to);

#endif
