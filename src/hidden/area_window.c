/* area_window.c - see area.h: memory, and the subdivision of the screen and of depth that bounds it. */
#include "hidden/area_sort.h"
#include "hidden/area_weld.h"
#include "hidden/area_wires.h"

#include "error.h"

/* Of what the faces leave of the memory, a part for pieces, which are as many as polygons divide each other into; of
 * the rest one for the clipper, and the other for what the pieces consist of: some 64 bytes each. */
#define PIECES_SHARE 4
#define CLIP_SHARE 3
/* A window with more faces than this allows is not even tried. */
#define PIECES_PER_FACE 3

/* ---- windows ---- */

static void corners_of(const area_box_t *w, poly_vertex_t v[4]) {
    v[0] = (poly_vertex_t){{w->x0, w->y0}, POLY_CUT};
    v[1] = (poly_vertex_t){{w->x1, w->y0}, POLY_CUT};
    v[2] = (poly_vertex_t){{w->x1, w->y1}, POLY_CUT};
    v[3] = (poly_vertex_t){{w->x0, w->y1}, POLY_CUT};
}

static bool is_within(const area_face_t *f, const area_box_t *w) {
    return f->box.x0 >= w->x0 && f->box.y0 >= w->y0 && f->box.x1 <= w->x1 && f->box.y1 <= w->y1;
}

/* What of face k lies in a polygon, as a piece; AREA_NONE if nothing does. Where a hole runs along the outer contour,
 * or along another hole, they are made to coincide, so that nothing is left between them. */
static int32_t face_in(area_t *a, int32_t k, const poly_t *by, int *err) {
    const area_face_t *f = &a->faces.face[k];
    clip_job_t job = {{a->faces.vertex + f->first, &f->n, 1}, *by, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    area_weld_t w;
    size_t used = 0;
    *err = 0;
    if (f->holed) {
        *err = area_weld(&w, &job.subject, &f->box, &job.subject, &f->box, a->clip_mem, a->clip_bytes, &used);
        if (!*err) job.subject = w.subject;
    }
    if (!*err) *err = clip_run(&a->clip, &job, (uint8_t *)a->clip_mem + used, a->clip_bytes - used);
    return *err ? AREA_NONE : area_pool_clipped(&a->pool, k, &a->clip, 0, err);
}

/* All pieces of faces in a window; those that it cuts are cut, and holes become contours. */
static int fill(area_t *a, const area_box_t *w, area_list_t *list) {
    poly_vertex_t corner[4];
    const int32_t end = 4;
    corners_of(w, corner);
    *list = (area_list_t){AREA_NONE, AREA_NONE};
    for (int32_t k = 0; k < a->faces.n; k++) {
        area_face_t *f = &a->faces.face[k];
        f->on_stack = false;
        if (!area_boxes_meet(&f->box, w)) continue;
        int err = 0;
        int32_t piece = AREA_NONE;
        if (is_within(f, w) && !f->holed) {
            piece = area_pool_whole(&a->pool, k);
            if (piece == AREA_NONE) return ERR_FULL;
        } else {
            piece = face_in(a, k, &(poly_t){corner, &end, 1}, &err);
            if (err) return err;
        }
        if (piece != AREA_NONE) area_list_add(&a->pool, list, piece);
    }
    return 0;
}

static int32_t count_in(const area_t *a, const area_box_t *w) {
    int32_t n = 0;
    for (int32_t k = 0; k < a->faces.n; k++) n += area_boxes_meet(&a->faces.face[k].box, w);
    return n;
}

/* More polygons than this in a window, and its halves take less work together: lateral sorting grows with the square.
 */
#define WINDOW_FACES 400
#define WINDOWS_DEEP 24

typedef struct area_progress {
    void (*tick)(void *ctx, int32_t done, int32_t of);
    void *ctx;
} area_progress_t;

typedef struct area_window {
    area_box_t box;
    int32_t level;
} area_window_t;

/* Halves a window across its longer side. False if it is as small as windows get. */
static bool halve(const area_window_t *w, int bits, area_window_t half[2]) {
    bool wide = w->box.x1 - w->box.x0 >= w->box.y1 - w->box.y0;
    int32_t from = wide ? w->box.x0 : w->box.y0, size = (wide ? w->box.x1 : w->box.y1) - from;
    if (w->level == WINDOWS_DEEP || size >> bits < LAT_PER_MM / 2) return false;
    half[0] = half[1] = (area_window_t){w->box, w->level + 1};
    *(wide ? &half[0].box.x1 : &half[0].box.y1) = from + size / 2;
    *(wide ? &half[1].box.x0 : &half[1].box.y0) = from + size / 2;
    return true;
}

static int sort_window(area_t *a, const area_box_t *box) {
    area_list_t list;
    area_pool_init(&a->pool, &a->faces, a->pool.piece, a->pool.pieces_max, a->pool.word, a->pool.words_max);
    a->stats->windows++;
    int err = fill(a, box, &list);
    return err ? err : area_sort_list(a, list);
}

/* ---- boxes of Z ---- */

/* Of a polygon of face k what is nearer (or not) than z; `p` may be a piece of the pool, which the clipper has read. */
static int32_t cut_at(area_t *a, int32_t k, const poly_t *p, int64_t z, bool nearer, int *err) {
    area_plane_t plane = a->faces.face[k].plane, zero = {{0, 0}, {0, 0}, {0, 0}};
    plane.c0 = wide_sub(plane.c0, wide_shl(wide_from_s64(z), AREA_PLANE_BITS));
    if (nearer) plane = area_plane_minus(&zero, &plane);
    poly_vertex_t v[8];
    const int32_t end = area_half_of(&a->faces.face[k].box, &plane, v);
    const clip_job_t job = {*p, {v, &end, 1}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    *err = clip_run(&a->clip, &job, a->clip_mem, a->clip_bytes);
    return *err ? AREA_NONE : area_pool_clipped(&a->pool, k, &a->clip, 0, err);
}

/* The piece of face k in a box of what is open. AREA_NONE if there is none. */
static int32_t piece_in_box(area_t *a, int32_t k, int64_t near, int64_t far, int *err) {
    const area_face_t *f = &a->faces.face[k];
    int32_t piece = face_in(a, k, a->open, err);
    for (int end = 0; end < 2 && piece != AREA_NONE; end++) {
        if (end ? f->z_far <= far : f->z_near >= near) continue;
        const poly_t whole = area_pool_poly(&a->pool, piece);
        int32_t cut = cut_at(a, k, &whole, end ? far : near, end, err);
        area_pool_drop(&a->pool, piece);
        piece = cut;
    }
    return piece;
}

static bool is_in_box(const area_face_t *f, const area_box_t *w, int64_t near, int64_t far) {
    return area_boxes_meet(&f->box, w) && f->z_near < far && f->z_far >= near;
}

/* How deep a box that begins at `near` may be to hold so many faces. */
static int64_t find_far(const area_t *a, const area_box_t *w, int64_t near, int32_t most) {
    for (int32_t k = 0, n = 0; k < a->faces.n; k++) { /* by z_near */
        const area_face_t *f = &a->faces.face[k];
        if (is_in_box(f, w, near, INT64_MAX) && n++ >= most && f->z_near > near) return f->z_near;
    }
    return INT64_MAX;
}

static int sort_box(area_t *a, const area_box_t *w, int64_t near, int64_t far) {
    area_list_t list = {AREA_NONE, AREA_NONE};
    area_pool_init(&a->pool, &a->faces, a->pool.piece, a->pool.pieces_max, a->pool.word, a->pool.words_max);
    a->stats->boxes++;
    for (int32_t k = 0; k < a->faces.n; k++) {
        a->faces.face[k].on_stack = false;
        if (!is_in_box(&a->faces.face[k], w, near, far)) continue;
        int err;
        int32_t piece = piece_in_box(a, k, near, far, &err);
        if (err) return err;
        if (piece != AREA_NONE) area_list_add(&a->pool, &list, piece);
    }
    return area_sort_list(a, list);
}

/* Weiler and Atherton's Z subdivision, from the front: a window is cut across the line of sight into boxes of few
 * faces, and of each box only what the boxes before it leave open is sorted. (They begin with the farthest and make it
 * detail of a backdrop; this way nothing is sorted that is hidden.) */
static int sort_boxes(area_t *a, const area_box_t *w) {
    poly_vertex_t corner[4];
    const int32_t end = 4, words = a->pool.words_max;
    poly_t open = {corner, &end, 1};
    corners_of(w, corner);
    int32_t most = a->pool.pieces_max / PIECES_PER_FACE / 2, each = words / 6, vertices = each / 5;
    int32_t *at = a->pool.word + words - 2 * each;
    for (int k = 0; k < 2; k++, at += each)
        a->store[k] = (clip_out_t){.v = (poly_vertex_t *)(void *)at,
                                   .end = at + 3 * vertices,
                                   .n_max = vertices,
                                   .contours_max = each - 3 * vertices};
    a->pool.words_max -= 2 * each;
    a->open = &open;
    int64_t near = INT64_MIN;
    int err = 0;
    while (!err && near != INT64_MAX && open.contours > 0) {
        int64_t far = find_far(a, w, near, most);
        err = sort_box(a, w, near, far);
        if (!err) {
            near = far;
        } else if (err == ERR_FULL && !a->sink_failed && most >= 2) { /* again, what is still open */
            most /= 2;
            err = 0;
        }
    }
    a->open = NULL;
    a->pool.words_max = words;
    return err;
}

/* ---- all windows ---- */

/* Halves a window if the halves have no more than so many eighths of its polygons together; where all reach across, it
 * would only be done twice. */
static bool halve_usefully(const area_t *a, const area_window_t *w, int32_t faces, area_window_t half[2], int eighths) {
    return halve(w, a->faces.lattice.bits, half) &&
           8 * ((int64_t)count_in(a, &half[0].box) + count_in(a, &half[1].box)) <= (int64_t)eighths * faces;
}

/* Sorts a window of so many faces, or halves it. */
static int sort_or_halve(area_t *a, const area_window_t *w, int32_t faces, area_window_t half[2], bool *halved) {
    int32_t most = a->sink->window_faces ? a->sink->window_faces : WINDOW_FACES;
    bool full = faces > a->pool.pieces_max / PIECES_PER_FACE;
    *halved = (full || faces > most) && halve_usefully(a, w, faces, half, full ? 15 : 14);
    if (*halved || faces == 0) return 0;
    int err = full ? ERR_FULL : sort_window(a, &w->box);
    if (err != ERR_FULL || a->sink_failed) return err;
    *halved = halve_usefully(a, w, faces, half, 15);
    if (*halved) return 0;
    err = sort_boxes(a, &w->box);
    if (err != ERR_FULL || a->sink_failed) return err;
    *halved = halve(w, a->faces.lattice.bits, half);
    return *halved ? 0 : err;
}

static int sort_windows(area_t *a, area_box_t all, const area_progress_t *progress) {
    area_window_t todo[WINDOWS_DEEP + 2] = {{all, 0}};
    int32_t n = 1, done = 0;
    while (n > 0) {
        area_window_t w = todo[--n], half[2];
        bool halved;
        int err = sort_or_halve(a, &w, count_in(a, &w.box), half, &halved);
        if (err) return err;
        if (halved) { /* the half at the lower end is done first */
            todo[n++] = half[1];
            todo[n++] = half[0];
            continue;
        }
        done += 1 << (WINDOWS_DEEP - w.level);
        if (progress->tick) progress->tick(progress->ctx, done, 1 << WINDOWS_DEEP);
    }
    return 0;
}

/* ---- memory ---- */

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

/* The faces first, then what they leave to pieces, clipper and pool. */
static int lay_out(area_t *a, const solid_map_t *m, void *mem, size_t bytes) {
    const solid_t *s = m->solid;
    bump_t b = {mem, bytes};
    size_t most = (size_t)area_faces_most(m) + 1;
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
    /* What is off the paper need not be sorted. */
    const page_window_t *page = m->lines.window;
    int32_t unit = 1 << a.faces.lattice.bits;
    if (all.x0 < page->x0_lat * unit) all.x0 = page->x0_lat * unit;
    if (all.y0 < page->y0_lat * unit) all.y0 = page->y0_lat * unit;
    if (all.x1 > page->x1_lat * unit) all.x1 = page->x1_lat * unit;
    if (all.y1 > page->y1_lat * unit) all.y1 = page->y1_lat * unit;
    const area_progress_t progress = {tick, tick_ctx};
    if (all.x0 < all.x1 && all.y0 < all.y1) err = sort_windows(&a, all, &progress);
    return err ? err : area_wires(&a.faces, a.state, a.clip_mem, a.clip_bytes, sink);
}
