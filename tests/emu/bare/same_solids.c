/* same_solids.c - solids: every seed's scene through the convex kernel with its hidden parts, the area sort, in every
 * other scene with hatching, shadows and their borders, and haloed lines; and two polygons through the clipper. Parts
 * that can be left out: objects, a bit each. */
#include "tests/emu/bare/same.h"

#include <stddef.h>

#include "error.h"
#include "hidden/area/area_tone.h"
#include "hidden/solid/convex.h"
#include "hidden/halo/halo.h"
#include "tests/emu/bare/bare.h"
#include "tests/emu/bare/integer_scene.h"
#include "tests/emu/bare/integer_solids.h"

#define BYTES (3 << 19)
#define HALO_WIDTH 16384

static integer_solids_t scene;
static uint64_t memory[BYTES / 8], places[(SOLID_MAP_BYTES(INTEGER_SOLIDS_VERTICES) + 7) / 8], border_memory[4096];

static void heading(const same_t *s, const char *text) {
    if (s->telling) bare_text(text);
}

static void tell_scene(const same_t *s) {
    const settings_t *set = &scene.set;
    if (!s->telling) return;
    bare_text(set->view.from ? "set view from" : "set view");
    for (int k = 0; k < 3 && set->view.from; k++) same_num(s, set->view.eye[k]);
    if (!set->view.from) same_num(s, set->view.rot_x), same_num(s, set->view.rot_z);
    for (int32_t v = 0; v < scene.mesh.nv; v++) {
        bare_text("\nv");
        for (int k = 0; k < 3; k++) same_num(s, packed_num(scene.vertex[v][k]));
    }
    for (mesh_walk_t w = mesh_walk(&scene.mesh); mesh_next(&w);) {
        bare_text(w.kind == MESH_FACE ? "\nf" : "\nl");
        for (int32_t k = 0; k < w.count; k++) bare_text(" "), bare_number(mesh_at(&w, k) + 1);
    }
    bare_text("\n");
}

static void enter_stats(same_t *s, int err, const hidden_stats_t *stats) {
    same_enter(s, err, " error, ");
    same_enter(s, stats->edges, " edges, ");
    same_enter(s, stats->tests, " tests, ");
    same_enter(s, stats->crossings, " crossings, ");
    same_enter(s, stats->pieces, " pieces\n");
}

static void enter_area(same_t *s, const area_stats_t *a) {
    const int64_t of[] = {a->polygons, a->lateral, a->clips,   a->removed, a->errors, a->intersections,
                          a->visible,  a->behind,  a->windows, a->boxes,   a->depth};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) same_enter(s, of[k], " ");
    heading(s, "of the area sort\n");
}

static void draw_area(const solid_map_t *map, const hidden_job_t *job, bool toned, same_t *s) {
    static hatch_t hatch;
    static borders_t borders;
    static area_tone_t tone;
    hidden_stats_t stats = {0};
    area_stats_t area = {0};
    hatch_setup(&hatch, &map->cam->window, num_from_i64(30), 4 * LAT_PER_MM);
    borders_init(&borders, border_memory, sizeof border_memory, &map->cam->window);
    tone = (area_tone_t){.hatch = &hatch, .borders = &borders, .shadow = true, .lights = 1};
    for (int k = 0; k < 3; k++) tone.light[0].at[k] = num_from_i64(k == 2 ? 3 : -1 - k);
    int err = area_draw(map, toned ? &tone : NULL, NULL, job, &stats, &area);
    enter_stats(s, err, &stats);
    enter_area(s, &area);
    for (int32_t k = 0; k < borders.n && toned; k++)
        for (int end = 0; end < 2; end++) {
            same_enter(s, borders.list[k].end[end].x, " ");
            same_enter(s, borders.list[k].end[end].y, end ? "\n" : " ");
        }
}

static int take_halo(void *ctx, int32_t id, uint32_t from_q30, uint32_t to_q30) {
    same_enter(ctx, id, " ");
    same_enter(ctx, from_q30, " ");
    same_enter(ctx, to_q30, "\n");
    return 0;
}

static void draw_halo(const solid_map_t *map, void *mem, size_t bytes, same_t *s) {
    halo_t h;
    int err = 0;
    halo_init(&h, mem, bytes);
    for (int32_t e = 0; e < map->solid->ne && !err; e++) {
        const int32_t *v = map->solid->edge[e].v;
        const solid_place_t *p = &map->place[v[0]], *q = &map->place[v[1]];
        if (!solid_map_is_good(map, v[0]) || !solid_map_is_good(map, v[1])) continue;
        err = halo_add(&h, e, (halo_point_t){p->x, p->y, -(p->z / 4)}, (halo_point_t){q->x, q->y, -(q->z / 4)});
    }
    if (!err) err = halo_cut(&h, s->hash & 1 ? HALO_WIDTH : 0);
    if (!err) err = halo_draw(&h, HALO_WIDTH, &(halo_sink_t){s, take_halo});
    same_enter(s, err, " error, ");
    same_enter(s, h.tests, " tests, ");
    same_enter(s, h.crossings, " crossings\n");
}

static void clip_polygons(uint64_t seed, void *mem, size_t bytes, same_t *s) {
    enum { MOST = 12 };
    static poly_vertex_t v[2][MOST], out_v[8 * MOST];
    static int32_t out_end[8 * MOST], end[2][2];
    static clip_t c;
    uint64_t rng = seed ^ 0xc11bu;
    const uint32_t coarse = integer_below(&rng, 2) ? 8 : 1 << 20; /* half of them full of coincidences */
    poly_t p[2];
    for (int k = 0; k < 2; k++) {
        const int32_t n = 3 + (int32_t)integer_below(&rng, MOST / 2 - 2), m = 3 + (int32_t)integer_below(&rng, 4);
        for (int32_t i = 0; i < n + m; i++) {
            v[k][i].at.x = (int32_t)integer_below(&rng, coarse);
            v[k][i].at.y = (int32_t)integer_below(&rng, coarse);
            v[k][i].tag = i;
        }
        end[k][0] = n, end[k][1] = n + m;
        p[k] = (poly_t){v[k], end[k], 2};
    }
    const clip_job_t job = {
        p[0], p[1], integer_below(&rng, 2) ? CLIP_NONZERO : CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_OUTSIDE}};
    int err = clip_run(&c, &job, mem, bytes);
    for (int which = 0; which < 2 && !err; which++) {
        clip_out_t out = {.v = out_v, .end = out_end, .n_max = 8 * MOST, .contours_max = 8 * MOST};
        err = clip_trace(&c, which, &out);
        for (int32_t i = 0; i < out.n; i++) {
            same_enter(s, out_v[i].at.x, " ");
            same_enter(s, out_v[i].at.y, " ");
            same_enter(s, out_v[i].tag, "\n");
        }
        for (int32_t i = 0; i < out.contours; i++) same_enter(s, out_end[i], i + 1 < out.contours ? " " : "\n");
    }
    same_enter(s, err, " error, ");
    same_enter(s, c.stats.sweeps, " sweeps, ");
    same_enter(s, c.stats.crossings, " crossings\n");
}

void same_scene(uint64_t seed, same_t *s) {
    static solid_t solid;
    static camera_t cam;
    static solid_map_t map;
    const ink_sink_t sink = {s, same_ink};
    hidden_stats_t stats = {0};
    integer_solids_random(&scene, seed, s->drop);
    tell_scene(s);
    const mesh_t *m = &scene.mesh;
    int err = solid_build(&solid, &m, 1, memory, sizeof memory);
    view_box_t box = {.solid = true};
    for (int k = 0; k < 3 && !err; k++) box.lo[k] = solid.lo[k], box.hi[k] = solid.hi[k];
    if (!err) err = camera_setup(&cam, &scene.set, &box);
    if (!err) err = solid_map_setup(&map, &solid, &cam, places);
    same_enter(s, err, " error\n");
    if (err) return;
    const size_t used = (solid.bytes + 7) & ~(size_t)7;
    const hidden_job_t job = {.mem = (uint8_t *)memory + used, .bytes = sizeof memory - used, .sink = &sink};
    heading(s, "convex\n");
    err = convex_draw(&map, &sink, &job, &stats);
    enter_stats(s, err, &stats);
    heading(s, "area sort\n");
    draw_area(&map, &job, seed & 1, s);
    heading(s, "haloes\n");
    draw_halo(&map, job.mem, job.bytes, s);
    heading(s, "clipper\n");
    clip_polygons(seed, job.mem, job.bytes, s);
}
