/* solid_rows.h - the rows of the section on solids, haloes and polygons: scenes, drawn, judged and timed. */
#ifndef REPORT_SOLID_ROWS_H
#define REPORT_SOLID_ROWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "tests/oracle/judge.h"
#include "view/page.h"

#define LAT_PER_STEP (LAT_PER_MM * JUDGE_STEP_MM)
#define ROWS 80

/* What one kernel did with one size of a family. NAN: not judged. Work, in the order of the columns:
 * convex: pairs compared, crossings, pieces; area sort: pairs clipped, pieces removed, visible polygons, sort errors;
 * halo: pairs computed, crossings, pieces; clipper: edges of the graph, crossings rounded, contours, sweeps. */
typedef struct row {
    const char *kernel, *family;
    int size;
    double per_step; /* units of the lattice */
    int64_t scenes, wrong, elements;
    double missing, falsely, end; /* steps */
    int64_t work[4];
    size_t bytes;
    double seconds;
} row_t;

extern row_t row[ROWS];
extern int rows;

/* Fills them: family by family in the order of size. quick: a few small scenes. */
void solid_rows_measure(bool quick);

/* Fills them with a few families of solids alone, for solid_bits.c. */
void solid_rows_bits(void);
/* And with haloes and the clipper, whose lattice is that of the page, at several numbers of bits. */
void solid_rows_page_bits(void);

#endif
