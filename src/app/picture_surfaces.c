/* picture_surfaces.c - grids of heights: the perimeter kernel, or all lines where nothing is hidden. */
#include "app/picture_stages.h"

#include "error.h"
#include "hidden/surface/grid_outline.h"
#include "hidden/surface/perimeter.h"
#include "hidden/surface/plain.h"

static void measure_tick(void *ctx, int32_t done, int32_t of) {
    picture_tell(ctx, PICTURE_MEASURE, done, of);
}

/* Called once a row. */
static void hide_tick(void *ctx, int32_t done, int32_t of) {
    const picture_t *p = ctx;
    int32_t facets = 0;
    for (int32_t k = 0; k < p->spaces; k++) facets += p->grid[k].nx;
    picture_hidden(ctx, done, of, facets);
}

static int64_t points_of(const surface_t *s) {
    return (int64_t)s->nx * s->ny;
}

/* Memory that makes the heights of s cheaper, if it takes an eighth of what is left at the most. */
static void lend(picture_t *p, const surface_t *s) {
    if (!s->lend) return;
    size_t most = picture_spare(p, 8);
    void *mem = p->arena.base + p->arena.used + arena_gap(&p->arena);
    size_t used = s->lend(s->ctx, mem, most);
    if (used) arena_take(&p->arena, used);
    p->stats.map_bytes += used;
}

static void take_back(const plot_t *plot) {
    for (int32_t k = 0; k < plot->n; k++) {
        const surface_t *s[3] = {&plot->item[k].surface, &plot->item[k].rows, &plot->item[k].cols};
        for (int i = 0; i < 3; i++) {
            if (s[i]->lend) s[i]->lend(s[i]->ctx, NULL, 0);
        }
    }
}

/* Measures surface number p->spaces. It is cached if that takes at most half of what is left. */
static int add_surface(picture_t *p, const surface_t *s) {
    const range_t *z = &p->plot->settings->z;
    grid_t *g = &p->grid[p->spaces];
    size_t size = (size_t)points_of(s) * sizeof(int32_t);
    int32_t *cache = size <= picture_spare(p, 2) ? arena_take(&p->arena, size) : NULL;
    if (cache) p->stats.cache_bytes += size;
    lend(p, s);
    const bool known = p->hooks && p->hooks->measured && p->spaces == 0 && g->src == s && g->cache == cache;
    int err =
        known ? 0 : grid_measure(g, s, z->auto_lo ? NULL : &z->lo, z->auto_hi ? NULL : &z->hi, cache, measure_tick, p);
    if (err) return err;
    g->to_limits = p->plot->settings->hidden == HIDDEN_NONE;
    p->spaces++;
    return 0;
}

static void scene_box(const picture_t *p, num_t lo[3], num_t hi[3]) {
#if CONFIG_CROP
    grid_t inside;
    bool known = false;
#endif
    for (int32_t k = 0; k < p->spaces; k++) {
        const grid_t *g = &p->grid[k];
        const surface_t *s = g->src;
#if CONFIG_CROP
        /* The axis of heights is as long as the points within the ranges want, without those where lines are cut. Rows
         * and, next, columns of an item that is cropped. */
        const plot_item_t *item = &p->plot->item[k / 2];
        const range_t *z = &p->plot->settings->z;
        if (k % 2 == 0)
            known = item->cropped && !grid_measure(&inside, &item->surface, z->auto_lo ? NULL : &z->lo,
                                                   z->auto_hi ? NULL : &z->hi, NULL, NULL, NULL);
        if (known) g = &inside;
#endif
        const num_t from[3] = {s->x_of(s->ctx, 0), s->y_of(s->ctx, 0), g->z_min};
        const num_t to[3] = {s->x_of(s->ctx, s->nx - 1), s->y_of(s->ctx, s->ny - 1), g->z_max};
        for (int axis = 0; axis < 3; axis++) {
            if (k == 0 || num_cmp(from[axis], lo[axis]) < 0) lo[axis] = from[axis];
            if (k == 0 || num_cmp(to[axis], hi[axis]) > 0) hi[axis] = to[axis];
        }
    }
}

/* A parallel view so near the vertical that over the whole height of the scene a line of sight moves less than
 * 2^-24 of its width: a graph of a function hides nothing then. */
static bool is_vertical(const camera_t *cam, const num_t lo[3], const num_t hi[3]) {
    if (cam->perspective) return false;
    for (int k = 0; k < 2; k++) {
        num_t drift = num_mul(num_abs(cam->eye[k]), num_sub(hi[2], lo[2]));
        num_t allowed = num_mul(num_abs(cam->eye[2]), num_sub(hi[k], lo[k]));
        if (num_cmp(drift, num_ldexp(allowed, -24)) > 0) return false;
    }
    return true;
}

static int map_surfaces(picture_t *p) {
    for (int32_t k = 0; k < p->spaces; k++) {
        grid_t *g = &p->grid[k];
        size_t size = PAGE_MAP_BYTES(g->nx, g->ny);
        void *table = size <= picture_spare(p, 4) ? arena_take(&p->arena, size) : NULL;
        if (table) p->stats.map_bytes += size;
        int err = page_map_setup(&p->map[k], g, &p->camera, table);
        if (err) return err;
        p->lines[k] = p->map[k].lines;
    }
    return 0;
}

/* All lines of every item: family by family, as gnuplot's isolines. */
static int draw_plain(picture_t *p, bool isolines) {
    for (int32_t k = 0; k < p->spaces; k++) {
        /* With isolines even numbers are rows, odd ones columns; otherwise each grid has both. */
        for (uint8_t family = INK_ROW; family <= INK_COL; family++) {
            if (isolines && (k & 1) != (family == INK_COL)) continue;
            int err = plain_draw(&p->grid[k], family, !isolines, (uint8_t)k, &p->sink);
            if (err) return err;
        }
        hide_tick(p, k + 1, p->spaces);
    }
    return 0;
}

#if CONFIG_AREA
/* Hatching takes rows of its own, and an eighth of the memory for its lines; they may be more. */
static int setup_shaded(picture_t *p) {
    const int32_t n = p->spaces, nx = p->grid[0].nx;
    size_t bytes = shaded_bytes(nx, n), more = arena_left(&p->arena) / 8;
    bytes += more > 4096 ? more : 4096;
    void *mem = arena_take(&p->arena, bytes);
    if (!mem) return ERR_FULL;
    picture_setup_hatch(p, &p->surface_hatch);
    p->lines[n] = p->surface_hatch.lines;
    p->surface_hatch.bits = SHADED_BITS;
    p->shaded = (shaded_t){.hatch = &p->surface_hatch,
                           .lines = p->lines,
                           .cam = &p->camera,
                           .light = p->lights,
                           .lights = picture_lights(p->plot->settings, p->lights),
                           .sink = &p->sink,
                           .space = (uint8_t)n};
    const grid_t *g = &p->grid[0];
    const surface_t *f = g->src;
    const num_t sum[3] = {num_add(f->x_of(f->ctx, 0), f->x_of(f->ctx, nx - 1)),
                          num_add(f->y_of(f->ctx, 0), f->y_of(f->ctx, g->ny - 1)), num_add(g->z_min, g->z_max)};
    for (int k = 0; k < 3; k++) p->shaded.middle[k] = num_ldexp(sum[k], -1);
    p->pens.of_space[n] = p->plot->settings->pen[LINE_HATCH];
    p->spaces++;
    return shaded_init(&p->shaded, nx, n, mem, bytes);
}

static int draw_surfaces(picture_t *p, grid_t *const grid[], const hidden_job_t *job) {
    const int32_t n = p->plot->n;
    return p->spaces == n ? perimeter_draw_several(grid, n, &p->camera, job, &p->stats.hidden)
                          : perimeter_draw_shaded(grid, n, &p->camera, job, &p->shaded, &p->stats.hidden);
}
#else
static int draw_surfaces(picture_t *p, grid_t *const grid[], const hidden_job_t *job) {
    return perimeter_draw_several(grid, p->plot->n, &p->camera, job, &p->stats.hidden);
}
#endif

#if CONFIG_FETCH
/* Strokes are drawn far from where the one before was drawn: the height of a vertex is seldom in the cache. */
static void fetch_height(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t) {
    const picture_t *p = ctx;
    if (surface >= p->spaces || family > INK_COL) return;
    const grid_t *g = &p->grid[surface];
    const int32_t at = (int32_t)(t >> INK_GRID_BITS), i = family == INK_ROW ? at : line,
                  j = family == INK_ROW ? line : at;
    if (g->cache) __builtin_prefetch(&g->cache[(int64_t)j * g->nx + i]);
}
#endif

static bool only_measures(const picture_t *p) {
    return CONFIG_WAITING == 0 && p->hooks && p->hooks->only_measure;
}

/* Measures all surfaces and sets the view up, where that is wanted. */
static int begin(picture_t *p, const pen_sink_t *pen, bool isolines, bool *plain) {
    const plot_t *plot = p->plot;
    int64_t points = 0;
    int32_t growing = 0;
    int err = 0;
    for (int32_t k = 0; k < plot->n; k++) {
        const plot_item_t *item = &plot->item[k];
        if (!isolines) {
            err = add_surface(p, &item->surface);
        } else {
            err = add_surface(p, &item->rows);
            if (!err) err = add_surface(p, &item->cols);
        }
        if (err) return err;
        points += points_of(&item->surface);
        growing += item->surface.nx;
    }
    if (only_measures(p)) return 0;
    num_t lo[3], hi[3];
    scene_box(p, lo, hi);
    err = picture_camera(p, lo, hi);
    if (!err) err = map_surfaces(p);
    *plain = isolines || (p->spaces == 1 && is_vertical(&p->camera, lo, hi));
    int64_t runs = 4 * points;
#if CONFIG_AREA
    if (!err && picture_is_hatched(plot)) {
        err = setup_shaded(p);
        *plain = false;
        runs += 16 * (int64_t)hatch_lines(&p->surface_hatch);
    }
#endif
    if (!*plain && plot->settings->hidden != HIDDEN_HALO) picture_pause(p);
#if CONFIG_FETCH
    p->fetch = fetch_height;
#endif
    return err ? err : picture_open(p, pen, growing, runs);
}

static int draw(picture_t *p, const pen_sink_t *pen) {
    const enum hidden_mode hidden = p->plot->settings->hidden;
    const bool isolines = hidden == HIDDEN_NONE;
    bool plain = false;
    size_t kernel_bytes = 0;
    void *kernel = isolines ? NULL : picture_kernel_memory(p, &kernel_bytes);
    int err = begin(p, pen, isolines, &plain);
    if (err || only_measures(p)) return err;
    ink_sink_t sink = p->sink;
#if CONFIG_AREA
    grid_outline_t outline = {p->lines, p->grid, p->sink};
    if (p->plot->settings->outline && !isolines) sink = grid_outline_sink(&outline);
#endif
    const hidden_job_t job = {
        kernel, kernel_bytes, &sink, hide_tick, p, picture_strips(p), p->pauses ? &p->pause : NULL};
    if (hidden == HIDDEN_HALO) {
        err = CONFIG_HALO ? picture_halo_surfaces(p, &job) : ERR_UNSUPPORTED;
        p->stats.kernel_bytes = p->stats.hidden.bytes;
    } else if (plain) {
        err = draw_plain(p, isolines);
        for (int32_t k = 0; k < p->spaces; k++) p->stats.facets += (int64_t)(p->grid[k].nx - 1) * (p->grid[k].ny - 1);
    } else {
        grid_t *grid[PICTURE_GRIDS_MAX];
        for (int32_t k = 0; k < p->plot->n; k++) grid[k] = &p->grid[k];
        err = draw_surfaces(p, grid, &job);
        p->stats.facets = p->stats.hidden.facets;
        p->stats.kernel_bytes = p->stats.hidden.bytes;
    }
    if (!err) err = picture_close(p);
    for (int32_t k = 0; k < p->spaces && (isolines || k < p->plot->n); k++) p->stats.evaluated += p->grid[k].evaluated;
    return err;
}

int picture_surfaces(picture_t *p, const pen_sink_t *pen) {
    int err = draw(p, pen);
    take_back(p->plot);
    return err;
}
