/* line_edit.h - one line as it is typed: echo, backspace, a history of one.
 *
 *     Return, line feed   the line is complete (CR LF counts once)
 *     Backspace, Delete   takes the last character back (a whole UTF-8 one)
 *     Ctrl-U, Ctrl-C      takes the whole line back
 *     Up, Ctrl-P          the last line again, in place of this one
 *
 * A line that is too long, holds other control characters, or has lost bytes on the way is refused as a whole when
 * it ends; half a line is never taken for a line. No hal: bytes in, text for the terminal out. */
#ifndef LINE_EDIT_H
#define LINE_EDIT_H

#include "config.h"
#include "lang/text.h"
#include <stdbool.h>
#include <stdint.h>

enum line_edit_event {
    LINE_EDIT_MORE,    /* the line goes on */
    LINE_EDIT_READY,   /* line->text is a complete line */
    LINE_EDIT_LONG,    /* a line of more than CONFIG_LINE_MAX bytes has ended: refused */
    LINE_EDIT_DAMAGED, /* a line with control characters or lost bytes has ended: refused */
};

/* Stands in the stream of bytes where some were lost. */
#define LINE_EDIT_LOST 0x00

typedef struct line_edit {
    uint16_t len, last_len;
    uint8_t escape; /* bytes of an escape sequence so far */
    bool too_long, damaged;
    bool was_cr;                    /* a line feed now belongs to it */
    char text[CONFIG_LINE_MAX + 1]; /* ended by a zero when READY */
    char last[CONFIG_LINE_MAX + 1];
} line_edit_t;
_Static_assert(CONFIG_LINE_MAX < UINT16_MAX, "lengths are 16 bits");

/* Forgets the line being typed. */
void line_edit_clear(line_edit_t *e);
/* Takes a byte; write gets what the terminal is to show. After any event but MORE the next byte begins a new line. */
enum line_edit_event line_edit_byte(line_edit_t *e, uint8_t byte, void (*write)(const char *text, size_t bytes));
/* Nothing typed yet? */
static inline bool line_edit_is_empty(const line_edit_t *e) {
    return e->len == 0 && !e->too_long && !e->damaged && !e->escape;
}
/* Keeps the line that has just been READY for Up. */
void line_edit_remember(line_edit_t *e);

#endif
