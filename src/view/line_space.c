/* line_space.c - see line_space.h. */
#include "view/line_space.h"

#include "num/ints.h"
#include "num/wide.h"
#include <string.h>

#define CLAMP_LAT 256 /* a rounded cut may fall outside of the window by this much, half a step */

/* The difference is taken in two halves of 30 bits, so that each product fits. */
static int64_t lerp(int64_t a, int64_t b, int32_t s_q30) {
    int64_t d = b - a;
    return a + (d >> 30) * s_q30 + (((d & (INK_ONE - 1)) * s_q30) >> 30);
}

page_h_t line_space_mix(const page_h_t *a, const page_h_t *b, int32_t s_q30) {
    return (page_h_t){lerp(a->x, b->x, s_q30), lerp(a->y, b->y, s_q30), lerp(a->e, b->e, s_q30)};
}

static int64_t lerp_fine(int64_t a, int64_t b, int64_t s_q46) {
    return a + (int64_t)wide_sar(wide_mul_s64(b - a, s_q46), INK_GRID_BITS).lo;
}

page_h_t line_space_mix_fine(const page_h_t *a, const page_h_t *b, int64_t s_q46) {
    return (page_h_t){lerp_fine(a->x, b->x, s_q46), lerp_fine(a->y, b->y, s_q46), lerp_fine(a->e, b->e, s_q46)};
}

static inline int64_t div_nearest(int64_t n, int64_t d) {
    return (n + (n < 0 ? -(d >> 1) : d >> 1)) / d;
}

int64_t line_space_share(int64_t u, int64_t w, int64_t e0, int64_t e1, int64_t way) {
    while ((e0 | e1) >> 31 != 0) e0 >>= 1, e1 >>= 1;
    const int64_t before = u * e0, all = before + w * e1;
    return all == 0 ? 0 : ints_muldiv_round(way, before, all);
}

page_point_t line_space_divide(const line_space_t *s, const page_h_t *h) {
    if (s->perspective) return (page_point_t){(int32_t)div_nearest(h->x, h->e), (int32_t)div_nearest(h->y, h->e)};
    int64_t half = (int64_t)1 << (s->frac_bits - 1);
    return (page_point_t){(int32_t)((h->x + half) >> s->frac_bits), (int32_t)((h->y + half) >> s->frac_bits)};
}

/* As one, as it will be read: what is read in larger pieces than it was written is waited for. */
static inline void put(page_point_t *out, page_point_t p) {
#if CONFIG_64BIT && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    const uint64_t both = (uint64_t)(uint32_t)p.y_lat << 32 | (uint32_t)p.x_lat;
    memcpy(out, &both, sizeof both);
#else
    *out = p;
#endif
}

static int32_t clamp(int32_t v, int32_t lo, int32_t hi) {
    return v < lo ? lo : v > hi ? hi : v;
}

static bool is_near(int32_t a, int32_t b) {
    int64_t d = (int64_t)a - b;
    return d >= -CLAMP_LAT && d <= CLAMP_LAT;
}

static __attribute__((noinline)) bool exact_divide(const num_t h[3], page_point_t *out) {
    bool fits = true;
    const int64_t x = num_to_fixed(num_div(h[0], h[2]), 0, &fits), y = num_to_fixed(num_div(h[1], h[2]), 0, &fits);
    const int64_t most = 1 << 25; /* beyond any paper */
    if (!fits || x > most || x < -most || y > most || y < -most) return false;
    *out = (page_point_t){(int32_t)x, (int32_t)y};
    return true;
}

/* A point close to the eye. Apart from line_space_point and from what follows, as little of the stack may be left where
 * it is evaluated. */
static __attribute__((noinline)) bool exact_point(const line_space_t *s, uint8_t family, int32_t line, int64_t t,
                                                  page_point_t *out) {
    num_t h[3];
    return s->exact(s->ctx, family, line, t, h) && num_sign(h[2]) > 0 && exact_divide(h, out);
}

/* Where what `at` has said of t is. */
static inline bool point_of(const line_space_t *s, uint8_t family, int32_t line, int64_t t, const page_h_t *h,
                            page_point_t *out) {
    if (line_space_is_close(s, h->e)) {
        if (!exact_point(s, family, line, t, out)) return false;
    } else {
        /* where a line was cut at near_e, E is that but for its rounding */
        if (h->e < s->near_e - (s->near_e >> 8)) return false;
        put(out, line_space_divide(s, h));
    }
    if (s->all_inside) return true;
    page_point_t free = *out;
    out->x_lat = clamp(free.x_lat, s->window->x0_lat, s->window->x1_lat);
    out->y_lat = clamp(free.y_lat, s->window->y0_lat, s->window->y1_lat);
    return is_near(free.x_lat, out->x_lat) && is_near(free.y_lat, out->y_lat);
}

bool line_space_point(const line_space_t *s, uint8_t family, int32_t line, int64_t t, page_point_t *out) {
    page_h_t h;
    return s->at(s->ctx, family, line, t, &h) && point_of(s, family, line, t, &h, out);
}

#if CONFIG_FETCH
bool line_space_span(const line_space_t *s, uint8_t family, int32_t line, int64_t from, int64_t to,
                     page_point_t out[2]) {
    page_h_t h[2];
    if (!s->span || !s->span(s->ctx, family, line, from, to, h))
        return line_space_point(s, family, line, from, &out[0]) && line_space_point(s, family, line, to, &out[1]);
    return point_of(s, family, line, from, &h[0], &out[0]) && point_of(s, family, line, to, &h[1], &out[1]);
}
#endif
