/* report.h - what a page took: for people as a row of a table, for programs as JSON.
 *
 * JSON: {"program", "version", "scene", "pages": [...]}, an object a page; docs/CLI.md lists its members. */
#ifndef REPORT_H
#define REPORT_H

#include <stdio.h>

#include "app/picture.h"
#include "host/drawing.h"
#include "motion/motion.h"

typedef struct report {
    int page;         /* 1 first */
    const char *name; /* of the scene, for the table */
    const char *title;
    const char *const *file; /* written for this page; NULL ends the list */
    picture_stats_t picture;
    motion_stats_t motion; /* of the plan on this machine; all 0 when machine_error is set */
    int machine_error;
    size_t points; /* of the drawing: one more than segments in every stroke */
    size_t strokes;
    drawing_length_t length;
    double measure_s, hide_s, order_s, write_s; /* wall clock */
    size_t path_bytes;                          /* needed to join and order the ink */
    size_t data_bytes;                          /* lent for data and used */
    size_t lent_bytes;                          /* lent to the picture */
} report_t;

void report_table_head(FILE *f);
void report_table_row(FILE *f, const report_t *r);

void report_json_begin(FILE *f, const char *scene);
void report_json_page(FILE *f, const report_t *r);
void report_json_end(FILE *f);

#endif
