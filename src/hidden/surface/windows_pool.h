/* windows_pool.h - what windows.c and windows_close.c share. */
#ifndef WINDOWS_POOL_H
#define WINDOWS_POOL_H

#include "hidden/surface/windows.h"

static inline int32_t windows_bin(const windows_t *w, int32_t a) {
    return (int32_t)(((int64_t)a + (INT64_C(1) << 30)) >> w->shift);
}

static inline int32_t windows_level(int32_t v) {
    return (int32_t)(((int64_t)v + (INT64_C(1) << 30)) >> (31 - WINDOWS_LEVEL_BITS));
}

static inline int32_t windows_band(const windows_t *w, int32_t v) {
    if (CONFIG_64BIT && w->band_of != NULL) return w->band_of[windows_level(v)];
    return windows_level(v) / (WINDOWS_LEVELS / WINDOWS_BANDS);
}

/* Lists of a bin that may hold windows from low to high: 0, and then from first to last. */
typedef struct windows_lists {
    int32_t *of; /* the bin's */
    int32_t first, last;
} windows_lists_t;

static inline windows_lists_t windows_lists(const windows_t *w, int32_t bin, int32_t low, int32_t high) {
    int32_t *of = w->list + bin * (1 + w->bands);
    if (w->bands == 0) return (windows_lists_t){of, 1, 0};
    const int32_t first = windows_band(w, low);
    return (windows_lists_t){of, first == 0 ? 1 : first, 1 + windows_band(w, high)};
}

/* The list after list k, more than l->last after the last one. */
static inline int32_t windows_next_list(const windows_lists_t *l, int32_t k) {
    return k == 0 ? l->first : k + 1;
}

/* The list of a window: that of the band where it begins; 0 if it reaches beyond the next one. */
static inline int32_t *windows_list_of(const windows_t *w, int32_t bin, int32_t low, int32_t high) {
    int32_t *of = w->list + bin * (1 + w->bands);
    if (w->bands == 0) return of;
    const int32_t first = windows_band(w, low);
    return windows_band(w, high) <= first + 1 ? &of[1 + first] : of;
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
