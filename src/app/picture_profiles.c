/* picture_profiles.c - the horizon algorithm's scenes: profiles across the view. */
#include "app/picture_stages.h"

#include "error.h"
#include "hidden/surface/horizon.h"
#include "scene/bilinear.h"

static void measure_tick(void *ctx, int32_t done, int32_t of) {
    picture_tell(ctx, PICTURE_MEASURE, done, of);
}

static void hide_tick(void *ctx, int32_t done, int32_t of) {
    const picture_t *p = ctx;
    picture_hidden(ctx, done, of, p->profiles.max_points);
}

/* A height of the function or between the data, undefined beyond `set zrange`. */
static num_t height_at(void *ctx, num_t x, num_t y) {
    picture_t *p = ctx;
    const plot_item_t *item = &p->plot->item[0];
    const range_t *r = &p->plot->settings->z;
    num_t z = item->anywhere ? item->anywhere->z_at(item->surface.ctx, x, y) : bilinear_at(&item->surface, x, y);
    p->stats.evaluated++;
    if (z.undef) return z;
    if (!r->auto_lo && num_cmp(z, r->lo) < 0) return num_undef();
    if (!r->auto_hi && num_cmp(z, r->hi) > 0) return num_undef();
    return z;
}

/* Memory that makes heights anywhere cheaper, if it takes an eighth of what is left at the most; NULL takes it back. */
static void lend(picture_t *p, bool give) {
    const plot_item_t *item = &p->plot->item[0];
    if (p->plot->kind == PLOT_SOLIDS || !item->anywhere) return;
    void *mem = give ? p->arena.base + p->arena.used + arena_gap(&p->arena) : NULL;
    size_t used = item->anywhere->lend(item->surface.ctx, mem, picture_spare(p, 8));
    if (used) arena_take(&p->arena, used);
    p->stats.map_bytes += used;
}

/* isosamples[1] profiles of samples[0] points. The ground direction of the view must be known before the heights are: a
 * camera for any range of heights gives it. */
static int cut_surface(picture_t *p) {
    const settings_t *s = p->plot->settings;
    const surface_t *f = &p->plot->item[0].surface;
    const num_t lo[3] = {f->x_of(f->ctx, 0), f->y_of(f->ctx, 0), num_from_i64(0)};
    const num_t hi[3] = {f->x_of(f->ctx, f->nx - 1), f->y_of(f->ctx, f->ny - 1), num_from_i64(1)};
    int err = picture_camera(p, lo, hi);
    if (err) return err;
    p->sampled = (profiles_sampled_t){
        .fn_ctx = p, .z_of = height_at, .x0 = lo[0], .x1 = hi[0], .y0 = lo[1], .y1 = hi[1], .samples = s->samples[0]};
    return profiles_from_function(&p->profiles, &p->sampled, &p->camera, s->isosamples[1]);
}

/* isosamples[1] profiles through the triangles. */
static int cut_terrain(picture_t *p) {
    const mesh_t *mesh = &p->plot->item[0].mesh;
    if (mesh->nv < 1) return ERR_EMPTY;
    num_t lo[3], hi[3];
    for (int32_t v = 0; v < mesh->nv; v++) {
        for (int axis = 0; axis < 3; axis++) {
            num_t at = packed_num(mesh->vertex[v][axis]);
            if (v == 0 || num_cmp(at, lo[axis]) < 0) lo[axis] = at;
            if (v == 0 || num_cmp(at, hi[axis]) > 0) hi[axis] = at;
        }
    }
    int err = picture_camera(p, lo, hi);
    if (err) return err;
    size_t bytes = arena_left(&p->arena) / 4;
    void *mem = arena_take(&p->arena, bytes);
    return profiles_from_mesh(&p->profiles, &p->mesh, mesh, &p->camera, p->plot->settings->isosamples[1], mem, bytes);
}

/* Keeps all points if that takes at most half of what is left. */
static void cache_points(picture_t *p) {
    size_t bytes = picture_spare(p, 2);
    arena_t before = p->arena;
    void *mem = arena_take(&p->arena, bytes);
    size_t used = mem ? profiles_cache_fill(&p->profiles_cache, &p->profiles, mem, bytes, measure_tick, p) : 0;
    p->arena = before;
    if (used) arena_take(&p->arena, used); /* the same place, no more than needed */
    p->stats.cache_bytes += used;
}

static int draw(picture_t *p, const pen_sink_t *pen) {
    const plot_t *plot = p->plot;
    size_t kernel_bytes;
    void *kernel = picture_kernel_memory(p, &kernel_bytes);
    lend(p, true);
    int err = plot->kind != PLOT_SOLIDS ? cut_surface(p) : CONFIG_HALO ? cut_terrain(p) : ERR_UNSUPPORTED;
    if (!err) cache_points(p);
    if (!err) err = profile_map_measure(&p->profile_map, &p->profiles, measure_tick, p);
    if (!err) err = picture_camera(p, p->profile_map.lo, p->profile_map.hi);
    if (!err) err = profile_map_setup(&p->profile_map, &p->camera);
    if (err) return err;
    p->lines[0] = p->profile_map.lines;
    p->spaces = 1;
    int64_t points = (int64_t)p->profiles.count * p->profiles.max_points;
    const hidden_pause_t *pause = picture_pause(p);
    err = picture_open(p, pen, p->profiles.count, points);
    if (err) return err;

    const hidden_job_t job = {kernel, kernel_bytes, &p->sink, hide_tick, p, 0, pause};
    err = horizon_draw(&p->profiles, &p->camera, plot->settings->horizon_infinite, &job, &p->stats.hidden);
    p->stats.facets = p->stats.hidden.facets;
    p->stats.kernel_bytes = p->stats.hidden.bytes;
    return err ? err : picture_close(p);
}

int picture_profiles(picture_t *p, const pen_sink_t *pen) {
    if (p->plot->n > 1) return ERR_UNSUPPORTED;
    int err = draw(p, pen);
    lend(p, false);
    return err;
}
