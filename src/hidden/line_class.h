/* line_class.h - what a line of a drawing is: outlines, creases, hatching and so on, for pens and for leaving out.
 *
 * In a scene of solids the class of a piece is the number of its line space (ink_piece_t.surface), so it travels
 * with the ink and costs nothing. Kernels of solids know edges only; line_class_sink() sorts their pieces. */
#ifndef LINE_CLASS_H
#define LINE_CLASS_H

#include "hidden/ink.h"
#include <stdbool.h>

enum line_class {
    LINE_CREASE,     /* edges between two faces that are both seen; free lines; grids, profiles, curves */
    LINE_SILHOUETTE, /* where a body ends for the eye: one face looks at it and the other does not, or there is none */
    LINE_HIDDEN,     /* `dashed` */
    LINE_HATCH,
    LINE_SHADOW, /* borders of shadows */
    LINE_DETAIL, /* lines on faces */
    LINE_CLASSES
};

#define PENS_MAX 8 /* pens have numbers from 1 on */

struct solid_map; /* view/solid_map.h */

/* Is the edge (or one of its twins) an outline of its object? Cost: a determinant for each face. */
bool line_is_silhouette(const struct solid_map *m, int32_t edge);

typedef struct line_sorter {
    const struct solid_map *map;
    bool outline; /* creases are left out, but for those sharper than the `crease` of their object */
    bool hidden;  /* what comes is hidden: class LINE_HIDDEN */
    ink_sink_t next;
} line_sorter_t;

/* Gives pieces of INK_SEGMENT of surface 0 their class, and leaves creases of smooth surfaces out; others pass as they
 * are. s and its map outlive the sink. */
ink_sink_t line_class_sink(line_sorter_t *s);

#endif
