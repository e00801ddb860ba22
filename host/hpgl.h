/* hpgl.h - the drawing for a Hewlett-Packard pen plotter (.hpgl, .plt).
 *
 * Plotter units of 1/40 mm from the lower left corner of the paper: `IN;SP1;`, for each stroke `PUx,y;PDx,y,x,y...;`,
 * and `PU0,0;SP0;` at the end. Points that fall on one unit are written once. A PD carries at most 32 points, for
 * plotters that buffer a command before they obey it. */
#ifndef HPGL_H
#define HPGL_H

#include "host/stroke_file.h"

extern const stroke_format_t HPGL_FORMAT;

#endif
