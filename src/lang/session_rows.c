/* session_rows.c - after an error in inline data come the rest of its rows, if a program sends them: they are no
 * commands, and are passed over. */
#include "lang/session_parts.h"

/* Whether a line can only be a row of inline data, or of a solid: a number, or one letter or two and a number. */
static bool is_row(const char *text) {
    text += strspn(text, " \t");
    if (*text == '\0' || *text == '#') return true;
    if (strchr("vfldog", *text)) {
        if (text[1] == 'n' || text[1] == 't') text++;
        text++;
        if (*text != ' ' && *text != '\t') return false;
        const bool named = text[-1] == 'o' || text[-1] == 'g';
        text += strspn(text, " \t");
        if (named) return *text != '=';
    }
    return *text && strchr("+-.0123456789", *text);
}

/* Up to and with the line `e`, or up to what is no row. */
bool session_pass_over(session_t *s, const char *text) {
    if (!s->rows_left) return false;
    const char *e = text + strspn(text, " \t");
    const bool ends = (*e == 'e' || *e == 'E') && e[1 + strspn(e + 1, " \t\r\n")] == '\0';
    s->rows_left = !ends && is_row(text);
    return ends || s->rows_left;
}
