/* out.c - numbers by table of three digits at a time; the decimals of a lat come out of one product. */
#include "host/out.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "error.h"
#include "view/page.h"

/* "000" ... "999", padded to four bytes so that one store writes an entry. */
static char digits3[1000][4];
/* "0" ... "999", and in the fourth byte how many digits that are: no branch, which would be guessed wrong. */
static char whole3[1000][4];
static bool digits_ready;

static void make_digits(void) {
    for (int i = 0; i < 1000; i++) {
        digits3[i][0] = (char)('0' + i / 100);
        digits3[i][1] = (char)('0' + i / 10 % 10);
        digits3[i][2] = (char)('0' + i % 10);
        digits3[i][3] = 0;
        const int zeros = i < 10 ? 2 : i < 100 ? 1 : 0;
        memcpy(whole3[i], digits3[i] + zeros, (size_t)(3 - zeros));
        whole3[i][3] = (char)(3 - zeros);
    }
    digits_ready = true;
}

int out_open(out_t *o, const char *path) {
    if (!digits_ready) make_digits();
    o->failed = false;
    o->used = 0;
    o->written = 0;
    o->fd = open(path, O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    return o->fd < 0 ? ERR_FILE : 0;
}

static void put(out_t *o, size_t size) {
    const char *p = o->buffer;
    size_t left = size;
    while (left && !o->failed) {
        ssize_t n = write(o->fd, p, left);
        if (n > 0) {
            p += n;
            left -= (size_t)n;
            o->written += n;
        } else if (errno != EINTR) {
            o->failed = true;
        }
    }
    o->used -= size;
}

/* A file that was there is written over, and cut off here. To give back all its pages first and to ask for others takes
 * the system longer than writing them. A terminal or a pipe has no length. */
int out_close(out_t *o) {
    struct stat s;
    put(o, o->used);
    if (fstat(o->fd, &s) == 0 && S_ISREG(s.st_mode) && s.st_size > o->written && ftruncate(o->fd, o->written) != 0)
        o->failed = true;
    if (close(o->fd) != 0) o->failed = true;
    return o->failed ? ERR_FILE : 0;
}

/* Whole pages go: of a page that is written in part the system might have to read the rest. */
char *out_reserve(out_t *o, size_t n) {
    if (OUT_BUFFER - o->used < n) {
        const size_t whole = o->used / OUT_PAGE * OUT_PAGE;
        put(o, whole);
        memmove(o->buffer, o->buffer + whole, o->used);
    }
    return o->buffer + o->used;
}

void out_commit(out_t *o, const char *end) {
    o->used = (size_t)(end - o->buffer);
}

void out_text(out_t *o, const char *s) {
    size_t n = strlen(s);
    while (n) {
        size_t part = n < 4096 ? n : 4096;
        char *p = out_reserve(o, part);
        memcpy(p, s, part);
        out_commit(o, p + part);
        s += part;
        n -= part;
    }
}

void out_format(out_t *o, const char *format, ...) {
    char line[1024];
    va_list args;
    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    out_text(o, line);
}

/* A non-negative integer without leading zeros. */
static inline char *put_u32(char *p, uint32_t v) {
    char rest[12];
    size_t n = 0;
    for (; v >= 1000; v /= 1000, n += 3) memcpy(rest + n, digits3[v % 1000], 4); /* three times at the most */
    memcpy(p, whole3[v], 4);
    p += whole3[v][3];
    for (; n > 0; n -= 3, p += 3) memcpy(p, rest + n - 3, 4);
    return p;
}

char *out_put_int(char *p, int32_t v) {
    if (v < 0) *p++ = '-';
    return put_u32(p, v < 0 ? 0u - (uint32_t)v : (uint32_t)v);
}

/* |lat| split into mm and lat below a mm. The fraction times 10^6 plus a half is below 2^15 * 10^6 < 2^35, and
 * the greatest, 32767/32768, rounds to .999969: never up to the next mm. */
char *out_put_mm6(char *p, int32_t lat) {
    uint32_t u = lat < 0 ? 0u - (uint32_t)lat : (uint32_t)lat;
    if (lat < 0) *p++ = '-';
    p = put_u32(p, u >> LAT_PER_MM_BITS);
    uint32_t micro = (uint32_t)(((uint64_t)(u & (LAT_PER_MM - 1)) * 1000000 + LAT_PER_MM / 2) >> LAT_PER_MM_BITS);
    *p++ = '.';
    memcpy(p, digits3[micro / 1000], 4);
    memcpy(p + 3, digits3[micro % 1000], 4);
    return p + 6;
}

char *out_put_mm3(char *p, int32_t lat) {
    uint32_t u = lat < 0 ? 0u - (uint32_t)lat : (uint32_t)lat;
    uint64_t um = ((uint64_t)u * 1000 + LAT_PER_MM / 2) >> LAT_PER_MM_BITS;
    if (lat < 0 && um) *p++ = '-';
    p = put_u32(p, (uint32_t)(um / 1000));
    const char *d = digits3[um % 1000];
    int decimals = d[2] != '0' ? 3 : d[1] != '0' ? 2 : d[0] != '0' ? 1 : 0;
    if (decimals) *p++ = '.';
    memcpy(p, d, 4);
    return p + decimals;
}
