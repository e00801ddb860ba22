/* area_plane.c - see area_plane.h. */
#include "hidden/area/area_plane.h"

#include "num/ints.h"

/* |a| = m 2^e with 63 bits in m. */
typedef struct scaled {
    uint64_t m;
    int e;
} scaled_t;

static scaled_t scaled(wide_t a) {
    if (wide_sign(a) < 0) a = wide_neg(a);
    if (a.hi == 0 && a.lo == 0) return (scaled_t){0, 0};
    int e = a.hi ? 64 - ints_clz64((uint64_t)a.hi) + 1 : 1 - ints_clz64(a.lo);
    return (scaled_t){e > 0 ? wide_sar(a, e).lo : wide_shl(a, -e).lo, e};
}

/* num / det in units of 2^-shift, to 2^-60 of itself. */
static wide_t quotient(wide_t num, wide_t det, int shift) {
    scaled_t n = scaled(num), d = scaled(det);
    uint64_t rest;
    if (n.m == 0) return (wide_t){0, 0};
    /* n.m < 2 d.m, so n.m / 4 d.m is below 1 */
    uint64_t q = wide_div_u64(n.m >> 2, n.m << 62, d.m, &rest);
    int e = n.e - d.e - 62 + shift;
    wide_t out = {0, (wide_u64_t)q};
    out = e >= 0 ? wide_shl(out, e > 63 ? 63 : e) : wide_sar(out, e < -64 ? 64 : -e);
    return wide_sign(num) == wide_sign(det) ? out : wide_neg(out);
}

static wide_t det(int64_t a, int64_t b, int64_t c, int64_t d) {
    return wide_sub(wide_mul_s64(a, d), wide_mul_s64(b, c));
}

/* c times a coordinate with AREA_FINE_BITS. */
static wide_t times_fine(wide_t c, int64_t at) {
    int32_t whole = (int32_t)(at >> AREA_FINE_BITS), rest = (int32_t)(at & ((1 << AREA_FINE_BITS) - 1));
    return wide_add(wide_times_s32(c, whole), wide_sar(wide_times_s32(c, rest), AREA_FINE_BITS));
}

bool area_plane_through(area_plane_t *p, const area_fine_t *a, const area_fine_t *b, const area_fine_t *c) {
    int64_t bx = b->x - a->x, by = b->y - a->y, bz = b->z - a->z;
    int64_t cx = c->x - a->x, cy = c->y - a->y, cz = c->z - a->z;
    wide_t whole = det(bx, by, cx, cy);
    if (wide_sign(whole) == 0) return false;
    p->cx = quotient(det(bz, by, cz, cy), whole, AREA_FINE_BITS + AREA_PLANE_BITS);
    p->cy = quotient(det(bx, bz, cx, cz), whole, AREA_FINE_BITS + AREA_PLANE_BITS);
    wide_t there = wide_add(times_fine(p->cx, a->x), times_fine(p->cy, a->y));
    p->c0 = wide_sub(wide_shl(wide_from_s64(a->z), AREA_PLANE_BITS), there);
    return true;
}

static uint64_t whole_of(wide_t c) {
    int64_t a = area_plane_round(c);
    return ints_abs64(a);
}

int64_t area_plane_slope(const area_plane_t *p) {
    uint64_t sum = whole_of(p->cx) + whole_of(p->cy) + 2;
    return sum > (uint64_t)1 << 62 ? (int64_t)1 << 62 : (int64_t)sum;
}

void area_plane_at_four(const area_plane_t *p, const poly_point_t at[4], int64_t out[4]) {
    int most = 0;
    for (int k = 0; k < 4; k++) {
        scaled_t s = scaled(area_plane_sum(p, at[k]));
        if (s.m != 0 && s.e > most) most = s.e;
    }
    for (int k = 0; k < 4; k++) out[k] = (int64_t)wide_sar(area_plane_sum(p, at[k]), most).lo / 4;
}

wide_t area_plane_at_fine(const area_plane_t *p, const area_fine_t *at) {
    wide_t sum = wide_add(p->c0, wide_add(times_fine(p->cx, at->x), times_fine(p->cy, at->y)));
    return wide_sar(sum, AREA_PLANE_BITS);
}
