/* seg.c - a point inside a stroke stands in two lines; its text is made once and copied. */
#include "host/seg.h"

enum { POINT_MAX = 2 * OUT_NUMBER_MAX + 1 };

static char *put_point(char *p, page_point_t at) {
    p = out_put_mm6(p, at.x_lat);
    *p++ = ' ';
    return out_put_mm6(p, at.y_lat);
}

static void head(stroke_file_t *f) {
    out_text(&f->out, "# camera");
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) out_format(&f->out, " %.17g", f->drawing->camera_mm[i][j]);
    out_text(&f->out, "\n");
}

static void take_pen(stroke_file_t *f, int pen) {
    out_format(&f->out, "# pen %d\n", pen);
}

static void stroke(stroke_file_t *f, const page_point_t *point, size_t n) {
    char from[POINT_MAX];
    size_t from_len = 0;
    for (size_t i = 1; i < n; i++) {
        char *p = out_reserve(&f->out, 2 * POINT_MAX + 2);
        if (i == 1) {
            p = put_point(p, point[0]);
        } else {
            memcpy(p, from, sizeof from); /* a fixed size is one burst of moves; from_len of it counts */
            p += from_len;
        }
        *p++ = ' ';
        const char *to = p;
        p = put_point(p, point[i]);
        from_len = (size_t)(p - to);
        *p++ = '\n';
        out_commit(&f->out, p);
        if (i + 1 < n) memcpy(from, to, sizeof from);
    }
}

static void tail(stroke_file_t *f) {
    (void)f;
}

const stroke_format_t SEG_FORMAT = {1, head, take_pen, stroke, tail};
