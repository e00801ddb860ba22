/* lang_error.c - error messages without stdio: every piece is appended up to the end of its buffer. */
#include "lang/lang_error.h"
#include <string.h>

typedef struct out {
    char *at, *end; /* end: the byte kept for the final zero */
} out_t;

static void put(out_t *o, const char *text, size_t len) {
    size_t room = (size_t)(o->end - o->at);
    if (len > room) len = room;
    memcpy(o->at, text, len);
    o->at += len;
    *o->at = 0;
}

/* What came from outside: a ? for each control character. */
static void put_shown(out_t *o, const char *text, size_t len) {
    char *at = o->at;
    put(o, text, len);
    for (; at < o->at; at++)
        if (((unsigned char)*at < ' ' && *at != '\t') || *at == 0x7f) *at = '?';
}

/* A message, which may be packed. */
static void put_said(out_t *o, const char *text) {
    said_t p = said_text(text);
    for (char c; (c = said_next(&p)) != '\0';) put(o, &c, 1);
}

static void put_text(out_t *o, const char *text) {
    put(o, text, strlen(text));
}

static void put_number(out_t *o, int32_t n) {
    char digits[12];
    char *d = digits + sizeof digits;
    uint32_t rest = n < 0 ? 0u - (uint32_t)n : (uint32_t)n;
    do {
        *--d = (char)('0' + rest % 10);
        rest /= 10;
    } while (rest);
    if (n < 0) *--d = '-';
    put(o, d, (size_t)(digits + sizeof digits - d));
}

static out_t message_of(lang_error_t *err) {
    return (out_t){err->message, err->message + LANG_ERROR_MAX - 1};
}

int lang_error_set(lang_error_t *err, int code, int32_t column, const char *text) {
    err->code = code;
    err->line = 0;
    err->column = column;
    out_t o = message_of(err);
    *o.at = 0;
    put_said(&o, text);
    return code;
}

int lang_error_set_name(lang_error_t *err, int code, int32_t column, const char *text, const char *name, size_t len) {
    lang_error_set(err, code, column, text);
    out_t o = message_of(err);
    o.at += strlen(err->message);
    put_text(&o, ": ");
    put_shown(&o, name, len);
    return code;
}

int lang_error_set_number(lang_error_t *err, int code, int32_t column, const char *text, int32_t number) {
    lang_error_set(err, code, column, text);
    out_t o = message_of(err);
    o.at += strlen(err->message);
    put_text(&o, " (");
    put_number(&o, number);
    put_text(&o, ")");
    return code;
}

size_t lang_error_picture(const lang_error_t *err, const char *text, size_t len, char *out, size_t size) {
    if (size == 0) return 0;
    out_t o = {out, out + size - 1};
    *out = 0;
    size_t column = err->column > 0 ? (size_t)err->column - 1 : 0; /* from 0 */
    size_t below = LANG_ERROR_MAX + 40;                            /* what the last line may take */
    if (text && err->column > 0 && column <= len && size > below + 2 * 20) {
        /* Two lines of `width` at most: the text is cut at its left when the caret would not fit. */
        size_t width = (size - below) / 2 - 1;
        size_t from = column < width ? 0 : column - width + 1;
        size_t shown = len - from < width ? len - from : width;
        put_shown(&o, text + from, shown);
        put_text(&o, "\n");
        for (size_t i = from; i < column; i++) {
            /* Tabs stay tabs, and the later bytes of a UTF-8 character take no room: so the caret stands below its
             * column. */
            if (i < len && ((unsigned char)text[i] & 0xC0) == 0x80) continue;
            put(&o, i < len && text[i] == '\t' ? "\t" : " ", 1);
        }
        put_text(&o, "^\n");
    }
    if (err->line > 0) {
        put_text(&o, "line ");
        put_number(&o, err->line);
        put_text(&o, err->column > 0 ? ", " : ": ");
    }
    if (err->column > 0) {
        put_text(&o, "column ");
        put_number(&o, err->column);
        put_text(&o, ": ");
    }
    put_text(&o, err->message);
    return (size_t)(o.at - out);
}
