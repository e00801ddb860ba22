/* texts.h - variables that hold text: `name = "..."`. They are no values of expressions; names of files, titles and
 * what is printed are put together from them (session_text.c).
 *
 * Names and texts lie one behind the other in one buffer; setting one again closes the gap of the old one. */
#ifndef TEXTS_H
#define TEXTS_H

#include "config.h"
#include <stdbool.h>
#include <stddef.h>

typedef struct texts {
    size_t used;
    char store[CONFIG_TEXTS]; /* name, 0, text, 0 ... */
} texts_t;

/* The text of a variable, or NULL. */
const char *texts_get(const texts_t *t, const char *name, size_t len);
/* Sets it; text NULL: forgets it. text may not lie in the store. false: no room. */
bool texts_set(texts_t *t, const char *name, size_t len, const char *text);

#endif
