/* out.h - a text file written fast: one buffer, and numbers formatted by table instead of by printf.
 *
 * A drawing of a million lines is a few million numbers; fprintf takes 150 ns for each, these calls below 10.
 * Errors are remembered and reported once, by out_close. */
#ifndef OUT_H
#define OUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

#define OUT_BUFFER 65536
#define OUT_PAGE 4096     /* room for more than a buffer less a page is not reserved */
#define OUT_NUMBER_MAX 16 /* most bytes one number takes */

typedef struct out {
    int fd;
    bool failed;
    size_t used;
    off_t written;
    char buffer[OUT_BUFFER];
} out_t;

/* Creates the file, or writes over it. 0, or ERR_FILE with errno set. */
int out_open(out_t *o, const char *path);
/* Flushes and closes. 0, or ERR_FILE when anything failed since out_open. */
int out_close(out_t *o);

void out_text(out_t *o, const char *s);
void out_format(out_t *o, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Room for n <= OUT_BUFFER - OUT_PAGE bytes at the end; say afterwards where they end. */
char *out_reserve(out_t *o, size_t n);
void out_commit(out_t *o, const char *end);

/* Put a number at p and return where it ends; at most OUT_NUMBER_MAX bytes, no final zero byte.
 * Lat to mm with 6 decimals: the error is below 0.5e-6 mm, 1/60 lat, so rounding reads the lat back exactly. */
char *out_put_mm6(char *p, int32_t lat);
/* Lat to mm with 3 decimals and no trailing zeros: within 0.5 um. */
char *out_put_mm3(char *p, int32_t lat);
char *out_put_int(char *p, int32_t v);

#endif
