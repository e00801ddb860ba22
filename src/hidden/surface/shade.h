/* shade.h - what one surface hides of another's edge over the same grid edge, in a vertical plane through the eye.
 *
 *      z |     .k    k: the edge at hand, m: the other surface's above or below it. In their common vertical plane
 *        |   .'/     a point of k is hidden by what of m is nearer to the eye: by m from its near end as far as the
 *        | .' / m    point that is above or below the point of k. Both conditions are signs of linear functions of
 *      E |   /       the way along the edge, so what is hidden is one interval.
 *        +------- distance
 *
 * The whole facet of m would hide too much: to either side of the plane it also covers what lies farther away. */
#ifndef SHADE_H
#define SHADE_H

#include "view/pencil.h"

/* An interval of an edge; from >= to: nothing. */
typedef struct shade {
    int32_t from_q30, to_q30;
} shade_t;

/* Edge k and edge m as lines of one chart, [0] the near end. In fractions of the chart, from the near end. */
shade_t shade_in_chart(const pencil_t k[2], const pencil_t m[2]);

/* The same in space: heights relative to the eye, |z| < 2^60, `noise` apart they touch; and distances from the eye in
 * plan, 0 <= d[0] < d[1] < 2^30. In fractions of the edge, from the near end. */
shade_t shade_in_space(const int64_t k_z[2], const int64_t m_z[2], const int32_t d[2], int64_t noise);

#endif
