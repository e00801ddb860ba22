/* plot_looks.c - how an element would look in gnuplot: title, with, colours and widths. Lines are what a pen draws. */
#include "lang/plot_options.h"
#include "lang/session_parts.h"

static int title(session_t *s, lexer_t *lx, session_source_t *src) {
#if CONFIG_CONTROL
    if (session_may_be_text(s, lx) && !plot_is_plain(lx)) {
        const char *text;
        int err = plot_text(s, lx, &text);
        src->title = text;
        src->title_len = err ? 0 : (int32_t)strlen(text);
        return err;
    }
#endif
    if (lx->tok.kind != TOKEN_STRING) return lexer_unexpected(lx, &s->error, "a text in quotes expected");
    src->title = lexer_text(lx) + 1;
    src->title_len = (int32_t)lx->tok.len - 2;
    lexer_next(lx);
    return 0;
}

static int with(session_t *s, lexer_t *lx) {
    int index = words_find(words_style, lx);
    if (index < 0) {
        if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "a way to draw expected, such as lines");
        return lang_error_set_name(&s->error, ERR_NAME, lexer_column(lx), "unknown way to draw", lexer_text(lx),
                                   lx->tok.len);
    }
    if (words_style_id[index] != STYLE_LINES)
        session_warn_once(s, s->warned_command, WORDS_WARNED_STYLE, "with ", lx, " is drawn with lines");
    lexer_next(lx);
    return 0;
}

/* A colour: rgb "name", palette ..., variable, a word, or a number. */
static int colour(session_t *s, lexer_t *lx) {
    static const char alone[] = "var$iable\0bgnd\0black\0nodraw\0pal$ette\0";
    num_t number;
    if (words_find(alone, lx) >= 0) {
        lexer_next(lx);
        if (lexer_is_almost(lx, "frac$tion") || lexer_is_almost(lx, "cb") || lexer_is_almost(lx, "z"))
            lexer_next(lx);
        else
            return 0;
    } else if (lexer_is_almost(lx, "rgb$color")) {
        lexer_next(lx);
        if (lexer_is_almost(lx, "var$iable")) {
            lexer_next(lx);
            return 0;
        }
    }
    if (lx->tok.kind == TOKEN_STRING) {
        lexer_next(lx);
        return 0;
    }
#if CONFIG_LOAD_DEPTH
    if (lexer_is_name(lx, "ls") || lexer_is_name(lx, "lt")) lexer_next(lx); /* that of a style */
#endif
    return expr_number(&s->lang, lx, &number, &s->error);
}

static int dash(session_t *s, lexer_t *lx) {
    num_t number;
    if (lx->tok.kind == TOKEN_STRING || lexer_is_name(lx, "solid")) {
        lexer_next(lx);
        return 0;
    }
    if (!lexer_accept(lx, '(')) return expr_number(&s->lang, lx, &number, &s->error);
    do {
        int err = expr_number(&s->lang, lx, &number, &s->error);
        if (err) return err;
    } while (lexer_accept(lx, ','));
    return lexer_accept(lx, ')') ? 0 : lexer_unexpected(lx, &s->error, "')' expected");
}

enum look { LOOK_COLOUR, LOOK_DASH, LOOK_NUMBER, LOOK_SIZE, LOOK_PAIR, LOOK_FILL, LOOK_WORD, LOOK_NAME };
#if CONFIG_LOAD_DEPTH
#define MORE_LOOKS(WORD)                                                                                               \
    WORD("fc", LOOK_COLOUR)                                                                                            \
    WORD("fillc$olor", LOOK_COLOUR)                                                                                    \
    WORD("tc", LOOK_COLOUR)                                                                                            \
    WORD("textc$olor", LOOK_COLOUR)                                                                                    \
    WORD("fs", LOOK_FILL)                                                                                              \
    WORD("fill$style", LOOK_FILL)                                                                                      \
    WORD("as", LOOK_NUMBER)                                                                                            \
    WORD("arrows$tyle", LOOK_NUMBER)                                                                                   \
    WORD("font", LOOK_NAME)                                                                                            \
    WORD("off$set", LOOK_PAIR)                                                                                         \
    WORD("rot$ate", LOOK_WORD)                                                                                         \
    WORD("by", LOOK_NUMBER)                                                                                            \
    WORD("size", LOOK_PAIR)                                                                                            \
    WORD("left", LOOK_WORD)                                                                                            \
    WORD("right", LOOK_WORD)                                                                                           \
    WORD("cen$ter", LOOK_WORD)                                                                                         \
    WORD("box$ed", LOOK_WORD)                                                                                          \
    WORD("nohead", LOOK_WORD)                                                                                          \
    WORD("head$s", LOOK_WORD)                                                                                          \
    WORD("backhead", LOOK_WORD)                                                                                        \
    WORD("filled", LOOK_WORD)                                                                                          \
    WORD("nofilled", LOOK_WORD)                                                                                        \
    WORD("empty", LOOK_WORD)                                                                                           \
    WORD("fixed", LOOK_WORD)                                                                                           \
    WORD("point", LOOK_WORD)                                                                                           \
    WORD("closed", LOOK_WORD)                                                                                          \
    WORD("above", LOOK_WORD)                                                                                           \
    WORD("below", LOOK_WORD)                                                                                           \
    WORD("hyper$text", LOOK_WORD)                                                                                      \
    WORD("zsort", LOOK_WORD)                                                                                           \
    WORD("pixels", LOOK_WORD)                                                                                          \
    WORD("units", LOOK_NAME)
#else
#define MORE_LOOKS(WORD)
#endif
#define LOOKS(WORD)                                                                                                    \
    WORD("lt", LOOK_COLOUR)                                                                                            \
    WORD("linet$ype", LOOK_COLOUR)                                                                                     \
    WORD("lc", LOOK_COLOUR)                                                                                            \
    WORD("linec$olor", LOOK_COLOUR)                                                                                    \
    WORD("dt", LOOK_DASH)                                                                                              \
    WORD("dasht$ype", LOOK_DASH)                                                                                       \
    WORD("lw", LOOK_NUMBER)                                                                                            \
    WORD("linew$idth", LOOK_NUMBER)                                                                                    \
    WORD("ls", LOOK_NUMBER)                                                                                            \
    WORD("lines$tyle", LOOK_NUMBER)                                                                                    \
    WORD("ps", LOOK_SIZE)                                                                                              \
    WORD("points$ize", LOOK_SIZE)                                                                                      \
    WORD("pt", LOOK_SIZE)                                                                                              \
    WORD("pointt$ype", LOOK_SIZE)                                                                                      \
    WORD("pi", LOOK_NUMBER)                                                                                            \
    WORD("pointi$nterval", LOOK_NUMBER)                                                                                \
    WORD("nohidden$3d", LOOK_WORD)                                                                                     \
    WORD("nocon$tours", LOOK_WORD)                                                                                     \
    WORD("nosur$face", LOOK_WORD)                                                                                      \
    WORD("noenh$anced", LOOK_WORD)                                                                                     \
    WORD("enh$anced", LOOK_WORD)                                                                                       \
    WORD("pal$ette", LOOK_WORD)                                                                                        \
    WORD("ax$es", LOOK_NAME)                                                                                           \
    MORE_LOOKS(WORD)
static const char look_words[] = LOOKS(WORDS_PATTERN);
static const uint8_t look_words_id[] = {LOOKS(WORDS_ID)};

#if CONFIG_LOAD_DEPTH
/* Numbers between commas, each perhaps behind the name of its coordinates: 0,1 or character 1,0. */
static int pair(session_t *s, lexer_t *lx) {
    num_t number;
    do {
        if (lexer_is_almost(lx, "char$acter") || lexer_is_almost(lx, "fi$rst") || lexer_is_almost(lx, "gr$aph") ||
            lexer_is_almost(lx, "sc$reen"))
            lexer_next(lx);
        int err = expr_number(&s->lang, lx, &number, &s->error);
        if (err) return err;
    } while (lexer_accept(lx, ','));
    return 0;
}

/* solid 0.5, pattern 2, border lt 3 and the like. */
static int fill(session_t *s, lexer_t *lx) {
    static const char words[] = "tr$ansparent\0s$olid\0p$attern\0em$pty\0bo$rder\0nobo$rder\0";
    num_t number;
    while (words_find(words, lx) >= 0 || lx->tok.kind == TOKEN_NUMBER) {
        int err = 0;
        if (lx->tok.kind == TOKEN_NUMBER)
            err = expr_number(&s->lang, lx, &number, &s->error);
        else
            lexer_next(lx);
        if (err) return err;
    }
    return 0;
}
#endif

static int look(session_t *s, lexer_t *lx, enum look what) {
    num_t number;
    switch (what) {
    case LOOK_COLOUR:
        return colour(s, lx);
    case LOOK_DASH:
        return dash(s, lx);
    case LOOK_SIZE:
        if (lexer_is_almost(lx, "var$iable") || lx->tok.kind == TOKEN_STRING) {
            lexer_next(lx);
            return 0;
        } /* fall through */
    case LOOK_NUMBER:
        return expr_number(&s->lang, lx, &number, &s->error);
#if CONFIG_LOAD_DEPTH
    case LOOK_PAIR:
        return pair(s, lx);
    case LOOK_FILL:
        return fill(s, lx);
#endif
    case LOOK_NAME:
        if (lx->tok.kind != TOKEN_NAME && lx->tok.kind != TOKEN_STRING)
            return lexer_unexpected(lx, &s->error, "a word expected");
        lexer_next(lx);
        return 0;
    default:
        return 0;
    }
}

int plot_options_style(session_t *s, lexer_t *lx, session_source_t *src) {
    bool seen_title = false, seen_with = false;
    for (;;) {
        int err = 0, index;
        lexer_t word = *lx;
        if (lexer_is_almost(lx, "t$itle")) {
            lexer_next(lx);
            err = plot_options_twice(s, &word, &seen_title);
            if (!err) err = title(s, lx, src);
        } else if (lexer_is_almost(lx, "not$itle")) {
            lexer_next(lx);
            err = plot_options_twice(s, &word, &seen_title);
            src->title_len = 0;
            if (lx->tok.kind == TOKEN_STRING) lexer_next(lx);
        } else if (lexer_is_almost(lx, "w$ith")) {
            lexer_next(lx);
            err = plot_options_twice(s, &word, &seen_with);
            if (!err) err = with(s, lx);
        } else if ((index = words_find(look_words, lx)) >= 0) {
            lexer_next(lx);
            err = look(s, lx, (enum look)look_words_id[index]);
        } else {
            return 0;
        }
        if (err) return err;
    }
}
