/* names.h - the language's context: variables, user functions and the memory they live in.
 *
 * Two tables share one array of symbols, as in gnuplot f and f(x) may both exist. Names and the code of functions lie
 * in one pool of bytes: names grow up from its start, function bodies follow; what is left at the end is lent
 * to expressions that are compiled, evaluated and forgotten. Redefining a function closes the gap of its old body.
 *
 * Compiled code names symbols by their index, so a symbol once made keeps its place until names_reset.
 *
 * Memory of a lang_t with the sizes below: symbols 24 bytes each, pool, stack 16 bytes each, calls 8 bytes each:
 * 3 KB + 8 KB + 4 KB + 0.5 KB. For a part with 16 KB of RAM: -DLANG_SYMBOLS=40 -DLANG_POOL=1024 -DLANG_STACK=48
 * -DLANG_CALLS=12 takes 2.9 KB. Every one that runs out is an ordinary ERR_FULL that names it. */
#ifndef NAMES_H
#define NAMES_H

#include "lang/lang_error.h"
#include "lang/value.h"
#include <stdbool.h>

#ifndef LANG_SYMBOLS
#define LANG_SYMBOLS 128 /* variables and functions, at most 255 */
#endif
#ifndef LANG_POOL
#define LANG_POOL 8192 /* bytes of names, functions and passing expressions, at most 65535 */
#endif
#ifndef LANG_STACK
#define LANG_STACK 256 /* values: arguments and operands of all calls under way */
#endif
#ifndef LANG_CALLS
#define LANG_CALLS 64 /* user functions under way at once: the limit of recursion */
#endif

enum symbol_kind { SYMBOL_VARIABLE, SYMBOL_FUNCTION };

typedef struct symbol {
    uint16_t name;    /* where its name starts in the pool */
    uint8_t name_len; /* bytes */
    uint8_t kind;     /* enum symbol_kind */
    bool defined;     /* false: somebody mentioned it, nobody said what it is */
    uint8_t params;   /* of a function */
    union {
        value_t value; /* of a variable */
        struct {
            uint16_t start, len, stack; /* in the pool, in bytes; values it needs on the stack */
        } code;                         /* of a function */
    } u;
} symbol_t;

typedef struct lang_call {
    const uint8_t *pc; /* where the caller goes on */
    uint16_t base;     /* the caller's first argument on the stack */
} lang_call_t;

typedef struct lang {
    symbol_t symbol[LANG_SYMBOLS];
    uint16_t symbols;               /* in use */
    uint16_t names_end, bodies_end; /* bytes of the pool in use */
    uint32_t seed[2];               /* rand() */
    /* Columns of the data line at hand, for $1 and column(1) in a using expression; NULL elsewhere. */
    value_t (*column)(void *ctx, int32_t n);
    void *column_ctx;
    struct {
        int code;         /* of the last expr_eval that failed */
        const char *text; /* what happened */
        int16_t symbol;   /* whose fault it is, or -1 */
    } fault;
    value_t stack[LANG_STACK];
    lang_call_t call[LANG_CALLS];
    uint8_t pool[LANG_POOL];
} lang_t;

/* Empties everything and defines pi and NaN. */
void names_reset(lang_t *l);
/* Sets a variable, making it if need be. Returns 0 or ERR_FULL. */
int names_set(lang_t *l, const char *name, size_t len, value_t v, lang_error_t *err);
/* The value of a variable; false if there is none of that name. */
bool names_get(const lang_t *l, const char *name, size_t len, value_t *v);
/* The index of a symbol, or -1. */
int names_find(const lang_t *l, enum symbol_kind kind, const char *name, size_t len);
/* The index of a symbol that is made, undefined, if it does not exist; or ERR_FULL. */
int names_intern(lang_t *l, enum symbol_kind kind, const char *name, size_t len, int32_t column, lang_error_t *err);
/* Forgets symbols made after the first `mark` ones that are still undefined, newest first up to the first
 * defined one; for an expression that was compiled and dropped. mark is an earlier l->symbols. */
void names_release(lang_t *l, uint16_t mark);

#endif
