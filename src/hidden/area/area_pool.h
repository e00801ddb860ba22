/* area_pool.h - pieces of polygons in lent memory: what the area sort's lists are made of.
 *
 * A piece is a whole face, which takes no room but its own, or what is left of one: a block of contours. Blocks are
 * stacked up, and when the memory is full those that nothing owns any more are squeezed out. */
#ifndef AREA_POOL_H
#define AREA_POOL_H

#include "hidden/area/area_face.h"
#include "poly/clip.h"

#define AREA_NONE (-1)

typedef struct area_piece {
    int32_t next;     /* in its list */
    int32_t face;     /* index in area_faces_t */
    int32_t block;    /* word of the pool where its block begins; AREA_NONE: the whole face */
    int32_t contours; /* of the block */
    area_box_t box;
} area_piece_t;

/* A list of pieces, first to last. */
typedef struct area_list {
    int32_t first, last;
} area_list_t;

typedef struct area_pool {
    const area_faces_t *faces;
    area_piece_t *piece;
    int32_t pieces, pieces_max, free; /* free: list of unused ones */
    int32_t *word;
    int32_t words, words_max;
    int32_t words_most, edges_most; /* at once: words that were in use, edges that the clipper had */
} area_pool_t;

void area_pool_init(area_pool_t *pool, const area_faces_t *faces, area_piece_t *piece, int32_t pieces_max,
                    int32_t *word, int32_t words_max);
/* A new piece of a face, whole; AREA_NONE if there is no room. */
int32_t area_pool_whole(area_pool_t *pool, int32_t face);
/* A new piece of a face from result `which` of a clip. AREA_NONE if it is empty. *err: ERR_FULL. */
int32_t area_pool_clipped(area_pool_t *pool, int32_t face, clip_t *c, int which, int *err);
/* The same, a piece for each of its parts that hang together (a contour and its holes), so that each can be in front of
 * or behind something as a whole. Returns 0 or ERR_FULL. */
int area_pool_parts(area_pool_t *pool, int32_t face, clip_t *c, int which, area_list_t *list);
void area_pool_drop(area_pool_t *pool, int32_t piece);
/* Its contours. Valid until the next call that makes a piece. */
poly_t area_pool_poly(area_pool_t *pool, int32_t piece);

static inline void area_list_add(area_pool_t *pool, area_list_t *l, int32_t piece) {
    pool->piece[piece].next = AREA_NONE;
    if (l->first == AREA_NONE)
        l->first = piece;
    else
        pool->piece[l->last].next = piece;
    l->last = piece;
}

#endif
