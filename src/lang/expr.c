/* expr.c - what commands do with expressions: definitions, numbers, and the report of what went wrong. */
#include "lang/expr.h"
#include "lang/arith.h"
#include "lang/builtins.h"
#include "lang/code.h"

static const char *name_of(const lang_t *l, int symbol) {
    return (const char *)l->pool + l->symbol[symbol].name;
}

/* The code of an evaluation carries no positions, they would cost memory on every board: the name at fault is looked
 * for in the text instead. */
int expr_fault(const lang_t *l, const lexer_t *at, lang_error_t *err) {
    int32_t column = at ? lexer_column(at) : 0;
    if (l->fault.symbol < 0) return lang_error_set(err, l->fault.code, column, l->fault.text);
    const char *name = name_of(l, l->fault.symbol);
    size_t len = l->symbol[l->fault.symbol].name_len;
    for (lexer_t lx = at ? *at : (lexer_t){0}; at && lx.tok.kind != TOKEN_END; lexer_next(&lx)) {
        if (lx.tok.kind == TOKEN_NAME && lx.tok.len == len && memcmp(lexer_text(&lx), name, len) == 0) {
            column = lexer_column(&lx);
            break;
        }
    }
    return lang_error_set_name(err, l->fault.code, column, l->fault.text, name, len);
}

/* What is looked for in code: rand() and assignments, or a variable if symbol >= 0. Marks the functions that it calls.
 */
static bool scan(const uint8_t *code, uint16_t len, int symbol, bool called[CONFIG_SYMBOLS]) {
    for (const uint8_t *p = code; p < code + len; p += 1 + code_operands(*p)) {
        if (*p == OP_CALL) called[p[1]] = true;
        if (symbol >= 0 && *p == OP_VAR && p[1] == symbol) return true;
        if (symbol >= 0) continue;
        if (*p == OP_SET) return true;
        if (*p == OP_FUNC && (BUILTINS[p[1]].flags & BUILTIN_IMPURE)) return true;
    }
    return false;
}

/* The same in what it calls, and so on. */
static bool scan_all(const lang_t *l, const expr_t *e, int symbol) {
    bool called[CONFIG_SYMBOLS] = {false}, seen[CONFIG_SYMBOLS] = {false};
    if (scan(e->code, e->len, symbol, called)) return true;
    for (int i = 0; i < l->symbols;) {
        const symbol_t *s = &l->symbol[i];
        if (called[i] && !seen[i] && s->defined) {
            seen[i] = true;
            if (scan(l->pool + s->u.code.start, s->u.code.len, symbol, called)) return true;
            i = 0; /* it may call functions that stand before it */
        } else {
            i++;
        }
    }
    return false;
}

bool expr_is_impure(const lang_t *l, const expr_t *e) {
    return scan_all(l, e, -1);
}

#if CONFIG_CONTROL
bool expr_mentions(const lang_t *l, const expr_t *e, int symbol) {
    return scan_all(l, e, symbol);
}
#endif

int expr_value(lang_t *l, lexer_t *lx, value_t *out, lang_error_t *err) {
    lexer_t start = *lx;
    uint16_t mark = l->symbols;
    expr_t e;
    *out = value_undef();
    int r = expr_compile(l, lx, NULL, l->pool + l->bodies_end, CONFIG_POOL, &e, err);
    if (r < 0) return r;
    r = expr_eval(l, &e, NULL, out);
    if (r < 0 || l->fault.code) r = expr_fault(l, &start, err);
    names_release(l, mark);
    return r;
}

int expr_number(lang_t *l, lexer_t *lx, num_t *out, lang_error_t *err) {
    int32_t column = lexer_column(lx);
    value_t v;
    int r = expr_value(l, lx, &v, err);
    const char *fault = arith_number(&v);
    *out = value_num(v);
    if (r < 0) return r;
    if (fault) return lang_error_set(err, ERR_VALUE, column, fault);
    return v.kind == VALUE_UNDEF ? lang_error_set(err, ERR_VALUE, column, "undefined value") : 0;
}

int expr_integer(lang_t *l, lexer_t *lx, int32_t lo, int32_t hi, int32_t *out, lang_error_t *err) {
    int32_t column = lexer_column(lx);
    num_t n;
    int r = expr_number(l, lx, &n, err);
    if (r < 0) return r;
    if (!num_is_integer(n)) return lang_error_set(err, ERR_VALUE, column, "a whole number is needed");
    int64_t i = num_to_fixed(n, 0, NULL); /* saturates, which is out of range */
    if (i < lo) return lang_error_set_number(err, ERR_VALUE, column, "number out of range, the least is", lo);
    if (i > hi) return lang_error_set_number(err, ERR_VALUE, column, "number out of range, the greatest is", hi);
    *out = (int32_t)i;
    return 0;
}

/* Does `(a,b) =` stand here, and what are the names? lx is behind the `=` then. */
static int parameter_list(lexer_t *lx, expr_params_t *params, lang_error_t *err) {
    params->count = 0;
    params->any_kind = true;
#if CONFIG_LOGSCALE
    params->base[0] = params->base[1] = params->result_base = NULL;
#endif
    do {
        lexer_next(lx);
        if (lx->tok.kind != TOKEN_NAME || lx->tok.len > UINT8_MAX) return 0;
        if (params->count == EXPR_PARAMS)
            return lang_error_set_number(err, ERR_FULL, lexer_column(lx), "function has too many parameters",
                                         EXPR_PARAMS);
        params->name[params->count].text = lexer_text(lx);
        params->name[params->count++].len = (uint8_t)lx->tok.len;
        lexer_next(lx);
    } while (lx->tok.kind == ',');
    return lexer_accept(lx, ')') && lexer_accept(lx, '=');
}

static int define_function(lang_t *l, lexer_t *lx, const char *name, size_t len, lang_error_t *err) {
    int32_t column = (int32_t)(name - lx->text) + 1;
    expr_params_t params;
    lexer_t after = *lx;
    int r = parameter_list(&after, &params, err);
    if (r <= 0) return r;
    int b = builtins_find(name, len);
    if (b >= 0 && !(BUILTINS[b].flags & BUILTIN_OURS))
        return lang_error_set_name(err, ERR_NAME, column, "cannot redefine a built-in function", name, len);
    uint16_t mark = l->symbols;
    int symbol = names_intern(l, SYMBOL_FUNCTION, name, len, column, err);
    if (symbol < 0) return symbol;
    expr_t e;
    r = expr_compile(l, &after, &params, l->pool + l->bodies_end, CONFIG_POOL, &e, err);
    if (r < 0) {
        names_release(l, mark);
        return r;
    }
    names_define_function(l, symbol, e.params, e.len, e.stack);
    *lx = after;
    return 1;
}

int expr_define(lang_t *l, lexer_t *lx, lang_error_t *err) {
    if (lx->tok.kind != TOKEN_NAME) return 0;
    const char *name = lexer_text(lx);
    size_t len = lx->tok.len;
    lexer_t after = *lx;
    lexer_next(&after);
    if (after.tok.kind == '(') {
        int r = define_function(l, &after, name, len, err);
        if (r > 0) *lx = after;
        return r;
    }
    if (!lexer_accept(&after, '=')) return 0;
    value_t v;
    int r = expr_value(l, &after, &v, err);
    if (r < 0) return r;
    r = names_set(l, name, len, v, err);
    if (r < 0) {
        if (CONFIG_CONTROL) err->column = lexer_column(lx);
        return r;
    }
    *lx = after;
    return 1;
}
