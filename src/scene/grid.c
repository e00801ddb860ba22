/* grid.c - heights as block-scaled integers.
 *
 * The scale must be the same whether the heights are cached or evaluated again, or a part with more memory would
 * draw another picture. Heights are therefore counted from the first defined point, which is known before any
 * other, and rounded down: rounding down commutes with a later halving of the scale, so the cache can start fine
 * and be coarsened in place whenever a height does not fit, and ends with the very numbers a second evaluation
 * gives. */
#include "scene/grid.h"
#include "config.h"
#include "error.h"
#include "num/num_fast.h"
#include "num/words.h"

#define Z_BITS 30 /* |zi| <= 2^30: sums and differences of two heights fit int32_t */
#define Z_LIMIT ((int32_t)1 << Z_BITS)

_Static_assert(Z_BITS + 1 < 32, "a difference of two heights must fit int32_t");

/* How far z is from the origin, in units of 2^*e: both are rounded down to 62 bits and subtracted. The difference of
 * two num_t would do, and normalise what is shifted to the grid's scale anyway: three times the work on a small core.
 */
static inline int64_t apart(num_t z, num_t origin, int32_t *e) {
    if (NUM_FAST_RARE(z.m == 0)) z.e = origin.e; /* it says nothing */
    if (NUM_FAST_RARE(origin.m == 0)) origin.e = z.e;
    int64_t a = z.m >> 1, b = origin.m >> 1;
    const int32_t d = z.e - origin.e;
    if (d > 0)
        b >>= d < 63 ? d : 63;
    else if (d < 0)
        a >>= d > -63 ? -d : 63;
    *e = (d > 0 ? z.e : origin.e) + 1;
    return a - b; /* below 2^63 */
}

/* Units in which d * 2^e fits: the smallest exponent x with |d| * 2^e < 2^(Z_BITS + x). d is not 0. */
static int32_t exponent_of(int64_t d, int32_t e) {
    return e + 64 - ints_clz64(ints_abs64(d)) - Z_BITS;
}

/* floor(d * 2^e / 2^exp), for exp >= exponent_of(d, e), or exp >= e. */
static inline int64_t units(int64_t d, int32_t e, int32_t exp) {
    const int32_t shift = exp - e;
    /* d is short: the rest was cancelled. Or it is 0, and e means nothing. */
    if (NUM_FAST_RARE(shift < 0)) return (int64_t)((uint64_t)d << (-shift & 63));
    return d >> (shift < 63 ? shift : 63);
}

/* The units of almost every height, in 2^exp: it is not 0, nor is the origin, and a unit is so large that the upper
 * word of the difference has it. False if it is another, or beyond the limit. */
static inline bool usual_units(num_t z, num_t origin, int32_t exp, int32_t *zi) {
    words_t a = words_sar(words_of((uint64_t)z.m), 1), b = words_sar(words_of((uint64_t)origin.m), 1);
    const int32_t d = z.e - origin.e;
    int32_t shift = exp - 33 - origin.e;
    if (CONFIG_64BIT) { /* which of them is larger cannot be guessed */
        const int32_t down = d < 0 ? -d : 0, up = d > 0 ? d : 0;
        a = words_sar(a, down < 63 ? down : 63);
        b = words_sar(b, up < 63 ? up : 63);
        shift -= up;
    } else if (d < 0) {
        a = words_sar_far(a, -d);
    } else if (d > 0) {
        b = words_sar_far(b, d);
        shift -= d;
    }
    if ((int32_t)(z.m >> 32) == 0 || (int32_t)(origin.m >> 32) == 0 || shift < 0) return false;
    *zi = (int32_t)words_hi(words_sub(a, b)) >> (shift < 31 ? shift : 31);
    return *zi > -Z_LIMIT && *zi < Z_LIMIT;
}

/* The height at a point, whatever the limits. */
static inline __attribute__((always_inline)) num_t raw(grid_t *g, int32_t i, int32_t j) {
    g->evaluated++;
    return g->src->z_of(g->src->ctx, i, j);
}

static __attribute__((noinline)) bool is_beyond(grid_t *g, num_t z) {
    bool below = g->has_lo && num_cmp(z, g->z_lo) < 0, above = g->has_hi && num_cmp(z, g->z_hi) > 0;
    g->below |= below;
    g->above |= above;
    return below || above;
}

/* What lies beyond the limits is a hole. */
static inline void limit(grid_t *g, num_t *z) {
    if ((g->has_lo || g->has_hi) && !z->undef && is_beyond(g, *z)) *z = num_undef();
}

static inline void evaluate(grid_t *g, int32_t i, int32_t j, num_t *z) {
    *z = raw(g, i, j);
    limit(g, z);
}

/* Columns i to i + n - 1 of row j, n <= CONFIG_ROW_POINTS. */
static inline void evaluate_row(grid_t *g, int32_t i, int32_t j, int32_t n, num_t *z) {
#if CONFIG_ROW_POINTS > 1
    if (g->src->z_row) {
        g->evaluated += n;
        g->src->z_row(g->src->ctx, i, j, n, z);
        for (int32_t k = 0; k < n; k++) limit(g, &z[k]);
        return;
    }
#endif
    for (int32_t k = 0; k < (CONFIG_ROW_POINTS > 1 ? n : 1); k++) evaluate(g, i + k, j, &z[k]);
}

static inline int32_t at_once(const grid_t *g, int32_t i) {
    return g->nx - i < CONFIG_ROW_POINTS ? g->nx - i : CONFIG_ROW_POINTS;
}

/* What is known of the heights so far, in units of 2^exp: that of the first is 0. */
typedef struct measure {
    int32_t exp, least, most;
    int32_t *cache, *at; /* the next one's place in it; NULL: no cache */
} measure_t;

static void coarsen(measure_t *m, int32_t by) {
    m->least >>= by;
    m->most >>= by;
    for (int32_t *c = m->cache; c != m->at; c++) {
        if (*c != GRID_HOLE) *c >>= by;
    }
}

/* The units of any height; the scale is made coarser if it does not fit. */
static __attribute__((noinline)) int32_t fitted_units(measure_t *m, num_t z, num_t origin) {
    int32_t e;
    const int64_t d = apart(z, origin, &e);
    int64_t u = m->exp >= e ? units(d, e, m->exp) : 0;
    if ((m->exp < e && d != 0) || u <= -Z_LIMIT || u >= Z_LIMIT) {
        const int32_t need = exponent_of(d, e);
        if (need > m->exp) {
            if (m->exp != INT16_MIN) coarsen(m, need - m->exp > 31 ? 31 : need - m->exp);
            m->exp = need;
        }
        u = units(d, e, m->exp);
    }
    return (int32_t)u;
}

static inline void measure_height(grid_t *g, measure_t *m, const num_t *height) {
    if (NUM_FAST_RARE(height->undef)) {
        g->holes++;
        if (m->at != NULL) *m->at++ = GRID_HOLE;
        return;
    }
    const num_t z = {height->m, height->e, false}; /* as it is, it would be copied as a whole */
    int32_t zi;
    if (NUM_FAST_RARE(!usual_units(z, g->z_origin, m->exp, &zi))) zi = fitted_units(m, z, g->z_origin);
    if (m->at != NULL) *m->at++ = zi;
    /* Rounding down keeps the order, so only a height in the units of an extreme can be beyond it. */
    if (zi <= m->least) {
        if (num_fast_cmp(z, g->z_min) < 0) g->z_min = *height;
        m->least = zi;
    }
    if (zi >= m->most) {
        if (num_fast_cmp(z, g->z_max) > 0) g->z_max = *height;
        m->most = zi;
    }
}

static void forget(grid_t *g) {
#if CONFIG_HEIGHTS > 0
    for (int k = 0; k < CONFIG_HEIGHTS; k++) g->known[k].zi = GRID_UNKNOWN;
#else
    (void)g;
#endif
}

int grid_measure(grid_t *g, const surface_t *src, const num_t *lo, const num_t *hi, int32_t *cache,
                 void (*tick)(void *ctx, int32_t done, int32_t of), void *tick_ctx) {
    bool any = false;
    measure_t m = {.exp = INT16_MIN, .cache = cache, .at = cache};
    if (src->nx > GRID_SIDE_MAX || src->ny > GRID_SIDE_MAX) return ERR_FULL;
    *g = (grid_t){.src = src, .nx = src->nx, .ny = src->ny, .cache = NULL, .has_lo = lo != NULL, .has_hi = hi != NULL};
    if (lo != NULL) g->z_lo = *lo;
    if (hi != NULL) g->z_hi = *hi;
    forget(g);
    num_t heights[CONFIG_ROW_POINTS];
    for (int32_t j = 0; j < g->ny; j++) {
        for (int32_t i = 0, n; i < g->nx; i += n) {
            n = at_once(g, i);
            evaluate_row(g, i, j, n, heights);
            for (int32_t k = 0; k < n; k++) {
                if (NUM_FAST_RARE(!any) && !heights[k].undef) {
                    any = true;
                    g->z_min = g->z_max = g->z_origin = heights[k];
                }
                measure_height(g, &m, &heights[k]);
            }
        }
        if (tick != NULL) tick(tick_ctx, j + 1, g->ny);
    }
    if (!any) return ERR_EMPTY;
    g->z_exp = (int16_t)(m.exp == INT16_MIN ? 0 : m.exp);
    g->cache = cache;
    return 0;
}

static inline bool scaled(const grid_t *g, num_t z, int32_t *zi) {
    if (z.undef) return false;
    if (usual_units(z, g->z_origin, g->z_exp, zi)) return true;
    int32_t e;
    const int64_t d = apart(z, g->z_origin, &e);
    *zi = (int32_t)units(d, e, g->z_exp);
    return true;
}

static bool evaluated(grid_t *g, int32_t i, int32_t j, int32_t *zi) {
    num_t z;
    evaluate(g, i, j, &z);
    return scaled(g, z, zi);
}

int32_t grid_row(grid_t *g, int32_t j, int32_t *zi, uint8_t *hole) {
    int32_t holes = 0;
    const int32_t *cached = g->cache ? g->cache + (int64_t)j * g->nx : NULL;
    num_t z[CONFIG_ROW_POINTS];
    for (int32_t i = 0, n = 0, k = 0; i < g->nx; i++, k++) {
        bool defined;
        if (cached) {
            zi[i] = cached[i];
            defined = cached[i] != GRID_HOLE;
        } else {
            if (CONFIG_ROW_POINTS == 1 || k == n) {
                n = at_once(g, i);
                k = 0;
                evaluate_row(g, i, j, n, z);
            }
            defined = scaled(g, z[k], &zi[i]);
        }
        if (!defined) {
            zi[i] = 0;
            holes++;
        }
        if (hole != NULL) hole[i] = !defined;
    }
    return holes;
}

#if CONFIG_HEIGHTS > 0
/* As evaluated. */
static bool remembered(grid_t *g, int32_t i, int32_t j, int32_t *zi) {
    grid_known_t *k = &g->known[(uint32_t)(i + 5 * j) % CONFIG_HEIGHTS];
    if (k->i != i || k->j != j || k->zi == GRID_UNKNOWN) {
        const bool defined = evaluated(g, i, j, zi);
        *k = (grid_known_t){(uint16_t)i, (uint16_t)j, defined ? *zi : GRID_HOLE};
    }
    *zi = k->zi;
    return k->zi != GRID_HOLE;
}
#else
#define remembered evaluated
#endif

bool grid_height(grid_t *g, int32_t i, int32_t j, int32_t *zi) {
    return g->cache == NULL ? remembered(g, i, j, zi) : grid_cached_height(g, i, j, zi);
}

/* Is v between the coordinates of points 0 and n - 1, or less than `by` beyond? */
static bool is_about(const surface_t *s, num_t (*of)(void *ctx, int32_t i), int32_t n, num_t v, num_t by) {
    return num_cmp(num_add(v, by), of(s->ctx, 0)) > 0 && num_cmp(num_sub(v, by), of(s->ctx, n - 1)) < 0;
}

bool grid_is_tall(const grid_t *g, const num_t eye[3]) {
    const surface_t *s = g->src;
    const num_t x = num_sub(s->x_of(s->ctx, g->nx - 1), s->x_of(s->ctx, 0));
    const num_t y = num_sub(s->y_of(s->ctx, g->ny - 1), s->y_of(s->ctx, 0));
    const num_t base = num_cmp(x, y) < 0 ? x : y, by = num_ldexp(base, -6);
    const bool inside = num_cmp(num_add(eye[2], by), g->z_min) > 0 && num_cmp(num_sub(eye[2], by), g->z_max) < 0 &&
                        is_about(s, s->x_of, g->nx, eye[0], by) && is_about(s, s->y_of, g->ny, eye[1], by);
    return num_cmp(num_sub(g->z_max, g->z_min), num_ldexp(base, inside ? -2 : 4)) > 0;
}

bool grid_value(grid_t *g, int32_t i, int32_t j, num_t *z) {
    evaluate(g, i, j, z);
    return !z->undef;
}

/* Where an edge from the height z to *far meets the limit that *far is beyond, which takes its place. */
static __attribute__((noinline)) int64_t meets_limit_q46(const grid_t *g, num_t z, num_t *far) {
    const num_t limit = g->has_lo && num_cmp(*far, g->z_lo) < 0 ? g->z_lo : g->z_hi;
    const int64_t s = num_to_fixed(num_div(num_sub(limit, z), num_sub(*far, z)), 46, NULL);
    *far = limit;
    return s < 0 ? 0 : s > (int64_t)1 << 46 ? (int64_t)1 << 46 : s;
}

bool grid_edge_limit(grid_t *g, const int32_t inside[2], const int32_t outside[2], num_t *limit, int64_t *s_q46) {
    const num_t z = raw(g, inside[0], inside[1]);
    *limit = raw(g, outside[0], outside[1]);
    if (z.undef || limit->undef) return false;
    *s_q46 = meets_limit_q46(g, z, limit);
    return true;
}
