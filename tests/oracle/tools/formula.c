/* A recursive-descent evaluator that computes while it parses: short enough to be trusted, slow enough to be a tool. */
#include "tests/oracle/tools/formula.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct parse {
    const char *at;
    double x, y;
    const char *bad;
} parse_t;

static double choice(parse_t *p);

static void blanks(parse_t *p) {
    while (isspace((unsigned char)*p->at)) p->at++;
}
static int eat(parse_t *p, const char *word) {
    blanks(p);
    size_t n = strlen(word);
    if (strncmp(p->at, word, n)) return 0;
    p->at += n;
    return 1;
}
static double fail(parse_t *p) {
    if (!p->bad) p->bad = p->at;
    return NAN;
}

static double sgn(double v) {
    return (v > 0) - (v < 0);
}

static double call(parse_t *p, const char *name, size_t n) {
    static const struct {
        const char *name;
        double (*fn)(double);
    } table[] = {{"abs", fabs},  {"acos", acos},   {"asin", asin}, {"atan", atan},   {"ceil", ceil},    {"cos", cos},
                 {"cosh", cosh}, {"erf", erf},     {"exp", exp},   {"floor", floor}, {"gamma", tgamma}, {"int", trunc},
                 {"log", log},   {"log10", log10}, {"sgn", sgn},   {"sin", sin},     {"sinh", sinh},    {"sqrt", sqrt},
                 {"tan", tan},   {"tanh", tanh},   {"besj0", j0},  {"besj1", j1}};
    double a = choice(p), b = 0;
    int two = eat(p, ",");
    if (two) b = choice(p);
    if (!eat(p, ")")) return fail(p);
    if (two && n == 5 && !strncmp(name, "atan2", n)) return atan2(a, b);
    if (two && n == 3 && !strncmp(name, "min", n)) return fmin(a, b);
    if (two && n == 3 && !strncmp(name, "max", n)) return fmax(a, b);
    for (size_t i = 0; i < sizeof table / sizeof *table && !two; i++)
        if (strlen(table[i].name) == n && !strncmp(name, table[i].name, n)) return table[i].fn(a);
    return fail(p);
}

static double primary(parse_t *p) {
    blanks(p);
    if (eat(p, "(")) {
        double v = choice(p);
        return eat(p, ")") ? v : fail(p);
    }
    if (isdigit((unsigned char)*p->at) || *p->at == '.') {
        char *end;
        double v = strtod(p->at, &end);
        p->at = end;
        return v;
    }
    const char *name = p->at;
    while (isalnum((unsigned char)*p->at) || *p->at == '_') p->at++;
    size_t n = (size_t)(p->at - name);
    if (n && eat(p, "(")) return call(p, name, n);
    if (n == 1 && *name == 'x') return p->x;
    if (n == 1 && *name == 'y') return p->y;
    if (n == 2 && !strncmp(name, "pi", 2)) return 3.14159265358979323846;
    return fail(p);
}

static double unary(parse_t *p);

static double power(parse_t *p) {
    double base = primary(p);
    return eat(p, "**") ? pow(base, unary(p)) : base;
}

static double unary(parse_t *p) {
    if (eat(p, "-")) return -unary(p);
    if (eat(p, "+")) return unary(p);
    return power(p);
}

static double product(parse_t *p) {
    double v = unary(p);
    for (;;) {
        if (eat(p, "*"))
            v *= unary(p);
        else if (eat(p, "/"))
            v /= unary(p);
        else if (eat(p, "%"))
            v = fmod(v, unary(p));
        else
            return v;
    }
}

static double sum(parse_t *p) {
    double v = product(p);
    for (;;) {
        if (eat(p, "+"))
            v += product(p);
        else if (eat(p, "-"))
            v -= product(p);
        else
            return v;
    }
}

static double comparison(parse_t *p) {
    double v = sum(p);
    if (eat(p, "<=")) return v <= sum(p);
    if (eat(p, ">=")) return v >= sum(p);
    if (eat(p, "<")) return v < sum(p);
    if (eat(p, ">")) return v > sum(p);
    return v;
}

static double choice(parse_t *p) {
    double c = comparison(p);
    if (!eat(p, "?")) return c;
    double a = choice(p);
    if (!eat(p, ":")) return fail(p);
    double b = choice(p);
    return isnan(c) ? NAN : c > 0 || c < 0 ? a : b;
}

double formula(const char *text, double x, double y, const char **bad) {
    parse_t p = {.at = text, .x = x, .y = y};
    double v = choice(&p);
    blanks(&p);
    if (*p.at && !p.bad) p.bad = p.at;
    *bad = p.bad;
    return p.bad ? NAN : v;
}
