/* texts.c - a list of pairs of strings in a fixed buffer, and two of strings. */
#include "lang/texts.h"
#include <string.h>

#if CONFIG_CONTROL
void texts_reset(texts_t *t) {
    t->used = t->literals = t->working = 0;
}

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

int texts_keep(texts_t *t, const char *text, size_t len) {
    for (size_t at = 0; at < t->literals; at += strlen(t->literal + at) + 1)
        if (strlen(t->literal + at) == len && memcmp(t->literal + at, text, len) == 0) return (int)at;
    if (len + 1 > sizeof t->literal - t->literals) return -1;
    const size_t at = t->literals;
    memmove(t->literal + at, text, len); /* it may be written there already */
    t->literal[at + len] = '\0';
    t->literals += len + 1;
    return (int)at;
}

char *texts_room(texts_t *t, size_t len) {
    if (len + 1 > sizeof t->work - t->working) return NULL;
    char *room = t->work + t->working;
    t->working += len + 1;
    return room;
}
#endif
