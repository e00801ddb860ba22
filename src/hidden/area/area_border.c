/* area_border.c - see area_border.h. */
#include "hidden/area/area_border.h"

#include "error.h"
#include "num/heap_sort.h"
#include "num/ints.h"

#define CRACK 96 /* units of 2^-5 lat: what is no wider is no shadow (a hundredth of a step) */
/* two lines that meet at an angle are near each other for a bit, and no crack */
#define LEAST_OVERLAP (8 * CRACK)
#define NEAR (4 * CRACK) /* so far before or behind the other's end a line may begin: windows overlap */
#define JOIN 3           /* units from a straight line that rounding at windows may leave */
#define FRAC_BITS 26

static bool lines_at(void *ctx, uint8_t family, int32_t line, int64_t t_q30, page_h_t *out) {
    const borders_t *b = ctx;
    const border_t *s = &b->list[line];
    (void)family;
    int64_t one = (int64_t)1 << (FRAC_BITS - b->bits);
    int64_t dx = (int64_t)s->end[1].x - s->end[0].x, dy = (int64_t)s->end[1].y - s->end[0].y;
    *out = (page_h_t){s->end[0].x * one + ints_muldiv_round(dx * one, t_q30, INK_ONE),
                      s->end[0].y * one + ints_muldiv_round(dy * one, t_q30, INK_ONE), (int64_t)1 << FRAC_BITS};
    return true;
}

void borders_init(borders_t *b, void *mem, size_t bytes, const page_window_t *window) {
    size_t n = bytes / sizeof(border_t);
    *b = (borders_t){.list = mem, .n_max = n > INT32_MAX / 4 ? INT32_MAX / 4 : (int32_t)n};
    b->lines = (line_space_t){.ctx = b, .at = lines_at, .window = window, .frac_bits = FRAC_BITS};
}

/* ---- one line against another ---- */

typedef struct ruler {
    poly_point_t a;
    int64_t ux, uy, length; /* u: from end to end */
} ruler_t;

static ruler_t ruler(poly_point_t a, poly_point_t b) {
    ruler_t r = {a, (int64_t)b.x - a.x, (int64_t)b.y - a.y, 0};
    r.length = (int64_t)ints_sqrt_u64((uint64_t)(r.ux * r.ux) + (uint64_t)(r.uy * r.uy));
    return r;
}

/* How far along, q30, and how far beside the line, in units. */
static int64_t along(const ruler_t *r, poly_point_t p) {
    int64_t dot = ((int64_t)p.x - r->a.x) * r->ux + ((int64_t)p.y - r->a.y) * r->uy;
    return ints_muldiv_round(INK_ONE, dot, r->length * r->length);
}

static int64_t beside(const ruler_t *r, poly_point_t p) {
    return (((int64_t)p.y - r->a.y) * r->ux - ((int64_t)p.x - r->a.x) * r->uy) / r->length;
}

/* The part of the line that p-q lies along, as near as a crack. False: nowhere. */
static bool overlap(const ruler_t *r, poly_point_t p, poly_point_t q, int64_t *from, int64_t *to) {
    int64_t side_p = beside(r, p), side_q = beside(r, q), a = along(r, p), b = along(r, q);
    if (a > b) {
        int64_t keep = a;
        a = b, b = keep, keep = side_p, side_p = side_q, side_q = keep;
    }
    if (b <= 0 || a >= INK_ONE) return false;
    /* where it leaves the strip, a wedge ends: what is within is a crack */
    int64_t in = a, out = b, turn = side_q - side_p;
    if (turn != 0) {
        int64_t low = a + ints_muldiv_round(b - a, -CRACK - side_p, turn);
        int64_t high = a + ints_muldiv_round(b - a, CRACK - side_p, turn);
        if (low > high) {
            int64_t keep = low;
            low = high, high = keep;
        }
        if (low > in) in = low;
        if (high < out) out = high;
    } else if (side_p > CRACK || side_p < -CRACK) {
        return false;
    }
    *from = in < 0 ? 0 : in;
    *to = out > INK_ONE ? INK_ONE : out;
    return *from < *to && ints_muldiv_round(r->length, *to - *from, INK_ONE) > LEAST_OVERLAP;
}

static poly_point_t place(const ruler_t *r, int64_t t) {
    return (poly_point_t){r->a.x + (int32_t)ints_muldiv_round(r->ux, t, INK_ONE),
                          r->a.y + (int32_t)ints_muldiv_round(r->uy, t, INK_ONE)};
}

static int add(borders_t *b, const ruler_t *r, int64_t from, int64_t to) {
    if (ints_muldiv_round(r->length, to - from, INK_ONE) <= CRACK) return 0;
    if (b->n == b->n_max) return ERR_FULL;
    b->list[b->n++] = (border_t){{place(r, from), place(r, to)}};
    return 0;
}

/* ---- the borders of a polygon ---- */

/* At a place of edge r: how many edges of p run along it there, r among them, less those that run back; and in *to
 * where that may change. Two that run against each other are a crack, or a spike that the clipper left of one; of an
 * odd number one is a border. */
static int32_t runs_along(const poly_t *p, int32_t edge, const ruler_t *r, int64_t at, int64_t *to) {
    int32_t n = 1;
    *to = INK_ONE;
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int32_t k = first; k < p->end[c]; k++) {
            const poly_point_t a = p->v[k].at, b = p->v[k + 1 < p->end[c] ? k + 1 : first].at;
            const int64_t along = ((int64_t)b.x - a.x) * r->ux + ((int64_t)b.y - a.y) * r->uy;
            int64_t from, end;
            if (k == edge || along == 0 || !overlap(r, a, b, &from, &end)) continue;
            if (from <= at && end > at) {
                n += along > 0 ? 1 : -1;
                *to = end < *to ? end : *to;
            } else if (from > at && from < *to)
                *to = from;
        }
    return n;
}

int borders_add(borders_t *b, const poly_t *p, int32_t tag) {
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int32_t k = first; k < p->end[c]; k++) {
            if (p->v[k].tag != tag) continue;
            const ruler_t r = ruler(p->v[k].at, p->v[k + 1 < p->end[c] ? k + 1 : first].at);
            int64_t from = 0;
            for (int64_t at = 0, to; at < INK_ONE && r.length > 0; at = to) {
                const bool free = runs_along(p, k, &r, at, &to) > 0;
                if (free && to < INK_ONE) continue;
                const int err = add(b, &r, from, free ? to : at);
                if (err) return err;
                from = to;
            }
        }
    return 0;
}

/* ---- what windows cut ---- */

/* Does p lie on the line, but for what rounding leaves? */
static bool is_on(const ruler_t *r, poly_point_t p) {
    const int64_t across = r->ux * ((int64_t)p.y - r->a.y) - r->uy * ((int64_t)p.x - r->a.x);
    return across <= JOIN * r->length && across >= -JOIN * r->length;
}

static bool is_close(int32_t a, int32_t b) {
    return a - b <= NEAR && b - a <= NEAR;
}

/* Both run the same way round what is dark. */
static bool join(border_t *s, const border_t *t) {
    if (!is_close(s->end[1].x, t->end[0].x) || !is_close(s->end[1].y, t->end[0].y)) return false;
    const ruler_t r = ruler(s->end[0], t->end[1]);
    const int64_t ahead = r.ux * ((int64_t)s->end[1].x - s->end[0].x) + r.uy * ((int64_t)s->end[1].y - s->end[0].y),
                  after = r.ux * ((int64_t)t->end[1].x - t->end[0].x) + r.uy * ((int64_t)t->end[1].y - t->end[0].y);
    if (ahead <= 0 || after <= 0 || !is_on(&r, s->end[1]) || !is_on(&r, t->end[0])) return false;
    s->end[1] = t->end[1];
    return true;
}

void borders_join(borders_t *b, int32_t from) {
    for (int32_t i = from; i < b->n; i++)
        for (int32_t k = from; k < b->n;) {
            if (k == i || !join(&b->list[i], &b->list[k])) {
                k++;
                continue;
            }
            b->list[k] = b->list[--b->n];
            if (i == b->n) i = k; /* it was the last one and has moved */
            k = from;
        }
    int32_t n = from;
    for (int32_t k = from; k < b->n; k++)
        if (ruler(b->list[k].end[0], b->list[k].end[1]).length > LEAST_OVERLAP) b->list[n++] = b->list[k];
    b->n = n;
}

/* ---- all of them ---- */

static int32_t low(const border_t *s) {
    return s->end[0].x < s->end[1].x ? s->end[0].x : s->end[1].x;
}

static bool is_before(const border_t *a, const border_t *b) {
    return low(a) < low(b);
}

HEAP_SORT(border_t, is_before)

/* Takes off s what lies on t; true if nothing is left. A part in the middle of s stays twice. */
static bool take_off(border_t *s, const border_t *t) {
    const ruler_t r = ruler(s->end[0], s->end[1]);
    int64_t from, to;
    if (r.length == 0) return true;
    if (!overlap(&r, t->end[0], t->end[1], &from, &to)) return false;
    const int64_t bit = CRACK * INK_ONE / r.length;
    if (from <= bit && to >= INK_ONE - bit) return true;
    if (from <= bit)
        s->end[0] = place(&r, to);
    else if (to >= INK_ONE - bit)
        s->end[1] = place(&r, from);
    return false;
}

void borders_settle(borders_t *b) {
    heap_sort(b->list, b->n);
    for (int32_t k = 0; k < b->n; k++) {
        border_t *s = &b->list[k];
        int32_t high = s->end[0].x > s->end[1].x ? s->end[0].x : s->end[1].x;
        for (int32_t i = k + 1; i < b->n && low(&b->list[i]) - CRACK <= high; i++) {
            border_t *t = &b->list[i];
            if (poly_same(t->end[0], t->end[1])) continue;
            if (take_off(t, s)) t->end[1] = t->end[0]; /* an empty one, so that the order stays */
        }
    }
    int32_t n = 0;
    for (int32_t k = 0; k < b->n; k++)
        if (!poly_same(b->list[k].end[0], b->list[k].end[1])) b->list[n++] = b->list[k];
    b->n = n;
}
