/* lang_error.h - what is wrong with a text, and where: the errors that a person at the prompt reads.
 *
 * Columns count bytes from 1; column 0 means "no place in particular". The line is the caller's business (it knows
 * which line of which file it is reading) and stays 0 here. Their texts may be packed (said.h). Messages are cut, never
 * overrun, at LANG_ERROR_MAX. */
#ifndef LANG_ERROR_H
#define LANG_ERROR_H

#include "error.h"
#include "said.h"
#include <stddef.h>
#include <stdint.h>

#define LANG_ERROR_MAX 80 /* bytes, with the final zero */

typedef struct lang_error {
    int code;       /* enum error, 0: none */
    int32_t line;   /* from 1; 0: not known (yet) */
    int32_t column; /* from 1; 0: not known */
    char message[LANG_ERROR_MAX];
} lang_error_t;

/* Fills err (line becomes 0) with the message `text` and returns code, so that one can write
 * `return lang_error_set(err, ERR_SYNTAX, column, "...")`. */
int lang_error_set(lang_error_t *err, int code, int32_t column, const char *text);
/* The same with `text: name`, the name being len bytes of the caller's text. */
int lang_error_set_name(lang_error_t *err, int code, int32_t column, const char *text, const char *name, size_t len);
/* The same with `text (number)`: which capacity ran out, and how large it is. */
int lang_error_set_number(lang_error_t *err, int code, int32_t column, const char *text, int32_t number);

/* Draws the error for a person into out (always ended by a zero), three lines without a final line feed:
 *
 *     splot sin(x
 *                ^
 *     line 3, column 12: ')' expected
 *
 * text is the line that err speaks of, NULL if it is not at hand (data). A line longer than the buffer allows is shown
 * around the column. Without a column only the last line is written. Returns the number of bytes before the zero. A
 * buffer of LANG_PICTURE_MAX bytes shows lines of up to 80 bytes whole. */
#define LANG_PICTURE_MAX (2 * 81 + LANG_ERROR_MAX + 40)
size_t lang_error_picture(const lang_error_t *err, const char *text, size_t len, char *out, size_t size);

#endif
