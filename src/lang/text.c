/* text.c - the little of printf that messages need. */
#include "lang/text.h"

text_t text_start(char *buf, size_t size) {
    buf[0] = '\0';
    return (text_t){buf, size, 0};
}

void text_add_bytes(text_t *t, const char *s, size_t n) {
    size_t room = t->size - 1 - t->len;
    if (n > room) n = room;
    memcpy(t->buf + t->len, s, n);
    t->len += n;
    t->buf[t->len] = '\0';
}

void text_add_shown(text_t *t, const char *s, size_t n) {
    size_t from = t->len;
    text_add_bytes(t, s, n);
    for (; from < t->len; from++)
        if ((unsigned char)t->buf[from] < ' ' || t->buf[from] == 0x7f) t->buf[from] = '?';
}

void text_add(text_t *t, const char *s) {
    text_add_bytes(t, s, strlen(s));
}

void text_add_said(text_t *t, const char *text) {
    said_t p = said_text(text);
    for (char c; (c = said_next(&p)) != '\0';) text_add_bytes(t, &c, 1);
}

void text_add_int(text_t *t, int64_t v) {
    char digits[20];
    size_t n = sizeof digits;
    uint64_t mag = v < 0 ? 0 - (uint64_t)v : (uint64_t)v;
    do {
        digits[--n] = (char)('0' + mag % 10);
        mag /= 10;
    } while (mag);
    if (v < 0) text_add(t, "-");
    text_add_bytes(t, digits + n, sizeof digits - n);
}

void text_add_num(text_t *t, num_t v) {
    char buf[VALUE_TEXT_MAX];
    size_t n = value_format(value_real(v), buf);
    if (n > 2 && buf[n - 2] == '.' && buf[n - 1] == '0') n -= 2;
    text_add_bytes(t, buf, n);
}

void text_add_scaled(text_t *t, int64_t v, int decimals) {
    int64_t one = 1;
    for (int i = 0; i < decimals; i++) one *= 10;
    if (v < 0) {
        text_add(t, "-");
        v = -v;
    }
    text_add_int(t, v / one);
    int64_t rest = v % one;
    if (rest == 0) return;
    text_add(t, ".");
    while (rest) {
        one /= 10;
        text_add_int(t, rest / one);
        rest %= one;
    }
}
