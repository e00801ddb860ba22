/* autoscale.h - the ranges of an autoscaled axis, rounded outward to whole tics as gnuplot does.
 *
 * A range that the user left open follows the data and then widens to the next multiple of the tic step, so
 * that a picture overlays gnuplot's (only if the axis has tics: `unset ztics` leaves the range as it is). The step is
 * 0.05, 0.1, 0.2, 0.5, 1, 2 or more times the power of ten below the span, chosen for roughly ten tics. An empty range
 * widens by 1 % of its value, or to [-1:1] at zero. */
#ifndef AUTOSCALE_H
#define AUTOSCALE_H

#include "lang/settings.h"

enum autoscale_tics {
    AUTOSCALE_NONE,
    AUTOSCALE_TICS,
    AUTOSCALE_LOG, /* of logarithms: whole numbers */
};

/* Those of axis k: 0 x, 1 y, 2 z. */
static inline enum autoscale_tics autoscale_tics(const settings_t *s, int k) {
    if (!(s->tics & SETTINGS_TICS_X << k)) return AUTOSCALE_NONE;
#if CONFIG_LOGSCALE
    if (s->log_axes >> k & 1) return AUTOSCALE_LOG;
#endif
    return AUTOSCALE_TICS;
}
/* The tic step for a span > 0; of logarithms at least 1. */
num_t autoscale_step(num_t span, bool log);
/* *lo and *hi: the data's ends going in, the axis's ends coming out. A fixed end of `set` is taken as it is.
 * Returns 0 or ERR_VALUE when the range cannot be used (lo >= hi with both ends fixed). */
int autoscale_range(const range_t *set, enum autoscale_tics tics, num_t *lo, num_t *hi);

#endif
