/* report_formats - what the number format of expressions is worth, by heights and by drawings.
 *
 *     report_formats DIR      writes DIR/formats.tsv, formats-times.tsv, and the section on stdout
 *
 * A small evaluator of its own computes each expression in long double and rounds every intermediate result to the
 * format in question: so each format is at its best, with correctly rounded functions. What is shipped goes through the
 * language itself. Then the surface is drawn from those heights, and judged against the exact one. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lang/expr.h"
#include "tests/emu/bare/formats.h"
#include "tests/report/create.h"
#include "tests/report/subject.h"

#define N 24
#define HIGH_STEPS 8000 /* the range of heights drawn 100 mm high */

enum { FORMAT_SHIPPED = FORMAT_NUM, FORMAT_EXACT = FORMATS };
static const char *const format_name[] = {"Q16.16", "Q32.32", "float", "double", "shipped (num_t)"};

/* code: in postfix order; x y and the constants a b of k[]; n negates, e s c q are exp sin cos sqrt. */
typedef struct formula {
    const char *text, *code;
    long double k[2], lo, hi;
} formula_t;

static const formula_t list[] = {
    {"exp(-x**2-y**2)", "xx*nyy*-e", {0}, -2, 2},
    {"sin(sqrt(x**2+y**2))/sqrt(x**2+y**2)", "xx*yy*+qsxx*yy*+q/", {0}, -8, 8},
    {"x**2-y**2", "xx*yy*-", {0}, -2, 2},
    {"x**4*y**4", "xx*xx**yy*yy***", {0}, -1000, 1000},
    {"1/(x**2+y**2)", "axx*yy*+/", {1}, -2, 2},
    {"1+1e-9*sin(3*x)*cos(3*y)", "abxx+x+s*yy+y+c*1*+", {1, 1e-9L}, -2, 2},
    {"1e12*sin(2*x)*cos(y)", "axx+s*yc*", {1e12L}, -2, 2},
    {"sin(1e9*x)*cos(1e9*y)", "ax*say*c*", {1e9L}, 0, 4e-9L},
};
#define EXPRESSIONS ((int)(sizeof list / sizeof *list))

static long double rounded(int f, long double v) {
    switch (f) {
    case FORMAT_Q16:
        v = roundl(v * 0x1p16L) * 0x1p-16L;
        return fabsl(v) < 0x1p15L ? v : NAN;
    case FORMAT_Q32:
        v = roundl(v * 0x1p32L) * 0x1p-32L;
        return fabsl(v) < 0x1p31L ? v : NAN;
    case FORMAT_FLOAT:
        return (float)v;
    case FORMAT_DOUBLE:
        return (double)v;
    case FORMAT_SHIPPED:
    case FORMAT_EXACT:
        break;
    }
    return v;
}

static long double evaluate(const formula_t *f, int format, long double x, long double y) {
    long double s[16], r = 0;
    int top = 0;
    for (const char *c = f->code; *c; c++) {
        long double b = top > 0 ? s[top - 1] : 0, a = top > 1 ? s[top - 2] : 0;
        const bool two = strchr("+-*/", *c) != NULL, one = strchr("nescq", *c) != NULL;
        switch (*c) {
        case 'x':
            r = x;
            break;
        case 'y':
            r = y;
            break;
        case 'a':
        case 'b':
            r = f->k[*c - 'a'];
            break;
        case '1':
            r = 1;
            break;
        case 'n':
            r = -b;
            break;
        case 'e':
            r = expl(b);
            break;
        case 's':
            r = sinl(b);
            break;
        case 'c':
            r = cosl(b);
            break;
        case 'q':
            r = sqrtl(b);
            break;
        case '+':
            r = a + b;
            break;
        case '-':
            r = a - b;
            break;
        case '*':
            r = a * b;
            break;
        default:
            r = b == 0 ? NAN : a / b;
            break;
        }
        top += two ? -2 : one ? -1 : 0;
        s[top++] = rounded(format, r);
    }
    return s[0];
}

static lang_t lang;
static uint8_t code[256];

static bool compile(const char *text, expr_t *e) {
    lexer_t lx;
    lang_error_t err;
    expr_params_t p = {.count = 2, .name = {{"x", 1}, {"y", 1}}};
    names_reset(&lang);
    lexer_start(&lx, text, strlen(text));
    return expr_compile(&lang, &lx, &p, code, sizeof code, e, &err) == 0;
}

static long double shipped(const expr_t *e, long double x, long double y) {
    num_t arg[2] = {run_num((double)x), run_num((double)y)};
    value_t v;
    if (expr_eval(&lang, e, arg, &v) || v.kind == VALUE_UNDEF) return NAN;
    return v.kind == VALUE_INT ? (long double)v.m : ldexpl((long double)v.m, v.e);
}

typedef struct outcome {
    double height_steps; /* largest error */
    int lost;            /* points undefined that are not */
    judge_report_t drawn;
    bool judged;
} outcome_t;

/* The height in the picture: every range is drawn a quarter as high as the surface is wide. */
static double shown(const formula_t *f, const long double range[2], long double z) {
    return (double)((z - range[0]) / (range[1] - range[0]) * (f->hi - f->lo) / 4);
}

static outcome_t try_format(const formula_t *f, int format, scene_t *exact, const long double range[2]) {
    outcome_t o = {0};
    scene_t s;
    expr_t e;
    surface_ref_t *r = &exact->ref;
    bool any = false;
    if (!compile(f->text, &e)) abort();
    scene_copy(exact, &s);
    s.ref.hole = calloc(N * N, 1);
    if (!s.ref.hole) abort();
    for (int i = 0; i < N * N; i++) {
        long double x = rounded(format, r->x[i % N]), y = rounded(format, r->y[i / N]);
        long double z = format == FORMAT_SHIPPED ? shipped(&e, x, y) : evaluate(f, format, x, y);
        s.ref.hole[i] = (unsigned char)(isfinite(z) ? 0 : 1);
        o.lost += s.ref.hole[i];
        any |= s.ref.hole[i] == 0;
        s.ref.z[i] = s.ref.hole[i] ? 0 : shown(f, range, z);
        long double off = z - evaluate(f, FORMAT_EXACT, r->x[i % N], r->y[i / N]);
        if (isfinite(z))
            o.height_steps = fmax(o.height_steps, (double)(fabsl(off) / (range[1] - range[0])) * HIGH_STEPS);
    }
    if (o.lost == 0) {
        free(s.ref.hole);
        s.ref.hole = NULL;
    }
    run_drawing_t d = {0};
    hidden_stats_t stats;
    if (any && run_perimeter(&s, &d, &stats) == 0) {
        judge_subject_t what = judge_surface(r);
        o.judged = judge_pieces(&what, &exact->view, d.piece, d.n, &o.drawn) == 0;
    }
    run_drawing_free(&d);
    scene_free(&s);
    return o;
}

static void make_exact(const formula_t *f, scene_t *s, long double range[2]) {
    double mid = (double)(f->lo + f->hi) / 2, half = (double)(f->hi - f->lo) / 2;
    scene_init(s, N, N);
    surface_ref_t *r = &s->ref;
    range[0] = INFINITY, range[1] = -INFINITY;
    for (int i = 0; i < N; i++) r->x[i] = r->y[i] = (double)(f->lo + (f->hi - f->lo) * i / (N - 1));
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < N * N; i++) {
            long double z = evaluate(f, FORMAT_EXACT, r->x[i % N], r->y[i / N]);
            if (pass) r->z[i] = shown(f, range, z);
            range[0] = fminl(range[0], z), range[1] = fmaxl(range[1], z);
        }
    r->eye = (exact_eye_t){mid + 3 * half, mid + 4 * half, 1.5 * half, 1};
    scene_aim(s);
    snprintf(s->what, sizeof s->what, "%s", f->text);
}

/* ns of CPU time for one evaluation of exp(-x*x-y*y): written out (tests/emu/bare/formats.c, as on the boards), and
 * interpreted. */
static double time_written(enum formats_format format) {
    double best = 1e9;
    for (int run = 0; run < 100; run++) {
        int points = 0;
        double start = subject_clock();
        for (int k = 0; k < 20; k++) points += formats_run(format, FORMULA_HILL);
        best = fmin(best, (subject_clock() - start) * 1e9 / points);
    }
    return best;
}

static double time_interpreted(void) {
    expr_t e;
    double best = 1e9;
    static volatile int64_t sink;
    if (!compile("exp(-x*x-y*y)", &e)) abort();
    for (int run = 0; run < 20; run++) {
        double start = subject_clock();
        for (int i = 0; i < 10000; i++) {
            num_t arg[2] = {num_from_fixed(i, 13), num_from_fixed(2 * i - 8192, 13)};
            value_t v;
            expr_eval(&lang, &e, arg, &v);
            sink = sink + v.m;
        }
        best = fmin(best, (subject_clock() - start) * 1e9 / 10000);
    }
    return best;
}

/* Returns the time that is shipped. */
static double all_times(const char *dir, double t[FORMATS]) {
    FILE *out = report_create(dir, "formats-times.tsv");
    fputs("format\tns_per_exp(-x*x-y*y)\n", out);
    for (int k = 0; k < FORMATS; k++) {
        t[k] = time_written((enum formats_format)k);
        fprintf(out, "%s\t%.1f\n", formats_name[k], t[k]);
    }
    const double shipped_ns = time_interpreted();
    fprintf(out, "shipped, interpreted\t%.1f\n", shipped_ns);
    fclose(out);
    return shipped_ns;
}

int main(int argc, char **argv) {
    char path[512];
    if (argc < 2) return 2;
    snprintf(path, sizeof path, "%s/formats.tsv", argv[1]);
    FILE *out = fopen(path, "w");
    if (!out) return 1;
    fputs("expression\tfrom\tto\tformat\theight_error_steps\tpoints_lost\tmissing_steps\tfalse_steps\n", out);
    printf(
        "\n## Formats of expressions\n\nHeights of %d x %d points and the drawing made from them, against the exact "
        "ones; an intermediate result that does not fit its format is undefined. Steps are those of a drawing 100 mm "
        "high, that is range / %d.\n\n| expression | range of x, y | format | largest height error (steps) | points "
        "lost | missing (steps) | false |\n|---|---|---|--:|--:|--:|--:|\n",
        N, N, HIGH_STEPS);
    double worst[FORMAT_EXACT] = {0};
    int lost[FORMAT_EXACT] = {0};
    for (int i = 0; i < EXPRESSIONS; i++) {
        const formula_t *f = &list[i];
        scene_t exact;
        long double range[2];
        make_exact(f, &exact, range);
        for (int k = 0; k < FORMAT_EXACT; k++) {
            outcome_t o = try_format(f, k, &exact, range);
            char runs[64] = "no drawing | |";
            if (o.judged)
                snprintf(runs, sizeof runs, "%.2f | %.2f |", o.drawn.missing_mm / JUDGE_STEP_MM,
                         o.drawn.false_mm / JUDGE_STEP_MM);
            printf("| `%s` | %Lg .. %Lg | %s | %.3g | %d | %s\n", f->text, f->lo, f->hi, format_name[k], o.height_steps,
                   o.lost, runs);
            fprintf(out, "%s\t%Lg\t%Lg\t%s\t%.6g\t%d\t%.3f\t%.3f\n", f->text, f->lo, f->hi, format_name[k],
                    o.height_steps, o.lost, o.judged ? o.drawn.missing_mm / JUDGE_STEP_MM : NAN,
                    o.judged ? o.drawn.false_mm / JUDGE_STEP_MM : NAN);
            worst[k] = fmax(worst[k], o.height_steps);
            lost[k] += o.lost;
        }
        scene_free(&exact);
    }
    fclose(out);
    double t[FORMATS];
    const double interpreted = all_times(argv[1], t);
    printf(
        "\n**Shipped: num_t**, scaled integers rounded to a double's 53 bits. Its largest height error in this list is "
        "%.2g steps with %d points lost; Q16.16 has %.2g and loses %d, Q32.32 %.2g and %d, float %.2g and %d. ",
        worst[FORMAT_SHIPPED], lost[FORMAT_SHIPPED], worst[FORMAT_Q16], lost[FORMAT_Q16], worst[FORMAT_Q32],
        lost[FORMAT_Q32], worst[FORMAT_FLOAT], lost[FORMAT_FLOAT]);
    printf(
        "The fixed formats fail by range, not by precision: they are good where heights are near 1 and useless a few "
        "powers of ten away, and a plotter of functions cannot choose its functions. A float fails on small "
        "differences.\n\nOn this machine `exp(-x*x-y*y)` takes %.1f ns in Q16.16, %.1f in Q32.32, %.1f in float, %.1f "
        "in "
        "double and %.1f in num_t, each written out in C; %.0f interpreted, as shipped. What the boards need is "
        "above.\n",
        t[FORMAT_Q16], t[FORMAT_Q32], t[FORMAT_FLOAT], t[FORMAT_DOUBLE], t[FORMAT_NUM], interpreted);
    return 0;
}
