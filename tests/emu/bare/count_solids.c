/* count_solids.c - what solids, haloes and polygons cost on a core, as count.c does it for surfaces: 4 x 4 cubes
 * (Franklin & Akman's figure 4), and two stars for the clipper.
 *
 *     kernel scene bits elements       then the marks: the kernel alone, its output dropped
 *
 * Elements: edges; faces that look at the eye (area); vertices (clip). */
#include "tests/emu/bare/bare.h"

#include <stddef.h>

#include "error.h"
#include "hidden/area.h"
#include "hidden/convex.h"
#include "hidden/halo.h"
#include "lang/settings.h"
#include "tests/bench/stars.h"

#define SIDE 4
#define CUBES (SIDE * SIDE)
#define RAYS 40 /* vertices of a star's contour */

enum kernel { CONVEX, AREA, HALO, CLIP, KERNELS };
static const struct {
    const char *name, *scene, *bits;
} kernels[KERNELS] = {{"convex", "4 x 4 cubes", "14"},
                      {"area", "4 x 4 cubes", "14"},
                      {"halo", "4 x 4 cubes", "8.7"},
                      {"clip", "spiky stars", "8.7"}};
static uint64_t memory[COUNT_BYTES / 8];

static packed_t vertex[8 * CUBES][3];
static int32_t word[30 * CUBES];
static mesh_t mesh;
static solid_t solid;
static camera_t cam;
static solid_map_t map;
static uint8_t *rest;
static size_t left;

static void make_mesh(void) {
    static const uint8_t side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    int32_t *w = word + sizeof word / sizeof *word;
    for (int n = 0; n < CUBES; n++) {
        for (int c = 0; c < 8; c++) {
            const int at[3] = {3 * (n % SIDE) + 2 * (c & 1), 3 * (n / SIDE) + 2 * (c >> 1 & 1), 2 * (c >> 2)};
            for (int k = 0; k < 3; k++) vertex[8 * n + c][k] = packed_from_num(num_ldexp(num_from_i64(at[k]), -1));
        }
        for (int f = 0; f < 6; f++) {
            *--w = 4 << 2 | MESH_FACE;
            for (int c = 0; c < 4; c++) *--w = 8 * n + side[f][c];
        }
    }
    mesh = (mesh_t){.nv = 8 * CUBES, .words = 30 * CUBES, .faces = 6 * CUBES, .corners = 24 * CUBES};
    mesh.vertex = (const packed_t(*)[3])vertex;
    mesh.top = word + sizeof word / sizeof *word;
}

static int prepare(void *mem, size_t bytes) {
    static uint64_t place[(SOLID_MAP_BYTES(8 * CUBES) + 7) / 8];
    static settings_t set;
    const mesh_t *m = &mesh;
    make_mesh();
    settings_default(&set);
    set.view.rot_x = num_from_i64(65);
    int err = solid_build(&solid, &m, 1, mem, bytes);
    view_box_t box = {.solid = true};
    for (int k = 0; k < 3; k++) box.lo[k] = solid.lo[k], box.hi[k] = solid.hi[k];
    if (!err) err = camera_setup(&cam, &set, &box);
    const size_t used = (solid.bytes + 7) & ~(size_t)7;
    rest = (uint8_t *)mem + used;
    left = bytes - used;
    return err ? err : solid_map_setup(&map, &solid, &cam, place);
}

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

static int64_t run_halo(void) {
    halo_t h;
    halo_init(&h, rest, left);
    int err = 0;
    for (int32_t e = 0; e < solid.ne && !err; e++) {
        const solid_place_t *p = &map.place[solid.edge[e].v[0]], *q = &map.place[solid.edge[e].v[1]];
        err = halo_add(&h, e, (halo_point_t){p->x, p->y, -(p->z / 4)}, (halo_point_t){q->x, q->y, -(q->z / 4)});
    }
    if (!err) err = halo_cut(&h, 0);
    if (!err) err = halo_draw(&h, 16384, &(halo_sink_t){NULL, drop_halo});
    return err ? err : solid.ne;
}

static int64_t run_clip(void) {
    static poly_vertex_t star[2][2 * RAYS], v[8 * RAYS];
    static int32_t end[8 * RAYS];
    const int32_t ends[2] = {RAYS, 2 * RAYS};
    static clip_t c;
    for (int s = 0; s < 2; s++)
        for (int k = 0; k < 2 * RAYS; k++) {
            poly_vertex_t *p = &star[s][k];
            star_point(1, s, k / RAYS, k % RAYS, RAYS, &p->at.x, &p->at.y);
            p->tag = k;
        }
    clip_out_t out = {.v = v, .end = end, .n_max = 8 * RAYS, .contours_max = 8 * RAYS};
    const clip_job_t job = {{star[0], ends, 2}, {star[1], ends, 2}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    int err = clip_run(&c, &job, rest, left);
    if (!err) err = clip_trace(&c, 0, &out);
    return err ? err : 4 * RAYS;
}

static int64_t run(enum kernel kernel) {
    const ink_sink_t ink = {NULL, drop_ink};
    const hidden_job_t job = {.mem = rest, .bytes = left, .sink = &ink};
    const area_sink_t polygons = {.polygon = drop_polygon, .wire = drop_wire};
    hidden_stats_t stats;
    area_stats_t area;
    int err;
    switch (kernel) {
    case CONVEX:
        err = convex_draw(&map, NULL, &job, &stats);
        return err ? err : stats.edges;
    case AREA:
        err = area_sort(&map, rest, left, &polygons, NULL, NULL, &area);
        return err ? err : area.polygons;
    case HALO:
        return run_halo();
    default:
        return run_clip();
    }
}

int bare_main(int argc, char **argv) {
    (void)argc, (void)argv;
    if (prepare(memory, sizeof memory)) return 1;
    for (int k = 0; k < KERNELS; k++) {
        bare_mark();
        const int64_t elements = run((enum kernel)k);
        bare_mark();
        const char *const text[] = {kernels[k].name, kernels[k].scene, kernels[k].bits};
        for (int i = 0; i < 3; i++) bare_text(text[i]), bare_text("\t");
        bare_number(elements);
        bare_text("\n");
    }
    return 0;
}
