/* sheet.c - see sheet.h. */
#include "tests/report/sheet.h"

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define COLUMNS 3 /* pairs in a row of a sheet */
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

/* In strokes of a few hundred lines, since a path of millions takes minutes. */
static void thumbnail(cairo_t *cr, double x, double y, const strokes_t *s, const sheet_box_t *b) {
    const double w = fmax(b->x1 - b->x0, 1e-6), h = fmax(b->y1 - b->y0, 1e-6);
    const double k = fmin((CELL_W - 12) / w, (CELL_H - 8) / h);
    cairo_save(cr);
    cairo_rectangle(cr, x + 2, y, CELL_W - 4, CELL_H);
    cairo_clip(cr);
    cairo_translate(cr, x + CELL_W / 2., y + CELL_H / 2.);
    cairo_scale(cr, k, -k);
    cairo_translate(cr, -(b->x0 + b->x1) / 2, -(b->y0 + b->y1) / 2);
    cairo_set_line_width(cr, .6 / k);
    cairo_set_source_rgb(cr, 0, 0, 0);
    for (size_t i = 0; i < s->n; i++) {
        cairo_move_to(cr, (double)s->at[i][0], (double)s->at[i][1]);
        cairo_line_to(cr, (double)s->at[i][2], (double)s->at[i][3]);
        if (i % 500 == 499) cairo_stroke(cr);
    }
    cairo_stroke(cr);
    cairo_restore(cr);
}

static void caption(cairo_t *cr, double x, double y, const char *text, double shade) {
    cairo_set_source_rgb(cr, shade, 0, 0);
    cairo_set_font_size(cr, 10);
    cairo_move_to(cr, x, y);
    cairo_show_text(cr, text);
    cairo_new_path(cr);
}

static cairo_t *start(int cases) {
    const int rows = (cases + COLUMNS - 1) / COLUMNS;
    cairo_surface_t *to =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, COLUMNS * 2 * CELL_W, rows * (CELL_H + CAPTION));
    cairo_t *cr = cairo_create(to);
    cairo_surface_destroy(to);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    return cr;
}

static void end(const sheets_t *s) {
    char path[512];
    snprintf(path, sizeof path, "%s/%s-%d.png", s->dir, s->name, sheets_count(s->entered));
    if (cairo_surface_write_to_png(cairo_get_target(s->cr), path) != CAIRO_STATUS_SUCCESS) {
        perror(path);
        exit(1);
    }
    cairo_destroy(s->cr);
}

void sheets_enter(sheets_t *s, const char *name, const char *naive, const strokes_t *ours, const strokes_t *other,
                  const sheet_box_t *part) {
    const int at = s->entered % SHEET_CASES, left = s->cases - s->entered;
    const double x = at % COLUMNS * 2 * CELL_W, y = (double)(at / COLUMNS) * (CELL_H + CAPTION);
    const sheet_box_t box = part ? *part : ink_box(ours);
    char text[160];
    if (at == 0) s->cr = start(left < SHEET_CASES ? left : SHEET_CASES);
    thumbnail(s->cr, x, y, ours, &box);
    thumbnail(s->cr, x + CELL_W, y, other, &box);
    snprintf(text, sizeof text, "%d %s", s->entered, name);
    caption(s->cr, x + 4, y + CELL_H + 11, text, 0);
    caption(s->cr, x + CELL_W + 4, y + CELL_H + 23, naive, .7);
    s->entered++;
    if (at == SHEET_CASES - 1 || left == 1) end(s);
}
