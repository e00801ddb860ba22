/* image.c - strokes are painted in pieces of at most CHUNK points: Cairo's cost to stroke a path at once grows faster
 * than its length, and black over black shows no seam. */
#include "host/image.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>

#include "error.h"
#include "host/library.h"
#include "host/out.h"
#include "host/progress.h"

#define LINE_WIDTH_MM 0.3
#define DOTS_PER_MM (200 / 25.4)
#define POINTS_PER_MM (72 / 25.4)

enum { CHUNK = 256 };

/* clang-format off */
#define CAIRO(F) \
    F(cairo_create) F(cairo_destroy) F(cairo_image_surface_create) F(cairo_line_to) F(cairo_move_to) F(cairo_paint) \
    F(cairo_pdf_surface_create_for_stream) F(cairo_pdf_surface_set_metadata) F(cairo_scale) F(cairo_set_line_cap) \
    F(cairo_set_line_join) F(cairo_set_line_width) F(cairo_set_operator) F(cairo_set_source_rgb) F(cairo_show_page) \
    F(cairo_stroke) F(cairo_surface_destroy) F(cairo_surface_finish) F(cairo_surface_status) \
    F(cairo_surface_write_to_png_stream) F(cairo_translate)
/* clang-format on */
static struct { CAIRO(LIBRARY_POINTER) } lib;

static bool is_there(void) {
    static const char *const NAMES[] = {CAIRO(LIBRARY_NAME)};
    static bool loaded;
    if (!loaded) loaded = library_load("libcairo.so.2", NAMES, sizeof NAMES / sizeof *NAMES, &lib);
    if (!loaded) fprintf(stderr, "ridgeline: .png and .pdf need the Cairo library: %s\n", library_error());
    return loaded;
}

static out_t out; /* large */

static cairo_status_t take_bytes(void *ctx, const unsigned char *data, unsigned n) {
    out_bytes(ctx, data, n);
    return CAIRO_STATUS_SUCCESS; /* what goes wrong is remembered */
}

static int close_out(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return out_close(&out);
    out_drop(&out);
    errno = status == CAIRO_STATUS_NO_MEMORY ? ENOMEM : 0;
    return ERR_FILE;
}

/* ink: how a line changes what is there. */
static void paint(cairo_t *c, const drawing_t *d, double scale, cairo_operator_t ink) {
    double height_mm = d->height_um / 1000.0;
    lib.cairo_set_source_rgb(c, 1, 1, 1);
    lib.cairo_paint(c);
    lib.cairo_set_operator(c, ink);
    lib.cairo_scale(c, scale, -scale);
    lib.cairo_translate(c, 0, -height_mm);
    lib.cairo_set_source_rgb(c, 0, 0, 0);
    lib.cairo_set_line_width(c, LINE_WIDTH_MM);
    lib.cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
    lib.cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
    int pen = 1;
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *p = drawing_stroke(d, s, &n);
        if (d->changes && drawing_pen(d, s) != pen) {
            pen = drawing_pen(d, s);
            unsigned rgb = drawing_colour(pen);
            lib.cairo_set_source_rgb(c, (rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
        }
        progress_update("painting", (int64_t)s, (int64_t)d->strokes);
        for (size_t i = 0; i < n; i++) {
            double x = (double)p[i].x_lat / LAT_PER_MM, y = (double)p[i].y_lat / LAT_PER_MM;
            if (i == 0) {
                lib.cairo_move_to(c, x, y);
                continue;
            }
            lib.cairo_line_to(c, x, y);
            if (i % CHUNK == 0 && i + 1 < n) {
                lib.cairo_stroke(c);
                lib.cairo_move_to(c, x, y);
            }
        }
        lib.cairo_stroke(c);
    }
}

/* The bitmap holds one channel, which a PNG file shows as grey: paper is opaque, so white, and ink takes away. A
 * quarter of the memory, half the file and a third of the time of colours, which several pens get. */
int image_write_png(const drawing_t *d, const char *path) {
    if (!is_there()) return ERR_UNSUPPORTED;
    int width = (int)lround(d->width_um / 1000.0 * DOTS_PER_MM);
    int height = (int)lround(d->height_um / 1000.0 * DOTS_PER_MM);
    bool colours = drawing_has_pens(d);
    cairo_surface_t *surface =
        lib.cairo_image_surface_create(colours ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_A8, width, height);
    if (lib.cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
        lib.cairo_surface_destroy(surface);
        return ERR_VALUE;
    }
    int err = out_open(&out, path);
    if (err) {
        lib.cairo_surface_destroy(surface);
        return err;
    }
    cairo_t *c = lib.cairo_create(surface);
    paint(c, d, DOTS_PER_MM, colours ? CAIRO_OPERATOR_OVER : CAIRO_OPERATOR_DEST_OUT);
    lib.cairo_destroy(c);
    cairo_status_t status = lib.cairo_surface_write_to_png_stream(surface, take_bytes, &out);
    lib.cairo_surface_destroy(surface);
    return close_out(status);
}

int image_write_pdf(const drawing_t *d, const char *path) {
    if (!is_there()) return ERR_UNSUPPORTED;
    int err = out_open(&out, path);
    if (err) return err;
    cairo_surface_t *surface = lib.cairo_pdf_surface_create_for_stream(
        take_bytes, &out, d->width_um / 1000.0 * POINTS_PER_MM, d->height_um / 1000.0 * POINTS_PER_MM);
    if (d->title[0]) lib.cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, d->title);
    cairo_t *c = lib.cairo_create(surface);
    paint(c, d, POINTS_PER_MM, CAIRO_OPERATOR_OVER);
    lib.cairo_show_page(c);
    lib.cairo_destroy(c);
    lib.cairo_surface_finish(surface);
    cairo_status_t status = lib.cairo_surface_status(surface);
    lib.cairo_surface_destroy(surface);
    return close_out(status);
}
