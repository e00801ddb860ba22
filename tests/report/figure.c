/* One pass for the ranges, one for the marks. Text stays text, so a browser can search it. */
#include "tests/report/figure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define WIDTH 760.
#define HEIGHT 460.
#define LEFT 76.
#define TOP 40.
#define PLOT_WIDTH 500.
#define PLOT_HEIGHT 360.

static const char *const colour[] = {"#1b6ca8", "#c8442b", "#2f8f4e", "#8a4fa3", "#c98a12",
                                     "#4c4c4c", "#12a0a0", "#b0306a", "#6b7d1e"};
#define COLOURS ((int)(sizeof colour / sizeof *colour))

typedef struct axis {
    double lo, hi;
    bool log;
} axis_t;

void figure_init(figure_t *f, const char *title, const char *x_title, const char *y_title) {
    *f = (figure_t){.title = title, .x_title = x_title, .y_title = y_title};
}

int figure_series(figure_t *f, const char *name) {
    if (f->series == FIGURE_SERIES) abort();
    f->name[f->series] = name;
    return f->series++;
}

void figure_line(figure_t *f, int series, double a, double b, double to) {
    const int s = figure_series(f, NULL);
    f->line_of[s] = series + 1;
    figure_add(f, s, 0, a, NULL);
    figure_add(f, s, to, a + b * to, NULL);
}

void figure_add(figure_t *f, int series, double x, double y, const char *label) {
    if (f->y_floor > 0) y = fmax(y, f->y_floor);
    if ((f->x_log && !(x > 0)) || (f->y_log && !(y > 0))) return;
    if (f->points == FIGURE_POINTS) abort();
    f->point[f->points++] = (figure_point_t){x, y, series, label, false};
}

void figure_mark(figure_t *f) {
    if (f->points > 0) f->point[f->points - 1].ring = true;
}

static axis_t range(const figure_t *f, bool of_y) {
    axis_t a = {INFINITY, -INFINITY, of_y ? f->y_log : f->x_log};
    for (int i = 0; i < f->points; i++) {
        double v = of_y ? f->point[i].y : f->point[i].x;
        a.lo = fmin(a.lo, v), a.hi = fmax(a.hi, v);
    }
    if (f->points == 0) a.lo = a.hi = 1;
    if (a.log) {
        a.lo = floor(log10(a.lo)), a.hi = ceil(log10(a.hi));
        if (a.lo == a.hi) a.hi++;
    } else {
        a.lo = fmin(a.lo, 0);
        if (a.hi <= a.lo) a.hi = a.lo + 1;
    }
    return a;
}

static double place(axis_t a, double v) {
    return ((a.log ? log10(v) : v) - a.lo) / (a.hi - a.lo);
}
static double px(axis_t a, double v) {
    return LEFT + PLOT_WIDTH * place(a, v);
}
static double py(axis_t a, double v) {
    return TOP + PLOT_HEIGHT * (1 - place(a, v));
}

/* Distance of the marks of an axis: 1, 2 or 5 times a power of ten. */
static double step_of(axis_t a) {
    double rough = (a.hi - a.lo) / 6, ten = pow(10, floor(log10(rough))), k = rough / ten;
    if (a.log) return fmax(1, ceil((a.hi - a.lo) / 10));
    return ten * (k <= 1 ? 1 : k <= 2 ? 2 : k <= 5 ? 5 : 10);
}

static void draw_axis(FILE *out, axis_t a, bool of_y, double floor_at) {
    double step = step_of(a);
    int first = (int)ceil(a.lo / step), last = (int)floor(a.hi / step + 1e-9);
    for (int k = first; k <= last; k++) {
        double v = a.log ? pow(10, k * step) : k * step;
        double at = of_y ? py(a, v) : px(a, v);
        if (of_y && floor_at > 0 && v <= 1.001 * floor_at) v = 0;
        if (of_y)
            fprintf(out, "<path d='M%g %.1fh%g' stroke='#ddd'/><text x='%g' y='%.1f' text-anchor='end'>%g</text>\n",
                    LEFT, at, PLOT_WIDTH, LEFT - 6, at + 4, v);
        else
            fprintf(out, "<path d='M%.1f %gv%g' stroke='#ddd'/><text x='%.1f' y='%g' text-anchor='middle'>%g</text>\n",
                    at, TOP, PLOT_HEIGHT, at, TOP + PLOT_HEIGHT + 16, v);
    }
}

static void draw_mark(FILE *out, int s, double x, double y) {
    const char *c = colour[s % COLOURS];
    if (s < COLOURS)
        fprintf(out, "<circle cx='%.1f' cy='%.1f' r='3' fill='%s'/>\n", x, y, c);
    else
        fprintf(out, "<rect x='%.1f' y='%.1f' width='6' height='6' fill='none' stroke='%s'/>\n", x - 3, y - 3, c);
}

/* Is there a point of the series that is better in one way and no worse in the other? */
static bool is_beaten(const figure_t *f, const figure_point_t *p) {
    for (int i = 0; i < f->points; i++) {
        const figure_point_t *q = &f->point[i];
        if (q->series != p->series || q->x > p->x || q->y > p->y) continue;
        if (q->x < p->x || q->y < p->y) return true;
    }
    return false;
}

static void draw_front(FILE *out, const figure_t *f, int s, axis_t x, axis_t y) {
    double after = -INFINITY;
    const char *verb = "M";
    fprintf(out, "<path fill='none' stroke='%s' stroke-opacity='.5' d='", colour[s % COLOURS]);
    for (;;) {
        const figure_point_t *next = NULL;
        for (int i = 0; i < f->points; i++) {
            const figure_point_t *p = &f->point[i];
            if (p->series == s && p->x > after && !is_beaten(f, p) && (!next || p->x < next->x)) next = p;
        }
        if (!next) break;
        after = next->x;
        fprintf(out, "%s%.1f %.1f", verb, px(x, next->x), py(y, next->y));
        verb = "L";
    }
    fprintf(out, "'/>\n");
}

static void draw_series(FILE *out, const figure_t *f, int s, axis_t x, axis_t y) {
    const char *c = colour[(f->line_of[s] ? f->line_of[s] - 1 : s) % COLOURS];
    const char *verb = "M";
    if (f->joined || f->line_of[s]) {
        fprintf(out, "<path fill='none' stroke='%s' stroke-width='1.5' d='", c);
        for (int i = 0; i < f->points; i++) {
            const figure_point_t *p = &f->point[i];
            if (p->series != s) continue;
            fprintf(out, "%s%.1f %.1f", verb, px(x, p->x), py(y, p->y));
            verb = "L";
        }
        fprintf(out, "'/>\n");
    }
    if (f->line_of[s]) return;
    if (f->front) draw_front(out, f, s, x, y);
    for (int i = 0; i < f->points; i++) {
        const figure_point_t *p = &f->point[i];
        if (p->series != s) continue;
        double at_x = px(x, p->x), at_y = py(y, p->y);
        draw_mark(out, s, at_x, at_y);
        if (p->ring) fprintf(out, "<circle cx='%.1f' cy='%.1f' r='7' fill='none' stroke='%s'/>\n", at_x, at_y, c);
        if (p->label) fprintf(out, "<text x='%.1f' y='%.1f' fill='%s'>%s</text>\n", at_x + 5, at_y - 4, c, p->label);
    }
    draw_mark(out, s, LEFT + PLOT_WIDTH + 18, 50 + 17 * s);
    fprintf(out, "<text x='%g' y='%d'>%s</text>\n", LEFT + PLOT_WIDTH + 28, 54 + 17 * s, f->name[s]);
}

static FILE *create(const char *name, double width, double height) {
    FILE *out = fopen(name, "w");
    if (!out) {
        perror(name);
        exit(1);
    }
    fprintf(out,
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %g %g' font-family='sans-serif' font-size='11'>\n"
            "<rect width='100%%' height='100%%' fill='#fff'/>\n",
            width, height);
    return out;
}

static void finish(FILE *out) {
    fputs("</svg>\n", out);
    if (fclose(out)) exit(1);
}

static void draw(FILE *out, const figure_t *f) {
    axis_t x = range(f, false), y = range(f, true);
    draw_axis(out, x, false, 0);
    draw_axis(out, y, true, f->y_floor);
    fprintf(out, "<rect x='%g' y='%g' width='%g' height='%g' fill='none' stroke='#555'/>\n", LEFT, TOP, PLOT_WIDTH,
            PLOT_HEIGHT);
    if (f->y_line > 0)
        fprintf(out, "<path d='M%g %.1fh%g' stroke='#c00' stroke-dasharray='6 4'/>\n", LEFT, py(y, f->y_line),
                PLOT_WIDTH);
    for (int s = 0; s < f->series; s++) draw_series(out, f, s, x, y);
    fprintf(out,
            "<text x='%g' y='24' font-size='14'>%s</text><text x='%g' y='%g' text-anchor='middle'>%s</text>\n"
            "<text transform='translate(16 %g) rotate(-90)' text-anchor='middle'>%s</text>\n",
            LEFT, f->title, LEFT + PLOT_WIDTH / 2, TOP + PLOT_HEIGHT + 38, f->x_title, TOP + PLOT_HEIGHT / 2,
            f->y_title);
}

void figure_write(const figure_t *f, const char *name) {
    FILE *out = create(name, WIDTH, HEIGHT);
    draw(out, f);
    finish(out);
}

void figure_write_panels(const figure_t *f, int n, int columns, const char *name) {
    FILE *out = create(name, columns * WIDTH, (double)((n + columns - 1) / columns) * HEIGHT);
    for (int i = 0; i < n; i++) {
        fprintf(out, "<g transform='translate(%g %g)'>\n", i % columns * WIDTH, (double)(i / columns) * HEIGHT);
        draw(out, &f[i]);
        fputs("</g>\n", out);
    }
    finish(out);
}
