/* seg.h - the drawing as text, one line a segment, for programs that judge or reuse it.
 *
 *     # camera m00 m01 m02 m03 m10 ... m23      the 3x4 matrix, row by row, 17 digits
 *     x0 y0 x1 y1                               one line per pen-down segment, page mm, in drawing order
 *
 * The matrix takes (x, y, z, 1) to (X, Y, E); page mm are X / E and Y / E. Page x is to the right, y up, the origin the
 * lower left corner of the paper. Coordinates have 6 decimals, a sixtieth of the page lattice, so nothing of
 * what the program knows is lost. A segment that starts where the one before ended was drawn without lifting.
 * tests/unit/test_drawing.c prints what a line takes. */
#ifndef SEG_H
#define SEG_H

#include "host/stroke_file.h"

extern const stroke_format_t SEG_FORMAT;

#endif
