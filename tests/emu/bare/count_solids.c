/* count_solids.c - what solids, haloes and polygons cost on a core, as count.c does it for surfaces. Built once for
 * each number of bits of the solids' lattice (SOLID_BITS, scene/solid.h); the program of those that are shipped also
 * runs haloes and the clipper, on pages of several lattices.
 *
 *     kernel family bits elements       then the marks: the kernel alone, its output dropped
 *
 * Elements: edges; faces that look at the eye (area); vertices (clip). */
#include "tests/emu/bare/bare.h"

#include <math.h>
#include <stddef.h>

#include "error.h"
#include "hidden/area/area.h"
#include "hidden/solid/convex.h"
#include "lang/settings.h"
#include "tests/emu/bare/count_bodies.h"
#include "tests/oracle/halo_scenes.h"

#define SHIPPED 28
#define ABOVE_STEP 14 /* bits of the solids' lattice: an A4 page is 2^14 steps wide */
#define LAT_PER_STEP 409.6
#define EDGES 200 /* of a wire frame, at most */

static uint64_t memory[COUNT_BYTES / 8];
static solid_t solid;
static solid_map_t map;
static uint8_t *rest; /* what the solid leaves of the memory */
static size_t left;

static int drop_ink(void *ctx, const ink_piece_t *p) {
    return (void)ctx, (void)p, 0;
}
static int drop_polygon(void *ctx, int32_t face, const poly_t *p) {
    return (void)ctx, (void)face, (void)p, 0;
}
static int drop_wire(void *ctx, int32_t edge, int32_t from_q30, int32_t to_q30) {
    return (void)ctx, (void)edge, (void)from_q30, (void)to_q30, 0;
}
static int drop_halo(void *ctx, int32_t id, uint32_t from_q30, uint32_t to_q30) {
    return (void)ctx, (void)id, (void)from_q30, (void)to_q30, 0;
}

static void tell(const char *kernel, const char *family, const char *bits, int64_t elements) {
    const char *const text[] = {kernel, family, bits};
    for (int i = 0; i < 3; i++) bare_text(text[i]), bare_text("\t");
    bare_number(elements);
    bare_text("\n");
}

static int prepare(const mesh_t *m) {
    static uint64_t place[(SOLID_MAP_BYTES(BODY_VERTICES) + 7) / 8];
    static settings_t set;
    static camera_t cam;
    settings_default(&set);
    set.view.rot_x = num_from_i64(65);
    int err = solid_build(&solid, &m, 1, memory, sizeof memory);
    view_box_t box = {.solid = true};
    for (int k = 0; k < 3; k++) box.lo[k] = solid.lo[k], box.hi[k] = solid.hi[k];
    if (!err) err = camera_setup(&cam, &set, &box);
    const size_t used = (solid.bytes + 7) & ~(size_t)7;
    rest = (uint8_t *)memory + used;
    left = sizeof memory - used;
    return err ? err : solid_map_setup(&map, &solid, &cam, place);
}

static void count_solids(const char *bits, bool area) {
    const ink_sink_t ink = {NULL, drop_ink};
    const area_sink_t polygons = {.polygon = drop_polygon, .wire = drop_wire};
    for (enum body b = BODY_CUBES; b < BODIES; b++) {
        hidden_stats_t stats = {0};
        area_stats_t sorted = {0};
        int err = prepare(body_mesh(b));
        const hidden_job_t job = {.mem = rest, .bytes = left, .sink = &ink};
        bare_mark();
        if (!err && area) err = area_sort(&map, rest, left, &polygons, NULL, NULL, &sorted);
        if (!err && !area) err = convex_draw(&map, NULL, &job, &stats);
        bare_mark();
        tell(area ? "area" : "convex", body_name[b], bits, err ? err : area ? sorted.polygons : stats.edges);
    }
}

static int32_t coarse(int32_t v, double unit) {
    return (int32_t)floor(v / unit + .5);
}

static void count_halo(const char *family, halo_edge_t *edge, int32_t n, double width, const char *bits, double unit) {
    halo_t h;
    int err = 0;
    for (int32_t k = 0; k < n; k++)
        for (int end = 0; end < 2; end++) {
            halo_point_t *p = end ? &edge[k].q : &edge[k].p;
            p->x = coarse(p->x, unit), p->y = coarse(p->y, unit);
        }
    halo_init(&h, memory, sizeof memory);
    bare_mark();
    for (int32_t k = 0; k < n && !err; k++) err = halo_add(&h, k, edge[k].p, edge[k].q);
    if (!err) err = halo_cut(&h, 0);
    if (!err) err = halo_draw(&h, coarse((int32_t)width, unit), &(halo_sink_t){NULL, drop_halo});
    bare_mark();
    tell("halo", family, bits, err ? err : n);
}

static void count_clip(int spiky, const char *bits, double unit) {
    static poly_vertex_t star[2][2 * STAR_RAYS], v[8 * STAR_RAYS];
    static int32_t end[8 * STAR_RAYS];
    static clip_t c;
    const int32_t ends[2] = {STAR_RAYS, 2 * STAR_RAYS};
    for (int s = 0; s < 2; s++) body_star(spiky, s, unit, star[s]);
    clip_out_t out = {.v = v, .end = end, .n_max = 8 * STAR_RAYS, .contours_max = 8 * STAR_RAYS};
    const clip_job_t job = {{star[0], ends, 2}, {star[1], ends, 2}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    bare_mark();
    int err = clip_run(&c, &job, memory, sizeof memory);
    if (!err) err = clip_trace(&c, 0, &out);
    bare_mark();
    tell("clip", spiky ? "spiky" : "round", bits, err ? err : 4 * STAR_RAYS);
}

static void count_page(const char *bits, double unit) {
    static halo_edge_t edge[EDGES];
    halo_scene_random(edge, 100, .1);
    count_halo("random edges", edge, 100, .002 * HALO_SCENE_PAGE, bits, unit);
    const double size = halo_scene_cubes(edge, 4);
    count_halo("cubes", edge, 192, .05 * size, bits, unit);
    for (int spiky = 0; spiky < 2; spiky++) count_clip(spiky, bits, unit);
}

int bare_main(int argc, char **argv) {
    (void)argc, (void)argv;
    const int below = SOLID_BITS - ABOVE_STEP; /* a step: 0 to 19 */
    const char bits[] = {(char)(below < 10 ? '0' + below : '1'), (char)(below < 10 ? 0 : '0' + below - 10), 0};
    for (int area = 0; area < 2; area++) count_solids(bits, area);
    if (SOLID_BITS != SHIPPED) return 0;
    count_page("8.68", 1);
    count_page("8", LAT_PER_STEP / 256);
    count_page("4", LAT_PER_STEP / 16);
    count_page("2", LAT_PER_STEP / 4);
    count_page("0", LAT_PER_STEP);
    return 0;
}
