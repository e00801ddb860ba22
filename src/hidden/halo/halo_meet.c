/* halo_meet.c - see halo_meet.h. */
#include "hidden/halo/halo_meet.h"

#include "num/ints.h"

#define ONE_Q30 (INT64_C(1) << 30)

static uint64_t size64(int64_t v) {
    return ints_abs64(v);
}

static uint64_t size_of_sum(int32_t x, int32_t y) {
    return size64(x) + size64(y);
}

/* The length of an edge on the page as length / 2^*half, 32 bits of it and within 2^-27. */
static uint32_t length_of(const halo_edge_t *e, int *half) {
    const int32_t x = e->q.x - e->p.x, y = e->q.y - e->p.y;
    const uint64_t square = (uint64_t)(wide_mul_s32(x, x) + wide_mul_s32(y, y));
    const int shift = ints_clz64(square) & ~1;
    const uint32_t top = (uint32_t)(square << shift >> 32);
    *half = shift / 2;
    return (uint32_t)(wide_mul_u32(top, ints_rsqrt(top)) >> 30);
}

/* The sign of z of a minus z of b where they cross, or 0 if that is too close to call: with an error of `contact` units
 * in each coordinate of the ends, the volume V = of * (z_a - z_b) changes by less than 2 contact (of + |dz_a| (|dx_b| +
 * |dy_b|) + |dz_b| (|dx_a| + |dy_a|)) to first order. */
static int order(const halo_edge_t *a, const halo_edge_t *b, const halo_meeting_t *m, int32_t contact) {
    const int32_t za = a->q.z - a->p.z, zb = b->q.z - b->p.z;
    wide_t v = wide_mul_s64(m->of, a->p.z - b->p.z);
    v = wide_add(v, wide_mul_s64(m->a, za));
    v = wide_sub(v, wide_mul_s64(m->b, zb));
    /* of < 2^61, products < 2^29 2^31, contact 2^16 */
    const uint64_t change = (uint64_t)m->of + size64(za) * size_of_sum(b->q.x - b->p.x, b->q.y - b->p.y) +
                            size64(zb) * size_of_sum(a->q.x - a->p.x, a->q.y - a->p.y);
    const wide_u_t most = wide_mul_u64_u32(change, 2 * (uint32_t)contact);
    const wide_t size = v.hi < 0 ? wide_neg(v) : v;
    if (wide_cmp(size, (wide_t){(int64_t)most.hi, most.lo}) <= 0) return 0;
    return v.hi < 0 ? -1 : 1;
}

static int log2_of(uint64_t v) {
    return 63 - ints_clz64(v);
}

/* The power of two below the width from which on the strip ends before its sides do, for an angle below 45 degrees:
 * W / tan = distance to the end + W. 31 for never. `part` of 2^32 is where the nearer edge is crossed. */
static uint32_t width_free(const halo_edge_t *far, const halo_edge_t *near, uint64_t of, uint32_t length,
                           uint32_t part) {
    const int64_t dot = wide_mul_s32(far->q.x - far->p.x, near->q.x - near->p.x) +
                        wide_mul_s32(far->q.y - far->p.y, near->q.y - near->p.y);
    const uint64_t along = size64(dot);
    if (along <= of) return 31;
    const uint32_t least = part >> 31 ? ~part : part;
    const uint64_t distance = wide_mul_u32(length, least) >> 32;
    if (distance == 0) return 0;
    const int bits = log2_of(distance) + log2_of(of) - log2_of(along - of) - 1;
    return bits < 0 ? 0 : bits > 31 ? 31 : (uint32_t)bits;
}

static void note(halo_t *h, const halo_crossing_t *x) {
    if (h->crossings < h->room) {
        h->crossing[h->crossings] = *x;
        h->first[x->edge]++;
    }
    h->crossings++;
}

void halo_take(halo_t *h, uint32_t i, uint32_t j, const halo_meeting_t *m) {
    const halo_edge_t *a = &h->edge[i], *b = &h->edge[j];
    const int front = order(a, b, m, h->contact);
    if (front == 0) return;
    const halo_edge_t *far = front < 0 ? a : b, *near = front < 0 ? b : a;
    const uint64_t at = (uint64_t)(front < 0 ? m->a : m->b), on = (uint64_t)(front < 0 ? m->b : m->a);
    /* With 32 bits of everything: 1 / of = inverse / 2^63 * 2^(shift - 32). */
    const int shift = ints_clz64((uint64_t)m->of);
    const uint32_t of = (uint32_t)((uint64_t)m->of << shift >> 32);
    int half;
    const uint32_t inverse = (uint32_t)((uint64_t)INT64_MAX / of), length = length_of(near, &half);
    const uint64_t way = wide_mul_u32(length, inverse);
    const int down = 59 - shift + half;
    const uint32_t part = (uint32_t)(wide_mul_u32((uint32_t)(on << shift >> 32), inverse) >> 31);
    halo_crossing_t x = {.edge = front < 0 ? i : j, .other = front < 0 ? j : i};
    x.at_q30 = (uint32_t)(wide_mul_u32((uint32_t)(at << shift >> 32), inverse) >> 33);
    const uint64_t rounded = down <= 0 ? UINT64_MAX : ((way >> (down - 1)) + 1) >> 1;
    x.way_q36 = rounded >> 32 != 0 ? UINT32_MAX : (uint32_t)rounded;
    x.other |= width_free(far, near, (uint64_t)m->of, length >> half, part) << 24;
    note(h, &x);
}

/* The root of a square as root / 2^*half, 32 bits of it. */
static uint32_t root_of(uint64_t square, int *half) {
    const int shift = square == 0 ? 0 : ints_clz64(square) & ~1;
    *half = shift / 2;
    return ints_sqrt_u64(square << shift);
}

/* An end of one edge and the closest point of another. All of it is made of lengths and products that turning the page
 * or swapping ends does not change. */
typedef struct place {
    int64_t distance_q4;
    int64_t above_q30; /* z of the end minus z there */
    int64_t end_q30;   /* 0 or 1 */
    int64_t on_q30;    /* where on the other edge */
} place_t;

static place_t place_of(const halo_edge_t *of, bool q_end, const halo_edge_t *e) {
    const halo_point_t *p = q_end ? &of->q : &of->p;
    const int32_t ex = e->q.x - e->p.x, ey = e->q.y - e->p.y, x = p->x - e->p.x, y = p->y - e->p.y;
    const int64_t square = wide_mul_s32(ex, ex) + wide_mul_s32(ey, ey);
    const int64_t dot = wide_mul_s32(x, ex) + wide_mul_s32(y, ey);
    place_t r = {.end_q30 = q_end ? ONE_Q30 : 0};
    int half;
    if (dot > 0 && dot < square) {
        const uint32_t root = root_of((uint64_t)square, &half);
        const uint64_t cross = size64(wide_mul_s32(ex, y) - wide_mul_s32(ey, x));
        r.on_q30 = ints_muldiv_round(dot, ONE_Q30, square);
        r.distance_q4 = ints_muldiv_round((int64_t)cross, INT64_C(16) << half, root);
    } else {
        const bool at_q = square == 0 ? e->q.z > e->p.z : dot > 0; /* of an edge seen end-on, its front */
        const halo_point_t *end = at_q ? &e->q : &e->p;
        r.on_q30 = at_q ? ONE_Q30 : 0;
        const int32_t dx = p->x - end->x, dy = p->y - end->y;
        const uint32_t root = root_of((uint64_t)(wide_mul_s32(dx, dx) + wide_mul_s32(dy, dy)), &half);
        r.distance_q4 = (int64_t)((uint64_t)root << 4 >> half);
    }
    r.above_q30 = (p->z - e->p.z) * ONE_Q30 - (e->q.z - e->p.z) * r.on_q30;
    return r;
}

/* Beyond this end the edge goes on in another one. */
static bool goes_on(const halo_t *h, uint32_t edge, int64_t at_q30) {
    return (at_q30 == 0 && (h->joined[edge] & HALO_JOINED_P)) ||
           (at_q30 == ONE_Q30 && (h->joined[edge] & HALO_JOINED_Q));
}

/* Do they lie in one plane? Where their lines cross, they touch then, and one is nearer only as far as the plane is
 * seen aslant. Parallel edges always do, and are no such case. */
static bool in_one_plane(const halo_edge_t *a, const halo_edge_t *b, const halo_meeting_t *m, int32_t contact) {
    int half_a, half_b;
    const uint32_t la = length_of(a, &half_a), lb = length_of(b, &half_b);
    if ((uint64_t)m->of < wide_mul_u32(la >> half_a, lb >> half_b) / 8) return false;
    return order(a, b, m, contact) == 0;
}

void halo_take_near(halo_t *h, uint32_t i, uint32_t j, const halo_meeting_t *m) {
    const halo_edge_t *a = &h->edge[i], *b = &h->edge[j];
    if (m->of != 0 && in_one_plane(a, b, m, h->contact)) return;
    /* Edges that do not cross are closest at an end of one of them, or, parallel, at several to a unit. Of those the
     * one with the greatest difference in depth counts. */
    const place_t place[4] = {place_of(a, false, b), place_of(a, true, b), place_of(b, false, a), place_of(b, true, a)};
    int64_t least = place[0].distance_q4, up = 0, down = 0;
    for (int k = 1; k < 4; k++) {
        if (place[k].distance_q4 < least) least = place[k].distance_q4;
    }
    for (int k = 0; k < 4; k++) {
        const int64_t ahead = k < 2 ? place[k].above_q30 : -place[k].above_q30; /* of a before b */
        if (place[k].distance_q4 > least + 16) continue;
        if (ahead > up) up = ahead;
        if (ahead < down) down = ahead;
    }
    if (up == -down || (up <= 2 * h->contact * ONE_Q30 && down >= -2 * h->contact * ONE_Q30)) return;
    const bool behind = -down > up;
    bool free = false; /* an end of the nearer edge */
    for (int k = 0; k < 4; k++) {
        const int64_t ahead = k < 2 ? place[k].above_q30 : -place[k].above_q30;
        if (place[k].distance_q4 > least + 16 || ahead != (behind ? down : up)) continue;
        const int64_t at = behind == (k < 2) ? place[k].on_q30 : place[k].end_q30;
        free |= !goes_on(h, behind ? j : i, at);
    }
    uint32_t from, to;
    const uint32_t far = behind ? i : j, near = behind ? j : i;
    if (!free || !halo_strip(&h->edge[far], &h->edge[near], h->reach, &from, &to)) return;
    note(h, &(halo_crossing_t){.edge = far, .other = near});
}

static bool same(const halo_point_t *p, const halo_point_t *q) {
    return p->x == q->x && p->y == q->y && p->z == q->z;
}

void halo_join(halo_t *h, uint32_t i, uint32_t j) {
    const halo_edge_t *a = &h->edge[i], *b = &h->edge[j];
    const bool pp = same(&a->p, &b->p), pq = same(&a->p, &b->q), qp = same(&a->q, &b->p), qq = same(&a->q, &b->q);
    if (pp || pq) h->joined[i] |= HALO_JOINED_P;
    if (qp || qq) h->joined[i] |= HALO_JOINED_Q;
    if (pp || qp) h->joined[j] |= HALO_JOINED_P;
    if (pq || qq) h->joined[j] |= HALO_JOINED_Q;
}
