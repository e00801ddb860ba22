/* svg.c - the page's y goes up and the picture's down: every y is counted from the upper edge of the paper. */
#include "host/svg.h"

static void write_escaped(out_t *o, const char *s) {
    for (; *s; s++) {
        char one[2] = {*s, 0};
        out_text(o, *s == '<'                 ? "&lt;"
                    : *s == '>'               ? "&gt;"
                    : *s == '&'               ? "&amp;"
                    : (unsigned char)*s < ' ' ? " "
                                              : one);
    }
}

static char *put_point(char *p, page_point_t at, int32_t height_lat) {
    p = out_put_mm3(p, at.x_lat);
    *p++ = ',';
    return out_put_mm3(p, height_lat - at.y_lat);
}

static void stroke(stroke_file_t *f, const page_point_t *point, size_t n) {
    const int32_t height_lat = (int32_t)((int64_t)f->drawing->height_um * LAT_PER_MM / 1000);
    out_text(&f->out, "<path d=\"M");
    for (size_t i = 0; i < n; i++) {
        char *p = out_reserve(&f->out, 2 * OUT_NUMBER_MAX + 2);
        if (i) *p++ = i == 1 ? 'L' : ' ';
        out_commit(&f->out, put_point(p, point[i], height_lat));
    }
    out_text(&f->out, "\"/>\n");
}

static void head(stroke_file_t *f) {
    const drawing_t *d = f->drawing;
    out_t *o = &f->out;
    const double width = d->width_um / 1000.0, height = d->height_um / 1000.0;
    out_format(
        o,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"%s width=\"%.6gmm\" "
        "height=\"%.6gmm\" viewBox=\"0 0 %.6g %.6g\">\n",
        drawing_has_pens(d) ? " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"" : "", width, height,
        width, height);
    if (d->title[0]) {
        out_text(o, "<title>");
        write_escaped(o, d->title);
        out_text(o, "</title>\n");
    }
    out_format(o,
               "<rect width=\"%.6g\" height=\"%.6g\" fill=\"#fff\"/>\n<g fill=\"none\" stroke=\"#000\" "
               "stroke-width=\"0.3\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
               width, height);
}

/* A layer for each pen, if there are several. */
static void take_pen(stroke_file_t *f, int pen) {
    if (!drawing_has_pens(f->drawing)) return;
    if (f->pen) out_text(&f->out, "</g>\n");
    out_format(&f->out, "<g id=\"pen%d\" inkscape:groupmode=\"layer\" inkscape:label=\"pen %d\" stroke=\"#%06x\">\n",
               pen, pen, drawing_colour(pen));
}

static void tail(stroke_file_t *f) {
    if (f->pen && drawing_has_pens(f->drawing)) out_text(&f->out, "</g>\n");
    out_text(&f->out, "</g>\n</svg>\n");
}

const stroke_format_t SVG_FORMAT = {0, head, take_pen, stroke, tail};
