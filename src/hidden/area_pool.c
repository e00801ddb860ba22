/* area_pool.c - see area_pool.h. A block: its owner, its words, its vertices, the ends of its contours. */
#include "hidden/area_pool.h"

#include "error.h"
#include <string.h>

enum { OWNER, SIZE, HEAD };
#define VERTEX_WORDS ((int32_t)(sizeof(poly_vertex_t) / sizeof(int32_t)))

void area_pool_init(area_pool_t *pool, const area_faces_t *faces, area_piece_t *piece, int32_t pieces_max,
                    int32_t *word, int32_t words_max) {
    *pool = (area_pool_t){faces, piece, 0, pieces_max, AREA_NONE, word, 0, words_max};
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

int32_t area_pool_clipped(area_pool_t *pool, int32_t face, clip_t *c, int which, int *err) {
    int32_t n = clip_count(c, which), most = n / 3 + 1;
    if (n == 0) return AREA_NONE;
    int32_t size = HEAD + n * VERTEX_WORDS + most;
    if (size > pool->words_max - pool->words) squeeze(pool);
    int32_t k = size > pool->words_max - pool->words ? AREA_NONE : take_piece(pool);
    if (k == AREA_NONE) {
        *err = ERR_FULL;
        return AREA_NONE;
    }
    int32_t *block = pool->word + pool->words;
    poly_vertex_t *v = (poly_vertex_t *)(void *)(block + HEAD);
    clip_out_t out = {.v = v, .end = (int32_t *)(void *)(v + n), .n_max = n, .contours_max = most};
    *err = clip_trace(c, which, &out);
    if (*err) {
        pool->piece[k].next = pool->free;
        pool->free = k;
        return AREA_NONE;
    }
    /* Vertices in the middle of an edge were left out: the ends move up to the rest. */
    memmove(v + out.n, out.end, (size_t)out.contours * sizeof(int32_t));
    block[OWNER] = k;
    block[SIZE] = HEAD + out.n * VERTEX_WORDS + out.contours;
    pool->piece[k] = (area_piece_t){AREA_NONE, face, pool->words, out.contours, area_box_of(v, out.n)};
    pool->words += block[SIZE];
    return k;
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
