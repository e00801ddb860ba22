/* line_edit.c - see line_edit.h. */
#include "app/line_edit.h"

#include <string.h>

enum {
    CTRL_C = 3,
    BELL = 7,
    BACKSPACE = 8,
    TAB = 9,
    LF = 10,
    CR = 13,
    CTRL_P = 16,
    XON = 17,
    XOFF = 19,
    CTRL_U = 21,
    ESCAPE = 27,
    DELETE = 127,
};

typedef void (*write_t)(const char *text, size_t bytes);

void line_edit_clear(line_edit_t *e) {
    e->len = 0;
    e->escape = 0;
    e->too_long = e->damaged = false;
}

static bool is_continuation(char c) {
    return ((uint8_t)c & 0xc0) == 0x80; /* of a UTF-8 character */
}

static void take_back(line_edit_t *e, write_t write) {
    if (e->len == 0) return;
    do e->len--;
    while (e->len > 0 && is_continuation(e->text[e->len]));
    write("\b \b", 3);
}

static void add(line_edit_t *e, char c, write_t write) {
    if (e->len == CONFIG_LINE_MAX) {
        e->too_long = true;
        write("\a", 1);
        return;
    }
    e->text[e->len++] = c;
    write(&c, 1);
}

static void recall(line_edit_t *e, write_t write) {
    while (e->len) take_back(e, write);
    memcpy(e->text, e->last, e->last_len);
    e->len = e->last_len;
    write(e->text, e->len);
}

void line_edit_remember(line_edit_t *e) {
    size_t n = strlen(e->text);
    if (n == 0) return;
    memcpy(e->last, e->text, n);
    e->last_len = (uint16_t)n;
}

static enum line_edit_event finish(line_edit_t *e, write_t write) {
    enum line_edit_event event = e->damaged ? LINE_EDIT_DAMAGED : e->too_long ? LINE_EDIT_LONG : LINE_EDIT_READY;
    e->text[e->len] = '\0';
    line_edit_clear(e);
    write("\r\n", 2);
    return event;
}

/* ESC [ parameters letter, or ESC O letter: only Up means something. */
static void escape(line_edit_t *e, uint8_t byte, write_t write) {
    if (e->escape == 1) {
        e->escape = byte == '[' || byte == 'O' ? 2 : 0;
        return;
    }
    if (byte >= 0x20 && byte < 0x40) return;
    e->escape = 0;
    if (byte == 'A') recall(e, write);
}

enum line_edit_event line_edit_byte(line_edit_t *e, uint8_t byte, write_t write) {
    bool was_cr = e->was_cr;
    e->was_cr = byte == CR;
    if (e->escape && byte >= 0x20) {
        escape(e, byte, write);
        return LINE_EDIT_MORE;
    }
    e->escape = 0;
    switch (byte) {
    case CR:
        return finish(e, write);
    case LF:
        return was_cr ? LINE_EDIT_MORE : finish(e, write);
    case BACKSPACE:
    case DELETE:
        take_back(e, write);
        break;
    case CTRL_C:
    case CTRL_U:
        while (e->len) take_back(e, write);
        line_edit_clear(e);
        break;
    case CTRL_P:
        recall(e, write);
        break;
    case ESCAPE:
        e->escape = 1;
        break;
    case XON:
    case XOFF:
        break;
    default:
        if (byte >= 0x20 || byte == TAB) {
            add(e, (char)byte, write);
        } else {
            e->damaged = true;
            write("\a", 1);
        }
    }
    return LINE_EDIT_MORE;
}
