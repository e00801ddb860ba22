/* lexer.h - tokens of one logical line.
 *
 * The line (continuations joined, no line feed needed) stays in the caller's memory and is not changed; tokens point
 * into it. The lexer is a plain value: to look ahead, copy it and advance the copy.
 *
 *     lexer_t lx;
 *     lexer_start(&lx, line, len);          lx.tok is already the first token
 *     while (lx.tok.kind != TOKEN_END) lexer_next(&lx);
 *
 * A `#` outside of a string ends the line. A line feed (CONFIG_CONTROL) is a token like ';'. Numbers as in gnuplot: 12,
 * 0x1f, 017 (octal), 1. .5 1e-3; an integer constant beyond 63 bits is a real. Strings: '..' with '' for a quote, "..."
 * with backslash escapes. */
#ifndef LEXER_H
#define LEXER_H

#include "lang/lang_error.h"
#include "lang/value.h"
#include <stdbool.h>

/* One-character operators and separators are their own kind: '+' '(' ',' ';' '$' ... */
enum token_kind {
    TOKEN_END = 0,
    TOKEN_NAME = 256, /* letter or _ or a byte above 127, then those and digits */
    TOKEN_NUMBER,     /* value holds it */
    TOKEN_STRING,     /* see lexer_string */
    TOKEN_POWER,      /* ** */
    TOKEN_SHL,        /* << */
    TOKEN_SHR,        /* >> */
    TOKEN_LE,         /* <= */
    TOKEN_GE,         /* >= */
    TOKEN_EQ,         /* == */
    TOKEN_NE,         /* != */
    TOKEN_AND,        /* && */
    TOKEN_OR,         /* || */
    TOKEN_BAD,        /* not a token; lexer_unexpected says why */
};

typedef struct token {
    int kind;        /* enum token_kind or a character */
    uint32_t start;  /* index of its first byte in the line; the column is start + 1 */
    uint32_t len;    /* bytes, with quotes; 0 at the end */
    value_t value;   /* of a number */
    const char *bad; /* of TOKEN_BAD: what is wrong with it */
} token_t;

typedef struct lexer {
    const char *text;
    uint32_t len;
    uint32_t pos; /* behind the current token */
    token_t tok;  /* the current token */
} lexer_t;

/* len: at most 65535 bytes are read, a zero byte ends the line earlier. */
void lexer_start(lexer_t *lx, const char *text, size_t len);
/* Goes to the next token; stays at TOKEN_END. */
void lexer_next(lexer_t *lx);
/* Is the current token this operator or separator; if so goes on. */
bool lexer_accept(lexer_t *lx, int kind);
/* Is the current token the given name, spelled out in full. Does not go on. */
bool lexer_is_name(const lexer_t *lx, const char *name);
/* Is the current token an abbreviation in gnuplot's notation: "sp$lot" takes sp, spl, splo, splot. Does not go on. */
bool lexer_is_almost(const lexer_t *lx, const char *pattern);
/* Column of the current token, from 1. */
static inline int32_t lexer_column(const lexer_t *lx) {
    return (int32_t)lx->tok.start + 1;
}

/* The current token's text: its first byte, lx->tok.len bytes. */
static inline const char *lexer_text(const lexer_t *lx) {
    return lx->text + lx->tok.start;
}
/* Copies the contents of the current TOKEN_STRING, escapes resolved, ended by a zero. Returns its length or
 * ERR_FULL when size (with the zero) is too small. Does not go on. */
int lexer_string(const lexer_t *lx, char *out, size_t size);

/* Reports the current token as not expected here: `what` names what would have been, for instance "')' expected";
 * a TOKEN_BAD reports its own reason instead. what may be NULL. Returns ERR_SYNTAX. */
int lexer_unexpected(const lexer_t *lx, lang_error_t *err, const char *what);

#endif
