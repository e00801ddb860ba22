/* picture_solids.c - solids and wire frames: put together, mapped, and given to the kernel that `set hidden3d` says. */
#include "app/picture_stages.h"

#include "error.h"
#include "hidden/area/area_face.h"
#include "hidden/area/area_tone.h"
#include "hidden/halo/halo_ink.h"
#include "hidden/solid/convex.h"
#include "hidden/solid/once.h"
#include "hidden/solid/seams.h"
#include "hidden/solid/wires.h"
#include "hidden/surface/perimeter.h"
#include "scene/surface_mesh.h"
#include "view/dash.h"
#include <string.h>

static void hide_tick(void *ctx, int32_t done, int32_t of) {
    picture_hidden(ctx, done, of, 0);
}

/* The meshes of all items; those of surfaces have their counts only. */
typedef struct meshes {
    mesh_t of[CONFIG_PLOT_ITEMS];
    const mesh_t *list[CONFIG_PLOT_ITEMS];
} meshes_t;

/* Where lines are hidden the cells of surfaces are two triangles each, whose common line is drawn where a twisted one
 * is folded for the eye: else it would end in lines that go nowhere. */
static bool wants_triangles(const plot_t *plot) {
    return CONFIG_PLOT_ITEMS > 1 && plot->settings->hidden != HIDDEN_NONE && plot->settings->hidden != HIDDEN_HALO;
}

/* The area sort alone knows details. */
static bool wants_details(const plot_t *plot) {
    return CONFIG_AREA && plot->settings->hidden == HIDDEN_AREA;
}

static void list_meshes(const plot_t *plot, meshes_t *m) {
    for (int32_t k = 0; k < plot->n; k++) {
        m->list[k] = plot->item[k].solid ? &plot->item[k].mesh : &m->of[k];
        if (!plot->item[k].solid) surface_mesh_counts(&plot->item[k].surface, wants_triangles(plot), &m->of[k]);
    }
}

#if CONFIG_AREA
bool picture_surfaces_are_solids(const plot_t *plot) {
    const settings_t *s = plot->settings;
    const bool area = s->hidden == HIDDEN_AREA;
    bool same = true;
    if (area && s->shadow) return true;
    if (s->hidden == HIDDEN_NONE || s->hidden == HIDDEN_HORIZON || s->hidden == HIDDEN_HALO) return false;
    if (s->hatch_um > 0 && !area) return false; /* only the area sort hatches faces */
    for (int32_t k = 1; k < plot->n && same; k++)
        same = perimeter_same_points(&plot->item[0].surface, &plot->item[k].surface);
    return !same;
}
#endif

bool picture_is_solid(const plot_t *plot) {
    bool solid = plot->kind == PLOT_SOLIDS && !picture_is_terrain(plot);
    for (int32_t k = 0; k < plot->n; k++) solid &= plot->item[k].solid && !plot->item[k].parametric;
    return solid;
}

static size_t surfaces_bytes(const plot_t *plot) {
    size_t bytes = 0;
    for (int32_t k = 0; k < plot->n; k++) {
        const surface_t *s = &plot->item[k].surface;
        if (!plot->item[k].solid) bytes += (SURFACE_MESH_BYTES(s->nx, s->ny, wants_triangles(plot)) + 15) & ~(size_t)15;
    }
    return bytes;
}

static mesh_t sum_of(const plot_t *plot, const meshes_t *m) {
    mesh_t sum = {0};
    for (int32_t k = 0; k < plot->n; k++) {
        sum.nv += m->list[k]->nv;
        sum.faces += m->list[k]->faces;
        sum.corners += m->list[k]->corners;
        sum.segments += m->list[k]->segments + m->list[k]->details;
    }
    return sum;
}

/* Before a scene is put together its bodies are counted by Euler's formula; 1 at least. */
static size_t bodies_of(const mesh_t *sum) {
    const int32_t twice = sum->nv - sum->corners / 2 + sum->faces;
    return twice < 4 ? 1 : (size_t)twice / 2;
}

/* Faces of bodies that are not convex hide one by one. Before the scene is put together what has more than thirty faces
 * is taken not to be convex. */
static size_t lone_faces(const picture_t *p, const mesh_t *sum) {
    const solid_t *s = &p->solid;
    size_t n = 0;
    if (p->stats.map_bytes == 0)
        return sum->faces > 15 * (sum->nv - sum->corners / 2 + sum->faces) ? (size_t)sum->faces : 0;
    for (int32_t k = 0; k < s->no; k++) n += s->object[k].kind == SOLID_CONVEX ? 0 : (size_t)s->object[k].faces;
    return n;
}

/* The area sort's: with shadows there are the lit polygons, the view from a light and a part for their borders. */
static size_t area_needs(const picture_t *p, const mesh_t *sum) {
#if CONFIG_AREA
    const settings_t *set = p->plot->settings;
    light_t light[LIGHTS_MAX];
    const int64_t seen = p->stats.map_bytes > 0 ? area_faces_most(&p->solid_map) : sum->faces / 2;
    const int32_t corners = (int32_t)(sum->corners * seen / (sum->faces + 1));
    if (!set->shadow) return area_least_bytes((int32_t)seen, corners, 0);
    return area_least_bytes((int32_t)seen, corners, picture_lights(set, light)) + SOLID_MAP_BYTES(sum->nv);
#else
    (void)p, (void)sum;
    return 0;
#endif
}

/* Hiding: of faces half look at the eye, and of a convex body half of the edges are outlines or fewer. */
static size_t hiding_needs(const picture_t *p, const mesh_t *sum, size_t edges, size_t objects) {
    const enum hidden_mode hidden = p->plot->settings->hidden;
    const size_t faces = (size_t)sum->faces, corners = (size_t)sum->corners;
    if (hidden == HIDDEN_NONE) return 0;
    if (CONFIG_HALO && hidden == HIDDEN_HALO)
        return halo_ink_needs((int32_t)edges, (int32_t)edges - sum->corners / 2, (int32_t)bodies_of(sum));
    if (CONFIG_AREA && hidden == HIDDEN_AREA) return area_needs(p, sum);
    const size_t lone = lone_faces(p, sum) / 2, wholes = lone == 0 ? objects : 0;
    return faces + 5 * objects + 48 * (lone + wholes) + 12 * faces + 4 * corners + 16 * 8;
}

/* And ordering, at the least. */
static size_t kernel_needs(const picture_t *p, const mesh_t *sum, size_t edges, size_t objects) {
    return hiding_needs(p, sum, edges, objects) + PATH_BYTES_MIN + 32;
}

size_t picture_solids_needs(const picture_t *p) {
    const plot_t *plot = p->plot;
    const solid_t *s = &p->solid;
    meshes_t m;
    list_meshes(plot, &m);
    const mesh_t sum = sum_of(plot, &m);
    const bool built = p->stats.map_bytes > 0;
    const size_t edges = built ? (size_t)s->ne : (size_t)(sum.corners / 2 + sum.segments);
    const size_t objects = built ? (size_t)s->no : (size_t)sum.faces / 6 + 1;
    const size_t building = solid_bytes_least(m.list, plot->n) + surfaces_bytes(plot);
    const size_t kept = built ? p->stats.map_bytes
                              : (size_t)sum.nv * sizeof(solid_vertex_t) + (size_t)sum.corners * sizeof(int32_t) +
                                    (size_t)sum.faces * sizeof(solid_face_t) + objects * sizeof(solid_object_t) +
                                    edges * sizeof(solid_edge_t) + SOLID_MAP_BYTES(sum.nv);
    /* Of what coincides some stays: of bodies that stand in line a fifth of the edges, of one body hardly any. */
    const size_t guess = (size_t)sum.corners / 2 * (bodies_of(&sum) > 1 ? 4 + 48 / 5 : 4 + 48 / 12);
    const size_t once = ONCE_BYTES_LEAST(edges, sum.nv), same = p->found_same ? p->same_bytes : guess,
                 hiding = same + kernel_needs(p, &sum, edges, objects);
    const size_t then = kept + (once > hiding ? once : hiding);
    return building > then ? building : then;
}

size_t picture_solids_bytes(const plot_t *plot) {
    meshes_t m;
    list_meshes(plot, &m);
    const mesh_t sum = sum_of(plot, &m);
    size_t bytes = solid_bytes(m.list, plot->n) + SOLID_MAP_BYTES(sum.nv) + surfaces_bytes(plot);
    bytes += ONCE_BYTES(sum.corners + sum.segments);
    if (plot->settings->hidden == HIDDEN_NONE) return bytes;
    if (CONFIG_HALO && plot->settings->hidden == HIDDEN_HALO) return bytes + picture_halo_bytes(plot, 4);
    if (plot->settings->hidden == HIDDEN_AREA) return bytes + area_bytes(sum.faces, sum.corners) * 4 / 3;
    return bytes + convex_bytes(sum.faces, sum.corners, sum.segments);
}

/* Surfaces among the solids become meshes, at the upper end of the arena, until all is put together. */
static int make_surfaces(picture_t *p, meshes_t *m) {
    const plot_t *plot = p->plot;
    const range_t *z = &plot->settings->z;
    for (int32_t k = 0; k < plot->n; k++) {
        const surface_t *s = &plot->item[k].surface;
        if (plot->item[k].solid) continue;
        size_t bytes = (SURFACE_MESH_BYTES(s->nx, s->ny, wants_triangles(plot)) + 15) & ~(size_t)15;
        if ((int64_t)s->nx * s->ny > INT32_MAX / 8 || bytes + 16 > arena_left(&p->arena)) return ERR_FULL;
        uintptr_t end = (uintptr_t)(p->arena.base + p->arena.bytes);
        p->arena.bytes -= bytes + end % 16;
        surface_mesh(s, z->auto_lo ? NULL : &z->lo, z->auto_hi ? NULL : &z->hi, wants_triangles(plot),
                     p->arena.base + p->arena.bytes, &m->of[k]);
        p->stats.evaluated += (int64_t)s->nx * s->ny;
    }
    return 0;
}

/* The scene in the arena, of which it keeps only what it needs. */
static int put_together(picture_t *p) {
    meshes_t m;
    const size_t all = p->arena.bytes;
    list_meshes(p->plot, &m);
    int err = make_surfaces(p, &m);
    if (err) return err;
    const arena_t before = p->arena;
    size_t bytes = 0;
    void *mem = arena_take_rest(&p->arena, &bytes);
    err = solid_build(&p->solid, m.list, p->plot->n, mem, bytes);
    p->arena = before;
    p->arena.bytes = all;
    if (!err) arena_take(&p->arena, p->solid.bytes); /* the same place */
    if (!err && !wants_details(p->plot)) solid_free_details(&p->solid);
    return err;
}

/* Only the convex kernel draws them: wire frames show what is behind, and the area sort takes faces apart. */
static int add_seams(picture_t *p) {
#if CONFIG_AREA
    const settings_t *set = p->plot->settings;
    if (!set->seams || (set->hidden != HIDDEN_PERIMETER && set->hidden != HIDDEN_CONVEX)) return 0;
    const arena_t before = p->arena;
    size_t bytes = 0, kept = 0;
    void *mem = arena_take_rest(&p->arena, &bytes);
    int err = mem ? seams_add(&p->solid, mem, bytes, &kept) : ERR_FULL;
    p->arena = before;
    if (!err && kept > 0) arena_take(&p->arena, kept); /* the same place */
    p->solid.bytes += kept;
    return err;
#else
    (void)p;
    return 0;
#endif
}

/* The box of the axes has room for what parametric surfaces leave out. */
static void widen(const plot_t *plot, num_t lo[3], num_t hi[3]) {
#if CONFIG_PARAMETRIC
    for (int32_t i = 0; i < plot->n; i++)
        for (int k = 0; k < 2 && plot->item[i].parametric; k++) {
            const num_t *e = plot->item[i].extent[k];
            if (num_cmp(e[0], lo[k]) < 0) lo[k] = e[0];
            if (num_cmp(e[1], hi[k]) > 0) hi[k] = e[1];
        }
#else
    (void)plot, (void)lo, (void)hi;
#endif
}

static int build(picture_t *p) {
    int err = put_together(p);
    if (!err) err = add_seams(p);
    if (err) return err;
    void *place = arena_take(&p->arena, SOLID_MAP_BYTES(p->solid.nv));
    if (!place) return ERR_FULL;
    p->stats.map_bytes = p->solid.bytes + SOLID_MAP_BYTES(p->solid.nv);
    num_t lo[3], hi[3];
    memcpy(lo, p->solid.lo, sizeof lo);
    memcpy(hi, p->solid.hi, sizeof hi);
    widen(p->plot, lo, hi);
    err = picture_camera(p, lo, hi);
    if (!err) err = solid_map_setup(&p->solid_map, &p->solid, &p->camera, place);
    if (err) return err;
    p->spaces = CONFIG_AREA ? LINE_CLASSES : 1;
    for (int32_t k = 0; k < p->spaces; k++) p->lines[k] = p->solid_map.lines;
    return 0;
}

#if CONFIG_AREA
#define BORDERS_SHARE 16

bool picture_is_hatched(const plot_t *plot) {
    const settings_t *set = plot->settings;
    if (plot->kind == PLOT_SURFACES && !picture_wants_solids(plot))
        return set->hatch_um > 0 && set->hidden != HIDDEN_HORIZON && set->hidden != HIDDEN_HALO &&
               set->hidden != HIDDEN_NONE;
    return picture_wants_solids(plot) && set->hidden == HIDDEN_AREA && set->hatch_um > 0;
}

void picture_setup_hatch(const picture_t *p, hatch_t *hatch) {
    const settings_t *set = p->plot->settings;
    num_t degrees = num_mul(num_from_i64(set->hatch_mdeg), num_from_decimal(1, -3));
    hatch_setup(hatch, &p->camera.window, degrees, (int32_t)((int64_t)set->hatch_um * LAT_PER_MM / 1000));
}

int32_t picture_lights(const settings_t *set, light_t light[LIGHTS_MAX]) {
    int32_t n = 0;
    for (int k = 0; k < LIGHTS_MAX; k++) {
        if (!set->light[k].on) continue;
        for (int i = 0; i < 3; i++)
            light[n].at[i] = num_mul(num_from_i64(set->light[k].milli[i]), num_from_decimal(1, -3));
        light[n++].point = set->light[k].point;
    }
    return n;
}

/* Runs that hatching adds, about. */
static int64_t hatch_runs(const picture_t *p) {
    return picture_is_hatched(p->plot) ? 32 * (int64_t)hatch_lines(&p->hatch) : 0;
}

static bool has_borders(const plot_t *plot) {
    const settings_t *set = plot->settings;
    return picture_wants_solids(plot) && set->hidden == HIDDEN_AREA && set->shadow && set->shadow_outline;
}

/* A part of the memory keeps the lines that are no edges, as long as they are drawn. */
static int setup_tones(picture_t *p) {
    if (picture_is_hatched(p->plot)) {
        picture_setup_hatch(p, &p->hatch);
        p->lines[LINE_HATCH] = p->hatch.lines;
    }
    if (!has_borders(p->plot)) return 0;
    size_t bytes = arena_left(&p->arena) / BORDERS_SHARE;
    void *mem = arena_take(&p->arena, bytes);
    if (!mem) return ERR_FULL;
    borders_init(&p->borders, mem, bytes, &p->camera.window);
    p->lines[LINE_SHADOW] = p->borders.lines;
    return 0;
}

static int draw_area(picture_t *p, const ink_sink_t *behind, const hidden_job_t *job) {
    const settings_t *set = p->plot->settings;
    area_tone_t tone = {.shadow = set->shadow};
    if (picture_is_hatched(p->plot)) tone.hatch = &p->hatch;
    if (has_borders(p->plot)) tone.borders = &p->borders;
    tone.lights = picture_lights(set, tone.light);
    for (int32_t n = 0; n < tone.lights; n++) /* directions are those of the picture */
        for (int k = 0; k < 3 && !tone.light[n].point; k++)
            tone.light[n].at[k] = num_div(tone.light[n].at[k], p->camera.unit[k]);
    return area_draw(&p->solid_map, tone.hatch || tone.borders ? &tone : NULL, behind, job, &p->stats.hidden, &p->area);
}
#else
static int64_t hatch_runs(const picture_t *p) {
    (void)p;
    return 0;
}
static int draw_area(picture_t *p, const ink_sink_t *behind, const hidden_job_t *job) {
    (void)p, (void)behind, (void)job;
    return ERR_UNSUPPORTED;
}
#endif

/* By the kernel that is set; dashes: where hidden parts go, if they go anywhere. */
static int hide(picture_t *p, const ink_sink_t *dashes, const hidden_job_t *job) {
    const settings_t *set = p->plot->settings;
    if (set->hidden == HIDDEN_NONE) return wires_draw(&p->solid_map, job, &p->stats.hidden);
    if (set->hidden == HIDDEN_HALO) return CONFIG_HALO ? picture_halo_solids(p, job) : ERR_UNSUPPORTED;
    if (set->hidden == HIDDEN_AREA) return draw_area(p, dashes, job);
    return convex_draw(&p->solid_map, set->dashed ? dashes : NULL, job, &p->stats.hidden);
}

static bool is_inside(const picture_t *p) {
    bool inside = true;
    for (int32_t k = 0; k < p->spaces; k++) inside &= p->lines[k].all_inside;
    return inside;
}

/* With all memory that is left, of which it keeps little. */
static int find_what_coincides(picture_t *p, once_t *once) {
    const arena_t before = p->arena;
    size_t bytes = 0;
    void *mem = arena_take_rest(&p->arena, &bytes);
    const settings_t *set = p->plot->settings;
    const bool away =
        set->dashed || set->hidden == HIDDEN_NONE || set->hidden == HIDDEN_HALO || set->hidden == HIDDEN_AREA;
    const bool plenty = p->hooks && p->hooks->generous;
    int err = mem ? once_build(once, &p->solid_map, away, plenty, mem, bytes) : ERR_FULL;
    p->arena = before;
    if (err || once->bytes == 0) return err;
    meshes_t m;
    list_meshes(p->plot, &m);
    const mesh_t sum = sum_of(p->plot, &m);
    const size_t rest = kernel_needs(p, &sum, (size_t)p->solid.ne, (size_t)p->solid.no);
    const size_t wanted = rest + rest / 4; /* how often haloed lines cross is a guess */
    if (bytes - once->bytes < wanted) once_spare(once, wanted - (bytes - once->bytes));
    arena_take(&p->arena, once->bytes); /* the same place */
    return 0;
}

/* In what is left of the memory, of a scene that does not fit; for picture_solids_needs. */
static void count_crossings(picture_t *p) {
    size_t bytes = 0;
    void *mem = arena_take_rest(&p->arena, &bytes);
    const ink_sink_t sink = picture_drop(p);
    const hidden_job_t job = {mem, bytes, &sink, hide_tick, p, 0, NULL};
    picture_halo_solids(p, &job);
    p->stats.kernel_bytes = p->stats.hidden.bytes;
}

int picture_solids(picture_t *p, const pen_sink_t *pen) {
    int err = build(p);
    if (err) return err;
#if CONFIG_AREA
    err = setup_tones(p);
    if (err) return err;
#endif
    once_t once;
    err = find_what_coincides(p, &once);
    if (CONFIG_AREA && err == ERR_FULL && p->plot->settings->hidden == HIDDEN_HALO) count_crossings(p);
    if (err) return err;
    p->same_bytes = once.bytes;
    p->found_same = true;

    size_t bytes = 0;
    void *mem = picture_kernel_memory(p, &bytes);
    err = picture_open(p, pen, 1, 4 * (int64_t)p->solid.ne + hatch_runs(p));
    if (err) return err;
    dash_t dash = {p->lines, p->cut.next};
    cut_t cut[2] = {{p->lines, once_seen(&once, p->cut.next)}, {p->lines, once_dashed(&once, dash_sink(&dash))}};
    ink_sink_t seen = is_inside(p) ? cut[0].next : cut_sink(&cut[0]), hidden = cut_sink(&cut[1]);
#if CONFIG_AREA
    const bool outline = p->plot->settings->outline;
    line_sorter_t sorter[2] = {{&p->solid_map, outline, false, seen}, {&p->solid_map, outline, true, hidden}};
    seen = line_class_sink(&sorter[0]);
    hidden = line_class_sink(&sorter[1]);
#endif
    const hidden_job_t job = {mem, bytes, &seen, hide_tick, p, 0, NULL};
    err = hide(p, &hidden, &job);
    if (!err) err = once_finish(&once);
    p->stats.facets = p->solid.nf;
    p->stats.kernel_bytes = once.bytes + p->stats.hidden.bytes;
    return err ? err : picture_close(p);
}
