/* picture_halo.c - wire frames of solids and of grids as sources for haloed lines. */
#include "app/picture_stages.h"

#include "error.h"
#include <string.h>

#include "hidden/halo/halo.h"
#include "hidden/halo/halo_ink.h"
#include "view/page.h"

/* A width in um as lat; what is set fits. */
static int32_t width_lat(const settings_t *s) {
    return (int32_t)((int64_t)s->halo_um * LAT_PER_MM / 1000);
}

/* Edges of a grid: first those of rows, row by row, then those of columns. */
static int32_t row_edges(const grid_t *g) {
    return (g->nx - 1) * g->ny;
}
static int32_t grid_edges(const grid_t *g) {
    return row_edges(g) + g->nx * (g->ny - 1);
}

#define SHARE_BITS 32 /* of a part of a depth; depths and heights of a grid take 31 at most */

/* A part of the depth, of column or row `at`; of an edge's two ends one is the last edge's. */
typedef struct share {
    int32_t grid, at;
    int64_t q32;
} share_t;

typedef struct frames {
    picture_t *p;
    num_t middle[3], weight[3];          /* parallel: depth is the sum of weight * (place - middle) */
    int64_t base_q32[PICTURE_GRIDS_MAX]; /* of a height of 0 on the grid's lattice */
    int64_t unit_q32[PICTURE_GRIDS_MAX]; /* of each unit more */
    share_t share[2][2];                 /* of x and y: by the lowest bit of at */
} frames_t;

/* Along a line of sight anything grows that has a positive product with its direction. Measured in parts of the box,
 * nothing is lost when its sides differ by orders. */
static void weigh(frames_t *f) {
    const camera_t *cam = &f->p->camera;
    num_t lo[3], hi[3], all = num_from_i64(0);
    for (int axis = 0; axis < 3; axis++) {
        for (int32_t k = 0; k < f->p->spaces; k++) {
            const grid_t *g = &f->p->grid[k];
            const surface_t *s = g->src;
            const num_t from[3] = {s->x_of(s->ctx, 0), s->y_of(s->ctx, 0), g->z_min};
            const num_t to[3] = {s->x_of(s->ctx, g->nx - 1), s->y_of(s->ctx, g->ny - 1), g->z_max};
            if (k == 0 || num_cmp(from[axis], lo[axis]) < 0) lo[axis] = from[axis];
            if (k == 0 || num_cmp(to[axis], hi[axis]) > 0) hi[axis] = to[axis];
        }
        const num_t side = num_sub(hi[axis], lo[axis]);
        f->middle[axis] = num_ldexp(num_add(lo[axis], hi[axis]), -1);
        f->weight[axis] = num_from_i64(0);
        if (num_sign(side) == 0) continue;
        f->weight[axis] = num_div(cam->eye[axis], num_mul(side, side));
        all = num_add(all, num_mul(num_abs(f->weight[axis]), side));
    }
    if (num_sign(all) == 0) return;
    for (int axis = 0; axis < 3; axis++)
        f->weight[axis] = num_div(num_mul(f->weight[axis], num_from_i64(HALO_INK_DEPTH)), all);
}

static int64_t depth_q32(const frames_t *f, int axis, num_t at) {
    return num_to_fixed(num_mul(f->weight[axis], num_sub(at, f->middle[axis])), SHARE_BITS, NULL);
}

/* Heights count in integers. */
static void weigh_heights(frames_t *f) {
    for (int32_t k = 0; k < f->p->spaces; k++) {
        const grid_t *g = &f->p->grid[k];
        f->base_q32[k] = depth_q32(f, 2, g->z_origin);
        f->unit_q32[k] = num_to_fixed(num_ldexp(f->weight[2], g->z_exp), SHARE_BITS, NULL);
    }
    for (int k = 0; k < 4; k++) f->share[k >> 1][k & 1] = (share_t){.grid = -1};
}

static int64_t share_of(frames_t *f, int axis, int32_t grid, int32_t at) {
    share_t *share = &f->share[axis][at & 1];
    if (share->grid != grid || share->at != at) {
        const surface_t *s = f->p->grid[grid].src;
        *share = (share_t){grid, at, depth_q32(f, axis, axis ? s->y_of(s->ctx, at) : s->x_of(s->ctx, at))};
    }
    return share->q32;
}

static int32_t depth_of(frames_t *f, int32_t grid, int32_t i, int32_t j) {
    int32_t zi = 0;
    grid_height(&f->p->grid[grid], i, j, &zi);
    const int64_t q32 = share_of(f, 0, grid, i) + share_of(f, 1, grid, j) + f->base_q32[grid] + zi * f->unit_q32[grid];
    return (int32_t)((q32 + ((int64_t)1 << (SHARE_BITS - 1))) >> SHARE_BITS);
}

static bool grid_edge(void *ctx, int32_t e, ink_piece_t *ink, page_h_t end[2], int32_t depth[2]) {
    frames_t *f = ctx;
    int32_t k = 0;
    for (; e >= grid_edges(&f->p->grid[k]); k++) e -= grid_edges(&f->p->grid[k]);
    const grid_t *g = &f->p->grid[k];
    const bool row = e < row_edges(g);
    if (!row) e -= row_edges(g);
    const int32_t cells = (row ? g->nx : g->ny) - 1, line = e / cells, cell = e % cells;
    *ink = (ink_piece_t){.family = row ? INK_ROW : INK_COL, .surface = (uint8_t)k, .line = line};
    ink->from = cell * INK_GRID_ONE;
    ink->to = ink->from + INK_GRID_ONE;
    const line_space_t *s = &f->p->lines[k];
    if (!s->at(s->ctx, ink->family, line, ink->from, &end[0])) return false;
    if (!s->at(s->ctx, ink->family, line, ink->to, &end[1])) return false;
    for (int at = 0; at < 2 && !s->perspective; at++)
        depth[at] = depth_of(f, k, row ? cell + at : line, row ? line : cell + at);
    return true;
}

int picture_halo_surfaces(picture_t *p, const hidden_job_t *job) {
    hidden_job_t rest = *job;
    HIDDEN_STATE(frames_t, f, rest);
    if (!f) return ERR_FULL;
    job = &rest;
    memset(f, 0, sizeof *f);
    f->p = p;
    halo_source_t source = {.ctx = f, .lines = p->lines, .surfaces = p->spaces, .edge = grid_edge};
    for (int32_t k = 0; k < p->spaces; k++) {
        source.edges += grid_edges(&p->grid[k]);
        p->stats.facets += (int64_t)(p->grid[k].nx - 1) * (p->grid[k].ny - 1);
    }
    weigh(f);
    if (!p->camera.perspective) weigh_heights(f);
    const settings_t *s = p->plot->settings;
    int err = halo_ink_draw(&source, width_lat(s), s->halo_ends, job, &p->stats.hidden);
    p->stats.hidden.bytes += HIDDEN_LENT(frames_t);
    return err;
}

static bool solid_edge(void *ctx, int32_t e, ink_piece_t *ink, page_h_t end[2], int32_t depth[2]) {
    const solid_map_t *m = ctx;
    const solid_edge_t *edge = &m->solid->edge[e];
    if (edge->first != e || solid_is_cut(m->solid, edge)) return false;
    *ink = (ink_piece_t){.family = INK_SEGMENT, .line = e, .to = INK_ONE};
    for (int k = 0; k < 2; k++) {
        end[k] = solid_map_vertex(m, edge->v[k]);
        depth[k] = -(m->place[edge->v[k]].z / ((1 << SOLID_Z_BITS) / HALO_INK_DEPTH)); /* there smaller is nearer */
    }
    return true;
}

int picture_halo_solids(picture_t *p, const hidden_job_t *job) {
    const halo_source_t source = {&p->solid_map, p->solid.ne, p->lines, 1, solid_edge};
    const settings_t *s = p->plot->settings;
    return halo_ink_draw(&source, width_lat(s), s->halo_ends, job, &p->stats.hidden);
}

size_t picture_halo_bytes(const plot_t *plot, int32_t crossings_each) {
    size_t edges = 0;
    for (int32_t k = 0; k < plot->n; k++) {
        const plot_item_t *item = &plot->item[k];
        if (!item->solid) {
            edges += 2 * (size_t)item->surface.nx * (size_t)item->surface.ny;
        } else {
            /* two faces have an edge in common */
            edges += (size_t)item->mesh.corners / 2 + (size_t)item->mesh.segments;
        }
    }
    return HALO_BYTES(edges, edges * (size_t)crossings_each);
}
