/* plot_options.c - using, index, every, matrix; title, with, and the looks of a line. */
#include "lang/plot_options.h"
#include "lang/session_parts.h"

#include "num/func.h"
#include "scene/affine.h"

#define INDEX_MAX 1000000000

static int twice(session_t *s, const lexer_t *lx, bool *seen) {
    if (*seen) return session_fail(s, lx, ERR_SYNTAX, "given twice");
    *seen = true;
    return 0;
}

/* One part of using: a column, or an expression in brackets. */
static int using_part(session_t *s, lexer_t *lx, session_source_t *src, int k) {
    data_spec_t *spec = &src->spec;
    if (lx->tok.kind == '(') {
        int err = plot_options_expression(s, lx, &src->part[k]);
        if (err) return err;
        spec->part[k] = USING_EXPR;
        spec->all |= src->part[k].columns;
        return 0;
    }
    if (lx->tok.kind == TOKEN_STRING)
        return session_fail(s, lx, ERR_UNSUPPORTED, "columns have numbers here, not names");
    lexer_t at = *lx;
    int32_t sign = lexer_accept(lx, '-') ? -1 : 1;
    if (lx->tok.kind != TOKEN_NUMBER || lx->tok.value.kind != VALUE_INT)
        return lexer_unexpected(lx, &s->error, "a column's number or an expression in brackets expected");
    int64_t c = lx->tok.value.m * sign;
    if (c < USING_SET || c > CONFIG_DATA_COLUMNS)
        return lang_error_set_number(&s->error, ERR_VALUE, lexer_column(&at), "columns are numbered from -2 to",
                                     CONFIG_DATA_COLUMNS);
    lexer_next(lx);
    spec->part[k] = (int32_t)c;
    if (c > 0) spec->wanted |= (uint64_t)1 << c;
    return 0;
}

static int using(session_t *s, lexer_t *lx, session_source_t *src) {
    lexer_t at = *lx;
    bool flat = src->spec.flat;
    int n = 0;
    do {
        if (n == (flat ? 2 : 3))
            return session_fail(s, lx, ERR_UNSUPPORTED,
                                flat ? "a curve takes no more than two columns"
                                     : "a surface takes no more than three columns");
        int err = using_part(s, lx, src, n++);
        if (err) return err;
    } while (lexer_accept(lx, ':'));
    if (n == 2 && !flat) return session_fail(s, &at, ERR_SYNTAX, "a surface needs one column (z) or three (x:y:z)");
    if (lx->tok.kind == TOKEN_STRING) return session_fail(s, lx, ERR_UNSUPPORTED, "formats are not supported");
    src->spec.parts = n;
    return 0;
}

/* Numbers between colons, each of which may be left out. */
static int colons(session_t *s, lexer_t *lx, int32_t *const value[], const int32_t lo[], int n) {
    for (int k = 0; k < n; k++) {
        if (lx->tok.kind == TOKEN_NUMBER || lx->tok.kind == '(') {
            int err = set_integer(s, lx, lo[k], INDEX_MAX, value[k], "this number is out of range");
            if (err) return err;
        } else if (lx->tok.kind != ':' && k == 0) {
            return lexer_unexpected(lx, &s->error, "a number expected");
        }
        if (!lexer_accept(lx, ':')) break;
    }
    return 0;
}

static int index_option(session_t *s, lexer_t *lx, data_spec_t *spec) {
    static const int32_t lo[3] = {0, 0, 1};
    int32_t *const value[3] = {&spec->first_set, &spec->last_set, &spec->set_step};
    lexer_t at = *lx;
    if (lx->tok.kind == TOKEN_STRING)
        return session_fail(s, lx, ERR_UNSUPPORTED, "data sets have numbers here, not names");
    spec->last_set = -1;
    int err = colons(s, lx, value, lo, 3);
    if (err) return err;
    if (spec->last_set < 0) { /* index 2 is one set, index 2: and 2::3 go on */
        lexer_t colon = at;
        lexer_next(&colon);
        spec->last_set = at.tok.kind == TOKEN_NUMBER && colon.tok.kind != ':' ? spec->first_set : INDEX_MAX;
    }
    if (spec->last_set < spec->first_set) return session_fail(s, &at, ERR_VALUE, "no data set is in this range");
    return 0;
}

static int every_option(session_t *s, lexer_t *lx, data_spec_t *spec) {
    static const int32_t lo[6] = {1, 1, 0, 0, 0, 0};
    int32_t *const value[6] = {&spec->point_step,  &spec->block_step, &spec->first_point,
                               &spec->first_block, &spec->last_point, &spec->last_block};
    return colons(s, lx, value, lo, 6);
}

int plot_options_data(session_t *s, lexer_t *lx, session_source_t *src) {
    static const word_t other[] = {{"bin$ary", 0},  {"smooth", 0},  {"s$mooth", 0}, {"skip", 0},
                                   {"volatile", 0}, {"mask", 0},    {"zsort", 0},   {"bins", 0},
                                   {"array", 0},    {"rec$ord", 0}, {NULL, 0}};
    bool seen_using = false, seen_index = false, seen_every = false, seen_matrix = false;
    const int32_t begin = lexer_column(lx);
    for (;;) {
        int err = 0;
        lexer_t word = *lx;
        if (lexer_is_almost(lx, "mat$rix")) {
            lexer_next(lx);
            err = twice(s, &word, &seen_matrix);
            if (src->spec.format == DATA_ROWS) src->spec.format = DATA_MATRIX;
        } else if (lexer_is_almost(lx, "nonuni$form")) {
            lexer_next(lx);
            src->spec.format = DATA_NONUNIFORM;
        } else if (lexer_is_almost(lx, "i$ndex")) {
            lexer_next(lx);
            err = twice(s, &word, &seen_index);
            if (!err) err = index_option(s, lx, &src->spec);
        } else if (lexer_is_almost(lx, "ev$ery")) {
            lexer_next(lx);
            err = twice(s, &word, &seen_every);
            if (!err) err = every_option(s, lx, &src->spec);
        } else if (lexer_is_almost(lx, "u$sing")) {
            lexer_next(lx);
            err = twice(s, &word, &seen_using);
            if (!err) err = using(s, lx, src);
        } else if (lexer_is_name(lx, "solid") || lexer_is_name(lx, "obj")) {
            lexer_next(lx);
            src->solid = true;
        } else if (words_find(other, lx) >= 0) {
            return lang_error_set_name(&s->error, ERR_UNSUPPORTED, lexer_column(lx), "not supported", lexer_text(lx),
                                       lx->tok.len);
        } else {
            if (src->solid && (src->spec.format != DATA_ROWS || seen_using || seen_index || seen_every))
                return lang_error_set(&s->error, ERR_SYNTAX, begin, "a solid is neither a matrix nor columns");
            if (src->spec.format != DATA_ROWS && src->spec.flat)
                return lang_error_set(&s->error, ERR_UNSUPPORTED, src->column, "a matrix is drawn by splot");
            if (src->spec.format == DATA_NONUNIFORM && !seen_matrix)
                return lexer_unexpected(lx, &s->error, "`matrix` expected with nonuniform");
            return 0;
        }
        if (err) return err;
    }
}

int32_t plot_options_cosine(num_t degrees) {
    num_t cosine = func_sin_degrees(num_sub(num_from_i64(90), degrees));
    return num_sign(degrees) ? (int32_t)num_to_fixed(cosine, 30, NULL) : 0;
}

static int crease(session_t *s, lexer_t *lx, int32_t *smooth_q30) {
    lexer_t at = *lx;
    num_t degrees;
    int err = expr_number(&s->lang, lx, &degrees, &s->error);
    if (err) return err;
    if (num_sign(degrees) < 0 || num_cmp(degrees, num_from_i64(89)) > 0)
        return session_fail(s, &at, ERR_VALUE, "crease must be between 0 and 89 degrees");
    *smooth_q30 = plot_options_cosine(degrees);
    return 0;
}

#if CONFIG_AREA
/* translucent ['NAME' ...]: names go to `names`, unless that is NULL, a zero behind each and another behind all. */
static int translucent(session_t *s, lexer_t *lx, char *names) {
    size_t at = 0;
    while (lx->tok.kind == TOKEN_STRING) {
        char name[OBJ_WORD_MAX + 1];
        int len = lexer_string(lx, name, sizeof name);
        if (len == 0) return session_fail(s, lx, ERR_VALUE, "the name of a group, an object or a material expected");
        if (len < 0 || at + (size_t)len + 2 > PLOT_NAMES_MAX)
            return session_fail(s, lx, ERR_FULL, "too many or too long names");
        if (names) memcpy(names + at, name, (size_t)len + 1);
        at += (size_t)len + 1;
        lexer_next(lx);
    }
    if (names) names[at] = '\0';
    return 0;
}
#endif

int plot_options_moves(session_t *s, lexer_t *lx, affine_t *a, session_source_t *src, char *names) {
    static const word_t words[] = {
        {"translate", 0},
        {"rotate", 1},
        {"scale", 2},
        {"crease", 3},
#if CONFIG_AREA
        {"transl$ucent", 4},
#endif
        {NULL, 0}
    };
#if !CONFIG_AREA
    (void)names;
#endif
    static void (*const move[])(affine_t *, const num_t[3]) = {affine_translate, affine_rotate, affine_scale};
    for (int which; (which = words_find(words, lx)) >= 0;) {
        lexer_t word = *lx;
        lexer_next(lx);
        num_t by[3];
        if (which == 3) {
            int err = crease(s, lx, &src->smooth_q30);
            if (err) return err;
            continue;
        }
#if CONFIG_AREA
        if (which == 4) {
            src->clear = true;
            int err = translucent(s, lx, names);
            if (err) return err;
            continue;
        }
#endif
        for (int k = 0; k < 3; k++) {
            if (which == 2 && k == 1 && lx->tok.kind != ',') {
                by[1] = by[2] = by[0];
                break;
            }
            if (k > 0 && !lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "three numbers X,Y,Z expected");
            int err = expr_number(&s->lang, lx, &by[k], &s->error);
            if (err) return err;
        }
        if (which == 2 && (num_sign(by[0]) == 0 || num_sign(by[1]) == 0 || num_sign(by[2]) == 0))
            return session_fail(s, &word, ERR_VALUE, "a scale of 0 leaves nothing");
        move[which](a, by);
    }
    return 0;
}

static int title(session_t *s, lexer_t *lx, session_source_t *src) {
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
    if (words_style[index].id != STYLE_LINES)
        return lang_error_set_name(&s->error, ERR_UNSUPPORTED, lexer_column(lx), "only lines are drawn, not",
                                   lexer_text(lx), lx->tok.len);
    lexer_next(lx);
    return 0;
}

/* A colour: rgb "name", palette ..., variable, a word, or a number. */
static int colour(session_t *s, lexer_t *lx) {
    static const word_t alone[] = {{"var$iable", 0}, {"bgnd", 0},     {"black", 0},
                                   {"nodraw", 0},    {"pal$ette", 0}, {NULL, 0}};
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

enum look { LOOK_COLOUR, LOOK_DASH, LOOK_NUMBER, LOOK_WORD, LOOK_AXES };
static const word_t look_words[] = {
    {"lt", LOOK_COLOUR},        {"linet$ype", LOOK_COLOUR},  {"lc", LOOK_COLOUR},       {"linec$olor", LOOK_COLOUR},
    {"dt", LOOK_DASH},          {"dasht$ype", LOOK_DASH},    {"lw", LOOK_NUMBER},       {"linew$idth", LOOK_NUMBER},
    {"ls", LOOK_NUMBER},        {"lines$tyle", LOOK_NUMBER}, {"ps", LOOK_NUMBER},       {"points$ize", LOOK_NUMBER},
    {"pt", LOOK_NUMBER},        {"pointt$ype", LOOK_NUMBER}, {"pi", LOOK_NUMBER},       {"pointi$nterval", LOOK_NUMBER},
    {"nohidden$3d", LOOK_WORD}, {"nocon$tours", LOOK_WORD},  {"nosur$face", LOOK_WORD}, {"noenh$anced", LOOK_WORD},
    {"enh$anced", LOOK_WORD},   {"pal$ette", LOOK_WORD},     {"ax$es", LOOK_AXES},      {NULL, LOOK_WORD},
};

static int look(session_t *s, lexer_t *lx, enum look what) {
    num_t number;
    switch (what) {
    case LOOK_COLOUR:
        return colour(s, lx);
    case LOOK_DASH:
        return dash(s, lx);
    case LOOK_NUMBER:
        return expr_number(&s->lang, lx, &number, &s->error);
    case LOOK_AXES:
        if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "axes expected");
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
            err = twice(s, &word, &seen_title);
            if (!err) err = title(s, lx, src);
        } else if (lexer_is_almost(lx, "not$itle")) {
            lexer_next(lx);
            err = twice(s, &word, &seen_title);
            src->title_len = 0;
            if (lx->tok.kind == TOKEN_STRING) lexer_next(lx);
        } else if (lexer_is_almost(lx, "w$ith")) {
            lexer_next(lx);
            err = twice(s, &word, &seen_with);
            if (!err) err = with(s, lx);
        } else if ((index = words_find(look_words, lx)) >= 0) {
            lexer_next(lx);
            err = look(s, lx, (enum look)look_words[index].id);
        } else {
            return 0;
        }
        if (err) return err;
    }
}
