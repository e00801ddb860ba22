/* lines.c - see lines.h. */
#include "tests/compare/lines.h"
#include "tests/compare/formula.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

typedef struct draft {
    uint64_t *rng;
    char *text;
    size_t len;
} draft_t;

__attribute__((format(printf, 2, 3))) static void add(draft_t *d, const char *form, ...) {
    va_list list;
    va_start(list, form);
    const int n = vsnprintf(d->text + d->len, LINES_TEXT - d->len, form, list);
    va_end(list);
    d->len += (size_t)n;
    if (d->len > LINES_TEXT - 1) d->len = LINES_TEXT - 1;
}

static int below(draft_t *d, int n) {
    return formula_below(d->rng, n);
}

/* May it give a complex number? */
static bool is_complex(const char *text) {
    static const char *const MAY[] = {"acos", "asin", "log", "sqrt", "gamma", "invnorm", "**", "rand"};
    for (size_t i = 0; i < sizeof MAY / sizeof MAY[0]; i++)
        if (strstr(text, MAY[i])) return true;
    return false;
}

/* A short expression. */
static const char *value(draft_t *d) {
    static char text[4][FORMULA_TEXT];
    static int next;
    char *to = text[next++ % 4];
    formula_t f;
    do {
        if (below(d, 5))
            formula_draw_small(&f, d->rng);
        else
            formula_draw_text(&f, d->rng);
        formula_write(&f, f.root, to);
    } while (is_complex(to) || strlen(to) > 60);
    return to;
}

static const char *pick(draft_t *d, const char *const list[], int n) {
    return list[below(d, n)];
}
#define PICK(list) pick(d, list, (int)(sizeof(list) / sizeof(list)[0]))

static const char *name(draft_t *d) {
    static const char *const NAMES[] = {"a", "b", "c", "w", "i", "var_1", "Ab", "x"};
    return PICK(NAMES);
}

static const char *condition(draft_t *d) {
    static char text[2 * FORMULA_TEXT];
    static const char *const SIGNS[] = {"<", ">", "==", "!=", "<=", ">="};
    const char *left = value(d), *right = value(d);
    snprintf(text, sizeof text, "%s %s %s", left, PICK(SIGNS), right);
    return text;
}

static void simple(draft_t *d) {
    static const char *const EVAL[] = {"eval 'print 1+1'", "eval \"a = 4; print a\"", "evaluate sprintf('b = %d', 3)",
                                       "undefine w",       "undefine Ab x",           "print exists('w')",
                                       "print defined(w)"};
    static const char *const ARRAYS[] = {
        "array A[4]",          "A[2] = a",   "A[1] = 'text'",    "print A[2]",
        "print |A|",           "A[a] = 3",   "print A[1], A[3]", "array A = [1, 2.5, 'three']",
        "array A[2] = [a, b]", "print A[5]", "print A",          "A[3] = A[2]",
        "undefine A"};
    switch (below(d, 9)) {
    case 0:
    case 1:
        add(d, "%s = %s", name(d), value(d));
        break;
    case 2:
        add(d, "p%d(x%s) = x + %s", below(d, 2), below(d, 2) ? ",y" : "", value(d));
        break;
    case 3:
        add(d, "print p%d(%s%s)", below(d, 2), value(d), below(d, 2) ? ",2" : "");
        break;
    case 4:
        add(d, "%s", PICK(EVAL));
        break;
    case 5:
        add(d, "%s", PICK(ARRAYS));
        break;
    case 6:
        add(d, "print %s, ' and ', %s", value(d), value(d));
        break;
    default:
        add(d, "print %s", name(d));
        break;
    }
}

static void set(draft_t *d) {
    static const char *const SET[] = {
        "xrange [%s:%s]",
        "yrange [%s:%s]",
        "zrange [%s:]",
        "xrange [:%s]",
        "xrange [*:%s]",
        "yrange [%s:*]",
        "zrange [*:*]",
        "samples %s",
        "isosamples %s,%s",
        "isosamples %s",
        "view %s,%s",
        "view %s,%s,1,1",
        "view 60",
        "hidden3d",
        "title 'T'",
        "title 'T'.a",
        "view ,%s",
        "urange [%s:%s]",
        "parametric",
        "angles degrees",
        "angles radians",
        "logscale z",
        "xr [-1:1]",
        "iso 12",
        "sam 30",
        "dummy u,v",
        "dummy x,y",
        "ticslevel %s",
        "xyplane at %s",
        "xyplane %s",
        "autoscale",
        "autoscale x",
        "key",
        "border",
        "polar",
        "vrange [0:1]",
        "view map",
        "contour base",
        "xlabel 'x'",
        "grid",
        "logscale x",
        "logscale xy 2",
        "trange [0:10]",
        "tics",
        "style data lines",
        "dgrid3d 10,10",
        "view equal xyz",
        "hidden3d offset 0",
        "cntrparam levels 5",
        "surface",
        "pm3d",
        "palette gray",
        "zlabel 'z' offset 1,0",
        "format x '%%g'",
        "mxtics 2",
        "xtics 1",
        "ztics 0,1,5",
        "label 1 'a' at 1,1",
        "arrow 1 from 0,0 to 1,1",
        "key off",
        "nokey",
        "size 0.5",
        "origin 0,0",
        "nonsense",
    };
    static const char *const UNSET[] = {"xrange",  "hidden3d", "parametric", "polar",   "logscale", "logscale x",
                                        "title",   "key",      "border",     "tics",    "view",     "samples",
                                        "dummy",   "angles",   "zrange",     "grid",    "label",    "nonsense",
                                        "contour", "dgrid3d",  "autoscale",  "surface", "xyplane",  "isosamples"};
    if (below(d, 4) == 0) {
        add(d, "unset %s", PICK(UNSET));
        return;
    }
    const char *form = PICK(SET);
    add(d, "set ");
    for (const char *c = form; *c; c++) {
        if (c[0] == '%' && c[1] == 's')
            add(d, "%s", below(d, 3) ? value(d) : "10"), c++;
        else if (c[0] == '%' && c[1] == '%')
            add(d, "%%"), c++;
        else
            add(d, "%c", *c);
    }
}

static void statement(draft_t *d, int depth);

static void block(draft_t *d, int depth) {
    const bool lines = below(d, 2);
    add(d, lines ? "{\n" : "{ ");
    for (int n = below(d, 4); n >= 0; n--) {
        statement(d, depth - 1);
        add(d, lines ? "\n" : n ? "; " : " ");
    }
    add(d, "}");
}

static void statement(draft_t *d, int depth) {
    static const char *const COUNTS[] = {"1:3", "2:6:2", "3:1:-1", "0:10:4", "2:1", "n:n+2", "1:2", "1:n/5", "1.5:3"};
    static const char *const WORDS[] = {"'one two'", "\"q  r s\"", "t", "''", "s.' '.t", "3"};
    static const char *const ELSE[] = {" else ", "\nelse ", "; else "};
    static int loop;
    switch (depth > 0 ? below(d, 12) : 0) {
    case 7:
        add(d, "if (%s) ", condition(d));
        block(d, depth);
        if (below(d, 2)) add(d, "%s", PICK(ELSE)), block(d, depth);
        break;
    case 8:
        if (depth == 2) add(d, "if (%s) print 'yes'; else print 'no'", condition(d)); /* not in brackets */
        break;
    case 9:
        add(d, "do for [%s=%s] ", name(d), PICK(COUNTS));
        if (below(d, 4) == 0) add(d, "for [%s=%s] ", name(d), PICK(COUNTS));
        block(d, depth);
        break;
    case 10:
        add(d, "do for [%s in %s] ", name(d), PICK(WORDS));
        block(d, depth);
        break;
    case 11:
        add(d, "k%d = 0; while (k%d < %d) { k%d = k%d + 1; %s; ", loop, loop, 1 + below(d, 3), loop, loop,
            below(d, 3)   ? "print 'turn'"
            : below(d, 2) ? "if (b > 1) { break }"
                          : "if (a > 1) { continue }");
        loop = (loop + 1) % 8;
        statement(d, depth - 1);
        add(d, "}");
        break;
    case 6:
        add(d, "%ssplot 1*%s", below(d, 2) ? "" : "set isosamples 5; ", below(d, 2) ? "x*y" : value(d));
        break;
    case 5:
    case 4:
        set(d);
        break;
    default:
        simple(d);
        break;
    }
}

/* A slip: a character left out, doubled, or another one; blanks where there were none. */
static void slip(draft_t *d, size_t from) {
    static const char OTHERS[] = "()[]:;,.'\"=+-*/ 01xa#\\&|<>!?$^~%";
    /* Loops might not end, and most options are not looked at. */
    if (d->len - from < 2 || strstr(d->text + from, "while") || strstr(d->text + from, "set ")) return;
    const size_t at = from + (size_t)below(d, (int)(d->len - from));
    char *c = d->text + at;
    if (*c == '{' || *c == '}') return; /* the rest would be waited for */
    switch (below(d, 4)) {
    case 0:
        memmove(c, c + 1, d->len - at);
        d->len--;
        break;
    case 1:
        memmove(c + 1, c, d->len - at + 1);
        d->len++;
        break;
    case 2:
        *c = OTHERS[below(d, (int)sizeof OTHERS - 1)];
        break;
    default:
        memmove(c + 1, c, d->len - at + 1);
        d->len++;
        *c = ' ';
        break;
    }
}

void lines_draw(uint64_t *rng, char text[LINES_TEXT]) {
    draft_t draft = {.rng = rng, .text = text}, *d = &draft;
    text[0] = 0;
    for (int n = 1 + below(d, 4); n > 0; n--) {
        const size_t from = d->len;
        statement(d, 2);
        if (below(d, 6) == 0) slip(d, from);
        if (below(d, 10) == 0) add(d, " # a remark");
        add(d, below(d, 8) ? "\n" : "; ");
    }
}
