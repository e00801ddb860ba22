/* texts.c - a list of pairs of strings in a fixed buffer. */
#include "lang/texts.h"
#include <string.h>

static size_t find(const texts_t *t, const char *name, size_t len) {
    size_t at = 0;
    while (at < t->used) {
        const size_t n = strlen(t->store + at);
        if (n == len && memcmp(t->store + at, name, len) == 0) break;
        at += n + 1;
        at += strlen(t->store + at) + 1;
    }
    return at;
}

const char *texts_get(const texts_t *t, const char *name, size_t len) {
    const size_t at = find(t, name, len);
    return at < t->used ? t->store + at + len + 1 : NULL;
}

bool texts_set(texts_t *t, const char *name, size_t len, const char *text) {
    const size_t at = find(t, name, len);
    if (text && t->used + len + strlen(text) + 2 > sizeof t->store) return false;
    if (at < t->used) {
        const size_t gap = len + 1 + strlen(t->store + at + len + 1) + 1;
        memmove(t->store + at, t->store + at + gap, t->used - at - gap);
        t->used -= gap;
    }
    if (!text) return true;
    memcpy(t->store + t->used, name, len);
    t->store[t->used + len] = '\0';
    strcpy(t->store + t->used + len + 1, text);
    t->used += len + strlen(text) + 2;
    return true;
}
