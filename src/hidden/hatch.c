/* hatch.c - see hatch.h. */
#include "hidden/hatch.h"

#include "error.h"
#include "num/func.h"
#include "num/ints.h"

#define FRAC_BITS 26
#define CROSSINGS 64 /* of one line with the borders of one polygon; with more the polygon is hatched in parts */

/* A place on line `line`, in homogeneous page coordinates. */
static bool lines_at(void *ctx, uint8_t family, int32_t line, int64_t t_q30, page_h_t *out) {
    const hatch_t *h = ctx;
    (void)family;
    int32_t each = 2 * h->half + 1, k = line % each - h->half;
    bool second = line >= each;
    int64_t reach = (int64_t)h->reach_lat << FRAC_BITS, u = ints_muldiv_round(2 * reach, t_q30, INK_ONE) - reach;
    int64_t w = (int64_t)k * h->pitch_lat * ((int64_t)1 << FRAC_BITS);
    int64_t c = second ? -h->sin_q30 : h->cos_q30, s = second ? h->cos_q30 : h->sin_q30;
    out->x =
        ((int64_t)h->middle.x_lat << FRAC_BITS) + ints_muldiv_round(u, c, INK_ONE) - ints_muldiv_round(w, s, INK_ONE);
    out->y =
        ((int64_t)h->middle.y_lat << FRAC_BITS) + ints_muldiv_round(u, s, INK_ONE) + ints_muldiv_round(w, c, INK_ONE);
    out->e = (int64_t)1 << FRAC_BITS;
    return true;
}

void hatch_setup(hatch_t *h, const page_window_t *window, num_t degrees, int32_t pitch_lat) {
    int64_t wide = (int64_t)window->x1_lat - window->x0_lat, high = (int64_t)window->y1_lat - window->y0_lat;
    *h = (hatch_t){.pitch_lat = pitch_lat};
    h->lines = (line_space_t){.ctx = h, .at = lines_at, .window = window, .frac_bits = FRAC_BITS};
    h->middle = (page_point_t){window->x0_lat + (int32_t)(wide / 2), window->y0_lat + (int32_t)(high / 2)};
    h->cos_q30 = (int32_t)num_to_fixed(func_sin_degrees(num_add(degrees, num_from_i64(90))), 30, NULL);
    h->sin_q30 = (int32_t)num_to_fixed(func_sin_degrees(degrees), 30, NULL);
    h->reach_lat = (int32_t)ints_sqrt_u64((uint64_t)(wide * wide + high * high)) / 2 + 2;
    h->half = h->reach_lat / pitch_lat;
}

int32_t hatch_lines(const hatch_t *h) {
    return 2 * (2 * h->half + 1);
}

hatch_place_t hatch_place(const hatch_t *h, bool second, poly_point_t p) {
    int64_t x = p.x - ((int64_t)h->middle.x_lat << h->bits), y = p.y - ((int64_t)h->middle.y_lat << h->bits);
    int64_t c = second ? -h->sin_q30 : h->cos_q30, s = second ? h->cos_q30 : h->sin_q30;
    return (hatch_place_t){c * x + s * y, c * y - s * x};
}

int64_t hatch_line_at(const hatch_t *h, int32_t k) {
    return (int64_t)k * h->pitch_lat * ((int64_t)1 << (h->bits + 30));
}

int32_t hatch_number(const hatch_t *h, bool second, int32_t k) {
    return k + h->half + (second ? 2 * h->half + 1 : 0);
}

bool hatch_cross(const hatch_t *h, hatch_place_t a, hatch_place_t b, int64_t at, int32_t *t_q30, int32_t *part_q30) {
    if ((a.w > at) == (b.w > at)) return false;
    const int64_t reach = (int64_t)h->reach_lat << (h->bits + 30), to = at / 2 - a.w / 2, all = b.w / 2 - a.w / 2;
    int64_t u = a.u / 2 + ints_muldiv_round(b.u / 2 - a.u / 2, to, all);
    int64_t q = ints_muldiv_round(u + reach / 2, INK_ONE, reach);
    *t_q30 = (int32_t)(q < 0 ? 0 : q > INK_ONE ? INK_ONE : q);
    if (part_q30) *part_q30 = (int32_t)ints_muldiv_round(INK_ONE, to, all);
    return true;
}

/* Where a line crosses the borders, sorted, as parameters. Returns how many, or ERR_FULL. */
static int32_t crossings(const hatch_t *h, bool second, const poly_t *p, int64_t at, int32_t t[CROSSINGS]) {
    int32_t n = 0;
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++]) {
        hatch_place_t a = hatch_place(h, second, p->v[p->end[c] - 1].at);
        for (int32_t i = first; i < p->end[c]; i++) {
            hatch_place_t b = hatch_place(h, second, p->v[i].at);
            int32_t q;
            if (hatch_cross(h, a, b, at, &q, NULL)) {
                if (n == CROSSINGS) return ERR_FULL;
                int32_t j = n++;
                for (; j > 0 && t[j - 1] > q; j--) t[j] = t[j - 1];
                t[j] = q;
            }
            a = b;
        }
    }
    return n;
}

void hatch_range(const hatch_t *h, int64_t low, int64_t high, int32_t *lo, int32_t *hi) {
    const int64_t pitch = hatch_line_at(h, 1);
    *lo = (int32_t)(low / pitch) - 1;
    *hi = (int32_t)(high / pitch) + 1;
    if (*lo < -h->half) *lo = -h->half;
    if (*hi > h->half) *hi = h->half;
}

static int add_family(const hatch_t *h, const poly_t *p, bool second, int32_t step, int32_t first, intervals_t *to) {
    int32_t lo, hi, t[CROSSINGS];
    int64_t low = INT64_MAX, high = INT64_MIN;
    for (int32_t i = 0; i < poly_vertices(p); i++) {
        int64_t w = hatch_place(h, second, p->v[i].at).w;
        low = w < low ? w : low;
        high = w > high ? w : high;
    }
    hatch_range(h, low, high, &lo, &hi);
    for (int32_t k = lo; k <= hi; k++) {
        if (k & (step - 1)) continue;
        int32_t n = crossings(h, second, p, hatch_line_at(h, k), t), line = first + hatch_number(h, second, k);
        if (n < 0) return n;
        for (int32_t i = 0; i + 1 < n; i += 2) {
            int err = intervals_add(to, line, t[i], t[i + 1]);
            if (err) return err;
        }
    }
    return 0;
}

int hatch_polygon(const hatch_t *h, const poly_t *p, enum hatch_tone tone, int32_t first, intervals_t *to) {
    int err = 0;
    for (int second = 0; second < 2 && !err && p->contours; second++) {
        int32_t step = hatch_step(tone, second);
        if (step) err = add_family(h, p, second, step, first, to);
    }
    return err;
}
