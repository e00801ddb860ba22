/* windows_pool.h - what windows.c and windows_close.c share. */
#ifndef WINDOWS_POOL_H
#define WINDOWS_POOL_H

#include "hidden/windows.h"

static inline int32_t windows_bin(const windows_t *w, int32_t a) {
    return (int32_t)(((int64_t)a + (INT64_C(1) << 30)) >> w->shift);
}

/* The ordinate of a line at x, within its range. */
static inline int32_t windows_line_at(const bands_line_t *s, int32_t x) {
    return pencil_ordinate(s->p, s->q, x);
}

/* The abscissa in [a0, a1] where a difference that goes from d0 to d1 changes its sign, rounded. */
static inline int32_t windows_crossing(int32_t a0, int32_t a1, int64_t d0, int64_t d1) {
    const uint64_t n = (uint64_t)(d0 < 0 ? -d0 : d0), m = (uint64_t)(d1 < 0 ? -d1 : d1);
    return n + m == 0 ? a0 : a0 + (int32_t)((n * (uint32_t)(a1 - a0) + (n + m) / 2) / (n + m));
}

/* Adds the window between lo and hi over [a0, a1], bin by bin, unless it is too low to show anything. */
int windows_insert(windows_t *w, int32_t a0, int32_t a1, const bands_line_t *lo, const bands_line_t *hi);

#endif
