/* stroke_file.c - see stroke_file.h. */
#include "host/stroke_file.h"

static void prepare(stroke_file_t *f, const stroke_format_t *format, const drawing_t *d, const machine_t *machine) {
    f->format = format;
    f->drawing = d;
    f->machine = machine;
    f->begun = false;
    f->pen = format->first_pen;
}

/* Not before the first stroke: until then the camera may not be known. */
static void begin(stroke_file_t *f) {
    if (f->begun) return;
    f->begun = true;
    f->format->head(f);
}

static void put_stroke(stroke_file_t *f, const page_point_t *point, size_t n, int pen) {
    begin(f);
    if (pen != f->pen) {
        f->format->take_pen(f, pen);
        f->pen = pen;
    }
    f->format->stroke(f, point, n);
}

static int end(stroke_file_t *f) {
    begin(f);
    f->format->tail(f);
    return out_close(&f->out);
}

int stroke_file_write(const stroke_format_t *format, const drawing_t *d, const machine_t *machine, const char *path) {
    static stroke_file_t file; /* large */
    prepare(&file, format, d, machine);
    int err = out_open(&file.out, path);
    if (err) return err;
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *point = drawing_stroke(d, s, &n);
        put_stroke(&file, point, n, d->changes ? drawing_pen(d, s) : 1);
    }
    return end(&file);
}

static void take_stroke(void *file, const page_point_t *point, size_t n) {
    put_stroke(file, point, n, 1);
}

bool stroke_file_begin(stroke_file_t *f, const stroke_format_t *format, drawing_t *d, const machine_t *machine,
                       const char *path) {
    prepare(f, format, d, machine);
    if (!out_open_unnamed(&f->out, path)) return false;
    drawing_hand_on(d, take_stroke, f);
    return true;
}

void stroke_file_restart(stroke_file_t *f) {
    prepare(f, f->format, f->drawing, f->machine);
    out_restart(&f->out);
}

int stroke_file_end(stroke_file_t *f, drawing_t *d) {
    drawing_hand_on(d, NULL, NULL);
    return end(f);
}

void stroke_file_drop(stroke_file_t *f, drawing_t *d) {
    drawing_hand_on(d, NULL, NULL);
    out_drop(&f->out);
}
