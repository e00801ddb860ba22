/* hpgl.c - rounding is to the nearest unit; the pen's own rounding elsewhere plays no part here. */
#include "host/hpgl.h"

enum { UNITS_PER_MM = 40, POINTS_PER_COMMAND = 32 };

typedef struct unit_point {
    int32_t x, y;
} unit_point_t;

static int32_t units(int32_t lat) {
    return (int32_t)(((int64_t)lat * UNITS_PER_MM + LAT_PER_MM / 2) >> LAT_PER_MM_BITS);
}

static unit_point_t unit_point(page_point_t p) {
    return (unit_point_t){units(p.x_lat), units(p.y_lat)};
}

static char *put_point(char *p, unit_point_t at) {
    p = out_put_int(p, at.x);
    *p++ = ',';
    return out_put_int(p, at.y);
}

static void stroke(stroke_file_t *f, const page_point_t *point, size_t n) {
    out_t *o = &f->out;
    unit_point_t at = unit_point(point[0]);
    char *p = out_reserve(o, 2 * OUT_NUMBER_MAX + 8);
    *p++ = 'P', *p++ = 'U';
    p = put_point(p, at);
    *p++ = ';', *p++ = '\n';
    out_commit(o, p);
    int in_command = 0, written = 0;
    for (size_t i = 1; i < n; i++) {
        unit_point_t to = unit_point(point[i]);
        bool last_of_dot = i + 1 == n && !written; /* what shrank to a dot still touches the paper */
        if (to.x == at.x && to.y == at.y && !last_of_dot) continue;
        p = out_reserve(o, 2 * OUT_NUMBER_MAX + 8);
        if (in_command == 0) {
            *p++ = 'P', *p++ = 'D';
        } else {
            *p++ = ',';
        }
        p = put_point(p, to);
        if (++in_command == POINTS_PER_COMMAND) {
            *p++ = ';', *p++ = '\n';
            in_command = 0;
        }
        out_commit(o, p);
        at = to;
        written++;
    }
    if (in_command) out_text(o, ";\n");
}

static void head(stroke_file_t *f) {
    out_text(&f->out, "IN;");
}

static void take_pen(stroke_file_t *f, int pen) {
    out_format(&f->out, "SP%d;\n", pen);
}

static void tail(stroke_file_t *f) {
    if (!f->pen) take_pen(f, 1); /* no stroke did */
    out_text(&f->out, "PU0,0;SP0;\n");
}

const stroke_format_t HPGL_FORMAT = {0, head, take_pen, stroke, tail};
