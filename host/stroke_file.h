/* stroke_file.h - drawings as text: what .seg, .svg, .hpgl and .gcode have in common. A stroke is written when it is
 * known, from a drawing in memory or while one is drawn. */
#ifndef STROKE_FILE_H
#define STROKE_FILE_H

#include "host/drawing.h"
#include "host/out.h"
#include "motion/machine.h"

typedef struct stroke_file {
    const struct stroke_format *format;
    const drawing_t *drawing; /* its strokes are given one by one */
    const machine_t *machine;
    bool begun; /* what stands before the strokes is written */
    int pen;    /* in use */
    out_t out;
} stroke_file_t;

typedef struct stroke_format {
    int first_pen; /* in use where none has been asked for; 0: none */
    void (*head)(stroke_file_t *f);
    void (*take_pen)(stroke_file_t *f, int pen); /* f->pen is still the one before */
    void (*stroke)(stroke_file_t *f, const page_point_t *point, size_t n);
    void (*tail)(stroke_file_t *f);
} stroke_format_t;

/* Writes all strokes of a drawing. 0, or ERR_FILE with errno set. */
int stroke_file_write(const stroke_format_t *format, const drawing_t *d, const machine_t *machine, const char *path);

/* Or while it is drawn: d hands its strokes on to f, which must outlive the drawing, and keeps none. All are of one pen
 * (drawing_has_pens). False if what is at path could not stay until all is drawn. */
bool stroke_file_begin(stroke_file_t *f, const stroke_format_t *format, drawing_t *d, const machine_t *machine,
                       const char *path);
/* The same from the beginning. */
void stroke_file_restart(stroke_file_t *f);
/* All is drawn: 0, or ERR_FILE with errno set. */
int stroke_file_end(stroke_file_t *f, drawing_t *d);
/* The drawing is given up; there is no file. */
void stroke_file_drop(stroke_file_t *f, drawing_t *d);

#endif
