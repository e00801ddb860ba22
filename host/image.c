/* image.c - strokes are painted in pieces of at most CHUNK points: Cairo's cost to stroke a path at once grows faster
 * than its length, and black over black shows no seam. */
#include "host/image.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <math.h>

#include "error.h"
#include "host/progress.h"

#define LINE_WIDTH_MM 0.3
#define DOTS_PER_MM (200 / 25.4)
#define POINTS_PER_MM (72 / 25.4)

enum { CHUNK = 256 };

/* ink: how a line changes what is there. */
static void paint(cairo_t *c, const drawing_t *d, double scale, cairo_operator_t ink) {
    double height_mm = d->height_um / 1000.0;
    cairo_set_source_rgb(c, 1, 1, 1);
    cairo_paint(c);
    cairo_set_operator(c, ink);
    cairo_scale(c, scale, -scale);
    cairo_translate(c, 0, -height_mm);
    cairo_set_source_rgb(c, 0, 0, 0);
    cairo_set_line_width(c, LINE_WIDTH_MM);
    cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *p = drawing_stroke(d, s, &n);
        progress_update("painting", (int64_t)s, (int64_t)d->strokes);
        for (size_t i = 0; i < n; i++) {
            double x = (double)p[i].x_lat / LAT_PER_MM, y = (double)p[i].y_lat / LAT_PER_MM;
            if (i == 0) {
                cairo_move_to(c, x, y);
                continue;
            }
            cairo_line_to(c, x, y);
            if (i % CHUNK == 0 && i + 1 < n) {
                cairo_stroke(c);
                cairo_move_to(c, x, y);
            }
        }
        cairo_stroke(c);
    }
}

/* The bitmap holds one channel, which a PNG file shows as grey: paper is opaque, so white, and ink takes away. A
 * quarter of the memory, half the file and a third of the time of colours. */
int image_write_png(const drawing_t *d, const char *path) {
    int width = (int)lround(d->width_um / 1000.0 * DOTS_PER_MM);
    int height = (int)lround(d->height_um / 1000.0 * DOTS_PER_MM);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, width, height);
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
        cairo_surface_destroy(surface);
        return ERR_VALUE;
    }
    cairo_t *c = cairo_create(surface);
    paint(c, d, DOTS_PER_MM, CAIRO_OPERATOR_DEST_OUT);
    cairo_destroy(c);
    cairo_status_t status = cairo_surface_write_to_png(surface, path);
    cairo_surface_destroy(surface);
    return status == CAIRO_STATUS_SUCCESS ? 0 : ERR_FILE;
}

int image_write_pdf(const drawing_t *d, const char *path) {
    cairo_surface_t *surface =
        cairo_pdf_surface_create(path, d->width_um / 1000.0 * POINTS_PER_MM, d->height_um / 1000.0 * POINTS_PER_MM);
    if (d->title[0]) cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, d->title);
    cairo_t *c = cairo_create(surface);
    paint(c, d, POINTS_PER_MM, CAIRO_OPERATOR_OVER);
    cairo_show_page(c);
    cairo_destroy(c);
    cairo_surface_finish(surface);
    cairo_status_t status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    return status == CAIRO_STATUS_SUCCESS ? 0 : ERR_FILE;
}
