/* picture_solids.c - solids and wire frames: put together, mapped, and given to the kernel that `set hidden3d` says. */
#include "app/picture_stages.h"

#include "error.h"
#include "hidden/convex.h"
#include "hidden/wires.h"
#include "view/dash.h"

static void hide_tick(void *ctx, int32_t done, int32_t of) {
    picture_tell(ctx, PICTURE_HIDE, done, of);
}

static int32_t list_meshes(const plot_t *plot, const mesh_t *mesh[CONFIG_PLOT_ITEMS]) {
    for (int32_t k = 0; k < plot->n; k++) mesh[k] = &plot->item[k].mesh;
    return plot->n;
}

size_t picture_solids_bytes(const plot_t *plot) {
    const mesh_t *mesh[CONFIG_PLOT_ITEMS];
    int32_t n = list_meshes(plot, mesh), vertices = 0, corners = 0, faces = 0, segments = 0;
    for (int32_t k = 0; k < n; k++) {
        vertices += mesh[k]->nv;
        faces += mesh[k]->faces;
        corners += mesh[k]->corners;
        segments += mesh[k]->segments;
    }
    size_t bytes = solid_bytes(mesh, n) + SOLID_MAP_BYTES(vertices);
    if (plot->settings->hidden == HIDDEN_NONE) return bytes;
    if (plot->settings->hidden == HIDDEN_HALO) return bytes + picture_halo_bytes(plot, 4);
    return bytes + convex_bytes(faces, corners, segments);
}

/* The scene in the arena, of which it keeps only what it needs. */
static int build(picture_t *p) {
    const mesh_t *mesh[CONFIG_PLOT_ITEMS];
    int32_t n = list_meshes(p->plot, mesh);
    size_t bytes = arena_left(&p->arena);
    arena_t before = p->arena;
    bytes = bytes > 16 ? bytes - 16 : 0;
    void *mem = arena_take(&p->arena, bytes);
    int err = solid_build(&p->solid, mesh, n, mem, bytes);
    if (err) return err;
    p->arena = before;
    arena_take(&p->arena, p->solid.bytes); /* the same place */
    void *place = arena_take(&p->arena, SOLID_MAP_BYTES(p->solid.nv));
    if (!place) return ERR_FULL;
    p->stats.map_bytes = p->solid.bytes + SOLID_MAP_BYTES(p->solid.nv);
    err = picture_camera(p, p->solid.lo, p->solid.hi);
    if (!err) err = solid_map_setup(&p->solid_map, &p->solid, &p->camera, place);
    if (err) return err;
    p->lines[0] = p->solid_map.lines;
    p->spaces = 1;
    return 0;
}

int picture_solids(picture_t *p, const pen_sink_t *pen) {
    const settings_t *set = p->plot->settings;
    if (set->hidden == HIDDEN_AREA) return ERR_UNSUPPORTED;
    int err = build(p);
    if (err) return err;
    size_t kernel_bytes = 0;
    void *kernel = set->hidden == HIDDEN_NONE ? NULL : picture_kernel_memory(p, &kernel_bytes);
    err = picture_open(p, pen, 1, 4 * (int64_t)p->solid.ne);
    if (err) return err;
    dash_t dash = {p->lines, p->cut.next};
    cut_t cut = {p->lines, dash_sink(&dash)};
    const ink_sink_t hidden = cut_sink(&cut);
    const hidden_job_t job = {kernel, kernel_bytes, &p->sink, hide_tick, p, false};
    if (set->hidden == HIDDEN_NONE)
        err = wires_draw(&p->solid_map, &job, &p->stats.hidden);
    else if (set->hidden == HIDDEN_HALO)
        err = picture_halo_solids(p, &job);
    else
        err = convex_draw(&p->solid_map, set->dashed ? &hidden : NULL, &job, &p->stats.hidden);
    p->stats.facets = p->solid.nf;
    p->stats.kernel_bytes = p->stats.hidden.bytes;
    return err ? err : picture_close(p);
}
