/* out.h - a file written fast: one buffer, and numbers formatted by table instead of by printf.
 *
 * A drawing of a million lines is a few million numbers; fprintf takes 150 ns for each, these calls some 2.
 * Errors are remembered and reported once, by out_close. A file is there when it is whole (host/atomic_file.h). */
#ifndef OUT_H
#define OUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "host/atomic_file.h"
#include "host/digits.h"
#include "view/page.h"

#define OUT_BUFFER ((size_t)256 << 10)
#define OUT_PAGE ((size_t)4096) /* room for more than a buffer less a page is not reserved */
#define OUT_NUMBER_MAX 16       /* most bytes one number takes, and one is put in */

/* Large: not for the stack. */
typedef struct out {
    atomic_file_t file;
    int trouble; /* errno of what failed first, or 0 */
    size_t used;
    off_t written;
    char buffer[OUT_BUFFER];
} out_t;

/* 0, or ERR_FILE with errno set. */
int out_open(out_t *o, const char *path);
/* Only where nothing happens to what is there before out_close; false if that cannot be. */
bool out_open_unnamed(out_t *o, const char *path);
/* Forgets what was written; after out_open_unnamed only. */
void out_restart(out_t *o);
/* Flushes and closes. 0, or ERR_FILE with errno set when anything failed since out_open. */
int out_close(out_t *o);
/* Closes a file that is not to be. */
void out_drop(out_t *o);

void out_bytes(out_t *o, const void *data, size_t n);
void out_text(out_t *o, const char *s);
void out_format(out_t *o, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Writes what can be written at once, so that there is room. */
void out_make_room(out_t *o);

/* Room for n <= OUT_BUFFER - OUT_PAGE bytes at the end; say afterwards where they end. */
static inline char *out_reserve(out_t *o, size_t n) {
    if (OUT_BUFFER - o->used < n) out_make_room(o);
    return o->buffer + o->used;
}
static inline void out_commit(out_t *o, const char *end) {
    o->used = (size_t)(end - o->buffer);
}

/* Put a number at p and return where it ends; at most OUT_NUMBER_MAX bytes, no final zero byte. No branch that is
 * guessed wrong: on a page most numbers have three digits, two or one before the point. */
static inline char *out_put_whole3(char *p, uint32_t v) {
    memcpy(p, DIGITS[v].whole, 4);
    return p + DIGITS[v].whole[3];
}
char *out_put_u32(char *p, uint32_t v);
char *out_put_int(char *p, int32_t v);

static inline char *out_put_above_mm(char *p, uint32_t mm) {
    return mm < 1000 ? out_put_whole3(p, mm) : out_put_u32(p, mm);
}

/* Lat to mm with 6 decimals: the error is below 0.5e-6 mm, 1/60 lat, so rounding reads the lat back exactly. The
 * fraction times 10^6 plus a half is below 2^15 * 10^6 < 2^35, and the greatest, 32767/32768, rounds to .999969: never
 * up to the next mm. */
static inline char *out_put_mm6(char *p, int32_t lat) {
    const uint32_t u = lat < 0 ? 0u - (uint32_t)lat : (uint32_t)lat;
    if (lat < 0) *p++ = '-';
    p = out_put_above_mm(p, u >> LAT_PER_MM_BITS);
    const uint32_t micro = (uint32_t)(((uint64_t)(u & (LAT_PER_MM - 1)) * 1000000 + LAT_PER_MM / 2) >> LAT_PER_MM_BITS);
    memcpy(p, DIGITS[micro / 1000].dotted, 4);
    memcpy(p + 4, DIGITS[micro % 1000].padded, 4);
    return p + 7;
}

/* Lat to mm with 3 decimals and no trailing zeros: within 0.5 um. */
static inline char *out_put_mm3(char *p, int32_t lat) {
    const uint32_t u = lat < 0 ? 0u - (uint32_t)lat : (uint32_t)lat;
    const uint64_t um = ((uint64_t)u * 1000 + LAT_PER_MM / 2) >> LAT_PER_MM_BITS;
    if (lat < 0 && um) *p++ = '-';
    p = out_put_above_mm(p, (uint32_t)(um / 1000));
    memcpy(p, DIGITS[um % 1000].dotted, 4);
    return p + DIGITS[um % 1000].kept[0];
}

#endif
