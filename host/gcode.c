/* gcode.c - three decimals: a thousandth of a millimetre is a twelfth of a step. */
#include "host/gcode.h"

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

static void pen_command(out_t *o, const char *command, uint32_t delay_us) {
    char *p = out_reserve(o, 4 * OUT_NUMBER_MAX);
    const size_t n = strlen(command);
    memcpy(p, command, n);
    p += n;
    if (delay_us) {
        memcpy(p, "\nG4 P", 5);
        p = out_put_u32(p + 5, delay_us / 1000000);
        *p++ = '.';
        memcpy(p, DIGITS[delay_us / 1000 % 1000].padded, 4);
        p += 3;
    }
    *p++ = '\n';
    out_commit(o, p);
}

static void lower(stroke_file_t *f) {
    pen_command(&f->out, "M3 S1000", f->machine->lower_us);
}
static void lift(stroke_file_t *f) {
    pen_command(&f->out, "M5", f->machine->lift_us);
}

static void head(stroke_file_t *f) {
    out_text(&f->out, "; Ridgeline drawing: M3 lowers the pen, M5 lifts it\nG21\nG90\n");
    lift(f);
}

static void take_pen(stroke_file_t *f, int pen) {
    out_format(&f->out, "G0 X0 Y0\nT%d\nM0 ; put pen %d in, then resume\n", pen, pen);
}

/* The speed stands in a stroke's first line. */
static void write_draw(stroke_file_t *f, page_point_t to) {
    const uint32_t um_s = f->machine->draw_speed_um_s, um_min = um_s < UINT32_MAX / 60 ? um_s * 60 : UINT32_MAX;
    char *p = out_reserve(&f->out, 4 * OUT_NUMBER_MAX);
    memcpy(p, "G1 F", 4);
    p = out_put_u32(p + 4, um_min / 1000);
    *p++ = ' ';
    out_commit(&f->out, put_point(p, to));
}

static void stroke(stroke_file_t *f, const page_point_t *point, size_t n) {
    write_move(&f->out, "G0 ", point[0]);
    lower(f);
    write_draw(f, point[1]);
    for (size_t i = 2; i < n; i++) write_move(&f->out, "", point[i]);
    lift(f);
}

static void tail(stroke_file_t *f) {
    out_text(&f->out, "G0 X0 Y0\nM2\n");
}

const stroke_format_t GCODE_FORMAT = {1, head, take_pen, stroke, tail};
