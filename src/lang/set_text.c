/* set_text.c - options that are words: title, dummy, datafile, angles, mapping. */
#include "lang/session_parts.h"

/* Options of a text's looks: known, and without a meaning for a pen. */
static const char looks[] =
    "off$set\0font\0tc\0textcolor\0enh$anced\0noenh$anced\0rot$ate\0norot$ate\0l$eft\0r$ight\0c$enter\0boxed\0opaque\0";

int set_title(session_t *s, lexer_t *lx) {
    char title[SETTINGS_TITLE_MAX] = "";
    if (session_may_be_text(s, lx)) {
        char *text = s->frame_name[0]; /* lent: no data file is open now */
        int err = session_string(s, lx, text, CONFIG_NAME_MAX + 1, "a text in quotes expected");
        if (err) return err;
        size_t n = strlen(text);
        if (n >= sizeof title) {
            n = sizeof title - 1;
            while (n > 0 && ((unsigned char)text[n] & 0xc0) == 0x80) n--; /* between characters of UTF-8 */
            session_warn(s, "", text, 0, "the title is cut");
        }
        memcpy(title, text, n);
    }
    if (!session_at_end(lx)) {
        if (words_find(looks, lx) < 0) return lexer_unexpected(lx, &s->error, "a text in quotes expected");
        session_skip(lx);
    }
    memcpy(s->settings.title, title, sizeof title);
    return 0;
}

int set_dummy(session_t *s, lexer_t *lx) {
    lexer_t name[2] = {*lx, *lx};
    bool given[2] = {false, false};
    for (int k = 0; k < 2; k++) {
        if (lx->tok.kind == TOKEN_NAME) {
            if (lx->tok.len >= sizeof s->dummy[k]) return session_fail(s, lx, ERR_FULL, "this name is too long");
            name[k] = *lx;
            given[k] = true;
            lexer_next(lx);
        }
        if (!lexer_accept(lx, ',')) break;
    }
    if (!given[0] && !given[1]) return lexer_unexpected(lx, &s->error, "the name of a variable expected");
    int err = session_expect_end(s, lx);
    if (err) return err;
    for (int k = 0; k < 2; k++) {
        if (!given[k]) continue;
        memcpy(s->dummy[k], lexer_text(&name[k]), name[k].tok.len);
        s->dummy[k][name[k].tok.len] = '\0';
    }
    return 0;
}

int set_datafile(session_t *s, lexer_t *lx, int index, const lexer_t *word) {
    if (!lexer_is_almost(lx, "sep$arators")) {
        session_warn_once(s, s->warned_set, index, "set ", word,
                          ": only its separator is known here, the rest is ignored");
        session_skip(lx);
        return 0;
    }
    lexer_next(lx);
    char separator = 0;
    if (lexer_is_almost(lx, "comma")) {
        separator = ',';
    } else if (lexer_is_almost(lx, "tab")) {
        separator = '\t';
    } else if (lx->tok.kind == TOKEN_STRING) {
        char c[8];
        if (lexer_string(lx, c, sizeof c) != 1 || c[0] == '#' || c[0] == '\n')
            return session_fail(s, lx, ERR_UNSUPPORTED, "a separator is one character");
        separator = c[0] == ' ' ? '\0' : c[0];
    } else if (!session_at_end(lx) && !lexer_is_almost(lx, "white$space")) {
        return lexer_unexpected(lx, &s->error, "whitespace, comma, tab or one character in quotes expected");
    }
    if (!session_at_end(lx)) lexer_next(lx);
    int err = session_expect_end(s, lx);
    if (!err) s->separator = separator;
    return err;
}

int set_angles(session_t *s, lexer_t *lx) {
    bool degrees = lexer_is_almost(lx, "d$egrees");
    if (degrees || lexer_is_almost(lx, "r$adians"))
        lexer_next(lx);
    else if (!session_at_end(lx))
        return lexer_unexpected(lx, &s->error, "degrees or radians expected");
    int err = session_expect_end(s, lx);
    if (!err) s->lang.degrees = degrees;
    return err;
}

#if CONFIG_SAMPLED
int set_mapping(session_t *s, lexer_t *lx) {
    static const char words[] = "ca$rtesian\0cy$lindrical\0s$pherical\0";
    static const enum data_mapping mapping[] = {DATA_CARTESIAN, DATA_CYLINDRICAL, DATA_SPHERICAL};
    const int k = session_at_end(lx) ? 0 : words_find(words, lx);
    if (k < 0) return lexer_unexpected(lx, &s->error, "cartesian, cylindrical or spherical expected");
    if (!session_at_end(lx)) lexer_next(lx);
    int err = session_expect_end(s, lx);
    if (!err) s->mapping = mapping[k];
    return err;
}
#endif
