/* expr.h - expressions: compiled once to a small stack code, evaluated many times.
 *
 * Grammar, tightest first, as gnuplot's:  postfix !, ** (right)  |  unary - + ! ~  |  * / %  |  + -  |  << >>  |
 * < <= > >=  |  == !=  |  &  |  ^  |  |  |  &&  |  ||  |  ?: (right)  |  name = expression.
 * (a, b) yields b. -2**2 is -4. Integers stay integers: 7/2 is 3.
 *
 * Functions: abs acos asin atan atan2 besj0 besj1 ceil column cos cosh erf exp floor gamma int invnorm log log10
 * max min norm rand real sgn sin sinh sqrt tan tanh, and the user's of up to EXPR_PARAMS arguments. A function
 * looks up other functions and variables when it is called, so they may be defined and changed later.
 *
 * Undefined results (1/0, sqrt(-1), log(0), overflow) end the evaluation: the result is undefined as a whole, no
 * error, a hole in a plot. NaN itself travels through arithmetic, and compares as false.
 *
 * Neither compiling nor evaluating recurses; everything that can run out is an ordinary ERR_FULL.
 * Context: main loop; one evaluation at a time for each lang_t. */
#ifndef EXPR_H
#define EXPR_H

#include "lang/lexer.h"
#include "lang/names.h"

#define EXPR_PARAMS 8
/* Dummy variables: parameter i stands for args[i]. */
typedef struct expr_params {
    uint8_t count; /* 0 .. EXPR_PARAMS */
    struct {
        const char *text;
        uint8_t len;
    } name[EXPR_PARAMS];
#if CONFIG_LOGSCALE
    const num_t *base[2], *result_base; /* logarithmic axes: parameter i is a logarithm, or the result; NULL: not */
#endif
    bool any_kind; /* arguments may be integers too: those of a user's function */
} expr_params_t;

/* A compiled expression. The code bytes belong to the caller and must stay where they are. */
typedef struct expr {
    const uint8_t *code;
    uint16_t len;   /* bytes */
    uint16_t stack; /* values it needs on the stack, arguments included */
    uint8_t params;
    bool columns; /* mentions $n or column() itself */
} expr_t;

/* Compiles the expression that starts at the current token of lx, and leaves lx at the first token that does not
 * belong to it. params may be NULL: none. The code goes to buf; a byte of code for each operator, 2 for
 * a name or small integer, 4 for a short real as 0.25, 11 for another constant; exp(-x**2-y**2) takes 9. Constant parts
 * are computed now. Returns 0, or with *err filled ERR_SYNTAX, ERR_NAME (a function that is neither built in nor called
 * as user functions are), ERR_FULL. */
int expr_compile(lang_t *l, lexer_t *lx, const expr_params_t *params, uint8_t *buf, size_t size, expr_t *out,
                 lang_error_t *err);

/* Evaluates. args: e->params real numbers. Returns 0, also when *out is undefined; or ERR_NAME (a variable or function
 * that does not exist), ERR_VALUE (an operand of the wrong kind), ERR_FULL (stack or calls); *out is then undefined and
 * expr_fault has the details. Cost on a desktop core: 6 ns, and 1 to 4 ns an operator (division 9), plus the functions.
 */
int expr_eval(lang_t *l, const expr_t *e, const num_t *args, value_t *out);

/* The same with the arguments, values of any kind, at the start of l->stack already. */
int expr_run(lang_t *l, const expr_t *e, value_t *out);

/* Describes the last failure of expr_eval. at: a copy of the lexer as it stood when the expression was compiled,
 * to find the column of the name that is at fault; or NULL. Returns the code. */
int expr_fault(const lang_t *l, const lexer_t *at, lang_error_t *err);

/* Can two evaluations with the same arguments differ: does it, or a function it calls, use rand() or assign? */
bool expr_is_impure(const lang_t *l, const expr_t *e);
#if CONFIG_CONTROL
/* Does it, or a function it calls, look at this variable? */
bool expr_mentions(const lang_t *l, const expr_t *e, int symbol);
#endif

#if CONFIG_64BIT || CONFIG_BINARY
/* Is the value of e decided by columns of data that it names by numbers: *columns, bit c for column c below 63? */
bool expr_is_of_columns(const lang_t *l, const expr_t *e, uint64_t *columns);
#endif

/* Compiles, evaluates and forgets the expression at lx: for print and for the numbers in a `set`.
 * expr_value yields undefined values as such only if they are NaN; otherwise, and in the other two for any value that
 * is not a number (or not within [lo, hi]), ERR_VALUE. Returns 0 or an error with *err filled, column included.
 * expr_integer takes reals that have no fraction too. */
int expr_value(lang_t *l, lexer_t *lx, value_t *out, lang_error_t *err);
int expr_number(lang_t *l, lexer_t *lx, num_t *out, lang_error_t *err);
int expr_integer(lang_t *l, lexer_t *lx, int32_t lo, int32_t hi, int32_t *out, lang_error_t *err);

/* If the tokens at lx read `name = expression` or `name(a,b) = expression`, carries the definition out and
 * returns 1; lx is then behind it. Returns 0, lx untouched, if they do not; or an error. */
int expr_define(lang_t *l, lexer_t *lx, lang_error_t *err);

#endif
