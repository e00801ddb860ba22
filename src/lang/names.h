/* names.h - the language's context: variables, user functions and the memory they live in.
 *
 * Two tables share one array of symbols, as in gnuplot f and f(x) may both exist. Names and the code of functions lie
 * in one pool of bytes: function bodies grow up from its start, names down from its end; what is left between them is
 * lent to expressions that are compiled, evaluated and forgotten. Redefining a function closes the gap of its old body.
 *
 * Compiled code names symbols by their index, so a symbol once made keeps its place until names_reset.
 *
 * Memory of a lang_t: CONFIG_SYMBOLS, CONFIG_POOL, CONFIG_STACK and CONFIG_CALLS in config.h say what each takes: 31 KB
 * as the desktop has them; 2.9 KB, for a part with 16 KB of RAM, with 40 symbols, a pool of 1024, a stack of 48 and 12
 * calls. Each one that runs out is an ordinary ERR_FULL that names it. */
#ifndef NAMES_H
#define NAMES_H

#include "config.h"
#include "lang/lang_error.h"
#include "lang/texts.h"
#include "lang/value.h"
#include <stdbool.h>

_Static_assert(CONFIG_SYMBOLS >= 4 && CONFIG_SYMBOLS <= 255, "compiled code holds a symbol in one byte");
_Static_assert(CONFIG_POOL >= 64 && CONFIG_POOL <= 65535, "the pool is addressed by 16 bits");
_Static_assert(CONFIG_STACK >= 16 && CONFIG_STACK <= 65535, "constant folding needs a few values");

enum symbol_kind { SYMBOL_VARIABLE, SYMBOL_FUNCTION, SYMBOL_ARRAY };

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
        struct {
            uint16_t start, len; /* in lang_t.cell */
        } cells;                 /* of an array */
    } u;
} symbol_t;

#define LANG_ITERATED 3 /* most `for` in front of one another */

typedef struct lang_call {
    const uint8_t *pc; /* where the caller goes on */
    uint16_t base;     /* the caller's first argument on the stack */
} lang_call_t;

typedef struct lang {
    symbol_t symbol[CONFIG_SYMBOLS];
    uint16_t symbols;     /* in use */
    uint16_t bodies_end;  /* function bodies: pool[0 .. bodies_end) */
    uint16_t names_start; /* names: pool[names_start .. CONFIG_POOL) */
#if CONFIG_CONTROL
    uint8_t iterated[LANG_ITERATED]; /* variables that `for` goes through now: what is compiled takes their values */
    uint8_t iterations;              /* of them */
    texts_t *texts;                  /* the session's; NULL: there are no texts */
    uint16_t cells;                  /* in use */
    value_t cell[CONFIG_CELLS];
#endif
    bool degrees;    /* what is compiled from now on measures angles in degrees */
    int32_t seed[2]; /* rand(); seed[0] == 0: not started. Any bits will do as a seed */
    /* Columns of the data line at hand, for $1 and column(1) in a using expression; NULL elsewhere. */
    value_t (*column)(void *ctx, int32_t n);
    void *column_ctx;
    struct {
        int code;         /* of the last expr_eval that failed */
        const char *text; /* what happened */
        int16_t symbol;   /* whose fault it is, or -1 */
    } fault;
    value_t stack[CONFIG_STACK];
    lang_call_t call[CONFIG_CALLS];
    uint8_t pool[CONFIG_POOL];
} lang_t;

/* Empties everything but texts and defines pi and NaN. */
void names_reset(lang_t *l);
/* What a variable holds, a number or a text; false if it is not defined. A text is copied to where results are. */
bool names_value(lang_t *l, int symbol, value_t *out);
/* Makes it hold that. false: no room for the text. */
bool names_assign(lang_t *l, int symbol, value_t v);
/* A variable, function or array is not defined any more. What mentions it goes on doing so. */
void names_forget(lang_t *l, int symbol);
/* Sets a variable, making it if need be; an array of this name is forgotten. Returns 0 or ERR_FULL. */
int names_set(lang_t *l, const char *name, size_t len, value_t v, lang_error_t *err);
/* The index of a symbol, or -1. */
int names_find(const lang_t *l, enum symbol_kind kind, const char *name, size_t len);
/* The index of a symbol that is defined, or -1. */
int names_find_defined(const lang_t *l, enum symbol_kind kind, const char *name, size_t len);
/* The index of a symbol that is made, undefined, if it does not exist; or ERR_FULL. */
int names_intern(lang_t *l, enum symbol_kind kind, const char *name, size_t len, int32_t column, lang_error_t *err);
/* Forgets symbols made after the first `mark` ones that are still undefined, newest first up to the first
 * defined one; for an expression that was compiled and dropped. mark is an earlier l->symbols. */
void names_release(lang_t *l, uint16_t mark);
/* Makes the len bytes of code that stand at pool + bodies_end the body of a function symbol, in place of its old one.
 * stack: values it needs on the stack, its params arguments included. */
void names_define_function(lang_t *l, int symbol, uint8_t params, uint16_t len, uint16_t stack);

#endif
