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

/* What a row that does not fit would have taken: a height, or as many as there are in a row of a matrix, a corner of
 * three numbers, or the corners of a face. */
static int32_t row_bytes(const session_source_t *src, const char *text) {
    int32_t fields = 0;
    for (; *text && *text != '#'; fields++) {
        text += strspn(text, " \t,");
        const size_t n = strcspn(text, " \t,");
        if (n == 0) break;
        if (src->solid && fields == 0 && *text == 'v') return 3 * sizeof(packed_t);
        text += n;
    }
    if (src->solid) return fields * (int32_t)sizeof(int32_t);
    return src->spec.format == DATA_ROWS ? (fields > 0) * (int32_t)sizeof(packed_t)
                                         : fields * (int32_t)sizeof(packed_t);
}

static void tell_bytes(const session_t *s) {
    char line[80];
    text_t t = text_start(line, sizeof line);
    text_add(&t, "the rows alone take ");
    text_add_int(&t, s->rows_bytes);
    text_add(&t, " bytes of memory, ");
    text_add_int(&t, (int64_t)(s->pool_size * sizeof(packed_t)));
    text_add(&t, " are free\n");
    s->port->warn(s->port->ctx, line);
}

/* Up to and with the line `e`, or up to what is no row. */
bool session_pass_over(session_t *s, const char *text) {
    if (!s->rows_left) return false;
    const char *e = text + strspn(text, " \t");
    const bool ends = (*e == 'e' || *e == 'E') && e[1 + strspn(e + 1, " \t\r\n")] == '\0';
    s->rows_left = !ends && is_row(text);
    if (ends && s->rows_bytes) tell_bytes(s);
    if (s->rows_left && s->rows_bytes) s->rows_bytes += row_bytes(&s->plot.source[s->plot.next], text);
    return ends || s->rows_left;
}
