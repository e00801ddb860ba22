/* texts.h - the memory of texts: those that variables hold, those that stand in what was compiled, and results.
 *
 * A text is a value (value.h, VALUE_TEXT) that points into one of three buffers:
 *   store     variables, name and text one behind the other; setting one again closes the gap of the old one, so nobody
 *             keeps a pointer into it
 *   literal   texts in quotes of compiled expressions, elements of arrays; each once, and there until all names are
 *             forgotten
 *   work      results of the evaluation that is under way, forgotten when the next one begins */
#ifndef TEXTS_H
#define TEXTS_H

#include "config.h"
#include <stdbool.h>
#include <stddef.h>

typedef struct texts {
    size_t used, literals, working; /* bytes of each */
    char store[CONFIG_TEXTS];       /* name, 0, text, 0 ... */
    char literal[CONFIG_LITERALS];  /* text, 0 ... */
    char work[CONFIG_TEXT_WORK];
} texts_t;

void texts_reset(texts_t *t);
/* The text of a variable, or NULL. */
const char *texts_get(const texts_t *t, const char *name, size_t len);
/* Sets it; text NULL: forgets it. text may not lie in the store. false: no room. */
bool texts_set(texts_t *t, const char *name, size_t len, const char *text);
/* Where in `literal` the text is from now on, or -1: no room. */
int texts_keep(texts_t *t, const char *text, size_t len);
/* Room for a result of len bytes and the zero, or NULL. */
char *texts_room(texts_t *t, size_t len);

#endif
