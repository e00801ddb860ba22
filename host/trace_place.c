/* trace_place.c - a least-squares parabola through four steps before a gap and four behind it. See trace_place.h. */
#include "host/trace_place.h"

#include <math.h>

enum { BESIDE = 4 };       /* steps on either side */
#define RATIO 6            /* how much farther off than the worst of its neighbours */
#define LEAST_FIT 0.005    /* steps: no parabola is trusted more than this */
#define GAP_STEPS 0.15     /* steps, besides what a corner in the gap could do */
#define INTERVAL_MAX_S .02 /* slower steps tell nothing */

typedef struct parabola {
    double c[3], middle_s, span_s;
} parabola_t;

static double at(const parabola_t *p, double time_s) {
    double t = (time_s - p->middle_s) / p->span_s;
    return p->c[0] + t * (p->c[1] + t * p->c[2]);
}

/* The index of the i-th of the steps beside a gap that begins at `first`. */
static size_t beside(size_t first, int gap, int i) {
    return i < BESIDE ? first - BESIDE + (size_t)i : first + (size_t)gap + (size_t)(i - BESIDE);
}

/* Fits pos over time by the normal equations; time is centred and scaled to [-1, 1], so they are well conditioned. */
static parabola_t fit(const trace_knots_t *k, size_t first, int gap) {
    double begin = k->time_s[beside(first, gap, 0)], end = k->time_s[beside(first, gap, 2 * BESIDE - 1)];
    parabola_t p = {.middle_s = (begin + end) / 2, .span_s = (end - begin) / 2};
    double base = k->pos[beside(first, gap, 0)], s[5] = {0}, b[3] = {0};
    for (int i = 0; i < 2 * BESIDE; i++) {
        size_t n = beside(first, gap, i);
        double t = (k->time_s[n] - p.middle_s) / p.span_s, y = k->pos[n] - base, power = 1;
        for (int j = 0; j < 5; j++, power *= t) {
            s[j] += power;
            if (j < 3) b[j] += power * y;
        }
    }
    double m[3][4] = {{s[0], s[1], s[2], b[0]}, {s[1], s[2], s[3], b[1]}, {s[2], s[3], s[4], b[2]}};
    for (int i = 0; i < 3; i++) {
        for (int r = i + 1; r < 3; r++) {
            double f = m[r][i] / m[i][i];
            for (int c = i; c < 4; c++) m[r][c] -= f * m[i][c];
        }
    }
    for (int i = 2; i >= 0; i--) {
        p.c[i] = m[i][3];
        for (int c = i + 1; c < 3; c++) p.c[i] -= m[i][c] * p.c[c];
        p.c[i] /= m[i][i];
    }
    p.c[0] += base;
    return p;
}

/* Are the steps around the gap of one direction, and none of them slow? */
static bool is_even(const trace_knots_t *k, size_t first, int gap) {
    size_t from = first - BESIDE, to = first + (size_t)gap + BESIDE - 1;
    if (fabs(k->pos[to] - k->pos[from]) != (double)(to - from)) return false;
    for (size_t n = from; n < to; n++) {
        double wait = k->time_s[n + 1] - k->time_s[n];
        if (wait > INTERVAL_MAX_S) return false;
    }
    return k->time_s[to] > k->time_s[from];
}

/* How long the worst of the steps in the gap is off, or 0 if that may be so. */
static double off(const trace_knots_t *k, size_t first, int gap, double mm, double accel, double jump) {
    if (!is_even(k, first, gap)) return 0;
    parabola_t p = fit(k, first, gap);
    double worst = 0, outside = LEAST_FIT, speed = fabs(p.c[1]) / p.span_s; /* steps/s */
    for (int i = 0; i < gap; i++)
        worst = fmax(worst, fabs(k->pos[first + (size_t)i] - at(&p, k->time_s[first + (size_t)i])));
    for (int i = 0; i < 2 * BESIDE; i++) {
        size_t n = beside(first, gap, i);
        outside = fmax(outside, fabs(k->pos[n] - at(&p, k->time_s[n])));
    }
    double least = TRACE_PLACE_STEPS;
    if (gap > 1) {
        double lasts = k->time_s[first + (size_t)gap] - k->time_s[first - 1];
        least = GAP_STEPS + (jump + accel * M_SQRT2 * lasts) * lasts / 4 / mm;
    }
    return worst > least && worst > RATIO * outside && speed > 0 ? worst / speed : 0;
}

trace_place_t trace_place(const trace_knots_t *k, double mm, double accel_mm_s2, double jump_mm_s) {
    trace_place_t found = {0};
    for (size_t n = BESIDE; n + BESIDE < k->count; n++) {
        double by = 0;
        int gap = 0;
        while (by <= 0 && ++gap <= TRACE_PLACE_GAP && n + (size_t)gap + BESIDE <= k->count)
            by = off(k, n, gap, mm, accel_mm_s2, jump_mm_s);
        if (by <= 0) continue;
        if (!found.count++) {
            found.at_s = k->time_s[n];
            found.off_s = by;
        }
        n += (size_t)gap + BESIDE; /* its neighbours' neighbours are disturbed, too */
    }
    return found;
}
