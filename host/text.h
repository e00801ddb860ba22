/* text.h - drawings as text: what .seg, .svg, .hpgl and .gcode have in common. A stroke is written when it is known,
 * from a drawing in memory or while one is drawn. */
#ifndef TEXT_H
#define TEXT_H

#include "host/drawing.h"
#include "host/out.h"
#include "motion/machine.h"

typedef struct text {
    const struct text_format *format;
    const drawing_t *drawing; /* its strokes are given one by one */
    const machine_t *machine;
    bool begun; /* what stands before the strokes is written */
    int pen;    /* in use */
    out_t out;
} text_t;

typedef struct text_format {
    int first_pen; /* in use where none has been asked for; 0: none */
    void (*head)(text_t *t);
    void (*take_pen)(text_t *t, int pen); /* t->pen is still the one before */
    void (*stroke)(text_t *t, const page_point_t *point, size_t n);
    void (*tail)(text_t *t);
} text_format_t;

/* Writes all strokes of a drawing. 0, or ERR_FILE with errno set. */
int text_write(const text_format_t *format, const drawing_t *d, const machine_t *machine, const char *path);

/* Or while it is drawn: d hands its strokes on to t, which must outlive the drawing, and keeps none. All are of one pen
 * (drawing_has_pens). False if what is at path could not stay until all is drawn. */
bool text_begin(text_t *t, const text_format_t *format, drawing_t *d, const machine_t *machine, const char *path);
/* The same from the beginning. */
void text_restart(text_t *t);
/* All is drawn: 0, or ERR_FILE with errno set. */
int text_end(text_t *t, drawing_t *d);
/* The drawing is given up; there is no file. */
void text_drop(text_t *t, drawing_t *d);

#endif
