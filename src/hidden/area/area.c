/* area.c - see area.h: what goes where in the memory, and the whole of the sort. */
#include "hidden/area/area_body.h"
#include "hidden/area/area_sort.h"
#include "hidden/area/area_wires.h"

#include "error.h"

/* Of what the faces leave of the memory, a part for pieces, which are as many as polygons divide each other into; of
 * the rest one for the clipper, and the other for what the pieces consist of: some 64 bytes each. */
#define PIECES_SHARE 4
#define CLIP_SHARE 3
/* Consolidation may take such a part of it. */
#define BODIES_SHARE 8

typedef struct bump {
    uint8_t *at;
    size_t left;
} bump_t;

static void *take(bump_t *b, size_t bytes) {
    bytes = (bytes + 7) & ~(size_t)7;
    if (bytes > b->left) return NULL;
    void *p = b->at;
    b->at += bytes;
    b->left -= bytes;
    return p;
}

static int32_t most_corners(const solid_t *s) {
    int32_t most = 0;
    for (int32_t k = 0; k < s->nf; k++) most = s->face[k].n > most ? s->face[k].n : most;
    return most;
}

/* Makes bodies of faces, if that takes no more than a small part of what is left. */
static void consolidate(area_t *a, bump_t *b) {
    const solid_t *s = a->faces.lattice.m->solid;
    const size_t vertices = (size_t)area_bodies_vertices(&a->faces) * sizeof(poly_vertex_t);
    if (vertices + area_bodies_bytes(s) > b->left / BODIES_SHARE) {
        for (int32_t k = 0; k < a->faces.n; k++) a->faces.face[k].part = false;
        return;
    }
    take(b, vertices); /* after the others */
    void *mem = take(b, area_bodies_bytes(s));
    area_bodies_make(&a->faces, mem, b->at, b->left);
    for (int32_t k = 0; k < a->faces.n; k++) a->stats->bodies += a->faces.face[k].body;
}

/* The faces first, then what they leave to pieces, clipper and pool. */
static int lay_out(area_t *a, const solid_map_t *m, void *mem, size_t bytes) {
    const solid_t *s = m->solid;
    bump_t b = {mem, bytes};
    const int32_t bodies = a->sink->one_by_one ? 0 : area_bodies_most(m);
    size_t most = (size_t)area_faces_most(m) + 1 + (size_t)bodies;
    a->faces.face = take(&b, most * sizeof(area_face_t));
    a->stack = take(&b, most * sizeof *a->stack);
    a->state = take(&b, (size_t)s->nf);
    if (!a->faces.face || !a->stack || !a->state) return ERR_FULL;
    bump_t before = b;
    a->faces.lattice = area_lattice(m);
    bool clips = a->faces.lattice.clips;
    int32_t corners = most_corners(s);
    a->faces.vertex = take(&b, ((size_t)s->nc + (clips ? (size_t)s->nc + 8 * most : 0)) * sizeof(poly_vertex_t));
    int32_t *corner_edge = take(&b, (size_t)s->nc * sizeof(int32_t));
    area_corner_t *scratch = take(&b, AREA_SCRATCH(clips, corners));
    if (!a->faces.vertex || !corner_edge || !scratch) return ERR_FULL;
    int err = area_faces_make(&a->faces, corner_edge, a->state, scratch, corners);
    if (err) return err;
    a->stats->polygons = a->faces.n;
    b = before;
    take(&b, (size_t)a->faces.vertices * sizeof(poly_vertex_t));
    if (bodies > 0) consolidate(a, &b);
    a->fixed = bytes - b.left;
    int32_t pieces = (int32_t)(b.left / PIECES_SHARE / sizeof(area_piece_t));
    area_piece_t *piece = take(&b, (size_t)pieces * sizeof *piece);
    a->clip_bytes = b.left / CLIP_SHARE;
    a->clip_mem = take(&b, a->clip_bytes);
    size_t words = b.left / sizeof(int32_t);
    if (!piece || !a->clip_mem || words < 64) return ERR_FULL;
    area_pool_init(&a->pool, &a->faces, piece, pieces, (int32_t *)(void *)b.at,
                   words > INT32_MAX / 2 ? INT32_MAX / 2 : (int32_t)words);
    return 0;
}

size_t area_bytes(int32_t faces, int32_t corners) {
    size_t each = sizeof(area_face_t) + 16 + PIECES_PER_FACE * sizeof(area_piece_t);
    return (size_t)faces * each + (size_t)corners * (sizeof(poly_vertex_t) * 4 + 4) + 3 * CLIP_BYTES(400);
}

/* As measured on 9 x 9 to 12 x 12 cubes and tori of 500 to 1600 triangles (tests/emu/needs.c): within a hundredth, with
 * a light within a fifth. */
size_t area_least_bytes(int32_t faces, int32_t corners, int32_t lights) {
    return (size_t)corners * 103 + (size_t)faces * 200 * (size_t)lights;
}

size_t area_fixed_bytes(const solid_map_t *m) {
    const size_t faces = (size_t)area_faces_most(m) + 1 + (size_t)area_bodies_most(m);
    return faces * (sizeof(area_face_t) + sizeof(int32_t)) + (size_t)m->solid->nf +
           (size_t)m->solid->nc * sizeof(poly_vertex_t);
}

/* Lines close to the eye have places that are off by so much (view/solid_map.h). */
#define PAGE_MARGIN_LAT (1 << 10)

/* What is off the paper need not be sorted. What is on it view/cut.h decides, exactly; pictures are fitted to the
 * paper, so lines along its border are not rare, and are not to be lost by rounding. */
static area_box_t page_of(const area_lattice_t *l) {
    const page_window_t *w = l->m->lines.window;
    const int32_t unit = 1 << l->bits, most = POLY_LIMIT / unit - PAGE_MARGIN_LAT;
    return (area_box_t){((w->x0_lat < -most ? -most : w->x0_lat) - PAGE_MARGIN_LAT) * unit,
                        ((w->y0_lat < -most ? -most : w->y0_lat) - PAGE_MARGIN_LAT) * unit,
                        ((w->x1_lat > most ? most : w->x1_lat) + PAGE_MARGIN_LAT) * unit,
                        ((w->y1_lat > most ? most : w->y1_lat) + PAGE_MARGIN_LAT) * unit};
}

int area_sort(const solid_map_t *m, void *mem, size_t bytes, const area_sink_t *sink,
              void (*tick)(void *ctx, int32_t done, int32_t of), void *tick_ctx, area_stats_t *stats) {
    area_t a = {.sink = sink, .stats = stats};
    *stats = (area_stats_t){.behind = m->any_behind};
    int err = lay_out(&a, m, mem, bytes);
    if (err) return err;
    if (a.faces.n == 0) return area_wires(&a.faces, a.state, a.clip_mem, a.clip_bytes, sink);
    area_box_t all = a.faces.face[0].box;
    for (int32_t k = 1; k < a.faces.n; k++) {
        const area_box_t *b = &a.faces.face[k].box;
        all.x0 = b->x0 < all.x0 ? b->x0 : all.x0;
        all.y0 = b->y0 < all.y0 ? b->y0 : all.y0;
        all.x1 = b->x1 > all.x1 ? b->x1 : all.x1;
        all.y1 = b->y1 > all.y1 ? b->y1 : all.y1;
    }
    const area_box_t page = page_of(&a.faces.lattice);
    if (all.x0 < page.x0) all.x0 = page.x0;
    if (all.y0 < page.y0) all.y0 = page.y0;
    if (all.x1 > page.x1) all.x1 = page.x1;
    if (all.y1 > page.y1) all.y1 = page.y1;
    if (all.x0 < all.x1 && all.y0 < all.y1) err = area_windows(&a, all, tick, tick_ctx);
    return err ? err : area_wires(&a.faces, a.state, a.clip_mem, a.clip_bytes, sink);
}
