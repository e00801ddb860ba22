/* seg.c - a point inside a stroke stands in two lines; its text is made once and copied. */
#include "host/seg.h"

#include <string.h>

#include "host/out.h"

enum { POINT_MAX = 2 * OUT_NUMBER_MAX + 1 };

static char *put_point(char *p, page_point_t at) {
    p = out_put_mm6(p, at.x_lat);
    *p++ = ' ';
    return out_put_mm6(p, at.y_lat);
}

int seg_write(const drawing_t *d, const char *path) {
    out_t o;
    int err = out_open(&o, path);
    if (err) return err;
    out_text(&o, "# camera");
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) out_format(&o, " %.17g", d->camera_mm[i][j]);
    out_text(&o, "\n");
    int pen = 1;
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *point = drawing_stroke(d, s, &n);
        if (d->changes && drawing_pen(d, s) != pen) {
            pen = drawing_pen(d, s);
            out_format(&o, "# pen %d\n", pen);
        }
        char from[POINT_MAX];
        size_t from_len = (size_t)(put_point(from, point[0]) - from);
        for (size_t i = 1; i < n; i++) {
            char *p = out_reserve(&o, 2 * POINT_MAX + 2);
            memcpy(p, from, sizeof from); /* a fixed size is one burst of moves; from_len of it counts */
            p += from_len;
            *p++ = ' ';
            char *to = p;
            p = put_point(p, point[i]);
            from_len = (size_t)(p - to);
            *p++ = '\n';
            out_commit(&o, p);
            memcpy(from, to, sizeof from);
        }
    }
    return out_close(&o);
}
