/* naive.h - a drawing as it is usually done: a floating horizon of heights in columns of pixels.
 *
 * Rows are taken from the side of the eye, nearer first; two arrays of single-precision numbers hold the highest and
 * the lowest ordinate drawn in each of NAIVE_COLUMNS columns of the page (T. J. Wright 1973, and programs since). What
 * the report sets beside ours, not a reference for anything. */
#ifndef NAIVE_H
#define NAIVE_H

#include "tests/oracle/run_kernel.h"

#define NAIVE_COLUMNS 1024

/* Draws s into d. */
void naive_draw(const scene_t *s, run_drawing_t *d);

#endif
