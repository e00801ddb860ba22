/* area_window.c - see area.h: the subdivision of the screen and of depth, which bounds memory. */
#include "hidden/area/area_body.h"
#include "hidden/area/area_border.h"
#include "hidden/area/area_sort.h"
#include "hidden/area/area_weld.h"

#include "error.h"

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

#define WINDOWS_DEEP 24
/* In comparisons of boxes, some 20 instructions: what it takes to cut a polygon for two windows (8,000 for each), and
 * to look at a face for what is in two halves and to fill them. */
#define CUT_WORTH 800
#define LOOK_WORTH 8

typedef struct area_window {
    area_box_t box;
    int32_t level;
} area_window_t;

/* Halves a window across its longer side. False if it is as small as windows get. */
static bool halve(const area_window_t *w, int bits, area_window_t half[2]) {
    area_box_t box[2];
    const int32_t size = area_box_halve(&w->box, box);
    if (w->level == WINDOWS_DEEP || size >> bits < LAT_PER_MM / 2) return false;
    for (int k = 0; k < 2; k++) half[k] = (area_window_t){box[k], w->level + 1};
    return true;
}

static void empty_pool(area_t *a) {
    area_pool_init(&a->pool, &a->faces, a->pool.piece, a->pool.pieces_max, a->pool.word, a->pool.words_max);
}

/* The clipper's memory serves as many crossings as edges. */
static void note_bytes(const area_t *a) {
    const area_pool_t *p = &a->pool;
    const size_t clip = CLIP_BYTES((size_t)p->edges_most) / 2;
    const size_t bytes = a->fixed + (size_t)p->pieces * sizeof(area_piece_t) +
                         (clip < a->clip_bytes ? clip : a->clip_bytes) + (size_t)p->words_most * sizeof(int32_t);
    if (bytes > a->stats->bytes) a->stats->bytes = bytes;
    if (p->pieces > a->stats->pieces) a->stats->pieces = p->pieces;
}

/* Finds the bodies that cut through something in a window, or may. */
static void look_for_cuts(area_t *a, const area_box_t *w) {
    for (int32_t i = 0; i < a->faces.n; i++) {
        area_face_t *f = &a->faces.face[i];
        if (!f->body || !area_boxes_meet(&f->box, w)) continue;
        for (int32_t k = 0; k < a->faces.n; k++) {
            area_face_t *g = &a->faces.face[k];
            if (g->body && k <= i) continue; /* two bodies are compared once */
            if (!area_boxes_meet(&f->box, &g->box) || !area_boxes_meet(&g->box, w)) continue;
            const int32_t first = i < k ? i : k, second = i < k ? k : i;
            if (area_bodies_compare(&a->faces, first, second) == AREA_APART_UNKNOWN) f->broken = g->broken = true;
        }
    }
}

static area_box_t widened(const area_t *a, const area_box_t *box) {
    const int32_t more = a->sink->overlap ? BORDERS_OVERLAP_LAT << a->faces.lattice.bits : 0;
    return (area_box_t){box->x0, box->y0, box->x1 + more, box->y1 + more};
}

static int sort_window(area_t *a, const area_box_t *box) {
    area_list_t list;
    do { /* their faces may cut through others */
        if (a->faces.parts > 0) look_for_cuts(a, box);
    } while (a->faces.parts > 0 && area_bodies_break(&a->faces, false));
    empty_pool(a);
    a->window = *box;
    a->stats->windows++;
    int err = fill(a, box, &list);
    if (!err) err = area_sort_list(a, list);
    note_bytes(a);
    return err;
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
    empty_pool(a);
    a->window = *w;
    a->stats->boxes++;
    for (int32_t k = 0; k < a->faces.n; k++) {
        a->faces.face[k].on_stack = false;
        if (!is_in_box(&a->faces.face[k], w, near, far)) continue;
        int err;
        int32_t piece = piece_in_box(a, k, near, far, &err);
        if (err) return err;
        if (piece != AREA_NONE) area_list_add(&a->pool, &list, piece);
    }
    const int err = area_sort_list(a, list);
    note_bytes(a);
    return err;
}

/* Weiler and Atherton's Z subdivision, from the front: a window is cut across the line of sight into boxes of few
 * faces, and of each box only what the boxes before it leave open is sorted. (They begin with the farthest and make it
 * detail of a backdrop; this way nothing is sorted that is hidden.) */
static int sort_boxes(area_t *a, const area_box_t *w) {
    poly_vertex_t corner[4];
    const int32_t end = 4, words = a->pool.words_max;
    poly_t open = {corner, &end, 1};
    corners_of(w, corner);
    area_bodies_break(&a->faces, true);
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

/* Halves a window if that spares work: lateral sorting compares half the square of its polygons, but what both halves
 * have is cut and sorted twice. */
static bool halve_to_spare(const area_t *a, const area_window_t *w, int32_t faces, area_window_t half[2]) {
    const int64_t n = faces, look = (int64_t)LOOK_WORTH * a->faces.n;
    if (n * n / 4 <= look || !halve(w, a->faces.lattice.bits, half)) return false;
    const int64_t low = count_in(a, &half[0].box), high = count_in(a, &half[1].box);
    return (n * n - low * low - high * high) / 2 > CUT_WORTH * (low + high - n) + look;
}

/* Sorts a window of so many faces, or halves it. */
static int sort_or_halve(area_t *a, const area_window_t *w, int32_t faces, area_window_t half[2], bool *halved) {
    const int32_t most = a->sink->window_faces;
    bool full = faces > a->pool.pieces_max / PIECES_PER_FACE;
    if (full || most)
        *halved = (full || faces > most) && halve_usefully(a, w, faces, half, full ? 15 : 14);
    else
        *halved = halve_to_spare(a, w, faces, half);
    if (*halved || faces == 0) return 0;
    const area_box_t box = widened(a, &w->box);
    int err = full ? ERR_FULL : sort_window(a, &box);
    if (err != ERR_FULL || a->sink_failed) return err;
    *halved = halve_usefully(a, w, faces, half, 15);
    if (*halved) return 0;
    err = sort_boxes(a, &box);
    if (err != ERR_FULL || a->sink_failed) return err;
    *halved = halve(w, a->faces.lattice.bits, half);
    return *halved ? 0 : err;
}

int area_windows(area_t *a, area_box_t all, void (*tick)(void *ctx, int32_t done, int32_t of), void *tick_ctx) {
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
        if (tick) tick(tick_ctx, done, 1 << WINDOWS_DEEP);
    }
    return 0;
}
