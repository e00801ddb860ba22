/* compile.c - text to stack code by operator precedence.
 *
 * gnuplot's parser descends recursively, one function for each level of precedence; here one loop keeps what is open
 * on a small stack, so depth costs 4 bytes and not a call. The two places where the grammar is not just a
 * table of precedences come out of the same loop: a prefix operator is never reduced when it arrives (so 2**-1 works
 * and -2**2 is -(2**2)), and a postfix ! acts at once on what stands before it. */
#include "lang/compile.h"
#include "lang/builtins.h"
#include "lang/share.h"
#include "num/func.h"
#include "num/num_double.h"

/* In the order of the operations; OP_ADD is the first. */
static const struct {
    int16_t token;
    uint8_t precedence;
} BINARY[] = {
    {'+', SUM},        {'-', SUM},        {'*', 11}, {'/', 11},     {'%', 11}, {TOKEN_POWER, POWER},
    {TOKEN_SHL, 9},    {TOKEN_SHR, 9},    {'<', 8},  {TOKEN_LE, 8}, {'>', 8},  {TOKEN_GE, 8},
    {TOKEN_EQ, EQUAL}, {TOKEN_NE, EQUAL}, {'&', 6},  {'^', 5},      {'|', 4},
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
    case P_TEXT:
        return p->at;
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
#if CONFIG_CONTROL
    case P_TEXT:
        emit_byte3(e, OP_FUNC, p.a, 2);
        emit_operated(e, 2, false, false);
        break;
#endif
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

#if CONFIG_CONTROL
void compile_reduce(compiler_t *c, int limit) {
    reduce(c, limit);
}
#endif

int compile_open(compiler_t *c, int kind, int a, uint16_t at) {
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

#if CONFIG_CONTROL
/* Is it one that a bracket ) closes? */
static bool is_round(const pending_t *in) {
    return in && in->kind != P_THEN && in->kind < P_ELEMENT;
}

/* What would close it. */
static const char *missing(const pending_t *in) {
    if (in->kind == P_THEN) return SAID("expecting ':'");
    if (is_round(in)) return SAID("')' expected");
    return in->kind == P_SLICE && in->at == 0 ? "':' expected: no array is called so" : "']' expected";
}
#else
#define is_round(in) ((in) && (in)->kind != P_THEN)
#define missing(in) ((in)->kind == P_THEN ? "expecting ':'" : "')' expected")
#endif

/* Takes one token behind an operand. Returns 0 when an operand is expected next, 1 when not, 2 when the token does not
 * belong to the expression, or an error. */
static int behind_operand(compiler_t *c) {
    lexer_t *lx = c->lx;
    int token = lx->tok.kind;
    pending_t *in = innermost(c);
    int b = binary_of(token);
    int r = 0;
    if (CONFIG_BOUNDED && token == '<') {
        lexer_t next = *lx;
        lexer_next(&next);
        if (next.tok.kind == '*') return 2; /* of a range: [0<*<3:5] */
    }
#if CONFIG_CONTROL
    r = compile_behind(c, in);
    if (r != COMPILE_NOT_TEXT) return r;
    r = 0;
#endif
    if (b >= 0) {
        reduce(c, BINARY[b].precedence + (token == TOKEN_POWER)); /* ** groups to the right */
        r = compile_open(c, P_BINARY, OP_ADD + b, 0);
    } else if (token == TOKEN_AND || token == TOKEN_OR) {
        int level = token == TOKEN_AND ? AND : OR;
        reduce(c, level);
        r = compile_open(c, P_LOGIC, level, emit_jump(&c->e, level == AND ? OP_AND : OP_OR));
    } else if (token == '?') {
        reduce(c, LOOSE + 1);
        r = compile_open(c, P_THEN, 0, emit_jump(&c->e, OP_JZ));
    } else if (token == '!') {
        emit_unary(&c->e, OP_FACT);
        r = 1;
    } else if (token == ':' && in && in->kind == P_THEN) {
        reduce(c, LOOSE);
        uint16_t over = emit_jump(&c->e, OP_JUMP);
        emit_patch(&c->e, in->at);
        *in = (pending_t){P_ELSE, 0, over};
        c->e.depth--;
    } else if (token == ',' && is_round(in)) {
        reduce(c, LOOSE);
        if (in->kind == P_GROUP) {
            if (in->at) emit_operated(&c->e, 2, false, false);
            in->at = 1;
            emit_byte(&c->e, OP_POP);
        } else if (++in->at > EXPR_PARAMS) {
            return lang_error_set_number(c->err, ERR_FULL, lexer_column(lx), "too many arguments", EXPR_PARAMS);
        }
    } else if (token == ')' && is_round(in)) {
        reduce(c, LOOSE);
        pending_t p = c->stack[--c->pending];
        if (p.kind != P_GROUP)
            r = close_call(c, p);
        else if (p.at)
            emit_operated(&c->e, 2, false, false);
        if (r == 0) r = 1;
    } else if (in) {
        return lexer_unexpected(lx, c->err, missing(in));
    } else {
        return 2;
    }
    if (r >= 0) lexer_next(lx);
    return r;
}

#if CONFIG_CONTROL
/* Functions that are called may look at the variables of `for`: (i = 3, f(x)) in place of f(x). */
static int set_iterated(compiler_t *c) {
    emit_t *e = &c->e;
    for (int i = 0; i < e->l->iterations; i++) {
        const int err = compile_iterated(c, e->l->iterated[i]);
        if (err < 0) return err;
        emit_byte2(e, OP_SET, e->l->iterated[i]);
        emit_byte(e, OP_POP);
        emit_operated(e, 1, false, false);
        e->depth--;
    }
    return 0;
}
#endif

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
        state = state == 0 ? compile_operand(c) : behind_operand(c);
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
        r = set_iterated(&c);
        if (r == 0) r = compile(&c);
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
