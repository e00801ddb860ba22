/* area_sort.c - see area.h: the sort itself, window by window. */
#include "hidden/area.h"
#include "hidden/area_pool.h"
#include "hidden/area_weld.h"
#include "hidden/area_wires.h"

#include "error.h"
#include "num/ints.h"

/* Of what the faces leave of the memory: to the clipper, and for each face so many pieces. */
#define CLIP_SHARE 3
#define PIECES_PER_FACE 3

typedef struct area {
    area_faces_t faces;
    area_pool_t pool;
    void *clip_mem;
    size_t clip_bytes;
    clip_t clip;
    struct {
        area_list_t outside;
        int32_t face;
    } * stack;
    int32_t depth;
    bool sink_failed;
    uint8_t *state; /* of each face of the scene, enum area_state */
    const area_sink_t *sink;
    area_stats_t *stats;
} area_t;

/* ---- which of two is in front ---- */

enum { BEHIND, TOGETHER, IN_FRONT, THROUGH };

/* Faces that reach through each other by less than this many units of the page do not: rounding moves a border so far
 * beyond the edge where two faces meet. */
#define LEAST_THROUGH 16

/* Where the polygon p of face `of` is to face `than`. Where they differ most decides. In one plane they hide nothing of
 * each other. */
static int compare(area_t *a, const poly_t *p, int32_t of, int32_t than) {
    const area_face_t *s = &a->faces.face[of], *c = &a->faces.face[than];
    const area_plane_t apart = area_plane_minus(&c->plane, &s->plane);
    int64_t front = 0, behind = 0, nearest = 0;
    for (int32_t k = 0; k < poly_vertices(p); k++) {
        int64_t d = area_plane_at(&apart, p->v[k].at);
        if (d > front) front = d;
        if (-d > behind) behind = -d;
        if (!s->deep && !c->deep) continue;
        int64_t z = area_plane_at(&s->plane, p->v[k].at);
        nearest = z < nearest ? z : nearest;
    }
    int64_t slack = area_slack(&a->faces.lattice, s, nearest) + area_slack(&a->faces.lattice, c, nearest);
    if (front <= slack && behind <= slack) return TOGETHER;
    if (front > slack && behind > slack) {
        int64_t through = area_plane_slope(&apart);
        through = through > INT64_MAX / (4 * LEAST_THROUGH) ? INT64_MAX / 4 : through * LEAST_THROUGH;
        if (front > slack + through && behind > slack + through) return THROUGH;
    }
    return front > behind ? IN_FRONT : BEHIND;
}

/* The part of a box where a plane is above 0: at most 6 vertices. */
static int32_t half_of(const area_box_t *box, const area_plane_t *plane, poly_vertex_t v[8]) {
    const poly_point_t corner[4] = {{box->x0, box->y0}, {box->x1, box->y0}, {box->x1, box->y1}, {box->x0, box->y1}};
    int64_t at[4];
    int32_t n = 0;
    area_plane_at_four(plane, corner, at);
    for (int k = 0; k < 4; k++) {
        poly_point_t p = corner[k], q = corner[(k + 1) % 4];
        int64_t at_p = at[k], at_q = at[(k + 1) % 4];
        if (at_p > 0) v[n++] = (poly_vertex_t){p, POLY_CUT};
        if ((at_p > 0) == (at_q > 0)) continue;
        p.x += (int32_t)ints_muldiv_round((int64_t)q.x - p.x, at_p, at_p - at_q);
        p.y += (int32_t)ints_muldiv_round((int64_t)q.y - p.y, at_p, at_p - at_q);
        v[n++] = (poly_vertex_t){p, POLY_CUT};
    }
    return n;
}

/* ---- the sort ---- */

/* Of a piece that cuts through face `by` what is in front of it is put on the list. */
static int cut_through(area_t *a, int32_t piece, int32_t by, area_list_t *in) {
    int32_t face = a->pool.piece[piece].face;
    const area_plane_t apart = area_plane_minus(&a->faces.face[by].plane, &a->faces.face[face].plane);
    poly_vertex_t v[8];
    const int32_t end = half_of(&a->pool.piece[piece].box, &apart, v);
    const clip_job_t job = {area_pool_poly(&a->pool, piece), {v, &end, 1}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    area_list_t parts;
    a->stats->intersections++;
    int err = clip_run(&a->clip, &job, a->clip_mem, a->clip_bytes);
    if (!err) err = area_pool_parts(&a->pool, face, &a->clip, 0, &parts);
    for (int32_t k = err ? AREA_NONE : parts.first, next; k != AREA_NONE; k = next) {
        next = a->pool.piece[k].next;
        area_list_add(&a->pool, in, k);
    }
    area_pool_drop(&a->pool, piece);
    return err;
}

/* Clips a piece by face `by`: what is inside and not behind goes to *in, what is outside to *out. */
static int clip_piece(area_t *a, int32_t piece, int32_t by, area_list_t *in, area_list_t *out) {
    area_pool_t *pool = &a->pool;
    int32_t face = pool->piece[piece].face;
    const area_face_t *f = &a->faces.face[by];
    const poly_t whole = {a->faces.vertex + f->first, &f->n, 1}, subject = area_pool_poly(pool, piece);
    area_weld_t w;
    size_t used;
    if (area_apart(&subject, &whole)) {
        area_list_add(pool, out, piece);
        return 0;
    }
    int err = area_weld(&w, &subject, &pool->piece[piece].box, &whole, &f->box, a->clip_mem, a->clip_bytes, &used);
    if (err) return err;
    const clip_job_t job = {w.subject, w.clip, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_OUTSIDE}};
    err = clip_run(&a->clip, &job, (uint8_t *)a->clip_mem + used, a->clip_bytes - used);
    if (err) return err;
    a->stats->clips++;
    /* Where rounding made something collapse, what is left is the result; otherwise the piece stays as it was. */
    bool exact = a->clip.stats.crossings == 0 && a->clip.stats.sweeps == 1 && !w.changed;
    if (exact && clip_count(&a->clip, 0) == 0) { /* wholly outside */
        area_list_add(pool, out, piece);
        return 0;
    }
    /* Outside, parts are apart because each meets fewer clip polygons than all of them do. */
    area_list_t parts, outside;
    err = area_pool_parts(pool, face, &a->clip, 1, &outside);
    if (!err) err = area_pool_parts(pool, face, &a->clip, 0, &parts);
    if (err) return err;
    bool same =
        exact && outside.first == AREA_NONE && parts.first == parts.last; /* wholly inside, with its own vertices */
    for (int32_t k = outside.first, next; k != AREA_NONE; k = next) {
        next = pool->piece[k].next;
        area_list_add(pool, out, k);
    }
    for (int32_t k = parts.first, next; k != AREA_NONE; k = next) {
        next = pool->piece[k].next;
        const poly_t p = area_pool_poly(pool, k);
        int where = compare(a, &p, face, by);
        if (where == BEHIND) {
            a->stats->removed++;
            same = false;
            area_pool_drop(pool, k);
            continue;
        }
        a->stats->errors += !a->faces.face[face].on_stack;
        same = same && where != THROUGH;
        if (where == THROUGH) {
            err = cut_through(a, k, by, in);
            if (err) return err;
        } else if (same)
            area_pool_drop(pool, k);
        else
            area_list_add(pool, in, k);
    }
    if (same)
        area_list_add(pool, in, piece);
    else
        area_pool_drop(pool, piece);
    return 0;
}

static int clip_list(area_t *a, area_list_t list, int32_t by, area_list_t *in, area_list_t *out) {
    *in = *out = (area_list_t){AREA_NONE, AREA_NONE};
    for (int32_t k = list.first, next; k != AREA_NONE; k = next) {
        const area_piece_t *p = &a->pool.piece[k];
        next = p->next;
        a->stats->lateral++;
        if (p->face == by) {
            area_list_add(&a->pool, in, k);
        } else if (!area_boxes_meet(&p->box, &a->faces.face[by].box)) {
            area_list_add(&a->pool, out, k);
        } else {
            int err = clip_piece(a, k, by, in, out);
            if (err) return err;
        }
    }
    return 0;
}

static int show(area_t *a, area_list_t list) {
    for (int32_t k = list.first, next; k != AREA_NONE; k = next) {
        next = a->pool.piece[k].next;
        const poly_t p = area_pool_poly(&a->pool, k);
        a->stats->visible++;
        int err = a->sink->polygon(a->sink->ctx, a->faces.face[a->pool.piece[k].face].face, &p);
        if (err) {
            a->sink_failed = true;
            return err;
        }
        area_pool_drop(&a->pool, k);
    }
    return 0;
}

/* The first polygon of a list that does not clip this area already, or AREA_NONE. */
static int32_t next_clip(const area_t *a, area_list_t list) {
    for (int32_t k = list.first; k != AREA_NONE; k = a->pool.piece[k].next)
        if (!a->faces.face[a->pool.piece[k].face].on_stack) return a->pool.piece[k].face;
    return AREA_NONE;
}

static int sort_list(area_t *a, area_list_t list) {
    a->depth = 0;
    for (;;) {
        int32_t by = next_clip(a, list);
        int err = 0;
        if (by != AREA_NONE) {
            area_list_t in, out;
            err = clip_list(a, list, by, &in, &out);
            if (err) return err;
            a->stack[a->depth].outside = out;
            a->stack[a->depth++].face = by;
            if (a->depth > a->stats->depth) a->stats->depth = a->depth;
            a->faces.face[by].on_stack = true;
            list = in;
            continue;
        }
        err = show(a, list);
        if (err) return err;
        if (a->depth == 0) return 0;
        list = a->stack[--a->depth].outside;
        a->faces.face[a->stack[a->depth].face].on_stack = false;
    }
}

/* ---- windows ---- */

/* All pieces of faces in a window; those that it cuts are cut. */
static int fill(area_t *a, const area_box_t *w, area_list_t *list) {
    const poly_vertex_t corner[4] = {
        {{w->x0, w->y0}, POLY_CUT}, {{w->x1, w->y0}, POLY_CUT}, {{w->x1, w->y1}, POLY_CUT}, {{w->x0, w->y1}, POLY_CUT}};
    const int32_t end = 4;
    *list = (area_list_t){AREA_NONE, AREA_NONE};
    for (int32_t k = 0; k < a->faces.n; k++) {
        area_face_t *f = &a->faces.face[k];
        f->on_stack = false;
        if (!area_boxes_meet(&f->box, w)) continue;
        int err = 0;
        int32_t piece = AREA_NONE;
        if (f->box.x0 >= w->x0 && f->box.y0 >= w->y0 && f->box.x1 <= w->x1 && f->box.y1 <= w->y1) {
            piece = area_pool_whole(&a->pool, k);
            if (piece == AREA_NONE) return ERR_FULL;
        } else {
            const clip_job_t job = {
                {a->faces.vertex + f->first, &f->n, 1}, {corner, &end, 1}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
            err = clip_run(&a->clip, &job, a->clip_mem, a->clip_bytes);
            if (!err) piece = area_pool_clipped(&a->pool, k, &a->clip, 0, &err);
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
    return err ? err : sort_list(a, list);
}

static int sort_windows(area_t *a, area_box_t all, const area_progress_t *progress) {
    area_window_t todo[WINDOWS_DEEP + 2] = {{all, 0}};
    int32_t n = 1, done = 0, most = a->sink->window_faces ? a->sink->window_faces : WINDOW_FACES;
    while (n > 0) {
        area_window_t w = todo[--n], half[2];
        int32_t faces = count_in(a, &w.box);
        bool many = faces > most || faces > a->pool.pieces_max / PIECES_PER_FACE;
        if (!many || !halve(&w, a->faces.lattice.bits, half)) {
            int err = faces ? sort_window(a, &w.box) : 0;
            many = err == ERR_FULL && !a->sink_failed && halve(&w, a->faces.lattice.bits, half);
            if (err && !many) return err;
        }
        if (many) { /* the half at the lower end is done first */
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
    int32_t pieces = a->faces.n * PIECES_PER_FACE + 64;
    if ((size_t)pieces > b.left / 4 / sizeof(area_piece_t)) pieces = (int32_t)(b.left / 4 / sizeof(area_piece_t));
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
