/* formula.c - see formula.h. */
#include "tests/compare/formula.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

uint64_t formula_dice(uint64_t *rng) { /* Marsaglia's xorshift */
    *rng ^= *rng << 13, *rng ^= *rng >> 7, *rng ^= *rng << 17;
    return *rng;
}

int formula_below(uint64_t *rng, int n) {
    return (int)((formula_dice(rng) >> 11) % (uint64_t)n);
}

const char *const FORMULA_START[] = {
    "a = 3",
    "b = 2.5",
    "c = -7",
    "d = 1e-3",
    "n = 12",
    "s = 'abc'",
    "t = \"x 12 y\"",
    "f(x) = x*x - 1",
    "g(x,y) = x > y ? x - y : y/2.0",
    "h(n) = n > 0 ? n + h(n-1) : 0",
    "k(a,b,c) = a*100 + b*10 + c",
    "q(x,y,z,w) = (x + y)*(z - w)",
    "l(a,b,c,d,e,f,g,h) = a - b + c*d - e + f - g*h",
    "u(x) = (v = x + 1, v*2)",
    "m(w,k) = w[1:k] . '!'",
    NULL,
};

enum { ATOM = 20, POSTFIX = 13, POWER = 12, PREFIX = 11, TERNARY = 0 };

typedef struct form {
    const char *text;
    int8_t children, level, right;
} form_t;

static const form_t NUMBERS[] = {
    {"0", 0, ATOM, 0},      {"1", 0, ATOM, 0},         {"2", 0, ATOM, 0},   {"3", 0, ATOM, 0},   {"5", 0, ATOM, 0},
    {"7", 0, ATOM, 0},      {"10", 0, ATOM, 0},        {"17", 0, ATOM, 0},  {"100", 0, ATOM, 0}, {"0x1f", 0, ATOM, 0},
    {"017", 0, ATOM, 0},    {"0.5", 0, ATOM, 0},       {"1.5", 0, ATOM, 0}, {".25", 0, ATOM, 0}, {"2.", 0, ATOM, 0},
    {"3.7", 0, ATOM, 0},    {"1e-3", 0, ATOM, 0},      {"1E2", 0, ATOM, 0}, {"0.0", 0, ATOM, 0}, {"1.0", 0, ATOM, 0},
    {"2.5e+1", 0, ATOM, 0}, {"1234.5678", 0, ATOM, 0}, {"pi", 0, ATOM, 0},  {"a", 0, ATOM, 0},   {"b", 0, ATOM, 0},
    {"c", 0, ATOM, 0},      {"d", 0, ATOM, 0},         {"n", 0, ATOM, 0},   {"0.1", 0, ATOM, 0}, {"4.35", 0, ATOM, 0},
};
/* Rarer, since little comes of them. */
static const form_t EDGES[] = {
    {"9223372036854775807", 0, ATOM, 0},
    {"2147483647", 0, ATOM, 0},
    {"2147483648", 0, ATOM, 0},
    {"4294967296", 0, ATOM, 0},
    {"1e10", 0, ATOM, 0},
    {"1e-10", 0, ATOM, 0},
    {"1e15", 0, ATOM, 0},
    {"1e300", 0, ATOM, 0},
    {"1e-300", 0, ATOM, 0},
    {"9007199254740993", 0, ATOM, 0},
    {"NaN", 0, ATOM, 0},
    {"1e22", 0, ATOM, 0},
    {"\"3\"", 0, ATOM, 0},
    {"'2.5'", 0, ATOM, 0},
    {"nobody", 0, ATOM, 0},
    {"710", 0, ATOM, 0},
    {"0.9999999999", 0, ATOM, 0},
    {"170", 0, ATOM, 0},
};
static const form_t OPERATORS[] = {
    {"(%s%%19)!", 1, POSTFIX, 0}, {"%s**%s", 2, POWER, 1}, {"%s**-%s", 2, POWER, 1}, {"%s**(%s%%40)", 2, POWER, 0},
    {"-%s", 1, PREFIX, 1},        {"-%s", 1, PREFIX, 1},   {"!%s", 1, PREFIX, 1},    {"~%s", 1, PREFIX, 1},
    {"+%s", 1, PREFIX, 1},        {"%s*%s", 2, 10, 0},     {"%s * %s", 2, 10, 0},    {"%s/%s", 2, 10, 0},
    {"%s / %s", 2, 10, 0},        {"%s%%%s", 2, 10, 0},    {"%s+%s", 2, 9, 0},       {"%s + %s", 2, 9, 0},
    {"%s-%s", 2, 9, 0},           {"%s - %s", 2, 9, 0},    {"%s<<%s", 2, 8, 0},      {"%s >> %s", 2, 8, 0},
    {"%s < %s", 2, 7, 0},         {"%s<=%s", 2, 7, 0},     {"%s > %s", 2, 7, 0},     {"%s>=%s", 2, 7, 0},
    {"%s==%s", 2, 6, 0},          {"%s != %s", 2, 6, 0},   {"%s&%s", 2, 5, 0},       {"%s^%s", 2, 4, 0},
    {"%s | %s", 2, 3, 0},         {"%s && %s", 2, 2, 0},   {"%s||%s", 2, 1, 0},      {"%s ? %s : %s", 3, 0, 1},
    {"%s?%s:%s", 3, 0, 1},        {"(%s,%s)", 2, ATOM, 0}, {"(z = %s)", 1, ATOM, 0},
};
static const form_t FUNCTIONS[] = {
    {"abs(%s)", 1, ATOM, 0},        {"acos(%s)", 1, ATOM, 0},
    {"asin(%s)", 1, ATOM, 0},       {"atan(%s)", 1, ATOM, 0},
    {"atan2(%s,%s)", 2, ATOM, 0},   {"ceil(%s)", 1, ATOM, 0},
    {"cos(%s)", 1, ATOM, 0},        {"cosh(%s)", 1, ATOM, 0},
    {"erf(%s)", 1, ATOM, 0},        {"exp(%s)", 1, ATOM, 0},
    {"floor(%s)", 1, ATOM, 0},      {"gamma(%s)", 1, ATOM, 0},
    {"int(%s)", 1, ATOM, 0},        {"log(%s)", 1, ATOM, 0},
    {"log10(%s)", 1, ATOM, 0},      {"norm(%s)", 1, ATOM, 0},
    {"real(%s)", 1, ATOM, 0},       {"sgn(%s)", 1, ATOM, 0},
    {"sin(%s)", 1, ATOM, 0},        {"sinh(%s)", 1, ATOM, 0},
    {"sqrt(%s)", 1, ATOM, 0},       {"tan(%s)", 1, ATOM, 0},
    {"tanh(%s)", 1, ATOM, 0},       {"besj0(%s)", 1, ATOM, 0},
    {"besj1(%s)", 1, ATOM, 0},      {"invnorm(%s)", 1, ATOM, 0},
    {"f(%s)", 1, ATOM, 0},          {"g(%s,%s)", 2, ATOM, 0},
    {"h(%s)", 1, ATOM, 0},          {"k(%s,%s,%s)", 3, ATOM, 0},
    {"q(%s,%s,%s,%s)", 4, ATOM, 0}, {"l(%s,%s,%s,%s,%s,%s,%s,%s)", 8, ATOM, 0},
    {"u(%s)", 1, ATOM, 0},          {"(rand(0) < %s)", 1, ATOM, 0},
};
/* From numbers and texts to numbers (the first of each line's %s are texts), and to texts. */
static const form_t OF_TEXTS[] = {
    {"strlen(%s)", 1, ATOM, 0}, {"words(%s)", 1, ATOM, 0},  {"strstrt(%s,%s)", 2, ATOM, 0},
    {"(%s eq %s)", 2, ATOM, 0}, {"(%s ne %s)", 2, ATOM, 0},
};
static const form_t TEXTS[] = {
    {"s", 0, ATOM, 0},
    {"t", 0, ATOM, 0},
    {"''", 0, ATOM, 0},
    {"'it''s'", 0, ATOM, 0},
    {"\"a\\tb\\\"\"", 0, ATOM, 0},
    {"'one two  three'", 0, ATOM, 0},
    {"\"7\"", 0, ATOM, 0},
};
static const form_t TO_TEXTS[] = {
    {"(%s . %s)", 2, ATOM, 0},           {"(%s)[2:3]", 1, ATOM, 0},
    {"substr(%s,2,3)", 1, ATOM, 0},      {"word(%s,2)", 1, ATOM, 0},
    {"sprintf('%%s-', %s)", 1, ATOM, 0}, {"m(%s,2)", 1, ATOM, 0},
    {"(1 ? %s : %s)", 2, ATOM, 0},       {"(s . %s)", 1, ATOM, 0},
    {"word(%s,1)", 1, ATOM, 0},          {"(0 ? %s : %s)", 2, ATOM, 0},
};
static const form_t SLICES[] = {
    {"%s[2:3]", 1, ATOM, 0}, {"%s[2:*]", 1, ATOM, 0}, {"%s[:2]", 1, ATOM, 0}, {"%s[*:1]", 1, ATOM, 0},
    {"%s[3:2]", 1, ATOM, 0}, {"%s[0:9]", 1, ATOM, 0}, {"%s[:]", 1, ATOM, 0},
};
static const form_t FROM_NUMBERS[] = {
    {"sprintf('%%d', %s)", 1, ATOM, 0},    {"sprintf('%%5.2f|%%g', %s, %s)", 2, ATOM, 0},
    {"('v' . int(%s)%%1000)", 1, ATOM, 0}, {"sprintf('%%03d %%x', %s, %s)", 2, ATOM, 0},
    {"sprintf('%%e', %s)", 1, ATOM, 0},
};

#define PICK(table) (&(table)[formula_below(rng, (int)(sizeof(table) / sizeof(table)[0]))])

static int add(formula_t *f, const form_t *form) {
    f->node[f->nodes] =
        (formula_node_t){.form = form->text, .children = form->children, .level = form->level, .right = form->right};
    return f->nodes++;
}

static int number(formula_t *f, uint64_t *rng, int depth);

static int text(formula_t *f, uint64_t *rng, int depth) {
    const bool room = f->nodes < FORMULA_NODES / 3 && depth > 0;
    const int kind = room ? formula_below(rng, 8) : 0;
    const form_t *form = kind < 3   ? PICK(TEXTS)
                         : kind < 5 ? PICK(TO_TEXTS)
                         : kind < 7 ? PICK(SLICES)
                                    : PICK(FROM_NUMBERS);
    const int at = add(f, form);
    for (int i = 0; i < form->children; i++) {
        const int child = kind == 7 ? number(f, rng, depth - 1) : text(f, rng, depth - 1);
        f->node[at].child[i] = (int16_t)child;
    }
    return at;
}

/* gnuplot multiplies as often as an integer exponent says. */
static bool is_power(const form_t *form) {
    return form->level == POWER && form->right;
}

static int number(formula_t *f, uint64_t *rng, int depth) {
    const bool room = f->nodes < FORMULA_NODES / 3 && depth > 0;
    const int kind = room ? formula_below(rng, 40) : 0;
    const form_t *form = kind < 8    ? (formula_below(rng, 12) ? PICK(NUMBERS) : PICK(EDGES))
                         : kind < 26 ? PICK(OPERATORS)
                         : kind < 39 ? PICK(FUNCTIONS)
                                     : PICK(OF_TEXTS);
    const int at = add(f, form);
    for (int i = 0; i < form->children; i++) {
        const int child = kind == 39                 ? text(f, rng, depth - 1)
                          : i == 1 && is_power(form) ? add(f, PICK(NUMBERS))
                                                     : number(f, rng, depth - 1);
        f->node[at].child[i] = (int16_t)child;
    }
    return at;
}

void formula_draw(formula_t *f, uint64_t *rng) {
    f->nodes = 0;
    f->root = number(f, rng, 1 + formula_below(rng, 5));
}

void formula_draw_small(formula_t *f, uint64_t *rng) {
    f->nodes = 0;
    f->root = number(f, rng, formula_below(rng, 3));
}

void formula_draw_text(formula_t *f, uint64_t *rng) {
    f->nodes = 0;
    f->root = text(f, rng, 1 + formula_below(rng, 4));
}

/* Does operand number i of p stand in brackets? Prefixes may follow any operator, but a sign would melt with one. */
static bool bracketed(const formula_node_t *p, const formula_node_t *c, int i) {
    if (p->level == ATOM || c->level == ATOM) return false;
    if (c->level == PREFIX && (p->level == POWER ? i == 1 : p->level <= PREFIX)) return false;
    if (c->level != p->level) return c->level < p->level;
    if (p->level == TERNARY) return i == 0;
    return p->right ? i == 0 && p->children > 1 : i > 0;
}

static char *write_node(const formula_t *f, int node, char *to, const char *end) {
    const formula_node_t *p = &f->node[node];
    int next = 0;
    for (const char *c = p->form; *c && to + 2 < end; c++) {
        if (c[0] == '%' && c[1] == '%') {
            *to++ = *c++;
        } else if (c[0] == '%' && c[1] == 's') {
            const formula_node_t *child = &f->node[p->child[next]];
            const bool brackets = bracketed(p, child, next);
            if (brackets) *to++ = '(';
            to = write_node(f, p->child[next++], to, end);
            if (brackets) *to++ = ')';
            c++;
        } else {
            *to++ = *c;
        }
    }
    return to;
}

void formula_write(const formula_t *f, int node, char text[FORMULA_TEXT]) {
    *write_node(f, node, text, text + FORMULA_TEXT - 1) = 0;
}
