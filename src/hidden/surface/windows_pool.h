/* windows_pool.h - what windows.c and windows_close.c share. */
#ifndef WINDOWS_POOL_H
#define WINDOWS_POOL_H

#include "hidden/surface/windows.h"

static inline int32_t windows_bin(const windows_t *w, int32_t a) {
    return (int32_t)(((int64_t)a + (INT64_C(1) << 30)) >> w->shift);
}

#define WINDOWS_BAND_SHIFT 26 /* an ordinate's band is (w + 2^30) >> that */
_Static_assert((INT64_C(1) << 31) >> WINDOWS_BAND_SHIFT == WINDOWS_BANDS, "bands cover all ordinates");

static inline int32_t windows_band(int32_t v) {
    return (int32_t)(((int64_t)v + (INT64_C(1) << 30)) >> WINDOWS_BAND_SHIFT);
}

/* Lists of a bin that may hold windows from low to high: 0, and then from first to last. */
typedef struct windows_lists {
    int32_t *of; /* the bin's */
    int32_t first, last;
} windows_lists_t;

static inline windows_lists_t windows_lists(const windows_t *w, int32_t bin, int32_t low, int32_t high) {
    int32_t *of = w->list + bin * (1 + w->bands);
    if (w->bands == 0) return (windows_lists_t){of, 1, 0};
    return (windows_lists_t){of, 1 + windows_band(low), 1 + windows_band(high)};
}

/* The list after list k, more than l->last after the last one. */
static inline int32_t windows_next_list(const windows_lists_t *l, int32_t k) {
    return k == 0 ? l->first : k + 1;
}

/* The list of a window. */
static inline int32_t *windows_list_of(const windows_t *w, int32_t bin, int32_t low, int32_t high) {
    const windows_lists_t l = windows_lists(w, bin, low, high);
    return l.first == l.last ? &l.of[l.first] : &l.of[0];
}

/* The ordinate of a line at x, within its range. */
static inline int32_t windows_line_at(const outline_line_t *s, int32_t x) {
    return pencil_ordinate(s->p, s->q, x);
}

/* The abscissa in [a0, a1] where a difference that goes from d0 to d1 changes its sign, rounded. */
static inline int32_t windows_crossing(int32_t a0, int32_t a1, int64_t d0, int64_t d1) {
    const uint64_t n = (uint64_t)(d0 < 0 ? -d0 : d0), m = (uint64_t)(d1 < 0 ? -d1 : d1);
    return n + m == 0 ? a0 : a0 + (int32_t)((n * (uint32_t)(a1 - a0) + (n + m) / 2) / (n + m));
}

/* Adds the window between lo and hi over [a0, a1], bin by bin, unless it is too low to show anything. */
int windows_insert(windows_t *w, int32_t a0, int32_t a1, const outline_line_t *lo, const outline_line_t *hi);

#endif
