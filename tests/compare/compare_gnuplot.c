/* compare_gnuplot.c - random expressions and small scripts, typed to gnuplot and to ridgeline: do both answer the same?
 *
 *     compare_gnuplot RIDGELINE [SEED [EXPRESSIONS [SCRIPTS]]]
 *
 * Ends with 0, 1 when something differs, 5 when there is no terminal to be had.
 *
 * Numbers agree when both are integers and equal, or both reals, and they differ by 1e-6 of the larger one or 1e-9 at
 * the most; texts when they are equal; and when both refuse. An expression that is answered differently is taken apart:
 * its smallest part that is, is shown. Left out is what the two are meant to differ in (excuse() has the list). */
#define _GNU_SOURCE
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/compare/formula.h"
#include "tests/compare/lines.h"
#include "tests/compare/talk.h"

static talk_t theirs, ours;

enum kind { REFUSED, INTEGER, REAL, OTHER };

typedef struct answer {
    enum kind kind;
    double value;
    char text[512];
} answer_t;

static void finish(void) {
    talk_end(&theirs);
    talk_end(&ours);
}

/* Types it to both, and waits for both. */
static void ask(const char *lines) {
    const bool typed = talk_type(&theirs, lines) && talk_type(&ours, lines);
    if (typed && talk_hear(&theirs) && talk_hear(&ours)) return;
    fprintf(stderr, "compare: it had been typed: %s\n", lines);
    finish();
    exit(1);
}

static bool is_error(const char *line) {
    return (strncmp(line, "         ", 9) == 0 && !strstr(line, " warning: ")) ||
           (strncmp(line, "line ", 5) == 0 && strstr(line, ", column "));
}

/* What was answered, behind the mark. */
static answer_t answer(const talk_t *t) {
    answer_t a = {.kind = OTHER};
    const char *said = strstr(t->text, "<<\n");
    if (!said) return a;
    said += 3;
    for (const char *line = said; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        if (!is_error(line)) {
            if (!a.text[0] && !strstr(line, " warning: "))
                snprintf(a.text, sizeof a.text, "%.*s", (int)strcspn(line, "\n"), line);
            continue;
        }
        a.kind = REFUSED;
        snprintf(a.text, sizeof a.text, "%.*s", (int)strcspn(line, "\n"), line);
        return a;
    }
    char *end;
    a.value = strtod(a.text, &end);
    if (end == a.text || *end) {
        if (strcmp(end, ".0") == 0) a.kind = REAL; /* inf.0 */
        return a;
    }
    a.kind = strpbrk(a.text, ".eN") ? REAL : INTEGER;
    return a;
}

static void evaluate(const char *expression, answer_t *g, answer_t *r) {
    static char lines[FORMULA_TEXT + 64];
    snprintf(lines, sizeof lines, "print '<<'\nprint %s\n", expression);
    ask(lines);
    *g = answer(&theirs);
    *r = answer(&ours);
}

static bool agree(const answer_t *g, const answer_t *r) {
    if (g->kind != r->kind) return false;
    if (g->kind == REFUSED) return true;
    if (g->kind != REAL) return strcmp(g->text, r->text) == 0;
    if (isnan(g->value) || isnan(r->value)) return isnan(g->value) && isnan(r->value);
    const double larger = fmax(fabs(g->value), fabs(r->value));
    return fabs(g->value - r->value) <= fmax(1e-9, 1e-6 * larger);
}

/* Why the two may differ here, or NULL. */
static const char *excuse(const char *expression, const answer_t *g, const answer_t *r) {
    if (strstr(expression, "rand(0)")) return "rand";
    if (strstr(g->text, "generate a file name") || strstr(g->text, "string value with numeric"))
        return "a text that is a number counts as one";
    if (strstr(g->text, "unrecognized token: !")) return "!> is no operator";
    if (g->kind == REAL && fabs(g->value) >= 1e9) return "too large a number to look at its sine";
    if (g->kind == REAL && g->value == 0 && strstr(r->text, "undefined value"))
        return "a complex power that is too small";
    if (g->kind == REAL && g->value == 0 && isnan(r->value)) return "0**NaN";
    if (g->kind == REAL && isnan(g->value) && fabs(r->value) > 4e18) return "int() of what all but overflows";
    if (strcmp(r->text, "nan") == 0) return "sprintf('%d', NaN)";
    if (g->text[0] == '{') return "complex";
    if (g->kind == REAL && isnan(g->value) && strstr(r->text, "undefined value")) return "NaN, not undefined";
    if (strstr(g->text, "inf")) return "infinite";
    if (g->kind == REAL && g->value == 0 && g->text[0] == '-') return "negative zero";
    if (r->kind == REAL && fabs(r->value) > 9e18 && g->kind == INTEGER) return "wrapped";
    if (fabs(g->value) > 0 && fabs(g->value) < 2.3e-308) return "denormal";
    return NULL;
}

typedef struct tally {
    long asked, agreed, refused, excused, wrong;
} tally_t;

/* Takes a formula apart that is answered differently; prints the part to blame. Returns whether it is no fault. */
static bool is_excused(const formula_t *f) {
    static char text[FORMULA_TEXT], worst[FORMULA_TEXT];
    answer_t theirs_worst = {0}, ours_worst = {0};
    worst[0] = 0;
    for (int i = f->nodes - 1; i >= 0; i--) {
        formula_write(f, i, text);
        answer_t g, r;
        evaluate(text, &g, &r);
        if (excuse(text, &g, &r)) return true;
        if (agree(&g, &r) || (worst[0] && strlen(worst) <= strlen(text))) continue;
        memcpy(worst, text, sizeof worst);
        theirs_worst = g;
        ours_worst = r;
    }
    if (!worst[0]) return true; /* rand, or a variable that was set meanwhile */
    printf("print %s\n    gnuplot:   %s\n    ridgeline: %s\n", worst, theirs_worst.text, ours_worst.text);
    return false;
}

static void compare_formulas(tally_t *n, uint64_t *rng, long formulas) {
    static char text[FORMULA_TEXT];
    for (long i = 0; i < formulas; i++) {
        formula_t f;
        if (formula_below(rng, 8))
            formula_draw(&f, rng);
        else
            formula_draw_text(&f, rng);
        formula_write(&f, f.root, text);
        answer_t g, r;
        evaluate(text, &g, &r);
        const bool same = agree(&g, &r);
        n->asked++;
        n->agreed += same && g.kind != REFUSED;
        n->refused += same && g.kind == REFUSED;
        if (same) continue;
        if (excuse(text, &g, &r) || is_excused(&f))
            n->excused++;
        else
            n->wrong++;
        if (n->wrong > 40) return;
    }
}

/* Remarks of either, and the lines that gnuplot repeats when a block fails. */
static bool is_remark(const char *line) {
    static const char *const HINTS[] = {"plot.svg", "done ",          "more> ",       "gnuplot> ",
                                        "\t",       "No output will", "Terminal type"};
    for (size_t i = 0; i < sizeof HINTS / sizeof HINTS[0]; i++)
        if (strncmp(line, HINTS[i], strlen(HINTS[i])) == 0) return true;
    return !line[strspn(line, " ")] || strstr(line, "arning") || strstr(line, "WARNING");
}

/* What was printed, and ERROR in place of messages. Ours repeat the line before the caret. */
static void essence(const char *said, bool repeats, char out[TALK_TEXT]) {
    size_t n = 0, before = 0;
    for (char line[4096]; *said; said += *said == '\n') {
        size_t length = strcspn(said, "\n");
        snprintf(line, sizeof line, "%.*s", (int)length, said);
        const char *behind = strstr(line, "       "); /* a message behind what the same command has printed */
        if (behind && behind > line + strspn(line, " ")) line[length = (size_t)(behind - line)] = 0;
        for (size_t k = strlen(line); k > 0 && line[k - 1] == ' ';) line[--k] = 0;
        said += length;
        const bool caret = line[strspn(line, " ")] == '^' && !line[strspn(line, " ") + 1];
        const bool error = strncmp(line, "      ", 6) == 0 || strstr(line, ", column ");
        if (is_remark(line)) continue;
        if (caret) {
            if (repeats) n = before;
            continue;
        }
        before = n;
        n += (size_t)sprintf(out + n, "%s\n", error ? "ERROR" : line);
    }
    out[n] = 0;
}

/* Do they differ in what they are meant to? */
static bool is_meant(const char *ours_said, const char *theirs_said) {
    static const char *const STRICT[] = {
        "this text is not a number",          /* in a loop's bounds it is 0 to gnuplot, */
        "range is empty",                     /* which makes these wider, */
        "the name of a variable or function", /* does nothing for `undefine` alone, */
        "a text with words expected",         /* has forgotten the variable when the loop is wrong, */
        "the step is 0",
        "[i=first:last] expected",
        "nothing to draw",                  /* takes norm(NaN) for 0, */
        "string without its closing quote", /* ends texts with the line, */
        "continues the line",               /* reads on behind a backslash, */
        "is ignored",                       /* knows what the option may say, */
    };
    for (size_t i = 0; i < sizeof STRICT / sizeof STRICT[0]; i++)
        if (strstr(ours_said, STRICT[i])) return true;
    return strstr(theirs_said, "z_min3d should not") || strstr(theirs_said, "sh: 1:") ||
           strstr(theirs_said, "{else-clause}") ||
           strstr(theirs_said, "invalid character"); /* draws no plane on a logarithmic axis, has a shell */
}

/* Equal, but for the last digits of numbers. */
static bool same_lines(const char *g, const char *r) {
    while (*g && *r) {
        char *g_end, *r_end;
        const double x = strtod(g, &g_end), y = strtod(r, &r_end);
        if (g_end > g && r_end > r && fabs(x - y) <= fmax(1e-9, 1e-6 * fabs(x))) {
            g = g_end;
            r = r_end;
        } else if (*g++ != *r++) {
            return false;
        }
    }
    return *g == *r;
}

static void compare_scripts(tally_t *n, uint64_t *rng, long scripts) {
    static char text[LINES_TEXT + 64], theirs_said[TALK_TEXT], ours_said[TALK_TEXT];
    for (long i = 0; i < scripts; i++) {
        strcpy(text, "e\nreset session\n");
        for (const char *const *line = FORMULA_START; *line; line++) strcat(strcat(text, *line), "\n");
        ask(text);
        lines_draw(rng, text);
        strcat(text, "\n}\n}\n}\n");
        if (getenv("COMPARE_SHOW")) fprintf(stderr, "---\n%s", text);
        ask(text);
        essence(theirs.text, false, theirs_said);
        essence(ours.text, true, ours_said);
        n->asked++;
        if (same_lines(theirs_said, ours_said)) {
            n->agreed++;
            continue;
        }
        if (is_meant(ours.text, theirs.text)) {
            n->excused++;
            continue;
        }
        n->wrong++;
        printf("--- script\n%s--- gnuplot\n%s--- ridgeline\n%s=====\n", text, theirs.text, ours.text);
        if (n->wrong >= 40) return;
    }
}

int main(int argc, char **argv) {
    uint64_t rng = argc > 2 ? strtoull(argv[2], NULL, 0) : 1;
    const long formulas = argc > 3 ? atol(argv[3]) : 2000, scripts = argc > 4 ? atol(argv[4]) : 500;
    char gnuplot[] = "gnuplot", *their_command[] = {gnuplot, NULL}, *our_command[] = {argv[1], NULL};
    if (argc < 2) return 2;
    rng = rng * 0x9e3779b97f4a7c15u | 1;
    if (!talk_start(&theirs, their_command) || !talk_start(&ours, our_command)) return 5;
    for (const char *const *line = FORMULA_START; *line; line++) ask(*line);
    tally_t n = {0};
    compare_formulas(&n, &rng, formulas);
    tally_t m = {0};
    ask("set term dumb; set output '/dev/null'");
    compare_scripts(&m, &rng, scripts);
    finish();
    printf("# %ld scripts: %ld carried out as gnuplot does, %ld left out, %ld differ\n", m.asked, m.agreed, m.excused,
           m.wrong);
    printf("# %ld expressions: %ld answered as gnuplot does, %ld refused by both, %ld left out, %ld differ\n", n.asked,
           n.agreed, n.refused, n.excused, n.wrong);
    return n.wrong + m.wrong > 0;
}
