/* autoscale.h - the ranges of an autoscaled axis, rounded outward to whole tics as gnuplot does.
 *
 * A range that the user left open follows the data and then widens to the next multiple of the tic step, so
 * that a picture overlays gnuplot's (only if the axis has tics: `unset ztics` leaves the range as it is). The step is
 * 0.05, 0.1, 0.2, 0.5, 1, 2 or more times the power of ten below the span, chosen for roughly ten tics. An empty range
 * widens by 1 % of its value, or to [-1:1] at zero. */
#ifndef AUTOSCALE_H
#define AUTOSCALE_H

#include "lang/settings.h"

/* The tic step for a span > 0. */
num_t autoscale_step(num_t span);
/* *lo and *hi: the data's ends going in, the axis's ends coming out. A fixed end of `set` is taken as it is.
 * Returns 0 or ERR_VALUE when the range cannot be used (lo >= hi with both ends fixed). */
int autoscale_range(const range_t *set, bool tics, num_t *lo, num_t *hi);

#endif
