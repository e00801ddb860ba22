/* svg.h - the drawing as a vector picture (.svg) that browsers and Inkscape open at its true size.
 *
 * Millimetres, the paper's size as width, height and viewBox, the title as <title>, one <path> a stroke in drawing
 * order, so that plotter software keeps that order. Lines are 0.3 mm wide, black, with round caps and joins.
 * Coordinates have 3 decimals (0.5 um). Written by hand (7 ns a segment) rather than by Cairo's SVG surface (694 ns,
 * and 1.6 times the bytes). */
#ifndef SVG_H
#define SVG_H

#include "host/stroke_file.h"

extern const stroke_format_t SVG_FORMAT;

#endif
