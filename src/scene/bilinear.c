/* bilinear.c - see bilinear.h. */
#include "scene/bilinear.h"

/* The cell k, 0 <= k <= n - 2, with v between its ends, or the first or last one. */
static int32_t cell_of(const surface_t *s, num_t (*at)(void *, int32_t), int32_t n, num_t v) {
    int32_t lo = 0, hi = n - 2;
    while (lo < hi) {
        int32_t mid = lo + (hi - lo + 1) / 2;
        if (num_cmp(at(s->ctx, mid), v) <= 0)
            lo = mid;
        else
            hi = mid - 1;
    }
    return lo;
}

/* Where v lies in [a, b], 0 to 1; undefined if it is outside by more than 2^-40 of the way. */
static num_t fraction(num_t a, num_t b, num_t v) {
    const num_t zero = num_from_i64(0), one = num_from_i64(1), slack = num_ldexp(one, -40);
    num_t t = num_div(num_sub(v, a), num_sub(b, a));
    if (t.undef || num_cmp(t, num_neg(slack)) < 0 || num_cmp(t, num_add(one, slack)) > 0) return num_undef();
    return num_cmp(t, zero) < 0 ? zero : num_cmp(t, one) > 0 ? one : t;
}

static num_t mix(num_t a, num_t b, num_t t) {
    return num_add(a, num_mul(t, num_sub(b, a)));
}

num_t bilinear_at(const surface_t *s, num_t x, num_t y) {
    int32_t i = cell_of(s, s->x_of, s->nx, x), j = cell_of(s, s->y_of, s->ny, y);
    num_t u = fraction(s->x_of(s->ctx, i), s->x_of(s->ctx, i + 1), x);
    num_t v = fraction(s->y_of(s->ctx, j), s->y_of(s->ctx, j + 1), y);
    num_t near = mix(s->z_of(s->ctx, i, j), s->z_of(s->ctx, i + 1, j), u);
    num_t far = mix(s->z_of(s->ctx, i, j + 1), s->z_of(s->ctx, i + 1, j + 1), u);
    return mix(near, far, v);
}
