/* svg.c - the page's y goes up and the picture's down: every y is counted from the upper edge of the paper. */
#include "host/svg.h"

#include "host/out.h"

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

static void write_stroke(out_t *o, const page_point_t *point, size_t n, int32_t height_lat) {
    out_text(o, "<path d=\"M");
    for (size_t i = 0; i < n; i++) {
        char *p = out_reserve(o, 2 * OUT_NUMBER_MAX + 2);
        if (i) *p++ = i == 1 ? 'L' : ' ';
        out_commit(o, put_point(p, point[i], height_lat));
    }
    out_text(o, "\"/>\n");
}

int svg_write(const drawing_t *d, const char *path) {
    out_t o;
    int err = out_open(&o, path);
    if (err) return err;
    double width = d->width_um / 1000.0, height = d->height_um / 1000.0;
    bool layers = drawing_has_pens(d);
    out_format(
        &o,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"%s width=\"%.6gmm\" "
        "height=\"%.6gmm\" viewBox=\"0 0 %.6g %.6g\">\n",
        layers ? " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"" : "", width, height, width, height);
    if (d->title[0]) {
        out_text(&o, "<title>");
        write_escaped(&o, d->title);
        out_text(&o, "</title>\n");
    }
    out_format(&o,
               "<rect width=\"%.6g\" height=\"%.6g\" fill=\"#fff\"/>\n<g fill=\"none\" stroke=\"#000\" "
               "stroke-width=\"0.3\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
               width, height);
    int pen = 0;
    int32_t height_lat = (int32_t)((int64_t)d->height_um * LAT_PER_MM / 1000);
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *point = drawing_stroke(d, s, &n);
        if (layers && drawing_pen(d, s) != pen) {
            if (pen) out_text(&o, "</g>\n");
            pen = drawing_pen(d, s);
            out_format(&o, "<g id=\"pen%d\" inkscape:groupmode=\"layer\" inkscape:label=\"pen %d\" stroke=\"#%06x\">\n",
                       pen, pen, drawing_colour(pen));
        }
        write_stroke(&o, point, n, height_lat);
    }
    if (pen) out_text(&o, "</g>\n");
    out_text(&o, "</g>\n</svg>\n");
    return out_close(&o);
}
