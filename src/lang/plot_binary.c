/* plot_binary.c - 'file' binary ...: how the bytes of a file are laid out. */
#include "lang/plot_options.h"
#include "lang/session_parts.h"

#if CONFIG_BINARY
#define SIZE_MAX_ 1000000000

static int equals(session_t *s, lexer_t *lx) {
    return lexer_accept(lx, '=') ? 0 : lexer_unexpected(lx, &s->error, "= expected");
}

/* =(x,y,z), or two of them. */
static int place(session_t *s, lexer_t *lx, num_t v[3]) {
    int err = equals(s, lx);
    if (!err && !lexer_accept(lx, '(')) err = lexer_unexpected(lx, &s->error, "( expected");
    for (int k = 0; k < 3 && !err; k++) {
        if (k == 2 && lx->tok.kind == ')') break;
        if (k > 0 && !lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, ", expected");
        err = expr_number(&s->lang, lx, &v[k], &s->error);
    }
    if (!err && !lexer_accept(lx, ')')) err = lexer_unexpected(lx, &s->error, ") expected");
    return err;
}

static int step(session_t *s, lexer_t *lx, num_t *v) {
    int err = equals(s, lx);
    return err ? err : expr_number(&s->lang, lx, v, &s->error);
}

/* =100 or =(10,20); -1: as many as there are. */
static int size(session_t *s, lexer_t *lx, int32_t n[2]) {
    static const char WRONG[] = "a number of points is at least 1; -1: up to the end";
    int err = equals(s, lx);
    if (err) return err;
    const bool both = lexer_accept(lx, '(');
    n[1] = 1;
    for (int k = 0; k < (both ? 2 : 1) && !err; k++) {
        const lexer_t at = *lx;
        if (k > 0 && !lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, ", expected");
        err = set_integer(s, lx, -1, SIZE_MAX_, &n[k], WRONG);
        if (!err && n[k] == 0) err = session_fail(s, &at, ERR_VALUE, WRONG);
        if (!err && both && k == 0 && n[0] < 0)
            err = session_fail(s, &at, ERR_UNSUPPORTED, "only the number of rows may be -1");
    }
    if (n[0] < 0) n[1] = -1; /* one row, of all there are */
    if (!err && both && !lexer_accept(lx, ')')) err = lexer_unexpected(lx, &s->error, ") expected");
    if (!err && lx->tok.kind == ':') err = session_fail(s, lx, ERR_UNSUPPORTED, "one record of a file is drawn");
    return err;
}

/* =x, =y, =xy, or nothing behind flipx, flipy. */
static int flip(session_t *s, lexer_t *lx, bool down[2]) {
    int err = equals(s, lx);
    if (err) return err;
    const bool x = lexer_is_name(lx, "x"), y = lexer_is_name(lx, "y"), xy = lexer_is_name(lx, "xy");
    if (!x && !y && !xy) return lexer_unexpected(lx, &s->error, "x, y or xy expected");
    down[0] |= x || xy;
    down[1] |= y || xy;
    lexer_next(lx);
    return 0;
}

static int endian(session_t *s, lexer_t *lx, bool *big) {
    const bool own = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
    int err = equals(s, lx);
    if (err) return err;
    if (lexer_is_name(lx, "little"))
        *big = false;
    else if (lexer_is_name(lx, "big"))
        *big = true;
    else if (lexer_is_name(lx, "default"))
        *big = own;
    else if (lexer_is_name(lx, "swap") || lexer_is_name(lx, "swab"))
        *big = !own;
    else
        return lexer_unexpected(lx, &s->error, "little, big, default or swap expected");
    lexer_next(lx);
    return 0;
}

static const struct {
    const char *names; /* with zeros between them, and another behind the last */
    binary_field_t field;
} TYPES[] = {
    {"float\0f\0float32\0real4\0", {4, BINARY_FLOAT, false}},
    {"double\0lf\0float64\0real8\0", {8, BINARY_FLOAT, false}},
    {"char\0schar\0c\0int8\0", {1, BINARY_SIGNED, false}},
    {"uchar\0uint8\0", {1, BINARY_UNSIGNED, false}},
    {"short\0int16\0", {2, BINARY_SIGNED, false}},
    {"ushort\0uint16\0", {2, BINARY_UNSIGNED, false}},
    {"int\0sint\0i\0d\0int32\0", {4, BINARY_SIGNED, false}},
    {"uint\0u\0uint32\0", {4, BINARY_UNSIGNED, false}},
    {"long\0ld\0int64\0", {8, BINARY_SIGNED, false}},
    {"ulong\0lu\0uint64\0", {8, BINARY_UNSIGNED, false}},
};

static bool find_type(const char *name, size_t n, binary_field_t *out) {
    for (size_t k = 0; k < sizeof TYPES / sizeof TYPES[0]; k++)
        for (const char *t = TYPES[k].names; *t; t += strlen(t) + 1)
            if (strlen(t) == n && memcmp(t, name, n) == 0) {
                *out = TYPES[k].field;
                return true;
            }
    return false;
}

/* ="%float%*2int". */
static int format(session_t *s, lexer_t *lx, binary_spec_t *b) {
    char text[200];
    int err = equals(s, lx);
    const lexer_t at = *lx;
    if (!err) err = session_string(s, lx, text, sizeof text, "a format in quotes expected, such as '%float'");
    if (err) return err;
    b->fields = 0;
    for (const char *p = text; *p;) {
        binary_field_t f;
        int32_t times = 0;
        if (*p == ' ') {
            p++;
            continue;
        }
        if (*p++ != '%') return session_fail(s, &at, ERR_SYNTAX, "a type begins with %, as %float does");
        const bool dropped = *p == '*';
        p += dropped;
        while (*p >= '0' && *p <= '9' && times < 1000) times = times * 10 + (*p++ - '0');
        const size_t n = strcspn(p, "% ");
        if (!find_type(p, n, &f))
            return session_fail(s, &at, ERR_VALUE,
                                "the types are float double char uchar short ushort int uint long ulong");
        f.dropped = dropped;
        for (times = times ? times : 1; times > 0; times--) {
            if (b->fields == CONFIG_DATA_COLUMNS)
                return lang_error_set_number(&s->error, ERR_FULL, lexer_column(&at), "too many fields; most",
                                             CONFIG_DATA_COLUMNS);
            b->field[b->fields++] = f;
        }
        p += n;
    }
    return b->fields ? 0 : session_fail(s, &at, ERR_SYNTAX, "no type");
}

/* One keyword; 0 with *known false: it is none of binary data. */
static int keyword(session_t *s, lexer_t *lx, session_source_t *src, num_t center[3], bool steps[2], bool *known) {
    static const char other[] = "filetype\0scan\0rot$ation\0perp$endicular\0";
    binary_spec_t *b = &src->layout;
    const lexer_t at = *lx;
    const bool array = lexer_is_name(lx, "array"), x = lexer_is_name(lx, "flipx") || lexer_is_name(lx, "dx");
    *known = true;
    lexer_next(lx);
    if (array || lexer_is_almost(&at, "rec$ord")) {
        b->layout = array ? BINARY_ARRAY : BINARY_RECORD;
        return size(s, lx, b->n);
    }
    if (lexer_is_name(&at, "format")) {
        if (b->layout == BINARY_MATRIX) b->layout = BINARY_RECORD;
        return format(s, lx, b);
    }
    if (lexer_is_almost(&at, "end$ian")) return endian(s, lx, &b->big_endian);
    if (lexer_is_name(&at, "skip")) {
        int err = equals(s, lx);
        return err ? err : set_integer(s, lx, 0, SIZE_MAX_, &b->skip, "this number is out of range");
    }
    if (lexer_is_name(&at, "dx") || lexer_is_name(&at, "dy")) {
        steps[!x] = true;
        return step(s, lx, &b->step[!x]);
    }
    if (lexer_is_name(&at, "origin")) return place(s, lx, b->first);
    if (lexer_is_name(&at, "center")) return place(s, lx, center);
    if (lexer_is_name(&at, "flip")) return flip(s, lx, b->down);
    if (lexer_is_name(&at, "flipx") || lexer_is_name(&at, "flipy")) {
        b->down[!x] = true;
        return 0;
    }
    if (lexer_is_name(&at, "transpose")) {
        b->transposed = true;
        return 0;
    }
    if (lexer_is_almost(&at, "mat$rix") || lexer_is_almost(&at, "nonuni$form")) {
        b->layout = BINARY_MATRIX;
        return 0;
    }
    *lx = at;
    *known = false;
    if (words_find(other, lx) < 0) return 0;
    return lang_error_set_name(&s->error, ERR_UNSUPPORTED, lexer_column(lx), "not supported", lexer_text(lx),
                               lx->tok.len);
}

int plot_binary_options(session_t *s, lexer_t *lx, session_source_t *src) {
    binary_spec_t *b = &src->layout;
    const lexer_t at = *lx;
    bool steps[2] = {false, false};
    num_t center[3] = {num_undef(), num_undef(), num_undef()};
    if (src->kind != SOURCE_FILE || src->name.tok.kind == '$' || !s->port->open_binary)
        return session_fail(s, lx, ERR_UNSUPPORTED, "binary data are read from files");
    lexer_next(lx);
    binary_spec_default(b);
    b->layout = BINARY_MATRIX;
    src->binary = true;
    for (bool known = true; known && lx->tok.kind == TOKEN_NAME;) {
        int err = keyword(s, lx, src, center, steps, &known);
        if (err) return err;
    }
    if (steps[0] && !steps[1]) b->step[1] = b->step[0];
    if (b->transposed) { /* a row runs along y, of which there are n[1] */
        if (b->n[1] < 0) return session_fail(s, &at, ERR_VALUE, "an array without an end cannot be transposed");
        const int32_t along_x = b->n[0];
        b->n[0] = b->n[1];
        b->n[1] = along_x;
    }
    for (int k = 0; k < 2; k++) {
        const int32_t n = b->n[k ^ b->transposed];
        if (n < 0 && b->layout == BINARY_ARRAY && (b->down[k] || !center[k].undef))
            return session_fail(s, &at, ERR_VALUE, "an array without an end has no centre, and cannot be flipped");
        if (!center[k].undef) b->first[k] = num_sub(center[k], num_ldexp(num_mul(b->step[k], num_from_i64(n - 1)), -1));
    }
    if (!center[2].undef) b->first[2] = center[2];
    return 0;
}

/* using is known: how many fields a point has, if no format says more. */
int plot_binary_fields(session_t *s, session_source_t *src) {
    binary_spec_t *b = &src->layout;
    data_spec_t *spec = &src->spec;
    if (spec->format != DATA_ROWS) { /* 'file' matrix binary */
        if (b->layout != BINARY_MATRIX)
            return lang_error_set(&s->error, ERR_SYNTAX, src->column, "a matrix, or an array?");
        spec->format = DATA_ROWS;
    }
    if (b->layout == BINARY_MATRIX)
        return spec->flat ? lang_error_set(&s->error, ERR_UNSUPPORTED, src->column, "a matrix is drawn by splot") : 0;
    const bool array = b->layout == BINARY_ARRAY;
    if (array && !spec->parts) {
        spec->parts = spec->part[0] = 1;
        spec->wanted = 2;
    }
    if (array && !spec->flat && spec->parts > 1)
        return lang_error_set(&s->error, ERR_UNSUPPORTED, src->column,
                              "points of an array are where they stand: `using` takes one column, or `record` three");
    uint64_t columns = spec->wanted;
    bool known = true;
    for (int k = 0; k < spec->parts; k++) {
        uint64_t looks = 0;
        if (spec->part[k] != USING_EXPR) continue;
        known &= expr_is_of_columns(&s->lang, &src->part[k], &looks);
        columns |= looks;
    }
    if (!known && !b->fields)
        return lang_error_set(&s->error, ERR_SYNTAX, src->column, "a format is needed, such as format='%3float'");
    int32_t have = 0, want = spec->parts ? 1 : spec->flat ? 2 : 3;
    while (columns >> (want + 1)) want++;
    for (int k = 0; k < b->fields; k++) have += !b->field[k].dropped;
    if (!spec->parts && b->fields) want = have;
    const binary_field_t more = b->fields ? b->field[b->fields - 1] : (binary_field_t){4, BINARY_FLOAT, false};
    for (; have < want; have++) {
        if (b->fields == CONFIG_DATA_COLUMNS)
            return lang_error_set_number(&s->error, ERR_FULL, src->column, "too many fields; most",
                                         CONFIG_DATA_COLUMNS);
        b->field[b->fields] = more;
        b->field[b->fields++].dropped = false;
    }
    return have ? 0 : lang_error_set(&s->error, ERR_SYNTAX, src->column, "a format without a column");
}
#endif
