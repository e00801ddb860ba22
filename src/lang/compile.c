/* compile.c - text to stack code by operator precedence.
 *
 * gnuplot's parser descends recursively, one function for each level of precedence; here one loop keeps what is open
 * on a small stack, so depth costs 4 bytes and not a call. The two places where the grammar is not just a
 * table of precedences come out of the same loop: a prefix operator is never reduced when it arrives (so 2**-1 works
 * and -2**2 is -(2**2)), and a postfix ! acts at once on what stands before it.. */
#include "lang/builtins.h"
#include "lang/emit.h"
#include "lang/expr.h"
#include "lang/share.h"
#include "num/func.h"
#include "num/num_double.h"

/* Precedences; the open brackets stay below all operators. */
enum { OPEN = 0, LOOSE = 1, OR = 2, AND = 3, PREFIX = 12, POWER = 13 };

enum pending_kind {
    P_BINARY,  /* a = operation */
    P_PREFIX,  /* a = operation */
    P_LOGIC,   /* && ||: at = its jump */
    P_SET,     /* name = ...: a = symbol */
    P_ELSE,    /* behind the colon: at = the jump over it */
    P_THEN,    /* from here on brackets. Behind the question mark: at = the jump to the other side */
    P_GROUP,   /* ( */
    P_BUILTIN, /* name( : a = index, at = arguments so far */
    P_USER,    /* name( : a = symbol, at = arguments so far */
};

typedef struct pending {
    uint8_t kind;
    uint8_t a;
    uint16_t at;
} pending_t;

typedef struct compiler {
    emit_t e;
    lexer_t *lx;
    const expr_params_t *params;
    lang_error_t *err;
    bool columns;
    bool calls;  /* a function of the user's */
    int pending; /* entries of stack in use */
    pending_t stack[CONFIG_NESTING];
} compiler_t;

_Static_assert(sizeof(pending_t) == 4, "the header promises 4 bytes for each level of nesting");

/* In the order of the operations; OP_ADD is the first. */
static const struct {
    int16_t token;
    uint8_t precedence;
} BINARY[] = {
    {'+', 10},      {'-', 10},      {'*', 11}, {'/', 11},     {'%', 11}, {TOKEN_POWER, POWER},
    {TOKEN_SHL, 9}, {TOKEN_SHR, 9}, {'<', 8},  {TOKEN_LE, 8}, {'>', 8},  {TOKEN_GE, 8},
    {TOKEN_EQ, 7},  {TOKEN_NE, 7},  {'&', 6},  {'^', 5},      {'|', 4},
};
_Static_assert(sizeof BINARY / sizeof BINARY[0] == OP_BOR - OP_ADD + 1, "one entry for each operation");

/* The index of a token's operation, or -1. */
static int binary_of(int token) {
    for (int i = 0; i <= OP_BOR - OP_ADD; i++) {
        if (BINARY[i].token == token) return i;
    }
    return -1;
}

static int precedence(const pending_t *p) {
    switch (p->kind) {
    case P_BINARY:
        return BINARY[p->a - OP_ADD].precedence;
    case P_PREFIX:
        return PREFIX;
    case P_LOGIC:
        return p->a;
    case P_SET:
    case P_ELSE:
        return LOOSE;
    default:
        return OPEN;
    }
}

static void reduce_one(compiler_t *c) {
    pending_t p = c->stack[--c->pending];
    emit_t *e = &c->e;
    switch (p.kind) {
    case P_BINARY:
        emit_binary(e, p.a);
        break;
    case P_PREFIX:
        emit_unary(e, p.a);
        break;
    case P_LOGIC:
        emit_byte(e, OP_BOOL);
        emit_patch(e, p.at);
        emit_operated(e, 2, false, false);
        break;
    case P_SET:
        emit_byte2(e, OP_SET, p.a);
        emit_operated(e, 1, false, false);
        break;
    default: /* P_ELSE */
        emit_patch(e, p.at);
        emit_operated(e, 2, false, false);
        break;
    }
}

/* Closes the operators that bind at least as tightly as `limit`. */
static void reduce(compiler_t *c, int limit) {
    while (c->pending && precedence(&c->stack[c->pending - 1]) >= limit) reduce_one(c);
}

static int open_new(compiler_t *c, int kind, int a, uint16_t at) {
    if (c->pending == CONFIG_NESTING)
        return lang_error_set_number(c->err, ERR_FULL, lexer_column(c->lx), "expression too deeply nested (levels)",
                                     CONFIG_NESTING);
    c->stack[c->pending++] = (pending_t){(uint8_t)kind, (uint8_t)a, at};
    return 0;
}

/* What is open, operators aside: a bracket, or NULL outside of all. */
static pending_t *innermost(compiler_t *c) {
    int i = c->pending;
    while (i && precedence(&c->stack[i - 1]) != OPEN) i--;
    return i ? &c->stack[i - 1] : NULL;
}

static int parameter(const compiler_t *c, const char *name, uint32_t len) {
    for (int i = c->params ? c->params->count - 1 : -1; i >= 0; i--) {
        if (c->params->name[i].len == len && memcmp(c->params->name[i].text, name, len) == 0) return i;
    }
    return -1;
}

/* A name followed by a bracket. */
static int call(compiler_t *c, const char *name, uint32_t len, int32_t column) {
    int b = builtins_find(name, len);
    if (b >= 0 && (BUILTINS[b].flags & BUILTIN_OURS)) {
        int s = names_find(c->e.l, SYMBOL_FUNCTION, name, len);
        if (s >= 0 && c->e.l->symbol[s].defined) b = -1;
    }
    if (b >= 0) {
        if (BUILTINS[b].flags & BUILTIN_COLUMNS) c->columns = true;
        return open_new(c, P_BUILTIN, b, 1);
    }
    int s = names_intern(c->e.l, SYMBOL_FUNCTION, name, len, column, c->err);
    return s < 0 ? s : open_new(c, P_USER, s, 1);
}

static bool is_iterated(const lang_t *l, int symbol) {
#if CONFIG_CONTROL
    for (int i = 0; i < l->iterations; i++)
        if (l->iterated[i] == symbol) return true;
#else
    (void)l, (void)symbol;
#endif
    return false;
}

#if CONFIG_CONTROL
/* Functions that are called may look at the variables of `for`: (i = 3, f(x)) in place of f(x). */
static void set_iterated(emit_t *e) {
    for (int i = 0; i < e->l->iterations; i++) {
        emit_constant(e, e->l->symbol[e->l->iterated[i]].u.value);
        emit_byte2(e, OP_SET, e->l->iterated[i]);
        emit_byte(e, OP_POP);
        emit_operated(e, 1, false, false);
        e->depth--;
    }
}
#endif

#if CONFIG_CONTROL
/* exists("name"), behind its bracket: known now. */
static int exists(compiler_t *c) {
    lexer_t *lx = c->lx;
    const lang_t *l = c->e.l;
    const char *text = lexer_text(lx) + 1;
    if (lx->tok.kind != TOKEN_STRING) return lexer_unexpected(lx, c->err, "the name of a variable in quotes expected");
    const size_t len = lx->tok.len - 2;
    const int s = names_find(l, SYMBOL_VARIABLE, text, len);
    emit_constant(&c->e, value_int((s >= 0 && l->symbol[s].defined) || (l->texts && texts_get(l->texts, text, len))));
    lexer_next(lx);
    return lexer_accept(lx, ')') ? 1 : lexer_unexpected(lx, c->err, "')' expected");
}
#endif

/* Returns 1 when the name was a whole operand, 0 when one is still expected, or an error. */
static int name(compiler_t *c) {
    lexer_t *lx = c->lx;
    const char *text = lexer_text(lx);
    uint32_t len = lx->tok.len;
    int32_t column = lexer_column(lx);
    lexer_next(lx);
#if CONFIG_CONTROL
    if (lx->tok.kind == '(' && len == 6 && memcmp(text, "exists", 6) == 0) {
        lexer_next(lx);
        return exists(c);
    }
#endif
    if (lexer_accept(lx, '(')) return call(c, text, len, column);
    /* An assignment may stand wherever an expression starts. */
    bool starts = c->pending == 0 || precedence(&c->stack[c->pending - 1]) <= LOOSE;
    bool assigned = starts && lx->tok.kind == '=';
    int p = assigned ? -1 : parameter(c, text, len);
    uint32_t start = c->e.len;
    if (p >= 0) {
#if CONFIG_LOGSCALE
        const num_t *base = p < 2 ? c->params->base[p] : NULL;
        if (base) emit_constant(&c->e, value_real(*base));
        start = c->e.len;
#endif
        emit_byte(&c->e, OP_ARG + p);
        emit_pushed(&c->e, start, !c->params->any_kind);
#if CONFIG_LOGSCALE
        if (base) emit_binary(&c->e, OP_POW);
#endif
        return 1;
    }
    int s = names_intern(c->e.l, SYMBOL_VARIABLE, text, len, column, c->err);
    if (s < 0) return s;
    if (assigned) {
        lexer_next(lx);
        return open_new(c, P_SET, s, 0);
    }
    if (is_iterated(c->e.l, s)) {
        emit_constant(&c->e, c->e.l->symbol[s].u.value);
        return 1;
    }
    emit_byte2(&c->e, OP_VAR, s);
    emit_pushed(&c->e, start, false);
    return 1;
}

/* $3 */
static int dollar(compiler_t *c) {
    lexer_next(c->lx);
    const token_t *t = &c->lx->tok;
    if (t->kind != TOKEN_NUMBER || t->value.kind != VALUE_INT || t->value.m > INT16_MAX)
        return lexer_unexpected(c->lx, c->err, "column number expected");
    emit_constant(&c->e, t->value);
    emit_byte3(&c->e, OP_FUNC, builtins_find("column", 6), 1);
    emit_operated(&c->e, 1, false, false);
    c->columns = true;
    lexer_next(c->lx);
    return 1;
}

/* Takes one token where an operand is expected. Returns 1 when it was one, 0 when it still is expected, or an
 * error. */
static int operand(compiler_t *c) {
    lexer_t *lx = c->lx;
    int prefix = 0, r;
    switch (lx->tok.kind) {
    case TOKEN_NUMBER:
        if (lx->tok.value.kind == VALUE_UNDEF)
            return lang_error_set(c->err, ERR_VALUE, lexer_column(lx), "constant too large");
        emit_constant(&c->e, lx->tok.value);
        lexer_next(lx);
        return 1;
    case TOKEN_NAME:
        return name(c);
    case '$':
        return dollar(c);
    case '(':
        r = open_new(c, P_GROUP, 0, 0);
        lexer_next(lx);
        return r;
    case '+':
        lexer_next(lx);
        return 0;
    case '-':
        prefix = OP_NEG;
        break;
    case '!':
        prefix = OP_NOT;
        break;
    case '~':
        prefix = OP_BNOT;
        break;
    case TOKEN_STRING:
        return lang_error_set(c->err, ERR_UNSUPPORTED, lexer_column(lx), "strings cannot be computed with");
    default:
        return lexer_unexpected(lx, c->err, "invalid expression");
    }
    r = open_new(c, P_PREFIX, prefix, 0);
    lexer_next(lx);
    return r;
}

/* Turns the operand on top from degrees into radians (OP_MUL), or back (OP_DIV). */
static void convert_angle(compiler_t *c, uint8_t op) {
    emit_constant(&c->e, value_real(num_double(num_div(func_pi(), num_from_i64(180)))));
    emit_binary(&c->e, op);
}

/* A bracket that closes a call: its operation. */
static int close_call(compiler_t *c, pending_t p) {
    bool builtin = p.kind == P_BUILTIN;
    const builtin_t *b = &BUILTINS[builtin ? p.a : 0];
    if (builtin && (p.at < b->min_args || p.at > b->max_args))
        return lang_error_set_name(c->err, ERR_SYNTAX, lexer_column(c->lx), "wrong number of arguments", b->name,
                                   strlen(b->name));
    const bool degrees = builtin && c->e.l->degrees;
    if (degrees && (b->flags & BUILTIN_ANGLE)) convert_angle(c, OP_MUL);
    c->calls |= !builtin;
    if (!builtin) {
        emit_byte3(&c->e, OP_CALL, p.a, p.at);
    } else if (b->real1) {
        emit_byte2(&c->e, OP_REAL1, p.a);
    } else {
        emit_byte3(&c->e, OP_FUNC, p.a, p.at);
    }
    emit_operated(&c->e, p.at, builtin && !(b->flags & BUILTIN_IMPURE), builtin && b->real1);
    if (degrees && (b->flags & BUILTIN_ARC)) convert_angle(c, OP_DIV);
    return 0;
}

/* Takes one token behind an operand. Returns 0 when an operand is expected next, 1 when not, 2 when the token does not
 * belong to the expression, or an error. */
static int behind_operand(compiler_t *c) {
    lexer_t *lx = c->lx;
    int token = lx->tok.kind;
    pending_t *in = innermost(c);
    int b = binary_of(token);
    int r = 0;
    if (b >= 0) {
        reduce(c, BINARY[b].precedence + (token == TOKEN_POWER)); /* ** groups to the right */
        r = open_new(c, P_BINARY, OP_ADD + b, 0);
    } else if (token == TOKEN_AND || token == TOKEN_OR) {
        int level = token == TOKEN_AND ? AND : OR;
        reduce(c, level);
        r = open_new(c, P_LOGIC, level, emit_jump(&c->e, level == AND ? OP_AND : OP_OR));
    } else if (token == '?') {
        reduce(c, LOOSE + 1);
        r = open_new(c, P_THEN, 0, emit_jump(&c->e, OP_JZ));
    } else if (token == '!') {
        emit_unary(&c->e, OP_FACT);
        r = 1;
    } else if (token == ':' && in && in->kind == P_THEN) {
        reduce(c, LOOSE);
        uint16_t over = emit_jump(&c->e, OP_JUMP);
        emit_patch(&c->e, in->at);
        *in = (pending_t){P_ELSE, 0, over};
        c->e.depth--;
    } else if (token == ',' && in && in->kind != P_THEN) {
        reduce(c, LOOSE);
        if (in->kind == P_GROUP) {
            if (in->at) emit_operated(&c->e, 2, false, false);
            in->at = 1;
            emit_byte(&c->e, OP_POP);
        } else if (++in->at > EXPR_PARAMS) {
            return lang_error_set_number(c->err, ERR_FULL, lexer_column(lx), "too many arguments", EXPR_PARAMS);
        }
    } else if (token == ')' && in && in->kind != P_THEN) {
        reduce(c, LOOSE);
        pending_t p = c->stack[--c->pending];
        if (p.kind != P_GROUP)
            r = close_call(c, p);
        else if (p.at)
            emit_operated(&c->e, 2, false, false);
        if (r == 0) r = 1;
    } else if (in) {
        return lexer_unexpected(lx, c->err, in->kind == P_THEN ? "expecting ':'" : "')' expected");
    } else {
        return 2;
    }
    if (r >= 0) lexer_next(lx);
    return r;
}

static int out_of_code(compiler_t *c, int32_t column) {
    return lang_error_set_number(c->err, ERR_FULL, column, "no memory for this expression (bytes)",
                                 (int32_t)emit_room(&c->e));
}

#if CONFIG_LOGSCALE
static void take_logarithm(compiler_t *c, num_t base) {
    emit_byte2(&c->e, OP_REAL1, builtins_find("log10", 5));
    emit_operated(&c->e, 1, true, true);
    if (num_cmp(base, num_from_i64(10)) == 0) return;
    emit_constant(&c->e, value_real(num_double(func_log10(base))));
    emit_binary(&c->e, OP_DIV);
}
#endif

static int compile(compiler_t *c) {
    int state = 0;
    do {
        state = state == 0 ? operand(c) : behind_operand(c);
        if (state < 0) return state;
        if (c->e.len >= emit_room(&c->e)) return out_of_code(c, lexer_column(c->lx));
    } while (state != 2);
    reduce(c, LOOSE);
#if CONFIG_LOGSCALE
    if (c->params && c->params->result_base) take_logarithm(c, *c->params->result_base);
#endif
    emit_byte(&c->e, OP_RET);
    if (emit_is_full(&c->e)) return out_of_code(c, lexer_column(c->lx));
    return 0;
}

static void begin(compiler_t *c, lang_t *l, lexer_t *lx, const expr_params_t *params, uint8_t *buf, size_t size,
                  lang_error_t *err) {
    *c = (compiler_t){.lx = lx, .params = params, .err = err};
    c->e.l = l;
    c->e.buf = buf;
    c->e.size = size < UINT16_MAX ? size : UINT16_MAX;
}

int expr_compile(lang_t *l, lexer_t *lx, const expr_params_t *params, uint8_t *buf, size_t size, expr_t *out,
                 lang_error_t *err) {
    int count = params ? params->count : 0;
    compiler_t c;
    uint16_t mark = l->symbols;
    begin(&c, l, lx, params, buf, size, err);
#if CONFIG_CONTROL
    const lexer_t start = *lx;
#endif
    int r = compile(&c);
#if CONFIG_CONTROL
    if (r == 0 && c.calls && l->iterations > 0) {
        *lx = start;
        begin(&c, l, lx, params, buf, size, err);
        set_iterated(&c.e);
        r = compile(&c);
    }
#endif
    if (r < 0) {
        names_release(l, mark);
        return r;
    }
    uint8_t kept;
    out->code = buf;
    out->len = share_parts(buf, (uint16_t)c.e.len, emit_room(&c.e), (uint8_t)count, &kept);
    out->stack = (uint16_t)(count + kept + c.e.deepest + 1); /* eval.c says what the one more is for */
    out->params = (uint8_t)count;
    out->columns = c.columns;
    return 0;
}
