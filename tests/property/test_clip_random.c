/* The clipper on random pairs of polygons on small lattices, where nearly everything that can touch or coincide does:
 * contours that cross themselves, share edges and vertices, holes that touch; and large ones, whose stretches are swept
 * as one edge. Each pair is judged by tests/oracle/clip_judge.h.
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
#include "tests/oracle/clip_judge.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/slab_area.h"

typedef clip_shape_t shape_t;

static shape_t subject, clip, *const result = clip_judge_result;
static uint64_t memory[1 << 17];
static clip_account_t account;

static void random_shape(shape_t *s, uint64_t *rng, int lattice, int32_t scale, int jitter) {
    int contours = 1 + scene_below(rng, 3);
    clip_shape_clear(s);
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
            clip_shape_add(s, at.x, at.y);
        }
        clip_shape_close(s);
    }
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
        const char *wrong = clip_judge(&subject, &clip, fill, seed % 400 == 0, &account);
        if (!wrong) continue;
        failed++;
        print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_clip_random: %s\n",
                      (unsigned long long)seed, wrong);
        clip_shape_print("subject", &subject);
        clip_shape_print("clip", &clip);
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
    for (int i = 0; i < n; i++) {
        double a = 2 * 3.14159265358979 * i / n, r = size * (1 + depth * cos(waves * a + turn));
        clip_shape_add(s, (int32_t)lrint(x + r * cos(a + turn)), (int32_t)lrint(y + r * tall * sin(a + turn)));
    }
    clip_shape_close(s);
}

/* The shape with each edge in as many pieces as its ends allow, some of them. */
static void refine(shape_t *s, uint64_t *rng) {
    static shape_t from;
    from = *s;
    clip_shape_clear(s);
    for (int c = 0, first = 0; c < from.out.contours; first = from.end[c++]) {
        for (int i = first; i < from.end[c]; i++) {
            poly_point_t a = from.v[i].at, b = from.v[i + 1 < from.end[c] ? i + 1 : first].at;
            int pieces = scene_below(rng, 4) == 0 ? 1 : 1 + scene_below(rng, 40);
            for (int k = 0; k < pieces; k++)
                clip_shape_add(s, a.x + (int32_t)lrint((double)(b.x - a.x) * k / pieces),
                               a.y + (int32_t)lrint((double)(b.y - a.y) * k / pieces));
        }
        clip_shape_close(s);
    }
}

static void random_large(shape_t *s, uint64_t *rng, int kind, double size) {
    clip_shape_clear(s);
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
        const clip_job_t job = {subject.poly, clip.poly, fill, {clip_judge_table[k], clip_judge_table[k + 1]}};
        if (clip_run_by(&work, &job, memory, sizeof memory, false)) return "error";
        for (int i = 0; i < 2; i++) {
            clip_shape_clear(&plain[i]);
            if (clip_trace(&work, i, &plain[i].out)) return "error";
        }
        const int sweeps = work.stats.sweeps;
        if (clip_run_by(&work, &job, memory, sizeof memory, true)) return "error";
        *stretched = work.stretches > 0;
        for (int i = 0; i < 2; i++) {
            shape_t *r = &result[k + i];
            int32_t counted = clip_count(&work, i);
            clip_shape_clear(r);
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
    for (int k = 0; k < 6; k++)
        if (clip_judge_off(&subject, &clip, fill, k, false) >
            .5 * sqrt(2) * borders * (work.stats.sweeps - 1) + 1e-9 * borders * borders)
            return "further off than rounding is";
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
        clip_shape_print("subject", &subject);
        clip_shape_print("clip", &clip);
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
