/* inline.h - calls of user functions replaced by what the functions say, for hoist.c.
 *
 *     f(a,b) = a**2 + b        f(x, 2*y)  ->  x**2 + 2*y
 *
 * An argument that is used twice is kept (OP_KEEP) where it is used first. The value is that of the calls, bit for bit:
 * the same operations on the same operands. */
#ifndef INLINE_H
#define INLINE_H

#include "lang/code.h"
#include "lang/expr.h"

#define INLINE_CODE_MAX ((size_t)4 * CONFIG_PARTS) /* bytes of code; what would be longer is left as it is */

/* A part with a smaller stack never lends as much as it takes, and saves the flash. */
#define INLINE_CALLS (CONFIG_STACK >= 64)

static inline bool inline_is_call(const expr_t *x) {
    for (const uint8_t *p = x->code; p < x->code + x->len; p += 1 + code_operands(*p)) {
        if (*p == OP_CALL) return true;
    }
    return false;
}

/* Replaces all calls of x, whose code moves to buf. buf: 2 * INLINE_CODE_MAX bytes, of which x->len are used in the
 * end. False, x being as it was, if there is something that cannot be moved: a function that does not exist, takes
 * another number of arguments, chooses (?:, &&), calls itself or does not use an argument that is more than a value. */
bool inline_calls(const lang_t *l, expr_t *x, uint8_t *buf);

#endif
