/* area_border.h - lines on the page that are no edges of the scene: borders of shadows, kept as pairs of points.
 *
 * They come out of the clipper as borders of what a light does not reach of a visible polygon, so each is there once,
 * but for three things that this file takes care of: the cracks of a unit or so that rounding leaves between polygons
 * that were lit side by side, or along the edge of the face, whose two sides run against each other; and what is given
 * twice because a window of the screen subdivision was begun again.
 *
 * Error: a shadow narrower than a hundredth of a step has no borders. Where one narrows to that, its borders end; that
 * may be a sixteenth of a step elsewhere where a window cuts it there. */
#ifndef AREA_BORDER_H
#define AREA_BORDER_H

#include "poly/poly.h"
#include "view/line_space.h"
#include <stddef.h>

/* Windows of the screen subdivision overlap by so much, more than a crack: the border of a shadow along the side of one
 * is in the midst of the next. */
#define BORDERS_OVERLAP_LAT 8

typedef struct border {
    poly_point_t end[2]; /* on the page, in units of 2^-bits lat */
} border_t;

typedef struct borders {
    border_t *list; /* lent */
    int32_t n, n_max;
    int bits;
    line_space_t lines; /* of family INK_CURVE, line = number in the list, parameter 0 to INK_ONE */
} borders_t;

/* mem: aligned to 4, in use as long as lines of the space are drawn. The window outlives b. */
void borders_init(borders_t *b, void *mem, size_t bytes, const page_window_t *window);
/* Adds the edges of p whose tag is `tag`, but for what runs back along another edge of p. Returns 0 or ERR_FULL. Cost:
 * edges times edges with that tag. */
int borders_add(borders_t *b, const poly_t *p, int32_t tag);
/* Of what was added from number `from` on, joins what windows cut (area_tone.h): lines that go on straight where
 * another ends. Then it drops what is too short to be told from a crack. Cost: its square. */
void borders_join(borders_t *b, int32_t from);
/* Drops what lies on another: to be called once all are there. Cost: pairs that overlap along x. */
void borders_settle(borders_t *b);

#endif
