/* curve.h - what a flat curve is to the rest of the program: points that can be asked for, in any order and again.
 *
 * Abscissae of functions increase, those of data may go any way. A point with an undefined y interrupts the curve. */
#ifndef CURVE_H
#define CURVE_H

#include "num/num.h"

typedef struct curve {
    int32_t n;                           /* points, >= 2 */
    void *ctx;                           /* the source's own; outlives the curve */
    num_t (*x_of)(void *ctx, int32_t i); /* 0 <= i < n, always defined */
    num_t (*y_of)(void *ctx, int32_t i); /* undefined: a gap */
} curve_t;

#endif
