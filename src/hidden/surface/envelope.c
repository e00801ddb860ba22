/* envelope.c - clip one edge against a horizon and raise it: the kernel under perimeter and horizon.
 *
 * The edge walks to the right over the pieces of the horizon. At each vertex one sign is asked for: is the edge
 * above it? Comparing ordinates answers most of the time, an orientation the rest. Where two neighbouring signs
 * differ there is one crossing. Vertices below the edge are dropped, those above it move to the left stack.
 *
 * Signs have a dead zone of ENVELOPE_NOISE units in which "above" is denied. Where a visible part begins or ends
 * at a vertex inside the dead zone it takes that vertex as it is: no crossing is computed, and edges that meet in
 * a vertex leave neither slivers nor steps behind. */
#include "hidden/surface/envelope.h"
#include "error.h"

#include <string.h>

_Static_assert(2 * (31 + 31) + 2 <= 2 * 63, "an orientation is the difference of two 62-bit products");

#define ONE_Q30 (INT32_C(1) << 30)

/* Called, vertices would be put together in memory of halves just written. */
#if CONFIG_64BIT
#define INLINE_64 inline __attribute__((always_inline))
#else
#define INLINE_64 __attribute__((noinline))
#endif

/* Room for the vertices that one step of a clip may add: foot, start, end, and the far side of a jump. */
#define STEP_ROOM 4

int envelope_init(envelope_t *upper, envelope_t *lower, pencil_t *pool, size_t count) {
    envelope_t *both[2] = {upper, lower};
    size_t each = lower == NULL ? count : count / 2;
    if (each < 2 + STEP_ROOM) return ERR_FULL;
    for (int k = 0; k < 2 && both[k] != NULL; k++) {
        envelope_t *h = both[k];
        h->base = pool + (k == 0 ? 0 : each);
        h->end = k == 0 ? pool + each : pool + count;
        h->base[0] = (pencil_t){-ENVELOPE_LIMIT, ENVELOPE_FLOOR};
        h->end[-1] = (pencil_t){ENVELOPE_LIMIT, ENVELOPE_FLOOR};
        h->l = h->base + 1;
        h->r = h->end - 1;
        h->peer = both[1 - k];
        h->spare = NULL;
        h->peak = 2;
    }
    return 0;
}

static void move_block(pencil_t *from, pencil_t *end, ptrdiff_t by) {
    if (by > 0) {
        for (pencil_t *p = end; p != from;) {
            p--;
            p[by] = *p;
        }
    } else {
        for (pencil_t *p = from; p != end; p++) p[by] = *p;
    }
}

/* Looks for the place by leaps that double, then by halves: vertices are only copied on the way. */
void envelope_leap(envelope_t *h, int32_t a) {
    ptrdiff_t known = 0, leap = ENVELOPE_NEAR;
    if (h->r->a <= a) {
        const ptrdiff_t all = h->end - h->r; /* r[known] is to go to the left */
        while (known + leap < all && h->r[known + leap].a <= a) known += leap, leap *= 2;
        for (; leap > 0; leap /= 2) {
            if (known + leap < all && h->r[known + leap].a <= a) known += leap;
        }
        memmove(h->l, h->r, (size_t)(known + 1) * sizeof *h->l);
        h->l += known + 1;
        h->r += known + 1;
    } else {
        const ptrdiff_t all = h->l - h->base; /* l[-1 - known] is to go to the right */
        while (known + leap < all && h->l[-1 - known - leap].a > a) known += leap, leap *= 2;
        for (; leap > 0; leap /= 2) {
            if (known + leap < all && h->l[-1 - known - leap].a > a) known += leap;
        }
        h->l -= known + 1;
        h->r -= known + 1;
        memmove(h->r, h->l, (size_t)(known + 1) * sizeof *h->l);
    }
}

static void move_base(envelope_t *upper, ptrdiff_t by) {
    move_block(upper->base, upper->l, by);
    upper->base += by;
    upper->l += by;
    upper->spare->to = (uint8_t *)upper->base;
}

/* Half of what is spare for the upper horizon, or enough. */
static bool take_spare(envelope_t *upper, ptrdiff_t enough) {
    if (upper->spare == NULL) return false;
    const ptrdiff_t all = (upper->spare->to - upper->spare->from) / (ptrdiff_t)sizeof(pencil_t);
    if (all < enough) return false;
    move_base(upper, all / 2 > enough ? -(all / 2) : -enough);
    return true;
}

/* Makes room for `need` vertices in h's gap, from its peer's. Only pointers of the two horizons move. */
static int grow(envelope_t *h, ptrdiff_t need) {
    envelope_t *o = h->peer;
    if (o == NULL) return ERR_FULL;
    if (h->r - h->l + (o->r - o->l) / 2 < need) {
        if (!take_spare(h->base < o->base ? h : o, 2 * need)) return ERR_FULL;
        if (h->r - h->l >= need) return 0;
    }
    ptrdiff_t take = (o->r - o->l) / 2;
    if (h->base < o->base) { /* what lies between the gaps: h's right stack and the peer's left one */
        move_block(h->r, o->l, take);
        h->r += take, h->end += take, o->base += take, o->l += take;
    } else {
        move_block(o->r, h->l, -take);
        o->r -= take, o->end -= take, h->base -= take, h->l -= take;
    }
    return 0;
}

void envelope_lend(envelope_t *upper, envelope_spare_t *spare) {
    upper->spare = spare;
}

bool envelope_give_back(envelope_t *upper, size_t bytes) {
    const ptrdiff_t need = (ptrdiff_t)((bytes + sizeof(pencil_t) - 1) / sizeof(pencil_t));
    if (upper->r - upper->l < need + STEP_ROOM && grow(upper, need + STEP_ROOM) != 0) return false;
    const ptrdiff_t most = (upper->r - upper->l) / 4;
    move_base(upper, most > need ? most : need);
    return true;
}

static inline int room(envelope_t *h) {
    return h->r - h->l >= STEP_ROOM ? 0 : grow(h, STEP_ROOM);
}

/* Appends a vertex to the left stack. Of three with equal a the middle one goes: a jump has two ends. */
static inline void push(envelope_t *h, int32_t a, int32_t w) {
    if (h->l[-1].a == a) {
        if (h->l[-1].w == w) return;
        if (h->l[-2].a == a) {
            h->l[-1].w = w;
            if (h->l[-2].w == w) h->l--;
            return;
        }
    }
    *h->l++ = (pencil_t){a, w};
}

/* Nearest to x + d * t. */
static inline int32_t along(int32_t x, int32_t d, int32_t t_q30) {
    return x + (int32_t)(((int64_t)d * t_q30 + (1 << 29)) >> 30);
}

/* Where x lies on the edge p-q, measured along its longer side. */
int32_t envelope_fraction_at(pencil_t p, pencil_t q, pencil_t x) {
    int32_t run = q.a - p.a, rise = q.w - p.w;
    int32_t whole = run, part = x.a - p.a;
    if (pencil_abs(rise) > run) {
        whole = pencil_abs(rise);
        part = rise < 0 ? p.w - x.w : x.w - p.w;
    }
    if (part <= 0) return 0;
    if (part >= whole) return ONE_Q30;
    return (int32_t)pencil_fraction((uint64_t)part, (uint64_t)whole);
}

/* A crossing x that rounding has put beside or onto the end of the edge: the end itself; but a steep edge may reach it
 * within half a unit of a and yet far away from its end. */
static pencil_t beside(pencil_t end, pencil_t x, int32_t w0, int32_t w1) {
    const int32_t w = pencil_max(pencil_min(x.w, pencil_max(w0, w1)), pencil_min(w0, w1));
    if (pencil_abs(w - end.w) > ENVELOPE_NOISE) end.w = w;
    return end;
}

/* The crossing of the edge p-q with the piece v-w, rounded, inside both ranges of a. If the signs that called for
 * it differ only by the dead zone there is none: the edge then emerges at v, or goes under at w, itself. */
static INLINE_64 pencil_t crossing(pencil_t p, pencil_t q, pencil_t v, pencil_t w, bool emerges,
                                   envelope_count_t *count) {
    int64_t ov = envelope_orient(p, q, v), ow = envelope_orient(p, q, w);
    uint64_t nv = ov < 0 ? 0 - (uint64_t)ov : (uint64_t)ov, nw = ow < 0 ? 0 - (uint64_t)ow : (uint64_t)ow;
    int32_t t = 0;
    if (ov == 0 || ow == 0 || (ov < 0) == (ow < 0)) {
        t = emerges ? 0 : ONE_Q30;
    } else {
        count->crossings++;
        t = (int32_t)pencil_fraction(nv >> 1, (nv >> 1) + (nw >> 1));
    }
    pencil_t x = {along(v.a, w.a - v.a, t), along(v.w, w.w - v.w, t)};
    if (x.a <= p.a) return beside(p, x, p.w, q.w);
    if (x.a >= q.a) return beside(q, x, p.w, q.w);
    return x;
}

/* The state of one clip. */
typedef struct clip {
    int32_t from_q30; /* start of the visible part */
    bool visible, any;
    bool first; /* the horizon is at the floor */
} clip_t;

static inline void begin(clip_t *c, int32_t at_q30) {
    c->visible = c->any = true;
    c->from_q30 = at_q30;
}

static inline int finish(clip_t *c, int32_t at_q30, envelope_take_t take, void *ctx) {
    c->visible = false;
    if (take == NULL || at_q30 <= c->from_q30) return 0;
    return take(ctx, (envelope_part_t){c->from_q30, at_q30}, c->first);
}

/* Is the horizon's vertex x, at the very abscissa of the edge's end, below that by more than the dead zone of a steep
 * edge lets show? The piece from x to `other` must be flat enough for its ordinate to mean something. */
static bool drops_from(pencil_t end, pencil_t x, pencil_t other) {
    const int64_t drop = (int64_t)end.w - x.w, run = pencil_abs(other.a - x.a), rise = pencil_abs(other.w - x.w);
    return drop > 2 * ENVELOPE_NOISE && x.w != ENVELOPE_FLOOR && (drop - ENVELOPE_NOISE) * run > rise * ENVELOPE_NOISE;
}

/* What all vertices are compared with. */
typedef struct edge {
    pencil_t p, q;
    int32_t lo, hi;
    int64_t noise;
} edge_t;

/* A core of 32 bits would gain 2 % by pass(), for a kilobyte of code. */
#define PASSES (sizeof(void *) >= 8)

/* Goes on while vertices, no jumps among them, leave the edge what it is: hidden, or visible. On a rough surface that
 * is seven vertices a clip. Decides as envelope_below does, with all that has to do with the edge alone computed once,
 * the ends of the gap in registers, and no branch on which side of the edge's box the vertex is: one that is guessed
 * wrong costs more than both products. Returns the last one passed, or v. */
static inline __attribute__((always_inline)) pencil_t
pass(envelope_t *h, const edge_t *e, pencil_t v, const bool visible, const bool raise, envelope_count_t *count) {
    pencil_t *l = h->l, *r = h->r;
    int64_t tests = 0;
    if (l[-1].a == r->a) return v;
    /* The orientation, but for what the edge alone adds to it. */
    const int64_t run = e->q.a - e->p.a, rise = e->q.w - e->p.w, least = run * e->p.w - rise * e->p.a - e->noise;
    while (r->a < e->q.a && r[1].a != r->a) {
        const bool under = r->w < e->hi, far = r->w + ENVELOPE_NOISE < e->lo;
        const bool below = far | (under & (run * r->w - rise * r->a < least));
        if (below != visible) break;
        tests += under - far; /* what is far is under */
        if (!raise || !visible) *l++ = *r;
        r++;
    }
    if (r == h->r) return v;
    h->l = l;
    h->r = r;
    count->tests += tests;
    return r[-1];
}

/* Walks along the horizon under an edge; raise: and raises it. */
static inline __attribute__((always_inline)) int walk(envelope_t *h, pencil_t p, pencil_t q, envelope_take_t take,
                                                      void *ctx, envelope_count_t *count, const bool raise) {
    clip_t c;
    c.from_q30 = 0;
    c.visible = c.any = false; /* one by one: some compilers call memset for a structure */
    const edge_t edge = {p, q, pencil_min(p.w, q.w), pencil_max(p.w, q.w), envelope_noise(p, q)};
    envelope_seek(h, p.a);
    int err = room(h);
    if (err != 0) return err;
    pencil_t v = h->l[-1]; /* start of the current piece; v.a <= the current abscissa */
    if (v.a == p.a ? envelope_below(p, q, v, count) || drops_from(p, v, *h->r) : envelope_above(v, *h->r, p, count)) {
        if (raise && v.a < p.a) push(h, p.a, pencil_ordinate(v, *h->r, p.a));
        if (raise) push(h, p.a, p.w);
        begin(&c, 0);
    }
    c.first = v.w == ENVELOPE_FLOOR;
    for (;;) {
        if (PASSES) v = c.visible ? pass(h, &edge, v, true, raise, count) : pass(h, &edge, v, false, raise, count);
        pencil_t w = *h->r;
        bool last = w.a > q.a;
        bool above = last ? envelope_above(v, w, q, count) : envelope_below(p, q, w, count);
        if (!above && w.a == q.a) above = drops_from(q, w, v);
        if (above != c.visible) {
            if ((err = room(h)) != 0) return err;
            pencil_t x = crossing(p, q, v, w, !c.visible, count);
            int32_t at = envelope_fraction_at(p, q, x);
            if (c.visible) {
                if ((err = finish(&c, at, take, ctx)) != 0) return err;
            } else {
                begin(&c, at);
            }
            if (raise) push(h, x.a, x.w);
        }
        if (last) {
            if (c.visible) {
                if (raise) push(h, q.a, q.w);
                if (raise) push(h, q.a, pencil_ordinate(v, w, q.a));
                if ((err = finish(&c, ONE_Q30, take, ctx)) != 0) return err;
            }
            break;
        }
        h->r++;
        if (!raise || !c.visible) push(h, w.a, w.w);
        v = w;
        if (h->r->a == w.a) { /* a jump */
            pencil_t far = *h->r;
            if ((err = room(h)) != 0) return err;
            /* Where the edge ends at the jump it does not begin to be visible any more. */
            above = (c.visible || w.a < q.a) && envelope_below(p, q, far, count);
            const bool floor = far.w == ENVELOPE_FLOOR;
            if (above && c.visible && floor != c.first) { /* onto the floor or off it */
                int32_t at = envelope_fraction_at(p, q, (pencil_t){w.a, pencil_ordinate(p, q, w.a)});
                if ((err = finish(&c, at, take, ctx)) != 0) return err;
                begin(&c, at);
            } else if (above != c.visible) {
                pencil_t x = {w.a, pencil_ordinate(p, q, w.a)};
                int32_t at = envelope_fraction_at(p, q, x);
                if (raise) push(h, x.a, x.w);
                if (c.visible) {
                    if ((err = finish(&c, at, take, ctx)) != 0) return err;
                } else {
                    begin(&c, at);
                }
            }
            c.first = floor;
            h->r++;
            if (!raise || !c.visible) push(h, far.a, far.w);
            v = far;
        }
        if (w.a == q.a) {
            if (c.visible) {
                if (raise) push(h, q.a, q.w);
                if (raise) push(h, v.a, v.w);
                if ((err = finish(&c, ONE_Q30, take, ctx)) != 0) return err;
            }
            break;
        }
    }
    if (raise && c.any) h->peak = pencil_max(h->peak, envelope_size(h));
    return c.any;
}

int envelope_clip(envelope_t *h, pencil_t p, pencil_t q, envelope_take_t take, void *ctx, envelope_count_t *count) {
    return walk(h, p, q, take, ctx, count, true);
}

int envelope_look(envelope_t *h, pencil_t p, pencil_t q, envelope_take_t take, void *ctx, envelope_count_t *count) {
    return walk(h, p, q, take, ctx, count, false);
}

envelope_limits_t envelope_limits(envelope_t *h, int32_t a) {
    envelope_seek(h, a);
    const pencil_t last = h->l[-1];
    if (last.a < a) {
        const int32_t w = pencil_ordinate(last, *h->r, a);
        return (envelope_limits_t){w, w};
    }
    return (envelope_limits_t){h->l[-2].a == a ? h->l[-2].w : last.w, last.w};
}
