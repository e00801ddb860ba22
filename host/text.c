/* text.c - see text.h. */
#include "host/text.h"

static void prepare(text_t *t, const text_format_t *format, const drawing_t *d, const machine_t *machine) {
    t->format = format;
    t->drawing = d;
    t->machine = machine;
    t->begun = false;
    t->pen = format->first_pen;
}

/* Not before the first stroke: until then the camera may not be known. */
static void begin(text_t *t) {
    if (t->begun) return;
    t->begun = true;
    t->format->head(t);
}

static void put_stroke(text_t *t, const page_point_t *point, size_t n, int pen) {
    begin(t);
    if (pen != t->pen) {
        t->format->take_pen(t, pen);
        t->pen = pen;
    }
    t->format->stroke(t, point, n);
}

static int end(text_t *t) {
    begin(t);
    t->format->tail(t);
    return out_close(&t->out);
}

int text_write(const text_format_t *format, const drawing_t *d, const machine_t *machine, const char *path) {
    static text_t text; /* large */
    prepare(&text, format, d, machine);
    int err = out_open(&text.out, path);
    if (err) return err;
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *point = drawing_stroke(d, s, &n);
        put_stroke(&text, point, n, d->changes ? drawing_pen(d, s) : 1);
    }
    return end(&text);
}

static void take_stroke(void *text, const page_point_t *point, size_t n) {
    put_stroke(text, point, n, 1);
}

bool text_begin(text_t *t, const text_format_t *format, drawing_t *d, const machine_t *machine, const char *path) {
    prepare(t, format, d, machine);
    if (!out_open_unnamed(&t->out, path)) return false;
    drawing_hand_on(d, take_stroke, t);
    return true;
}

void text_restart(text_t *t) {
    prepare(t, t->format, t->drawing, t->machine);
    out_restart(&t->out);
}

int text_end(text_t *t, drawing_t *d) {
    drawing_hand_on(d, NULL, NULL);
    return end(t);
}

void text_drop(text_t *t, drawing_t *d) {
    drawing_hand_on(d, NULL, NULL);
    out_drop(&t->out);
}
