/* The clipper on random pairs of polygons on small lattices, where nearly everything that can touch or coincide does:
 * contours that cross themselves, share edges and vertices, holes that touch. Each pair is judged by slab areas
 * (tests/oracle/slab_area.h) against what was asked for, and by laws that hold exactly: no two edges of a result cross
 * or overlap, areas add up, a result clipped again stays itself, every hole lies in its outer contour.
 *
 * A result may differ from the exact one by what rounding crossings does: where no crossing was rounded by nothing,
 * otherwise by at most half a unit a sweep along all borders.
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "poly/clip_inner.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/slab_area.h"

#define MOST 4096

typedef struct shape {
    poly_vertex_t v[MOST];
    int32_t end[MOST], outer[MOST];
    clip_out_t out;
    poly_t poly;
} shape_t;

static shape_t subject, clip, result[6], once_more;
static uint64_t memory[1 << 17];

static struct {
    int64_t pairs, rounded, contours, holes, sweeps, exact;
    int most_sweeps;
    double worst; /* symmetric difference over length of all borders: mean displacement, units */
} account;

static void clear(shape_t *s) {
    s->out = (clip_out_t){s->v, s->end, s->outer, 0, MOST, 0, MOST};
    s->poly = (poly_t){s->v, s->end, 0};
}

static void close_contour(shape_t *s) {
    s->end[s->out.contours++] = s->out.n;
    s->poly.contours = s->out.contours;
}

static void random_shape(shape_t *s, uint64_t *rng, int lattice, int32_t scale, int jitter) {
    int contours = 1 + scene_below(rng, 3);
    clear(s);
    for (int c = 0; c < contours; c++) {
        bool box = scene_below(rng, 4) == 0;
        int vertices = 3 + scene_below(rng, 6);
        int x0 = scene_below(rng, lattice), y0 = scene_below(rng, lattice), x1 = 1 + scene_below(rng, lattice),
            y1 = 1 + scene_below(rng, lattice);
        for (int i = 0; i < (box ? 4 : vertices); i++) {
            int x = box ? (i == 1 || i == 2 ? x1 : x0) : scene_below(rng, lattice + 1);
            int y = box ? (i >= 2 ? y1 : y0) : scene_below(rng, lattice + 1);
            poly_point_t at = {(x - lattice / 2) * scale, (y - lattice / 2) * scale};
            if (jitter)
                at.x += scene_below(rng, 2 * jitter + 1) - jitter, at.y += scene_below(rng, 2 * jitter + 1) - jitter;
            s->v[s->out.n] = (poly_vertex_t){at, s->out.n};
            s->out.n++;
        }
        close_contour(s);
    }
}

/* |dx| + |dy| of all edges: splitting never makes it longer, cancelling makes it shorter. */
static int64_t way(const poly_t *p) {
    int64_t sum = 0;
    for (int c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int i = first; i < p->end[c]; i++) {
            poly_point_t a = p->v[i].at, b = p->v[i + 1 < p->end[c] ? i + 1 : first].at;
            sum += llabs((int64_t)b.x - a.x) + llabs((int64_t)b.y - a.y);
        }
    return sum;
}

static int run(const poly_t *s, const poly_t *c, enum clip_fill fill, enum clip_result a, enum clip_result b,
               shape_t *to_a, shape_t *to_b, clip_t *work) {
    const clip_job_t job = {*s, *c, fill, {a, b}};
    int err = clip_run(work, &job, memory, sizeof memory);
    shape_t *to[2] = {to_a, to_b};
    for (int k = 0; k < 2 && !err; k++) {
        if (!to[k]) continue;
        clear(to[k]);
        err = clip_trace(work, k, &to[k]->out);
        to[k]->poly.contours = to[k]->out.contours;
    }
    return err;
}

/* Do collinear edges share more than a point? */
static bool overlap(poly_point_t a, poly_point_t b, poly_point_t c, poly_point_t d) {
    poly_point_t l1 = poly_before(a, b) ? a : b, r1 = poly_before(a, b) ? b : a;
    poly_point_t l2 = poly_before(c, d) ? c : d, r2 = poly_before(c, d) ? d : c;
    return poly_before(l1, r2) && poly_before(l2, r1);
}

/* Do no two edges cross or overlap, and has no edge length zero? */
static bool is_planar(const poly_t *p) {
    int n = poly_vertices(p);
    poly_point_t *a = malloc((size_t)(n + 1) * sizeof *a), *b = malloc((size_t)(n + 1) * sizeof *b);
    bool good = a && b;
    for (int c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int i = first; i < p->end[c]; i++) {
            a[i] = p->v[i].at;
            b[i] = p->v[i + 1 < p->end[c] ? i + 1 : first].at;
        }
    for (int i = 0; i < n && good; i++) {
        if (poly_same(a[i], b[i])) good = false;
        for (int j = 0; j < i && good; j++) {
            int64_t o1 = poly_orient(a[i], b[i], a[j]), o2 = poly_orient(a[i], b[i], b[j]);
            int64_t o3 = poly_orient(a[j], b[j], a[i]), o4 = poly_orient(a[j], b[j], b[i]);
            if (((o1 > 0 && o2 < 0) || (o1 < 0 && o2 > 0)) && ((o3 > 0 && o4 < 0) || (o3 < 0 && o4 > 0))) good = false;
            if (o1 == 0 && o2 == 0 && overlap(a[i], b[i], a[j], b[j])) good = false;
        }
    }
    free(a);
    free(b);
    return good;
}

/* Outer contours turn left, holes right; a hole's area plus that of the others of its outer contour leaves some. */
static bool are_holes_right(const shape_t *s) {
    for (int k = 0; k < s->out.contours; k++) {
        int first = k ? s->end[k - 1] : 0;
        const int32_t end = s->end[k] - first;
        poly_t one = {s->v + first, &end, 1};
        int64_t area = poly_area2(&one);
        account.contours++;
        if (s->outer[k] < 0) {
            if (area <= 0) return false;
            continue;
        }
        account.holes++;
        if (area >= 0 || s->outer[k] >= k || s->outer[s->outer[k]] >= 0) return false;
        /* Every vertex of it is in or on the outer contour: no area of the hole is outside. */
        int o = s->outer[k], from = o ? s->end[o - 1] : 0;
        const int32_t length = s->end[o] - from;
        poly_t outer = {s->v + from, &length, 1};
        clip_t work;
        shape_t *left = &once_more;
        if (run(&one, &outer, CLIP_EVEN_ODD, CLIP_OUTSIDE, CLIP_NOTHING, left, NULL, &work)) return false;
        if (left->out.contours) return false;
    }
    return true;
}

static bool differs(unsigned in, const void *ctx) {
    unsigned table = *(const unsigned *)ctx;
    return (table >> (in & 3) & 1) != (in >> 2 & 1);
}

static const enum clip_result TABLE[6] = {CLIP_INSIDE, CLIP_OUTSIDE, CLIP_REST, CLIP_UNION, CLIP_XOR, CLIP_SUBJECT};

static const char *judge(enum clip_fill fill, bool exact) {
    clip_t work;
    int64_t area[6];
    double borders = slab_border(&subject.poly) + slab_border(&clip.poly);
    int sweeps = 0;
    for (int k = 0; k < 6; k += 2)
        if (run(&subject.poly, &clip.poly, fill, TABLE[k], TABLE[k + 1], &result[k], &result[k + 1], &work))
            return "error";
    sweeps = work.stats.sweeps;
    for (int k = 0; k < 6; k++) {
        if (!is_planar(&result[k].poly)) return "edges of a result cross";
        if (!are_holes_right(&result[k])) return "a hole is in the wrong contour";
        if (way(&result[k].poly) > way(&subject.poly) + way(&clip.poly)) return "borders have become longer";
        area[k] = poly_area2(&result[k].poly);
    }
    account.pairs++;
    account.rounded += work.stats.crossings;
    account.sweeps += sweeps;
    if (sweeps > account.most_sweeps) account.most_sweeps = sweeps;
    if (area[0] + area[1] != area[5]) return "inside and outside are not the subject";
    if (area[1] + area[2] != area[4]) return "outside and rest are not the exclusive or";
    if (area[0] + area[4] != area[3]) return "inside and exclusive or are not the union";
    for (int k = 0; k < 6; k++) {
        slab_scene_t s = {
            {&subject.poly, &clip.poly, &result[k].poly}, {fill == CLIP_NONZERO, fill == CLIP_NONZERO, false}, 3};
        unsigned table = TABLE[k];
        double off = exact ? slab_area_exact(&s, differs, &table) : slab_area(&s, differs, &table);
        if (exact) account.exact++;
        if (off > 1e-9 * borders * borders && work.stats.crossings == 0) return "not the exact result without rounding";
        if (off > .5 * sqrt(2) * borders * (sweeps - 1) + 1e-9 * borders * borders)
            return "further off than rounding is";
        if (borders > 0 && off / borders > account.worst) account.worst = off / borders;
    }
    /* A result is a planar graph already: clipped with itself or alone nothing is rounded and nothing changes. */
    for (int k = 0; k < 6; k++) {
        if (run(&result[k].poly, &result[k].poly, CLIP_EVEN_ODD, CLIP_INSIDE, CLIP_OUTSIDE, &once_more, NULL, &work))
            return "error";
        if (work.stats.sweeps != 1 || poly_area2(&once_more.poly) != area[k])
            return "a result changes when clipped again";
        if (once_more.out.n != result[k].out.n ||
            memcmp(once_more.v, result[k].v, (size_t)once_more.out.n * sizeof once_more.v[0]))
            return "a result's vertices change when clipped again";
    }
    return NULL;
}

static void print(const char *name, const shape_t *s) {
    print_message("#   %s:", name);
    for (int c = 0, first = 0; c < s->poly.contours; first = s->end[c++]) {
        print_message(" (");
        for (int i = first; i < s->end[c]; i++) print_message("%d,%d ", s->v[i].at.x, s->v[i].at.y);
        print_message(")");
    }
    print_message("\n");
}

static void test_random(void **state) {
    (void)state;
    static const int32_t SCALES[] = {1, 1, 2, 3, 7, 100, 1000, 1 << 20, 70000000};
    uint64_t first = cases_first(8000000000, cases_scaled(20000)), count = cases_scaled(20000);
    int failed = 0;
    if (cases_only_seed(&first)) count = 1;
    for (uint64_t seed = first; seed < first + count && failed < 5; seed++) {
        uint64_t rng = seed;
        int lattice = 1 + scene_below(&rng, 12);
        int32_t scale = SCALES[scene_below(&rng, sizeof SCALES / sizeof SCALES[0])];
        int jitter = scale > 50 && scene_below(&rng, 3) == 0 ? 1 : 0;
        enum clip_fill fill = scene_below(&rng, 4) == 0 ? CLIP_NONZERO : CLIP_EVEN_ODD;
        random_shape(&subject, &rng, lattice, scale, jitter);
        random_shape(&clip, &rng, lattice, scale, jitter);
        const char *wrong = judge(fill, seed % 400 == 0);
        if (!wrong) continue;
        failed++;
        print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_clip_random: %s\n",
                      (unsigned long long)seed, wrong);
        print("subject", &subject);
        print("clip", &clip);
    }
    print_message(
        "# test_clip_random: %lld pairs, %lld contours of results, %lld holes; %lld crossings rounded, sweeps "
        "%.2f on average, %d at most; mean displacement of borders at worst %.3f units; %lld areas in rationals\n",
        (long long)account.pairs, (long long)account.contours, (long long)account.holes, (long long)account.rounded,
        (double)account.sweeps / (double)account.pairs, account.most_sweeps, account.worst, (long long)account.exact);
    assert_int_equal(failed, 0);
}

/* ---- large polygons ---- */

/* A contour of n vertices: round with waves, in whole units, so that small ones have upright and level edges, vertices
 * that repeat, and turn back on themselves. */
static void random_round(shape_t *s, uint64_t *rng, double size) {
    int n = 30 + scene_below(rng, 170), waves = scene_below(rng, 9);
    double depth = scene_below(rng, 100) * .01, turn = scene_below(rng, 100), tall = .1 + scene_below(rng, 20) * .1;
    double x = size * (scene_below(rng, 201) - 100) * .01, y = size * (scene_below(rng, 201) - 100) * .01;
    for (int i = 0; i < n; i++, s->out.n++) {
        double a = 2 * 3.14159265358979 * i / n, r = size * (1 + depth * cos(waves * a + turn));
        poly_point_t at = {(int32_t)lrint(x + r * cos(a + turn)), (int32_t)lrint(y + r * tall * sin(a + turn))};
        s->v[s->out.n] = (poly_vertex_t){at, s->out.n};
    }
    close_contour(s);
}

/* The shape with each edge in as many pieces as its ends allow, some of them. */
static void refine(shape_t *s, uint64_t *rng) {
    static shape_t from;
    from = *s;
    clear(s);
    for (int c = 0, first = 0; c < from.out.contours; first = from.end[c++]) {
        for (int i = first; i < from.end[c]; i++) {
            poly_point_t a = from.v[i].at, b = from.v[i + 1 < from.end[c] ? i + 1 : first].at;
            int pieces = scene_below(rng, 4) == 0 ? 1 : 1 + scene_below(rng, 40);
            for (int k = 0; k < pieces; k++, s->out.n++) {
                poly_point_t at = {a.x + (int32_t)lrint((double)(b.x - a.x) * k / pieces),
                                   a.y + (int32_t)lrint((double)(b.y - a.y) * k / pieces)};
                s->v[s->out.n] = (poly_vertex_t){at, s->out.n};
            }
        }
        close_contour(s);
    }
}

static void random_large(shape_t *s, uint64_t *rng, int kind, double size) {
    clear(s);
    if (kind < 2) {
        int contours = 1 + scene_below(rng, 3);
        for (int c = 0; c < contours; c++) random_round(s, rng, size);
    } else {
        random_shape(s, rng, 1 + scene_below(rng, 6), (int32_t)(size / 6) + 1, 0);
        refine(s, rng);
    }
}

static bool is_same(const shape_t *a, const shape_t *b) {
    return a->out.n == b->out.n && a->out.contours == b->out.contours &&
           !memcmp(a->v, b->v, (size_t)a->out.n * sizeof a->v[0]) &&
           !memcmp(a->outer, b->outer, (size_t)a->out.contours * sizeof(int32_t));
}

static double distance(poly_point_t p, poly_point_t a, poly_point_t b) {
    double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y, length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? fmin(fmax((px * dx + py * dy) / length2, 0), 1) : 0;
    return hypot(px - t * dx, py - t * dy);
}

/* How far the farthest vertex of a is from b's border. */
static double farthest(const shape_t *a, const shape_t *b) {
    double worst = 0;
    for (int i = 0; i < a->out.n; i++) {
        double least = INFINITY;
        for (int c = 0, first = 0; c < b->out.contours; first = b->end[c++])
            for (int k = first; k < b->end[c]; k++)
                least = fmin(least, distance(a->v[i].at, b->v[k].at, b->v[k + 1 < b->end[c] ? k + 1 : first].at));
        worst = fmax(worst, least);
    }
    return worst;
}

static struct {
    int stretched, differ;
    double worst;
} large;

/* Results must be the same, vertex by vertex, whether stretches of border are swept as one edge or not. Edges that all
 * but coincide may be rounded in another order, though, or in another sweep: then neither may be off by more than its
 * own roundings, against the exact areas and against the other. */
static const char *judge_large(enum clip_fill fill, bool slabs, bool *stretched) {
    static shape_t plain[2];
    clip_t work;
    for (int k = 0; k < 6; k += 2) {
        const clip_job_t job = {subject.poly, clip.poly, fill, {TABLE[k], TABLE[k + 1]}};
        if (clip_run_by(&work, &job, memory, sizeof memory, false)) return "error";
        for (int i = 0; i < 2; i++) {
            clear(&plain[i]);
            if (clip_trace(&work, i, &plain[i].out)) return "error";
        }
        const int sweeps = work.stats.sweeps;
        if (clip_run_by(&work, &job, memory, sizeof memory, true)) return "error";
        *stretched = work.stretches > 0;
        for (int i = 0; i < 2; i++) {
            shape_t *r = &result[k + i];
            int32_t counted = clip_count(&work, i);
            clear(r);
            if (clip_trace(&work, i, &r->out)) return "error";
            r->poly.contours = r->out.contours;
            if (counted < r->out.n) return "fewer were counted";
            if (is_same(r, &plain[i])) continue;
            double off = fmax(farthest(r, &plain[i]), farthest(&plain[i], r));
            large.differ++;
            large.worst = fmax(large.worst, off);
            slabs = true;
            if (off > .5 * sqrt(2) * (sweeps + work.stats.sweeps - 2)) return "not the same";
        }
    }
    if (!slabs) return NULL;
    double borders = slab_border(&subject.poly) + slab_border(&clip.poly);
    for (int k = 0; k < 6; k++) {
        slab_scene_t s = {
            {&subject.poly, &clip.poly, &result[k].poly}, {fill == CLIP_NONZERO, fill == CLIP_NONZERO, false}, 3};
        unsigned table = TABLE[k];
        if (slab_area(&s, differs, &table) >
            .5 * sqrt(2) * borders * (work.stats.sweeps - 1) + 1e-9 * borders * borders)
            return "further off than rounding is";
    }
    return NULL;
}

static void test_large(void **state) {
    (void)state;
    static const double SIZES[] = {10, 40, 200, 3000, 1e5, 1e7, 1.5e8};
    uint64_t first = cases_first(8500000000, cases_scaled(2000)), count = cases_scaled(2000);
    int failed = 0;
    if (cases_only_seed(&first)) count = 1;
    for (uint64_t seed = first; seed < first + count && failed < 5; seed++) {
        uint64_t rng = seed;
        int kind = scene_below(&rng, 3);
        double size = SIZES[scene_below(&rng, sizeof SIZES / sizeof SIZES[0])];
        random_large(&subject, &rng, kind, size);
        if (kind == 2 || size < 1000) /* where edges of one polygon coincide, either's tag is right */
            for (int k = 0; k < subject.out.n; k++) subject.v[k].tag = 0;
        random_large(&clip, &rng, scene_below(&rng, 4) ? kind : 2 - kind, size);
        if (scene_below(&rng, 4) == 0) { /* the same again, at its place or a bit beside it */
            int32_t dx = scene_below(&rng, 3) - 1, dy = scene_below(&rng, 3) - 1;
            clip = subject;
            clip.poly = (poly_t){clip.v, clip.end, clip.out.contours};
            for (int k = 0; k < clip.out.n; k++) clip.v[k].at.x += dx, clip.v[k].at.y += dy;
        }
        bool some = false;
        const char *wrong = judge_large(seed % 4 ? CLIP_EVEN_ODD : CLIP_NONZERO, seed % 50 == 0, &some);
        large.stretched += some;
        if (!wrong) continue;
        failed++;
        print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_clip_random: large: %s\n",
                      (unsigned long long)seed, wrong);
        print("subject", &subject);
        print("clip", &clip);
    }
    print_message("# test_clip_random: %d pairs of up to 600 vertices each, %d with stretches swept as one edge; %d "
                  "results differ from those without, by %.2f units at most\n",
                  (int)count, large.stretched, large.differ, large.worst);
    assert_int_equal(failed, 0);
    if (count > 100) assert_true(large.stretched > (int)count / 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random), cmocka_unit_test(test_large)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
