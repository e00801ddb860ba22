/* complete.h - what the tab key makes of a word at the prompt. */
#ifndef COMPLETE_H
#define COMPLETE_H

#include <stdbool.h>
#include <stddef.h>

/* The words that may stand at line + start: commands, or behind `set` and its like options. NULL: neither (names of
 * files are the editor's). */
const char *complete_table(const char *line, size_t start);
/* The next word of the table that begins with text, to be freed, or NULL. *at, NULL at first, is where to go on. */
char *complete_next(const char *table, const char *text, const char **at);

#endif
