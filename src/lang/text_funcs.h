/* text_funcs.h - functions and operators of texts and arrays, for the table of builtins.c; CONFIG_CONTROL.
 *
 * As gnuplot has them: characters are counted from 1, those of UTF-8 as one. A number where a text is needed is a
 * mistake, but `.` takes numbers too. Each replaces args[0] by its result and returns what arith_binary does. */
#ifndef TEXT_FUNCS_H
#define TEXT_FUNCS_H

#include "lang/names.h"

/* What no name can be called. */
#define BUILTIN_IS_TEXT " text"  /* a text in quotes: where it is in texts_t.literal */
#define BUILTIN_IS_CONCAT " ."   /* a . b */
#define BUILTIN_IS_EQ " eq"      /* a eq b */
#define BUILTIN_IS_NE " ne"      /* a ne b */
#define BUILTIN_IS_SLICE " [:]"  /* a[from:to] */
#define BUILTIN_IS_ELEMENT " []" /* array: its symbol, index */
#define BUILTIN_IS_SIZE " ||"    /* array: its symbol */

const char *text_literal(lang_t *l, value_t *args, int n);
const char *text_concat(lang_t *l, value_t *args, int n);
const char *text_eq(lang_t *l, value_t *args, int n);
const char *text_ne(lang_t *l, value_t *args, int n);
const char *text_slice(lang_t *l, value_t *args, int n);
const char *text_strlen(lang_t *l, value_t *args, int n);
const char *text_strstrt(lang_t *l, value_t *args, int n);
const char *text_word(lang_t *l, value_t *args, int n);
const char *text_words(lang_t *l, value_t *args, int n);
const char *text_sprintf(lang_t *l, value_t *args, int n);
const char *text_of_column(lang_t *l, value_t *args, int n);
const char *array_element(lang_t *l, value_t *args, int n);
const char *array_size(lang_t *l, value_t *args, int n);

#endif
