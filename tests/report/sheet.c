/* sheet.c - see sheet.h. */
#include "tests/report/sheet.h"

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/oracle/page_lines.h"

#define NEAR_MM .03    /* what is as near to the other drawing's ink is in it, too */
#define PAIRS_MOST 1e9 /* of more no differences are looked for */
#define COLUMNS 3      /* pairs in a row of a sheet */
#define CELL_W 190
#define CELL_H 140
#define CAPTION 30

void strokes_add(strokes_t *s, double x0, double y0, double x1, double y1) {
    if (s->n == s->room) {
        s->room = s->room ? 2 * s->room : 1024;
        s->at = realloc(s->at, s->room * sizeof *s->at);
        if (!s->at) abort();
    }
    const double v[4] = {x0, y0, x1, y1};
    for (int k = 0; k < 4; k++) s->at[s->n][k] = (float)v[k];
    s->n++;
}

void strokes_free(strokes_t *s) {
    free(s->at);
    *s = (strokes_t){0};
}

int sheets_count(int cases) {
    return (cases + SHEET_CASES - 1) / SHEET_CASES;
}

static sheet_box_t ink_box(const strokes_t *s) {
    sheet_box_t b = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < s->n; i++)
        for (int k = 0; k < 4; k += 2) {
            const double x = (double)s->at[i][k], y = (double)s->at[i][k + 1];
            b = (sheet_box_t){fmin(b.x0, x), fmin(b.y0, y), fmax(b.x1, x), fmax(b.y1, y)};
        }
    return b.x1 >= b.x0 ? b : (sheet_box_t){0, 0, 1, 1};
}

static page_lines_t lines_of(const strokes_t *s) {
    page_lines_t all = {0};
    for (size_t i = 0; i < s->n; i++) {
        const float *p = s->at[i];
        page_lines_add(&all, (page_line_t){(double)p[0], (double)p[1], (double)p[2], (double)p[3]});
    }
    return all;
}

/* What of `what` has nothing of `by` along it. */
static strokes_t without(const strokes_t *what, const strokes_t *by) {
    page_lines_t from = lines_of(what), other = lines_of(by);
    spans_t along = {0}, bare = {0};
    strokes_t out = {0};
    for (size_t i = 0; i < from.n && (double)from.n * (double)other.n < PAIRS_MOST; i++) {
        const page_line_t *l = &from.line[i];
        const double dx = l->x1 - l->x0, dy = l->y1 - l->y0;
        page_lines_along(l, &other, NEAR_MM, &along);
        spans_complement(&along, 0, 1, &bare);
        for (size_t k = 0; k < bare.n; k++) {
            const double a = (double)bare.s[k].a, b = (double)bare.s[k].b;
            strokes_add(&out, l->x0 + a * dx, l->y0 + a * dy, l->x0 + b * dx, l->y0 + b * dy);
        }
    }
    spans_free(&along);
    spans_free(&bare);
    page_lines_free(&from);
    page_lines_free(&other);
    return out;
}

enum ink { INK_BLACK, INK_FALSE, INK_MISSING };

/* In strokes of a few hundred lines, since a path of millions takes minutes. */
static void thumbnail(cairo_t *cr, double x, double y, const strokes_t *s, const sheet_box_t *b, enum ink ink) {
    const double w = fmax(b->x1 - b->x0, 1e-6), h = fmax(b->y1 - b->y0, 1e-6);
    const double k = fmin((CELL_W - 12) / w, (CELL_H - 8) / h);
    cairo_save(cr);
    cairo_rectangle(cr, x + 2, y, CELL_W - 4, CELL_H);
    cairo_clip(cr);
    cairo_translate(cr, x + CELL_W / 2., y + CELL_H / 2.);
    cairo_scale(cr, k, -k);
    cairo_translate(cr, -(b->x0 + b->x1) / 2, -(b->y0 + b->y1) / 2);
    cairo_set_line_width(cr, (ink == INK_BLACK ? .6 : .9) / k);
    cairo_set_source_rgb(cr, ink == INK_FALSE ? .85 : 0, ink == INK_MISSING ? .5 : 0, ink == INK_MISSING ? 1 : 0);
    for (size_t i = 0; i < s->n; i++) {
        cairo_move_to(cr, (double)s->at[i][0], (double)s->at[i][1]);
        cairo_line_to(cr, (double)s->at[i][2], (double)s->at[i][3]);
        if (i % 500 == 499) cairo_stroke(cr);
    }
    cairo_stroke(cr);
    cairo_restore(cr);
}

void sheet_text(cairo_t *cr, double x, double y, const char *text, double shade) {
    cairo_set_source_rgb(cr, shade, 0, 0);
    cairo_set_font_size(cr, 10);
    cairo_move_to(cr, x, y);
    cairo_show_text(cr, text);
    cairo_new_path(cr);
}

cairo_t *sheet_begin(double zoom, int width, int height) {
    cairo_surface_t *to = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)(zoom * width), (int)(zoom * height));
    cairo_t *cr = cairo_create(to);
    cairo_scale(cr, zoom, zoom);
    cairo_surface_destroy(to);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    return cr;
}

void sheet_end(cairo_t *cr, const char *dir, const char *name, int number) {
    char path[512];
    snprintf(path, sizeof path, "%s/%s-%d.png", dir, name, number);
    if (cairo_surface_write_to_png(cairo_get_target(cr), path) != CAIRO_STATUS_SUCCESS) {
        perror(path);
        exit(1);
    }
    cairo_destroy(cr);
}

static cairo_t *start(int cases, double zoom) {
    const int rows = (cases + COLUMNS - 1) / COLUMNS, columns = cases < COLUMNS ? cases : COLUMNS;
    return sheet_begin(zoom, columns * 2 * CELL_W, rows * (CELL_H + CAPTION));
}

void sheets_enter(sheets_t *s, const char *name, const char *naive, const strokes_t *ours, const strokes_t *other,
                  const sheet_box_t *part) {
    const int at = s->entered % SHEET_CASES, left = s->cases - s->entered;
    const double x = at % COLUMNS * 2 * CELL_W, y = (double)(at / COLUMNS) * (CELL_H + CAPTION);
    const sheet_box_t box = part ? *part : ink_box(ours);
    char text[160];
    if (at == 0) s->cr = start(left < SHEET_CASES ? left : SHEET_CASES, s->zoom > 0 ? s->zoom : 1);
    strokes_t wrong = {0}, lacks = {0};
    if (!s->apart) wrong = without(other, ours), lacks = without(ours, other);
    thumbnail(s->cr, x, y, ours, &box, INK_BLACK);
    thumbnail(s->cr, x + CELL_W, y, &lacks, &box, INK_MISSING);
    thumbnail(s->cr, x + CELL_W, y, other, &box, INK_BLACK);
    thumbnail(s->cr, x + CELL_W, y, &wrong, &box, INK_FALSE);
    strokes_free(&wrong);
    strokes_free(&lacks);
    snprintf(text, sizeof text, "%d %s", s->entered, name);
    sheet_text(s->cr, x + 4, y + CELL_H + 11, text, 0);
    sheet_text(s->cr, x + CELL_W + 4, y + CELL_H + 23, naive, .7);
    s->entered++;
    if (at == SHEET_CASES - 1 || left == 1) sheet_end(s->cr, s->dir, s->name, sheets_count(s->entered));
}
