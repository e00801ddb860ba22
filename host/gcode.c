/* gcode.c - three decimals: a thousandth of a millimetre is a twelfth of a step. */
#include "host/gcode.h"

#include <stdio.h>
#include <string.h>

#include "host/out.h"

static char *put_point(char *p, page_point_t at) {
    *p++ = 'X';
    p = out_put_mm3(p, at.x_lat);
    *p++ = ' ', *p++ = 'Y';
    p = out_put_mm3(p, at.y_lat);
    *p++ = '\n';
    return p;
}

static void write_move(out_t *o, const char *command, page_point_t to) {
    char *p = out_reserve(o, 2 * OUT_NUMBER_MAX + 32);
    size_t n = strlen(command);
    memcpy(p, command, n);
    out_commit(o, put_point(p + n, to));
}

static void pen_command(char *text, size_t room, const char *command, uint32_t delay_us) {
    if (delay_us)
        snprintf(text, room, "%s\nG4 P%u.%03u\n", command, delay_us / 1000000, delay_us / 1000 % 1000);
    else
        snprintf(text, room, "%s\n", command);
}

int gcode_write(const drawing_t *d, const machine_t *m, const char *path) {
    out_t o;
    int err = out_open(&o, path);
    if (err) return err;
    char down[64], up[64], draw_first[32];
    pen_command(down, sizeof down, "M3 S1000", m->lower_us);
    pen_command(up, sizeof up, "M5", m->lift_us);
    uint32_t feed_um_min = m->draw_speed_um_s < UINT32_MAX / 60 ? m->draw_speed_um_s * 60 : UINT32_MAX;
    snprintf(draw_first, sizeof draw_first, "G1 F%u ", feed_um_min / 1000);
    out_text(&o, "; Ridgeline drawing: M3 lowers the pen, M5 lifts it\nG21\nG90\n");
    out_text(&o, up);
    int pen = 1;
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *point = drawing_stroke(d, s, &n);
        if (drawing_pen(d, s) != pen) {
            pen = drawing_pen(d, s);
            out_format(&o, "G0 X0 Y0\nT%d\nM0 ; put pen %d in, then resume\n", pen, pen);
        }
        write_move(&o, "G0 ", point[0]);
        out_text(&o, down);
        for (size_t i = 1; i < n; i++) write_move(&o, i == 1 ? draw_first : "", point[i]);
        out_text(&o, up);
    }
    out_text(&o, "G0 X0 Y0\nM2\n");
    return out_close(&o);
}
