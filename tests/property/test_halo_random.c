/* Seeded random wire frames with haloes, judged against every-edge-with-every-other in rationals, and the laws of the
 * kernel. RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "tests/oracle/halo_ref.h"
#include "tests/oracle/run_cases.h"

#define MOST 120 /* edges */
#define PIECES (MOST * MOST)

typedef struct frame {
    int n;
    halo_edge_t edge[MOST];
    int32_t width, contact;
    bool ends;
} frame_t;

typedef struct frame_ink {
    int n;
    halo_ref_piece_t piece[PIECES];
    int64_t crossings;
} frame_ink_t;

static int32_t below(uint64_t *rng, int32_t n) {
    return (int32_t)scene_below(rng, n);
}

static void add(frame_t *f, halo_point_t p, halo_point_t q) {
    if (p.z > HALO_Z_MAX) p.z = HALO_Z_MAX;
    if (q.z > HALO_Z_MAX) q.z = HALO_Z_MAX;
    if (f->n < MOST) f->edge[f->n] = (halo_edge_t){p, q, f->n}, f->n++;
}

static halo_point_t anywhere(uint64_t *rng, int32_t size, int32_t deep) {
    return (halo_point_t){below(rng, size), below(rng, size), deep ? below(rng, deep) : 0};
}

enum shape {
    RANDOM,  /* edges of one typical length */
    LATTICE, /* few places: shared ends, T, collinear, vertical, dots */
    STAR,    /* many through a point */
    NEEDLES, /* enormous differences of length */
    CELL,    /* all but one in a single cell */
    UNITS,   /* edges of one unit */
    CHAINS,  /* polylines in space */
    BOXES,   /* wire frames of boxes, some of equal depth */
    HATCH,   /* parallel lines and some across */
    FLAT,    /* all in one plane: contacts */
    HUGE,    /* the ends of the range */
    SHALLOW, /* nearly parallel */
    FRAME_SHAPES
};

static void fill(frame_t *f, enum shape shape, int n, uint64_t *rng) {
    const int32_t size = 1 << (10 + below(rng, 15)), deep = below(rng, 4) == 0 ? 4 : 1 << (4 + below(rng, 24));
    for (int k = 0; k < n; k++) {
        halo_point_t p = anywhere(rng, size, deep), q = anywhere(rng, size, deep);
        const int32_t half = size / 2, part = size / 8 + 1;
        switch (shape) {
        case RANDOM:
            q = (halo_point_t){p.x + below(rng, 2 * part) - part, p.y + below(rng, 2 * part) - part, q.z};
            break;
        case LATTICE:
            p = (halo_point_t){p.x / part * part, p.y / part * part, below(rng, 3) * (deep / 2)};
            q = (halo_point_t){q.x / part * part, q.y / part * part, below(rng, 3) * (deep / 2)};
            break;
        case STAR:
            if (below(rng, 3) != 0) q = (halo_point_t){size - p.x, size - p.y, q.z};
            if (below(rng, 4) == 0) q = (halo_point_t){half, half, q.z};
            break;
        case NEEDLES:
            if (below(rng, 3) != 0) q = (halo_point_t){p.x + below(rng, 40) - 20, p.y + below(rng, 3000) - 1500, q.z};
            if (below(rng, 4) == 0) q.y = p.y + below(rng, 3);
            break;
        case CELL:
            if (k > 0) p.x = p.x / 256 + half, p.y = p.y / 256, q.x = q.x / 256 + half, q.y = q.y / 256;
            break;
        case UNITS:
            p = (halo_point_t){below(rng, 12), below(rng, 12), p.z};
            q = (halo_point_t){p.x + below(rng, 3) - 1, p.y + below(rng, 3) - 1, q.z};
            break;
        case CHAINS:
            if (k % 16 != 0) p = f->edge[f->n - 1].q;
            q = (halo_point_t){p.x + below(rng, 2 * part) - part, p.y + below(rng, 2 * part) - part,
                               p.z + below(rng, deep) / 8};
            break;
        case HATCH:
            if (k % 4 != 0) q = (halo_point_t){p.x + part, p.y + 2 * part, q.z};
            break;
        case FLAT: /* z = (x + y) * 4 */
            p.z = (p.x + p.y) * 4;
            q.z = (q.x + q.y) * 4;
            break;
        case HUGE:
            p = (halo_point_t){below(rng, 2) ? HALO_XY_MAX : -HALO_XY_MAX, (below(rng, 1 << 30) - (1 << 29)), p.z};
            q = (halo_point_t){(below(rng, 1 << 30) - (1 << 29)), below(rng, 2) ? HALO_XY_MAX : -HALO_XY_MAX, -q.z};
            break;
        case SHALLOW:
            p.x /= 16, q.x = size - q.x / 16;
            q.y = p.y + below(rng, part) - part / 2;
            break;
        default:
            break;
        }
        if (shape == BOXES) {
            halo_point_t c[8];
            const halo_point_t d = {below(rng, part) + 1, below(rng, part), below(rng, deep / 4 + 1)};
            if (below(rng, 2)) p.z = deep / 2;
            for (int v = 0; v < 8; v++)
                c[v] = (halo_point_t){p.x + (v & 1 ? d.x : 0) + (v & 2 ? d.y : 0),
                                      p.y + (v & 1 ? -d.y / 2 : 0) + (v & 2 ? d.x / 2 : 0) + (v & 4 ? part / 2 : 0),
                                      p.z + (v & 1 ? d.z : 0) - (v & 2 ? d.z / 2 : 0) + (v & 4 ? d.z / 3 : 0)};
            for (int v = 0; v < 8; v++)
                for (int bit = 1; bit < 8; bit *= 2)
                    if (!(v & bit)) add(f, c[v], c[v | bit]);
            k += 11;
        } else {
            add(f, p, q);
        }
    }
    f->width = HALO_WIDTH_MIN + below(rng, below(rng, 3) == 0 ? 100 : size / 20 + 1);
    if (shape == HUGE) f->width = HALO_WIDTH_MIN + below(rng, HALO_WIDTH_MAX - HALO_WIDTH_MIN);
}

static void make(frame_t *f, uint64_t seed) {
    uint64_t rng = seed;
    *f = (frame_t){0};
    const enum shape shape = (enum shape)below(&rng, FRAME_SHAPES);
    f->ends = below(&rng, 3) == 0;
    f->contact = below(&rng, 3) ? 1 : 1 + below(&rng, 2000);
    fill(f, shape, 2 + below(&rng, seed % 40 == 7 ? MOST - 2 : 40), &rng);
    if (below(&rng, 6) == 0) fill(f, (enum shape)below(&rng, FRAME_SHAPES), 2 + below(&rng, 20), &rng);
    if (f->width > HALO_WIDTH_MAX) f->width = HALO_WIDTH_MAX;
}

static int take(void *ctx, int32_t id, uint32_t from, uint32_t to) {
    frame_ink_t *d = ctx;
    if (from >= to || to > 1u << 30 || d->n >= PIECES) return ERR_VALUE;
    d->piece[d->n++] = (halo_ref_piece_t){id, from * 0x1p-30, to * 0x1p-30};
    return 0;
}

static int draw(const frame_t *f, int32_t width, frame_ink_t *d) {
    static uint64_t mem[(512 + 56 * MOST + 32 * PIECES) / 8];
    halo_t h;
    d->n = 0;
    halo_init(&h, mem, sizeof mem);
    h.contact = f->contact;
    for (int i = 0; i < f->n; i++) {
        int err = halo_add(&h, f->edge[i].id, f->edge[i].p, f->edge[i].q);
        if (err) return err;
    }
    int err = halo_cut(&h, f->ends ? f->width : 0);
    if (!err && f->width % 2 != 0) { /* again with as little memory as will do: crossings are then grouped in place */
        halo_t again;
        halo_init(&again, mem, h.used);
        again.contact = f->contact;
        for (int i = 0; !err && i < f->n; i++) err = halo_add(&again, f->edge[i].id, f->edge[i].p, f->edge[i].q);
        if (!err) err = halo_cut(&again, f->ends ? f->width : 0);
        if (!err && again.crossings != h.crossings) err = ERR_DATA;
        h = again;
    }
    d->crossings = h.crossings;
    return err ? err : halo_draw(&h, width, &(halo_sink_t){d, take});
}

/* Where one drawing has ink and the other, of the same edges, has not: the longest such stretch, in units. */
static double difference(const frame_t *f, const frame_ink_t *a, const frame_ink_t *b, bool only_a) {
    double most = 0;
    for (int i = 0; i < f->n; i++) {
        const double length = hypot((double)f->edge[i].q.x - f->edge[i].p.x, (double)f->edge[i].q.y - f->edge[i].p.y);
        double edge[2][MOST * 2 + 2];
        int n[2] = {0, 0};
        const frame_ink_t *of[2] = {a, b};
        for (int w = 0; w < 2; w++)
            for (int k = 0; k < of[w]->n; k++)
                if (of[w]->piece[k].edge == i) {
                    edge[w][n[w]++] = of[w]->piece[k].from;
                    edge[w][n[w]++] = of[w]->piece[k].to;
                }
        int at[2] = {0, 0};
        double t = 0;
        while (at[0] < n[0] || at[1] < n[1]) {
            const double next0 = at[0] < n[0] ? edge[0][at[0]] : 2, next1 = at[1] < n[1] ? edge[1][at[1]] : 2;
            const double next = fmin(next0, next1);
            const bool in0 = at[0] & 1, in1 = at[1] & 1;
            if ((in0 && !in1) || (!only_a && in1 && !in0)) most = fmax(most, (next - t) * length);
            if (next0 == next) at[0]++;
            if (next1 == next) at[1]++;
            t = next;
        }
    }
    return most;
}

/* Rounding: of a gap's end by length * width / 2^36, of its place by 2^-27 of the edge. */
static double allowance(const frame_t *f) {
    double longest = 0;
    for (int i = 0; i < f->n; i++)
        longest =
            fmax(longest, hypot((double)f->edge[i].q.x - f->edge[i].p.x, (double)f->edge[i].q.y - f->edge[i].p.y));
    return 4 + longest * (2.0 * f->width * 0x1p-36 + 0x1p-25);
}

/* Moving and scaling all, and adding an edge behind or in front of all. */
static const char *breaks_a_law_of_space(const frame_t *f, const frame_ink_t *d, uint64_t *rng) {
    static frame_ink_t other;
    static frame_t g;
    int32_t lo[3] = {INT32_MAX, INT32_MAX, INT32_MAX}, hi[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
    for (int k = 0; k < f->n; k++)
        for (int end = 0; end < 2; end++) {
            const halo_point_t *p = end ? &f->edge[k].q : &f->edge[k].p;
            const int32_t at[3] = {p->x, p->y, p->z};
            for (int i = 0; i < 3; i++) lo[i] = at[i] < lo[i] ? at[i] : lo[i], hi[i] = at[i] > hi[i] ? at[i] : hi[i];
        }
    if (hi[0] < HALO_XY_MAX - 99999 && hi[1] < HALO_XY_MAX - 99999 && hi[2] < HALO_Z_MAX - 99999) {
        g = *f;
        const halo_point_t by = {below(rng, 99999), below(rng, 99999), below(rng, 99999)};
        for (int k = 0; k < g.n; k++)
            for (int end = 0; end < 2; end++) {
                halo_point_t *p = end ? &g.edge[k].q : &g.edge[k].p;
                *p = (halo_point_t){p->x + by.x, p->y + by.y, p->z + by.z};
            }
        if (draw(&g, f->width, &other) || other.crossings != d->crossings) return "moved";
        if (difference(f, d, &other, false) > allowance(f)) return "moved";
    }
    /* Twice as large; not with `ends`: the places where two edges are closest are rounded, whatever the scale. */
    bool twice = !f->ends && f->width <= HALO_WIDTH_MAX / 2 && f->contact <= HALO_CONTACT_MAX / 2;
    for (int i = 0; i < 3; i++) twice = twice && lo[i] > -(HALO_Z_MAX / 2) && hi[i] < HALO_Z_MAX / 2;
    if (twice) {
        g = *f;
        g.width *= 2, g.contact *= 2;
        for (int k = 0; k < g.n; k++)
            for (int end = 0; end < 2; end++) {
                halo_point_t *p = end ? &g.edge[k].q : &g.edge[k].p;
                *p = (halo_point_t){2 * p->x, 2 * p->y, 2 * p->z};
            }
        if (draw(&g, g.width, &other) || other.crossings != d->crossings) return "scaled";
        if (difference(f, d, &other, false) > allowance(f)) return "scaled";
    }
    for (int front = 0; front < 2 && f->n < MOST; front++) {
        const int32_t z = front ? HALO_Z_MAX : -HALO_Z_MAX, margin = 2 * f->contact + 2;
        if (front ? hi[2] > z - margin : lo[2] < z + margin) continue;
        g = *f;
        halo_point_t p[2];
        for (int end = 0; end < 2; end++)
            p[end] = (halo_point_t){(int32_t)(lo[0] + (int64_t)(scene_uniform(rng) * ((double)hi[0] - lo[0]))),
                                    (int32_t)(lo[1] + (int64_t)(scene_uniform(rng) * ((double)hi[1] - lo[1]))), z};
        add(&g, p[0], p[1]);
        if (draw(&g, f->width, &other)) return "one more edge";
        if (difference(f, &other, d, true) > allowance(&g)) return "one more edge shows something";
        if (!front && difference(f, d, &other, true) > allowance(&g)) return "an edge behind all hides something";
    }
    return NULL;
}

static const char *breaks_a_law(const frame_t *f, frame_ink_t *d, uint64_t seed) {
    static frame_ink_t other;
    static frame_t g;
    const double allowed = allowance(f);
    uint64_t rng = seed ^ 0x5eed;
    /* zero halo is no halo */
    if (draw(f, 0, &other) || other.n != f->n) return "zero halo";
    for (int k = 0; k < other.n; k++)
        if (other.piece[k].from != 0 || other.piece[k].to != 1) return "zero halo";
    /* what a wider halo shows, a narrower one shows */
    if (draw(f, f->width / 2, &other)) return "narrower halo";
    if (difference(f, d, &other, true) > allowed) return "narrower halo shows less";
    /* order and direction of the edges */
    g = *f;
    for (int k = g.n - 1; k > 0; k--) {
        const int j = below(&rng, k + 1);
        const halo_edge_t swap = g.edge[k];
        g.edge[k] = g.edge[j];
        g.edge[j] = swap;
    }
    bool turned[MOST];
    for (int k = 0; k < g.n; k++) {
        turned[g.edge[k].id] = below(&rng, 2);
        if (turned[g.edge[k].id]) g.edge[k] = (halo_edge_t){g.edge[k].q, g.edge[k].p, g.edge[k].id};
    }
    if (draw(&g, f->width, &other)) return "order";
    for (int k = 0; k < other.n; k++) {
        halo_ref_piece_t *p = &other.piece[k];
        if (turned[p->edge]) *p = (halo_ref_piece_t){p->edge, 1 - p->to, 1 - p->from};
    }
    for (int from = 0, to; from < other.n; from = to) { /* turned edges' pieces came in reverse */
        for (to = from; to < other.n && other.piece[to].edge == other.piece[from].edge;) to++;
        if (!turned[other.piece[from].edge]) continue;
        for (int a = from, b = to - 1; a < b; a++, b--) {
            const halo_ref_piece_t swap = other.piece[a];
            other.piece[a] = other.piece[b];
            other.piece[b] = swap;
        }
    }
    if (!f->ends && other.crossings != d->crossings) return "order changes the crossings";
    if (difference(f, d, &other, false) > allowed) return "order";
    /* quarter turns and mirrors of the page */
    g = *f;
    const int turn = below(&rng, 7) + 1;
    for (int k = 0; k < g.n; k++) {
        halo_point_t *p[2] = {&g.edge[k].p, &g.edge[k].q};
        for (int end = 0; end < 2; end++) {
            if (turn & 1) p[end]->x = -p[end]->x;
            if (turn & 2) p[end]->y = -p[end]->y;
            if (turn & 4) {
                const int32_t swap = p[end]->x;
                p[end]->x = p[end]->y;
                p[end]->y = swap;
            }
        }
    }
    if (draw(&g, f->width, &other)) return "turned page";
    if (!f->ends && other.crossings != d->crossings) return "turned page changes the crossings";
    if (difference(f, d, &other, false) > allowed) return "turned page";
    return breaks_a_law_of_space(f, d, &rng);
}

/* Is it wrong, and how? */
static const char *fault_of(const frame_t *f, frame_ink_t *d, uint64_t seed, int *err, halo_ref_report_t *r) {
    *err = draw(f, f->width, d);
    *r = halo_ref_judge(f->edge, f->n, f->width, f->ends, f->contact, d->piece, *err ? 0 : d->n);
    return *err ? "error" : r->beyond > 0 ? "the reference" : breaks_a_law(f, d, seed);
}

/* Leaves out edges while something stays wrong, and prints the rest. */
static void shrink(frame_t *f, frame_ink_t *d, uint64_t seed) {
    halo_ref_report_t r;
    int err;
    for (int k = f->n - 1; k >= 0 && f->n > 1; k--) {
        frame_t less = *f;
        less.n--;
        for (int i = k; i < less.n; i++) less.edge[i] = (halo_edge_t){f->edge[i + 1].p, f->edge[i + 1].q, i};
        if (fault_of(&less, d, seed, &err, &r)) *f = less;
    }
    print_message("#   shrunk: %s; width %d, contact %d%s\n", fault_of(f, d, seed, &err, &r), f->width, f->contact,
                  f->ends ? ", ends" : "");
    for (int k = 0; k < f->n; k++) {
        const halo_edge_t *e = &f->edge[k];
        print_message("    {{%d, %d, %d}, {%d, %d, %d}, %d},\n", e->p.x, e->p.y, e->p.z, e->q.x, e->q.y, e->q.z, k);
    }
}

static void test_random(void **state) {
    (void)state;
    static frame_t f;
    static frame_ink_t d;
    uint64_t first = 0, count = cases_scaled(6000);
    int failed = 0;
    double worst = 0, drawn = 0, whole = 0;
    int64_t edges = 0, crossings = 0, contacts = 0, open = 0;
    if (cases_only_seed(&first))
        count = 1;
    else
        first = cases_first(first, count);
    for (uint64_t seed = first; seed < first + count && failed < 10; seed++) {
        make(&f, seed);
        int err;
        halo_ref_report_t r;
        const char *fault = fault_of(&f, &d, seed, &err, &r);
        worst = fmax(worst, fmax(r.missing, r.falsely) - allowance(&f) + 4);
        edges += f.n, crossings += r.crossings, contacts += r.contacts, open += r.open;
        drawn += r.drawn, whole += r.whole;
        if (fault) {
            failed++;
            print_message("# FAILED: RIDGELINE_SEED=%llu build/tests/property/test_halo_random\n"
                          "#   %d edges, width %d%s: error %d, missing %g, false %g, edge %d: %s\n",
                          (unsigned long long)seed, f.n, f.width, f.ends ? " ends" : "", err, r.missing, r.falsely,
                          r.edge, fault);
            if (failed <= 3) shrink(&f, &d, seed);
        }
    }
    print_message(
        "# test_halo_random: %llu frames, %lld edges, %lld crossings, %lld contacts, %lld open; ends off by %.2f "
        "lat at most (%.4f steps) beyond length * width / 2^36; %.1f %% of the ink drawn\n",
        (unsigned long long)count, (long long)edges, (long long)crossings, (long long)contacts / 2, (long long)open,
        worst, worst / 409.6, 100 * drawn / whole);
    assert_int_equal(failed, 0);
}

/* Enough edges for all levels of the grid and for sorting by rows first: all crossings, counted by sweeping over x. */
typedef struct count {
    int64_t pairs;
    uint64_t sum;
} count_t;

static int by_left(const void *a, const void *b) {
    const halo_edge_t *e = a, *f = b;
    const int32_t l = e->p.x < e->q.x ? e->p.x : e->q.x, m = f->p.x < f->q.x ? f->p.x : f->q.x;
    return (l > m) - (l < m);
}

static bool crosses(const halo_edge_t *a, const halo_edge_t *b) {
    const int64_t ax = a->q.x - a->p.x, ay = a->q.y - a->p.y, bx = b->q.x - b->p.x, by = b->q.y - b->p.y;
    const int64_t o1 = ax * (b->p.y - a->p.y) - ay * (b->p.x - a->p.x),
                  o2 = ax * (b->q.y - a->p.y) - ay * (b->q.x - a->p.x);
    const int64_t o3 = bx * (a->p.y - b->p.y) - by * (a->p.x - b->p.x),
                  o4 = bx * (a->q.y - b->p.y) - by * (a->q.x - b->p.x);
    if (ax * by == ay * bx) return false;
    return (o1 <= 0 || o2 <= 0) && (o1 >= 0 || o2 >= 0) && (o3 <= 0 || o4 <= 0) && (o3 >= 0 || o4 >= 0);
}

static void test_many(void **state) {
    (void)state;
    const int size[] = {500, 3000, 20000, 70000};
    for (int c = 0; c < 12; c++) {
        const int n = size[c % 4];
        uint64_t rng = 77 + (uint64_t)c;
        halo_edge_t *edge = malloc((size_t)n * sizeof *edge);
        for (int i = 0; i < n; i++) {
            halo_point_t p = anywhere(&rng, 1 << 23, 0), q;
            /* lengths of one size; of all sizes; the same with clusters */
            const int32_t l =
                c < 4 ? (1 << 23) / (int32_t)sqrt(n) + 1 : 1 << (2 + below(&rng, c < 8 || i % 64 ? 13 : 20));
            if (c >= 8 && i % 2 == 0) p.x = p.x / 64 + (1 << 21), p.y = p.y / 64;
            q = (halo_point_t){p.x + below(&rng, 2 * l) - l, p.y + below(&rng, 2 * l) - l, 1 << 27};
            p.z = q.z = i * 3500; /* no contacts */
            edge[i] = (halo_edge_t){p, q, i};
        }
        halo_t h;
        const size_t bytes = HALO_BYTES(n, 6 * n);
        void *mem = malloc(bytes);
        halo_init(&h, mem, bytes);
        for (int i = 0; i < n; i++) assert_int_equal(halo_add(&h, i, edge[i].p, edge[i].q), 0);
        const int err = halo_cut(&h, 0);
        if (err != 0) print_message("# case %d: error %d, %lld crossings\n", c, err, (long long)h.crossings);
        assert_int_equal(err, 0);
        int64_t found = 0;
        qsort(edge, (size_t)n, sizeof *edge, by_left);
        for (int i = 0; i < n; i++) {
            const int32_t right = edge[i].p.x > edge[i].q.x ? edge[i].p.x : edge[i].q.x;
            const int32_t low = edge[i].p.y < edge[i].q.y ? edge[i].p.y : edge[i].q.y;
            const int32_t top = edge[i].p.y < edge[i].q.y ? edge[i].q.y : edge[i].p.y;
            for (int j = i + 1; j < n; j++) {
                const halo_edge_t *e = &edge[j];
                if ((e->p.x < e->q.x ? e->p.x : e->q.x) > right) break;
                if ((e->p.y < low && e->q.y < low) || (e->p.y > top && e->q.y > top)) continue;
                found += crosses(&edge[i], e);
            }
        }
        print_message("# %d edges: %lld crossings, %.2f pairs looked at per edge, %.1f bytes per edge in all\n", n,
                      (long long)h.crossings, (double)h.tests / n, (double)h.used / n);
        assert_int_equal(h.crossings, found);
        free(mem);
        free(edge);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_many),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
