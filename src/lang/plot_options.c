/* plot_options.c - which data of a file are drawn: using, index, every, skip, matrix. */
#include "lang/plot_options.h"
#include "lang/session_parts.h"

#define INDEX_MAX 1000000000
#define COLUMN_EXPECTED SAID("a column's number or an expression in brackets expected")

int plot_options_twice(session_t *s, const lexer_t *lx, bool *seen) {
    if (*seen) return session_fail(s, lx, ERR_SYNTAX, "given twice");
    *seen = true;
    return 0;
}

/* A whole number: an expression without brackets is a column's number. */
static int column_number(session_t *s, lexer_t *lx, int32_t *c) {
    if (lx->tok.kind != TOKEN_NUMBER && lx->tok.kind != TOKEN_NAME && lx->tok.kind != '-')
        return lexer_unexpected(lx, &s->error, COLUMN_EXPECTED);
    return expr_integer(&s->lang, lx, INT16_MIN, INT16_MAX, c, &s->error);
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
    int32_t c = 0;
    int err = column_number(s, lx, &c);
    if (err) return err;
    if (c < USING_SET || c > CONFIG_DATA_COLUMNS)
        return lang_error_set_number(&s->error, ERR_VALUE, lexer_column(&at), "columns are numbered from -2 to",
                                     CONFIG_DATA_COLUMNS);
    spec->part[k] = c;
    if (c > 0) spec->wanted |= (uint64_t)1 << c;
    return 0;
}

/* A column that is not drawn. */
static int using_more(session_t *s, lexer_t *lx) {
    expr_t unused;
    if (lx->tok.kind == '(') return plot_options_expression(s, lx, &unused);
    int32_t number;
    if (lx->tok.kind != TOKEN_STRING) return column_number(s, lx, &number);
    lexer_next(lx);
    return 0;
}

static int using(session_t *s, lexer_t *lx, session_source_t *src) {
    lexer_t at = *lx;
    bool flat = src->spec.flat;
    int n = 0;
    do {
        /* What comes behind x, y and z has to do with colours, sizes or errors. */
        int err = n == (flat ? 2 : 3) ? using_more(s, lx) : using_part(s, lx, src, n++);
        if (err) return err;
    } while (lexer_accept(lx, ':'));
#if CONFIG_SAMPLED
    if (n == 2 && s->mapping != DATA_CARTESIAN) flat = true; /* two angles are enough */
#endif
    if (n == 2 && !flat) return session_fail(s, &at, ERR_SYNTAX, "a surface needs one column (z) or three (x:y:z)");
    if (lx->tok.kind == TOKEN_STRING) return session_fail(s, lx, ERR_UNSUPPORTED, "formats are not supported");
    src->spec.parts = n;
    return 0;
}

/* Numbers between colons, each of which may be left out. Returns how many colons there were, or an error. */
static int colons(session_t *s, lexer_t *lx, int32_t *const value[], const int32_t lo[], int n) {
    int k = 0;
    for (; k < n; k++) {
        const bool variable = CONFIG_CONTROL && lx->tok.kind == TOKEN_NAME &&
                              names_find_defined(&s->lang, SYMBOL_VARIABLE, lexer_text(lx), lx->tok.len) >= 0;
        if (lx->tok.kind == TOKEN_NUMBER || lx->tok.kind == '(' || variable) {
            int err = set_integer(s, lx, lo[k], INDEX_MAX, value[k], "this number is out of range");
            if (err) return err;
        } else if (lx->tok.kind != ':' && k == 0) {
            return lexer_unexpected(lx, &s->error, "a number expected");
        }
        if (!lexer_accept(lx, ':')) break;
    }
    return k;
}

static int index_option(session_t *s, lexer_t *lx, data_spec_t *spec) {
    static const int32_t lo[3] = {0, 0, 1};
    int32_t *const value[3] = {&spec->first_set, &spec->last_set, &spec->set_step};
    lexer_t at = *lx;
    if (lx->tok.kind == TOKEN_STRING)
        return session_fail(s, lx, ERR_UNSUPPORTED, "data sets have numbers here, not names");
    spec->last_set = -1;
    const int n = colons(s, lx, value, lo, 3);
    if (n < 0) return n;
    if (spec->last_set < 0) spec->last_set = n == 0 ? spec->first_set : INDEX_MAX; /* index 2: and 2::3 go on */
    if (spec->last_set < spec->first_set) return session_fail(s, &at, ERR_VALUE, "no data set is in this range");
    return 0;
}

static int every_option(session_t *s, lexer_t *lx, data_spec_t *spec) {
    static const int32_t lo[6] = {1, 1, 0, 0, 0, 0};
    int32_t *const value[6] = {&spec->point_step,  &spec->block_step, &spec->first_point,
                               &spec->first_block, &spec->last_point, &spec->last_block};
    const int n = colons(s, lx, value, lo, 6);
    return n < 0 ? n : 0;
}

int plot_options_data(session_t *s, lexer_t *lx, session_source_t *src) {
    static const char other[] = "smooth\0s$mooth\0mask\0zsort\0bins\0array\0rec$ord\0";
    bool seen_using = false, seen_index = false, seen_every = false, seen_matrix = false;
    const int32_t begin = lexer_column(lx);
    for (;;) {
        int err = 0;
        lexer_t word = *lx;
        if (lexer_is_almost(lx, "mat$rix")) {
            lexer_next(lx);
            err = plot_options_twice(s, &word, &seen_matrix);
            if (src->spec.format == DATA_ROWS) src->spec.format = DATA_MATRIX;
        } else if (lexer_is_almost(lx, "nonuni$form")) {
            lexer_next(lx);
            src->spec.format = DATA_NONUNIFORM;
        } else if (lexer_is_almost(lx, "i$ndex")) {
            lexer_next(lx);
            err = plot_options_twice(s, &word, &seen_index);
            if (!err) err = index_option(s, lx, &src->spec);
        } else if (lexer_is_almost(lx, "ev$ery")) {
            lexer_next(lx);
            err = plot_options_twice(s, &word, &seen_every);
            if (!err) err = every_option(s, lx, &src->spec);
        } else if (lexer_is_name(lx, "skip")) {
            lexer_next(lx);
            err = set_integer(s, lx, 0, INDEX_MAX, &src->spec.skip, "this number is out of range");
        } else if (lexer_is_name(lx, "volatile")) {
            lexer_next(lx); /* data are read once anyway */
        } else if (lexer_is_almost(lx, "u$sing")) {
            lexer_next(lx);
            err = plot_options_twice(s, &word, &seen_using);
            if (!err) err = using(s, lx, src);
        } else if (lexer_is_name(lx, "solid") || lexer_is_name(lx, "obj")) {
            lexer_next(lx);
            src->solid = true;
        } else if (lexer_is_almost(lx, "bin$ary")) {
#if CONFIG_BINARY
            err = plot_options_twice(s, lx, &src->binary);
            if (!err) err = plot_binary_options(s, lx, src);
#else
            return session_fail(s, lx, ERR_UNSUPPORTED, "binary data are not read; write them as text");
#endif
        } else if (words_find(other, lx) >= 0) {
            return lang_error_set_name(&s->error, ERR_UNSUPPORTED, lexer_column(lx), "not supported", lexer_text(lx),
                                       lx->tok.len);
        } else {
            if (src->solid && (src->spec.format != DATA_ROWS || seen_using || seen_index || seen_every))
                return lang_error_set(&s->error, ERR_SYNTAX, begin, "a solid is neither a matrix nor columns");
#if CONFIG_BINARY
            if (src->binary) return plot_binary_fields(s, src);
#endif
            if (src->spec.format != DATA_ROWS && src->spec.flat)
                return lang_error_set(&s->error, ERR_UNSUPPORTED, src->column, "a matrix is drawn by splot");
            if (src->spec.format == DATA_NONUNIFORM && !seen_matrix)
                return lexer_unexpected(lx, &s->error, "`matrix` expected with nonuniform");
            return 0;
        }
        if (err) return err;
    }
}
