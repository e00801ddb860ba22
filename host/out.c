/* out.c - numbers by table of three digits at a time. */
#include "host/out.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include "error.h"

static void begin(out_t *o) {
    o->trouble = 0;
    o->used = 0;
    o->written = 0;
}

int out_open(out_t *o, const char *path) {
    begin(o);
    return atomic_file_open(&o->file, path);
}

bool out_open_unnamed(out_t *o, const char *path) {
    begin(o);
    return atomic_file_open_unnamed(&o->file, path);
}

void out_restart(out_t *o) {
    begin(o);
    if (!atomic_file_restart(&o->file)) o->trouble = errno;
}

static void put(out_t *o, size_t size) {
    const char *p = o->buffer;
    size_t left = size;
    while (left && !o->trouble) {
        const ssize_t n = write(o->file.fd, p, left);
        if (n > 0) {
            p += n;
            left -= (size_t)n;
            o->written += n;
        } else if (n == 0 || errno != EINTR) {
            o->trouble = n < 0 ? errno : EIO;
        }
    }
    o->used -= size;
}

int out_close(out_t *o) {
    put(o, o->used);
    if (o->trouble) {
        atomic_file_drop(&o->file);
        errno = o->trouble;
        return ERR_FILE;
    }
    return atomic_file_keep(&o->file, o->written);
}

void out_drop(out_t *o) {
    atomic_file_drop(&o->file);
}

/* Whole pages go: of a page that is written in part the system might have to read the rest. */
void out_make_room(out_t *o) {
    const size_t whole = o->used / OUT_PAGE * OUT_PAGE;
    atomic_file_ahead(&o->file, o->written + (off_t)whole);
    put(o, whole);
    memmove(o->buffer, o->buffer + whole, o->used);
}

void out_bytes(out_t *o, const void *data, size_t n) {
    const char *from = data;
    while (n) {
        if (o->used == OUT_BUFFER) out_make_room(o);
        const size_t room = OUT_BUFFER - o->used, part = n < room ? n : room;
        memcpy(o->buffer + o->used, from, part);
        o->used += part;
        from += part;
        n -= part;
    }
}

void out_text(out_t *o, const char *s) {
    out_bytes(o, s, strlen(s));
}

void out_format(out_t *o, const char *format, ...) {
    char line[1024];
    va_list args;
    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    out_text(o, line);
}

/* Without leading zeros. */
char *out_put_u32(char *p, uint32_t v) {
    char rest[12];
    size_t n = 0;
    for (; v >= 1000; v /= 1000, n += 3) memcpy(rest + n, DIGITS[v % 1000].padded, 4); /* three times at the most */
    p = out_put_whole3(p, v);
    for (; n > 0; n -= 3, p += 3) memcpy(p, rest + n - 3, 4);
    return p;
}

char *out_put_int(char *p, int32_t v) {
    if (v < 0) *p++ = '-';
    return out_put_u32(p, v < 0 ? 0u - (uint32_t)v : (uint32_t)v);
}
