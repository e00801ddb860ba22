/* area_pool.c - see area_pool.h. A block: its owner, its words, its vertices, the ends of its contours. */
#include "hidden/area/area_pool.h"

#include "error.h"
#include <string.h>

enum { OWNER, SIZE, HEAD };
#define VERTEX_WORDS ((int32_t)(sizeof(poly_vertex_t) / sizeof(int32_t)))

void area_pool_init(area_pool_t *pool, const area_faces_t *faces, area_piece_t *piece, int32_t pieces_max,
                    int32_t *word, int32_t words_max) {
    *pool = (area_pool_t){faces, piece, 0, pieces_max, AREA_NONE, word, 0, words_max, 0, 0};
}

static int32_t take_piece(area_pool_t *pool) {
    int32_t k = pool->free;
    if (k != AREA_NONE) {
        pool->free = pool->piece[k].next;
        return k;
    }
    return pool->pieces < pool->pieces_max ? pool->pieces++ : AREA_NONE;
}

int32_t area_pool_whole(area_pool_t *pool, int32_t face) {
    int32_t k = take_piece(pool);
    if (k != AREA_NONE) pool->piece[k] = (area_piece_t){AREA_NONE, face, AREA_NONE, 1, pool->faces->face[face].box};
    return k;
}

static void squeeze(area_pool_t *pool) {
    int32_t to = 0;
    for (int32_t at = 0; at < pool->words;) {
        int32_t owner = pool->word[at + OWNER], size = pool->word[at + SIZE];
        if (owner != AREA_NONE) {
            if (to != at) memmove(pool->word + to, pool->word + at, (size_t)size * sizeof(int32_t));
            pool->piece[owner].block = to;
            to += size;
        }
        at += size;
    }
    pool->words = to;
}

/* Traces a result to the end of the words, with room for `more` words after it. Returns the number of its vertices, 0
 * if it is empty, or an error. */
static int32_t trace(area_pool_t *pool, clip_t *c, int which, clip_out_t *out, int32_t more) {
    int32_t n = clip_count(c, which), most = n / 3 + 1, size = HEAD + n * VERTEX_WORDS + 2 * most + more;
    if (c->stats.most_edges > pool->edges_most) pool->edges_most = c->stats.most_edges;
    if (n == 0) return 0;
    if (size > pool->words_max - pool->words) squeeze(pool);
    if (size > pool->words_max - pool->words) return ERR_FULL;
    if (pool->words + size > pool->words_most) pool->words_most = pool->words + size;
    poly_vertex_t *v = (poly_vertex_t *)(void *)(pool->word + pool->words + HEAD);
    int32_t *end = (int32_t *)(void *)(v + n);
    *out = (clip_out_t){.v = v, .end = end, .outer = end + most, .n_max = n, .contours_max = most};
    int err = clip_trace(c, which, out);
    return err ? err : n;
}

/* A block of so many vertices and contours where the words end; the caller fills it. AREA_NONE if there is no room. */
static int32_t new_block(area_pool_t *pool, int32_t face, int32_t vertices, int32_t contours) {
    int32_t size = HEAD + vertices * VERTEX_WORDS + contours;
    int32_t k = size > pool->words_max - pool->words ? AREA_NONE : take_piece(pool);
    if (k == AREA_NONE) return AREA_NONE;
    pool->piece[k] = (area_piece_t){.next = AREA_NONE, .face = face, .block = pool->words, .contours = contours};
    pool->word[pool->words + OWNER] = k;
    pool->word[pool->words + SIZE] = size;
    pool->words += size;
    return k;
}

static void set_box(area_pool_t *pool, int32_t piece) {
    const poly_t p = area_pool_poly(pool, piece);
    pool->piece[piece].box = area_box_of(p.v, poly_vertices(&p));
}

/* All that was traced, where it is. */
static int32_t keep(area_pool_t *pool, int32_t face, const clip_out_t *out) {
    int32_t k = new_block(pool, face, out->n, out->contours);
    if (k == AREA_NONE) return k;
    /* Vertices in the middle of an edge were left out: the ends move up to the rest. */
    memmove(out->v + out->n, out->end, (size_t)out->contours * sizeof(int32_t));
    set_box(pool, k);
    return k;
}

int32_t area_pool_clipped(area_pool_t *pool, int32_t face, clip_t *c, int which, int *err) {
    clip_out_t out;
    int32_t n = trace(pool, c, which, &out, 0), k = n > 0 ? keep(pool, face, &out) : AREA_NONE;
    *err = n < 0 ? n : n > 0 && k == AREA_NONE ? ERR_FULL : 0;
    return k;
}

static int32_t first_of(const clip_out_t *out, int32_t contour) {
    return contour ? out->end[contour - 1] : 0;
}

/* The outer contour and its holes. */
static int32_t copy_part(area_pool_t *pool, int32_t face, const clip_out_t *out, int32_t outer) {
    int32_t vertices = 0, contours = 0;
    for (int32_t c = outer; c < out->contours; c++) {
        if (c != outer && out->outer[c] != outer) continue;
        vertices += out->end[c] - first_of(out, c);
        contours++;
    }
    int32_t k = new_block(pool, face, vertices, contours);
    if (k == AREA_NONE) return k;
    poly_vertex_t *v = (poly_vertex_t *)(void *)(pool->word + pool->piece[k].block + HEAD);
    int32_t *end = (int32_t *)(void *)(v + vertices), n = 0;
    for (int32_t c = outer; c < out->contours; c++) {
        if (c != outer && out->outer[c] != outer) continue;
        int32_t first = first_of(out, c), count = out->end[c] - first;
        memcpy(v + n, out->v + first, (size_t)count * sizeof *v);
        n += count;
        *end++ = n;
    }
    set_box(pool, k);
    return k;
}

int area_pool_parts(area_pool_t *pool, int32_t face, clip_t *c, int which, area_list_t *list) {
    clip_out_t out;
    int32_t outers = 0, most = clip_count(c, which);
    int32_t n = trace(pool, c, which, &out, most * VERTEX_WORDS + (most / 3 + 1) * (HEAD + 1));
    *list = (area_list_t){AREA_NONE, AREA_NONE};
    if (n <= 0) return n;
    for (int32_t k = 0; k < out.contours; k++) outers += out.outer[k] < 0;
    /* The traced one stays in front of its copies until they are made, as a block without an owner. */
    int32_t start = pool->words, whole = HEAD + n * VERTEX_WORDS + 2 * (n / 3 + 1);
    if (outers > 1) {
        pool->word[start + OWNER] = AREA_NONE;
        pool->word[start + SIZE] = whole;
        pool->words += whole;
    }
    for (int32_t k = 0; k < out.contours; k++) {
        if (out.outer[k] >= 0) continue;
        int32_t piece = outers > 1 ? copy_part(pool, face, &out, k) : keep(pool, face, &out);
        if (piece == AREA_NONE) return ERR_FULL;
        area_list_add(pool, list, piece);
    }
    return 0;
}

void area_pool_drop(area_pool_t *pool, int32_t piece) {
    area_piece_t *p = &pool->piece[piece];
    if (p->block != AREA_NONE) {
        int32_t *block = pool->word + p->block;
        block[OWNER] = AREA_NONE;
        if (p->block + block[SIZE] == pool->words) pool->words = p->block;
    }
    p->next = pool->free;
    pool->free = piece;
}

poly_t area_pool_poly(area_pool_t *pool, int32_t piece) {
    const area_piece_t *p = &pool->piece[piece];
    if (p->block != AREA_NONE) {
        const int32_t *block = pool->word + p->block;
        const poly_vertex_t *v = (const poly_vertex_t *)(const void *)(block + HEAD);
        return (poly_t){v, block + block[SIZE] - p->contours, p->contours};
    }
    const area_face_t *f = &pool->faces->face[p->face];
    return (poly_t){pool->faces->vertex + f->first, &f->n, 1};
}
