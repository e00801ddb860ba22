/* compile.h - what is open while an expression is compiled; between compile.c and compile_operand.c only. */
#ifndef COMPILE_H
#define COMPILE_H

#include "lang/emit.h"
#include "lang/expr.h"

/* Precedences; the open brackets stay below all operators. */
enum { OPEN = 0, LOOSE = 1, OR = 2, AND = 3, EQUAL = 7, SUM = 10, PREFIX = 12, POWER = 13 };

enum pending_kind {
    P_BINARY,  /* a = operation */
    P_PREFIX,  /* a = operation */
    P_LOGIC,   /* && ||: at = its jump */
    P_TEXT,    /* . eq ne: a = builtin */
    P_SET,     /* from here on what a value may be assigned behind. name = ...: a = symbol */
    P_ELSE,    /* behind the colon: at = the jump over it */
    P_THEN,    /* from here on brackets. Behind the question mark: at = the jump to the other side */
    P_GROUP,   /* ( */
    P_BUILTIN, /* name( : a = index, at = arguments so far */
    P_USER,    /* name( : a = symbol, at = arguments so far */
    P_ELEMENT, /* [ of an array */
    P_SLICE,   /* [ behind a text: at = bounds so far */
};

typedef struct pending {
    uint8_t kind;
    uint8_t a;
    uint16_t at;
} pending_t;

typedef struct compiler {
    emit_t e;
    lexer_t *lx;
    const expr_params_t *params;
    lang_error_t *err;
    bool columns;
    bool calls;  /* a function of the user's */
    int pending; /* entries of stack in use */
    pending_t stack[CONFIG_NESTING];
} compiler_t;

_Static_assert(sizeof(pending_t) == 4, "the header promises 4 bytes for each level of nesting");

/* compile.c: one more is open. 0 or ERR_FULL. */
int compile_open(compiler_t *c, int kind, int a, uint16_t at);
/* compile_operand.c: takes one token where an operand is expected. Returns 1 when it was one, 0 when it still is
 * expected, or an error. */
int compile_operand(compiler_t *c);
#if CONFIG_CONTROL
/* compile_text.c: texts and arrays. Does an operand of theirs begin here; takes it, as compile_operand does. */
bool compile_is_text(const compiler_t *c);
int compile_text(compiler_t *c);
/* The same behind an operand: COMPILE_NOT_TEXT if nothing of theirs stands here. in: the open bracket, or NULL. */
#define COMPILE_NOT_TEXT 3
int compile_behind(compiler_t *c, pending_t *in);
/* A function without a name of the user's: of the topmost n operands. */
void compile_builtin(compiler_t *c, const char *name, int n);
/* What a variable of `for` holds now. 1, or ERR_FULL. */
int compile_iterated(compiler_t *c, int symbol);
/* compile.c: closes the operators that bind at least as tightly as `limit`. */
void compile_reduce(compiler_t *c, int limit);
#endif

#endif
