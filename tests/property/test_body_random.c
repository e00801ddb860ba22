/* Consolidation (hidden/area/area_body.h) changes no picture: of random scenes, and of rows of bodies that touch or
 * hide each other, every face shows as much sorted in bodies as sorted one by one. RIDGELINE_CASES multiplies the
 * count, RIDGELINE_SEED tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "hidden/area/area.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_scenes.h"

#define CASES 1500
#define FLUSH 1000000000u /* so much more than their seed is the number of flush scenes: a group of their own */
#define UNITS 24          /* borders may be so far apart: welds, and a rounding each time an area is cut */

/* What is seen of the faces: their areas, and how long the borders are. */
typedef struct seen {
    double *area, *border;
} seen_t;

static int take(void *ctx, int32_t face, const poly_t *p) {
    seen_t *s = ctx;
    s->area[face] += fabs((double)poly_area2(p)) / 2;
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int32_t k = first; k < p->end[c]; k++) {
            const poly_point_t a = p->v[k].at, b = p->v[k + 1 < p->end[c] ? k + 1 : first].at;
            s->border[face] += hypot(b.x - (double)a.x, b.y - (double)a.y);
        }
    return 0;
}

static int no_wire(void *ctx, int32_t edge, int32_t from, int32_t to) {
    (void)ctx, (void)edge, (void)from, (void)to;
    return 0;
}

typedef struct account {
    long long scenes, faces, bodies, lateral[2], clips[2];
    double worst; /* units */
} account_t;

static int look(const solid_stage_t *t, bool one_by_one, seen_t *s, area_stats_t *stats) {
    const size_t n = (size_t)t->solid.nf;
    s->area = calloc(n, sizeof *s->area);
    s->border = calloc(n, sizeof *s->border);
    void *mem = malloc(8 * t->bytes);
    if (!s->area || !s->border || !mem) abort();
    const area_sink_t sink = {.ctx = s, .polygon = take, .wire = no_wire, .one_by_one = one_by_one};
    int err = area_sort(&t->map, mem, 8 * t->bytes, &sink, NULL, NULL, stats);
    free(mem);
    return err;
}

/* True if both show the same. */
static bool compare(const solid_scene_t *s, account_t *all) {
    solid_stage_t t;
    seen_t seen[2];
    area_stats_t stats[2] = {{0}};
    bool good = true;
    if (solid_stage_make(&t, s, true)) {
        solid_stage_free(&t);
        return true;
    }
    for (int k = 0; k < 2; k++) good &= look(&t, k, &seen[k], &stats[k]) == 0;
    for (int32_t f = 0; f < t.solid.nf && good; f++) {
        const double border = fmax(seen[0].border[f], seen[1].border[f]) + UNITS,
                     off = fabs(seen[0].area[f] - seen[1].area[f]) / border;
        all->worst = fmax(all->worst, off);
        good &= off <= UNITS;
    }
    all->scenes++;
    all->faces += t.solid.nf;
    all->bodies += stats[0].bodies;
    for (int k = 0; k < 2; k++) {
        all->lateral[k] += stats[k].lateral;
        all->clips[k] += stats[k].clips;
        free(seen[k].area);
        free(seen[k].border);
    }
    solid_stage_free(&t);
    return good;
}

static void tell(const char *what, const account_t *a) {
    print_message(
        "# bodies, %s: %lld scenes, %lld faces, %lld bodies as silhouettes; faces' borders %.2f units apart at "
        "worst; %lld lateral comparisons (%lld one by one), %lld clips (%lld)\n",
        what, a->scenes, a->faces, a->bodies, a->worst, a->lateral[0], a->lateral[1], a->clips[0], a->clips[1]);
}

/* Scenes of a kind, `count` seeds from `first` on. */
static void run(const char *what, uint64_t first, uint64_t count, void (*make)(solid_scene_t *s, uint64_t seed)) {
    account_t all = {0};
    uint64_t from, to;
    int failed = 0;
    if (!cases_seeds(first, cases_scaled(count), &from, &to)) return;
    for (uint64_t seed = from; seed < to && failed < 3; seed++) {
        solid_scene_t s;
        make(&s, seed);
        if (!compare(&s, &all)) {
            failed++;
            print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_body_random: %s, %s\n",
                          (unsigned long long)seed, what, s.what);
        }
        solid_scene_free(&s);
    }
    tell(what, &all);
    assert_int_equal(failed, 0);
    assert_true(to - from == 1 || all.bodies > 0);
}

static void random_scene(solid_scene_t *s, uint64_t seed) {
    solid_scene_random(s, seed, seed % 8 ? 5 : 20);
}
static void random_scenes(void **state) {
    (void)state;
    run("random", 1, CASES, random_scene);
}

static void flush_scene(solid_scene_t *s, uint64_t seed) {
    solid_scene_flush(s, seed - FLUSH, 12);
}
static void flush_scenes(void **state) {
    (void)state;
    run("flush", FLUSH + 1, CASES / 5, flush_scene);
}

static void rows_of_bodies(void **state) {
    (void)state;
    account_t all = {0};
    for (int k = 2; k <= 14; k += 4)
        for (int x = 0; x <= 90; x += 15) {
            solid_scene_t s;
            solid_scene_cubes(&s, k);
            s.set.view.rot_x = num_from_i64(x);
            assert_true(compare(&s, &all));
            solid_scene_free(&s);
        }
    tell("cubes", &all);
    assert_true(all.clips[0] < all.clips[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_scenes),
        cmocka_unit_test(flush_scenes),
        cmocka_unit_test(rows_of_bodies),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
