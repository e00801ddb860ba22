/* compile.c - text to stack code by operator precedence.
 *
 * gnuplot's parser descends recursively, one function for each level of precedence; here one loop keeps what is open
 * on a small stack, so depth costs 4 bytes and not a call. The two places where the grammar is not just a
 * table of precedences come out of the same loop: a prefix operator is never reduced when it arrives (so 2**-1 works
 * and -2**2 is -(2**2)), and a postfix ! acts at once on what stands before it.
 *
 * An operand that is known when the text is compiled is marked as constant; an operator whose operands all
 * are is evaluated by the evaluator itself, and its code replaced by the result. */
#include "lang/arith.h"
#include "lang/builtins.h"
#include "lang/expr.h"
#include "lang/share.h"

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
    uint8_t a : 8;
    uint16_t at;
} pending_t;

/* Operands that can still be folded; deeper ones just are not. */
enum { TRACKED = 16 };

typedef struct compiler {
    lang_t *l;
    lexer_t *lx;
    const expr_params_t *params;
    lang_error_t *err;
    uint8_t *buf;
    size_t size;
    uint32_t len; /* bytes of code, also those that did not fit */
    int pending;  /* entries of stack in use */
    /* Operands on the evaluator's stack; a left side that a jump or comma has dropped keeps its place here until
     * the whole is known, so that the whole starts where the left side did. */
    int depth, deepest;
    bool columns;
    pending_t stack[CONFIG_NESTING];
    struct {
        uint16_t start; /* where its code starts */
        bool constant;
        bool real;      /* cannot be an integer */
    } operand[TRACKED]; /* operand[i] for depth i + 1 */
} compiler_t;

_Static_assert(sizeof(pending_t) == 4, "the header promises 4 bytes for each level of nesting");

/* The buffer may be the free part of the pool, which shrinks as names are made. */
static size_t room(const compiler_t *c) {
    const uint8_t *names = c->l->pool + c->l->names_start;
    bool lent = c->buf >= c->l->pool && c->buf <= names;
    return lent && (size_t)(names - c->buf) < c->size ? (size_t)(names - c->buf) : c->size;
}

static void emit(compiler_t *c, int byte) {
    if (c->len < room(c)) c->buf[c->len] = (uint8_t)byte;
    c->len++;
}

static void emit2(compiler_t *c, int op, int operand) {
    emit(c, op);
    emit(c, operand);
}

static void emit_bytes(compiler_t *c, const void *bytes, size_t n) {
    for (size_t i = 0; i < n; i++) emit(c, ((const uint8_t *)bytes)[i]);
}

static int out_of_code(compiler_t *c, int32_t column) {
    return lang_error_set_number(c->err, ERR_FULL, column, "no memory for this expression (bytes)", (int32_t)room(c));
}

/* Declares that code from start to the end pushes one operand. */
static void pushed(compiler_t *c, uint32_t start, bool constant, bool real) {
    if (c->depth < TRACKED) {
        c->operand[c->depth].start = (uint16_t)start;
        c->operand[c->depth].constant = constant;
        c->operand[c->depth].real = real;
    }
    c->depth++;
    if (c->depth > c->deepest) c->deepest = c->depth;
}

static bool is_constant(const compiler_t *c, int from_top) {
    int i = c->depth - 1 - from_top;
    return i < TRACKED && c->operand[i].constant;
}

static bool is_real(const compiler_t *c, int from_top) {
    int i = c->depth - 1 - from_top;
    return i < TRACKED && c->operand[i].real;
}

static void emit_constant(compiler_t *c, value_t v) {
    if (v.kind == VALUE_INT && v.m >= -128 && v.m < 128) {
        emit2(c, OP_INT8, (int)v.m & 255);
    } else if (v.kind == VALUE_INT) {
        emit(c, OP_INT64);
        emit_bytes(c, &v.m, 8);
    } else if (((uint64_t)v.m & 0xFFFFFFFFFFFF) == 0 && v.e >= -128 && v.e < 128) {
        emit2(c, OP_REAL_SHORT, (int)(v.m >> 48) & 255);
        emit2(c, (int)(v.m >> 56) & 255, v.e & 255);
    } else {
        int16_t e = (int16_t)v.e;
        emit(c, OP_REAL);
        emit_bytes(c, &v.m, 8);
        emit_bytes(c, &e, 2);
    }
}

static void push_constant(compiler_t *c, value_t v) {
    uint32_t start = c->len;
    emit_constant(c, v);
    pushed(c, start, true, v.kind == VALUE_REAL);
}

/* If one of the two topmost operands is an integer constant and the other surely real, makes the constant real now
 * and not at each evaluation. */
static void meet_real(compiler_t *c) {
    int which = is_constant(c, 0) ? 0 : 1;
    if (!is_constant(c, which) || is_real(c, which) || !is_real(c, 1 - which)) return;
    uint8_t fresh[CODE_CONSTANT_MAX];
    if (c->len + sizeof fresh > room(c)) return;
    uint32_t start = c->operand[c->depth - 1 - which].start;
    uint32_t end = which == 0 ? c->len : c->operand[c->depth - 1].start;
    uint32_t behind = c->len - end;
    const uint8_t *code = c->buf + start;
    value_t v = code[0] == OP_INT8 ? value_int(code_int8(code + 1)) : code_int64(code + 1);
    uint32_t scratch = c->len;
    emit_constant(c, value_real(value_num(v)));
    uint32_t len = c->len - scratch;
    memcpy(fresh, c->buf + scratch, len);
    memmove(c->buf + start + len, c->buf + end, behind);
    memcpy(c->buf + start, fresh, len);
    c->len = start + len + behind;
    if (which == 1) c->operand[c->depth - 1].start = (uint16_t)(start + len);
}

/* The operation just emitted takes the topmost n operands and leaves one; known: if they are constant, so is it.
 * real: the result cannot be an integer. */
static void operated(compiler_t *c, int n, bool known, bool real) {
    for (int i = 0; i < n; i++) known = known && is_constant(c, i);
    c->depth -= n;
    uint32_t start = c->depth < TRACKED ? c->operand[c->depth].start : 0;
    if (known && c->len < room(c)) {
        c->buf[c->len] = OP_RET;
        expr_t e = {.code = c->buf + start, .stack = EXPR_PARAMS};
        value_t v;
        if (expr_eval(c->l, &e, NULL, &v) == 0 && v.kind != VALUE_UNDEF) {
            c->len = start;
            push_constant(c, v);
            return;
        }
    }
    pushed(c, start, false, real);
}

/* A power whose exponent is a small constant needs no second operand. */
static bool emit_small_power(compiler_t *c) {
    int i = c->depth - 1;
    if (!is_constant(c, 0) || c->len > room(c)) return false;
    const uint8_t *code = c->buf + c->operand[i].start;
    if (code[0] != OP_INT8) return false;
    int k = code_int8(code + 1);
    c->len = c->operand[i].start;
    if (k == 2)
        emit(c, OP_SQUARE);
    else
        emit2(c, OP_POWI, k & 255);
    c->depth--;
    operated(c, 1, true, is_real(c, 0));
    return true;
}

/* Division by a power of two is multiplication by another, exactly and sooner. */
static bool invert_constant(compiler_t *c) {
    if (!is_constant(c, 0) || c->len > room(c)) return false;
    uint8_t *code = c->buf + c->operand[c->depth - 1].start;
    int e = code_int8(code + 3);
    /* 2^62 * 2^e; the short form holds exponents from -128 on */
    if (code[0] != OP_REAL_SHORT || code_u16(code + 1) != 0x4000 || e > 4) return false;
    code[3] = (uint8_t)(-124 - e);
    return true;
}

/* x*x is x**2: one operand less to fetch. */
static bool emit_square(compiler_t *c) {
    if (c->depth < 2 || c->depth > TRACKED || c->len > room(c)) return false;
    uint16_t left = c->operand[c->depth - 2].start, right = c->operand[c->depth - 1].start;
    size_t len = c->len - right;
    const uint8_t *code = c->buf + left;
    bool name = (len == 1 && code[0] >= OP_ARG && code[0] < OP_VAR) || (len == 2 && code[0] == OP_VAR);
    if (!name || (size_t)(right - left) != len || memcmp(code, c->buf + right, len) != 0) return false;
    c->len = right;
    emit(c, OP_SQUARE);
    c->depth--;
    operated(c, 1, false, is_real(c, 0));
    return true;
}

static void patch(compiler_t *c, uint16_t at) {
    uint32_t distance = c->len - at - CODE_JUMP_LEN;
    if (c->len > room(c)) return;
    c->buf[at + 1] = (uint8_t)distance;
    c->buf[at + 2] = (uint8_t)(distance >> 8);
}

static uint16_t emit_jump(compiler_t *c, int op) {
    uint16_t at = (uint16_t)c->len;
    emit(c, op);
    emit2(c, 0, 0);
    return at;
}

static int precedence(const pending_t *p) {
    static const uint8_t of_binary[] = {
        [OP_ADD - OP_ADD] = 10, [OP_SUB - OP_ADD] = 10,    [OP_MUL - OP_ADD] = 11, [OP_DIV - OP_ADD] = 11,
        [OP_MOD - OP_ADD] = 11, [OP_POW - OP_ADD] = POWER, [OP_SHL - OP_ADD] = 9,  [OP_SHR - OP_ADD] = 9,
        [OP_LT - OP_ADD] = 8,   [OP_LE - OP_ADD] = 8,      [OP_GT - OP_ADD] = 8,   [OP_GE - OP_ADD] = 8,
        [OP_EQ - OP_ADD] = 7,   [OP_NE - OP_ADD] = 7,      [OP_BAND - OP_ADD] = 6, [OP_XOR - OP_ADD] = 5,
        [OP_BOR - OP_ADD] = 4,
    };
    switch (p->kind) {
    case P_BINARY:
        return of_binary[p->a - OP_ADD];
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
    switch (p.kind) {
    case P_BINARY:
        if (p.a == OP_POW && emit_small_power(c)) break;
        if (p.a == OP_MUL && emit_square(c)) break;
        if (p.a <= OP_DIV || (p.a >= OP_LT && p.a <= OP_NE)) meet_real(c);
        if (p.a == OP_DIV && invert_constant(c)) p.a = OP_MUL;
        emit(c, p.a);
        operated(c, 2, true, (p.a <= OP_DIV || p.a == OP_POW) && (is_real(c, 0) || is_real(c, 1)));
        break;
    case P_PREFIX:
        emit(c, p.a);
        operated(c, 1, true, p.a == OP_NEG && is_real(c, 0));
        break;
    case P_LOGIC:
        emit(c, OP_BOOL);
        patch(c, p.at);
        operated(c, 2, false, false);
        break;
    case P_SET:
        emit2(c, OP_SET, p.a);
        operated(c, 1, false, false);
        break;
    default: /* P_ELSE */
        patch(c, p.at);
        operated(c, 2, false, false);
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
        int s = names_find(c->l, SYMBOL_FUNCTION, name, len);
        if (s >= 0 && c->l->symbol[s].defined) b = -1;
    }
    if (b >= 0) {
        if (BUILTINS[b].flags & BUILTIN_COLUMNS) c->columns = true;
        return open_new(c, P_BUILTIN, b, 1);
    }
    int s = names_intern(c->l, SYMBOL_FUNCTION, name, len, column, c->err);
    return s < 0 ? s : open_new(c, P_USER, s, 1);
}

/* Returns 1 when the name was a whole operand, 0 when one is still expected, or an error. */
static int name(compiler_t *c) {
    lexer_t *lx = c->lx;
    const char *text = lexer_text(lx);
    uint32_t len = lx->tok.len;
    int32_t column = lexer_column(lx);
    lexer_next(lx);
    if (lexer_accept(lx, '(')) return call(c, text, len, column);
    /* An assignment may stand wherever an expression starts. */
    bool starts = c->pending == 0 || precedence(&c->stack[c->pending - 1]) <= LOOSE;
    bool assigned = starts && lx->tok.kind == '=';
    int p = assigned ? -1 : parameter(c, text, len);
    uint32_t start = c->len;
    if (p >= 0) {
        emit(c, OP_ARG + p);
        pushed(c, start, false, !c->params->any_kind);
        return 1;
    }
    int s = names_intern(c->l, SYMBOL_VARIABLE, text, len, column, c->err);
    if (s < 0) return s;
    if (assigned) {
        lexer_next(lx);
        return open_new(c, P_SET, s, 0);
    }
    emit2(c, OP_VAR, s);
    pushed(c, start, false, false);
    return 1;
}

/* $3 */
static int dollar(compiler_t *c) {
    lexer_next(c->lx);
    const token_t *t = &c->lx->tok;
    if (t->kind != TOKEN_NUMBER || t->value.kind != VALUE_INT || t->value.m > INT16_MAX)
        return lexer_unexpected(c->lx, c->err, "column number expected");
    push_constant(c, t->value);
    emit(c, OP_FUNC);
    emit2(c, builtins_find("column", 6), 1);
    operated(c, 1, false, false);
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
        push_constant(c, lx->tok.value);
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

static int binary_of(int token) {
    switch (token) {
    case '+':
        return OP_ADD;
    case '-':
        return OP_SUB;
    case '*':
        return OP_MUL;
    case '/':
        return OP_DIV;
    case '%':
        return OP_MOD;
    case TOKEN_POWER:
        return OP_POW;
    case TOKEN_SHL:
        return OP_SHL;
    case TOKEN_SHR:
        return OP_SHR;
    case '<':
        return OP_LT;
    case TOKEN_LE:
        return OP_LE;
    case '>':
        return OP_GT;
    case TOKEN_GE:
        return OP_GE;
    case TOKEN_EQ:
        return OP_EQ;
    case TOKEN_NE:
        return OP_NE;
    case '&':
        return OP_BAND;
    case '^':
        return OP_XOR;
    case '|':
        return OP_BOR;
    default:
        return -1;
    }
}

/* A bracket that closes a call: its operation. */
static int close_call(compiler_t *c, pending_t p) {
    bool builtin = p.kind == P_BUILTIN;
    const builtin_t *b = &BUILTINS[builtin ? p.a : 0];
    if (builtin && (p.at < b->min_args || p.at > b->max_args))
        return lang_error_set_name(c->err, ERR_SYNTAX, lexer_column(c->lx), "wrong number of arguments", b->name,
                                   strlen(b->name));
    if (!builtin) {
        emit(c, OP_CALL);
        emit2(c, p.a, p.at);
    } else if (b->real1) {
        emit2(c, OP_REAL1, p.a);
    } else {
        emit(c, OP_FUNC);
        emit2(c, p.a, p.at);
    }
    operated(c, p.at, builtin && !(b->flags & BUILTIN_IMPURE), builtin && b->real1);
    return 0;
}

/* Takes one token behind an operand. Returns 0 when an operand is expected next, 1 when not, 2 when the token does not
 * belong to the expression, or an error. */
static int behind_operand(compiler_t *c) {
    lexer_t *lx = c->lx;
    int token = lx->tok.kind;
    pending_t *in = innermost(c);
    int op = binary_of(token);
    int r = 0;
    if (op >= 0) {
        pending_t p = {P_BINARY, (uint8_t)op, 0};
        reduce(c, precedence(&p) + (op == OP_POW)); /* ** groups to the right */
        r = open_new(c, P_BINARY, op, 0);
    } else if (token == TOKEN_AND || token == TOKEN_OR) {
        int level = token == TOKEN_AND ? AND : OR;
        reduce(c, level);
        r = open_new(c, P_LOGIC, level, emit_jump(c, level == AND ? OP_AND : OP_OR));
    } else if (token == '?') {
        reduce(c, LOOSE + 1);
        r = open_new(c, P_THEN, 0, emit_jump(c, OP_JZ));
    } else if (token == '!') {
        emit(c, OP_FACT);
        operated(c, 1, true, false);
        r = 1;
    } else if (token == ':' && in && in->kind == P_THEN) {
        reduce(c, LOOSE);
        uint16_t over = emit_jump(c, OP_JUMP);
        patch(c, in->at);
        *in = (pending_t){P_ELSE, 0, over};
        c->depth--;
    } else if (token == ',' && in && in->kind != P_THEN) {
        reduce(c, LOOSE);
        if (in->kind == P_GROUP) {
            if (in->at) operated(c, 2, false, false);
            in->at = 1;
            emit(c, OP_POP);
        } else if (++in->at > EXPR_PARAMS) {
            return lang_error_set_number(c->err, ERR_FULL, lexer_column(lx), "too many arguments", EXPR_PARAMS);
        }
    } else if (token == ')' && in && in->kind != P_THEN) {
        reduce(c, LOOSE);
        pending_t p = c->stack[--c->pending];
        if (p.kind != P_GROUP)
            r = close_call(c, p);
        else if (p.at)
            operated(c, 2, false, false);
        if (r == 0) r = 1;
    } else if (in) {
        return lexer_unexpected(lx, c->err, in->kind == P_THEN ? "expecting ':'" : "')' expected");
    } else {
        return 2;
    }
    if (r >= 0) lexer_next(lx);
    return r;
}

static int compile(compiler_t *c) {
    int state = 0;
    do {
        state = state == 0 ? operand(c) : behind_operand(c);
        if (state < 0) return state;
        if (c->len >= room(c)) return out_of_code(c, lexer_column(c->lx));
    } while (state != 2);
    reduce(c, LOOSE);
    emit(c, OP_RET);
    if (c->len > room(c)) return out_of_code(c, lexer_column(c->lx));
    return 0;
}

int expr_compile(lang_t *l, lexer_t *lx, const expr_params_t *params, uint8_t *buf, size_t size, expr_t *out,
                 lang_error_t *err) {
    int count = params ? params->count : 0;
    compiler_t c = {.l = l, .lx = lx, .params = params, .err = err, .buf = buf};
    c.size = size < UINT16_MAX ? size : UINT16_MAX;
    uint16_t mark = l->symbols;
    int r = compile(&c);
    if (r < 0) {
        names_release(l, mark);
        return r;
    }
    uint8_t kept;
    out->code = buf;
    out->len = share_parts(buf, (uint16_t)c.len, room(&c), (uint8_t)count, &kept);
    out->stack = (uint16_t)(count + kept + c.deepest);
    out->params = (uint8_t)count;
    out->columns = c.columns;
    return 0;
}
