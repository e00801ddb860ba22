/* places.h - where very many ends are: a grid over the page, and all ends sorted by its cells.
 *
 * Ends lie in memory as they do on the page ("places": row of cells by row, an end after the other), so that what is
 * near is looked at without going anywhere else. Ends that meet are paired here (meet.h), and strokes are put in order
 * (match.h). Beside a place's end stands its tip, the place of the other end of its stroke or chain of strokes; so
 * linking two of them is four numbers changed, however long they are.
 * Coordinates are 15 bits an axis that begin again every sixteen cells or more: whoever compares them knows that they
 * are at most three cells apart. Cost: linear; 16 bytes an end are touched. */
#ifndef PLACES_H
#define PLACES_H

#include "path/chain.h"
#include "path/near.h"

#define PLACES_SCAN 128  /* ends looked at in one cell: whatever is in the same cell is near */
#define PLACES_CROWD 512 /* and in a row of cells, where an end may be that meets another */
#define PLACES_MASK INT16_MAX
#define PLACES_NEAR_MARGIN 2 /* by which what is near is so in spots, too: rounding, and one in meet.c */

typedef struct place {
    int32_t end, tip;
} place_t;

/* Where the ends are lies together, for that is what is looked through. A spot is one number, written as a whole (read
 * as one what is written in parts, it would have to wait): twice x, twice y from bit 16 on, so that differences are
 * those of 16 bits. Ends that have a link are marked: farther away than anything that is compared, and odd. */
#define PLACES_SPOT(x, y) ((uint32_t)(x) << 1 | (uint32_t)(y) << 17)
#define PLACES_FAR_AWAY (UINT32_C(1) << 31)
typedef struct place_list {
    int32_t n;
    uint32_t *spot;
    place_t *place;
} place_list_t;

typedef struct places {
    chain_t *chain;
    near_extent_t box;
    place_list_t now;
    uint32_t *start; /* of every cell, in now; and two more */
    int32_t nx, ny;
    int cell_x, cell_y; /* a cell is 2^cell_x lat wide, and as high or twice as high */
    int fine;           /* spots count in 2^fine lat */
    int32_t strokes;
    int32_t pen;                /* the first end of the pen's stroke; its points are the chain's, too */
    int32_t *next;              /* where fewer are sorted anew */
    int32_t (*brief)[2], *loop; /* there before: the places of runs that may be dots, and of strokes that are closed */
    int32_t briefs, loops;
} places_t;

/* Sorts all ends that the chain has placed, each run a stroke, if they are so many and there is memory; and two more:
 * the pen's stroke has the ends that one more run would have, home, where it is entered, and where the pen is (at).
 * Runs no longer than brief_lat are listed, and some others. */
bool places_sort(places_t *p, chain_t *c, page_point_t at, page_point_t home, int32_t brief_lat);
/* Sorts what is left of the ends without a link, and forgets the others; there are so many chains. */
void places_thin(places_t *p, int32_t chains, int32_t crowd);
/* Forgets the stroke at a place whose end is free. */
void places_drop(places_t *p, int32_t at);

/* Free ends within the chain's near_lat of a point: their places, up to max of them. Returns how many. In a crowd not
 * all are found. */
int places_near(const places_t *p, page_point_t at, uint32_t *out, int max);
/* The place of the free end e, of those that places_near finds there; or PLACES_NONE. */
uint32_t places_find(const places_t *p, int32_t e, page_point_t at);
#define PLACES_NONE UINT32_MAX

static inline bool places_is_marked(uint32_t spot) {
    return (spot & 1) != 0;
}
/* Of a spot that is not marked, and of one that is. */
static inline void places_mark(uint32_t *spot) {
    *spot = (*spot ^ PLACES_FAR_AWAY) | 1;
}
static inline void places_unmark(uint32_t *spot) {
    *spot = (*spot ^ PLACES_FAR_AWAY) & ~UINT32_C(1);
}
/* The spot, marked or not, that it was before. */
static inline uint32_t places_without_mark(uint32_t spot) {
    return (spot ^ spot << 31) & ~UINT32_C(1);
}
/* The first place of the cell that a point is in, in start. */
static inline uint32_t *places_cell(const places_t *p, page_point_t at) {
    return &p->start[((at.y_lat - p->box.y0) >> p->cell_y) * p->nx + ((at.x_lat - p->box.x0) >> p->cell_x)];
}
/* Two ends go on into each other, or the pen goes from one to the other: they are free no more, and what was two chains
 * is one. */
static inline void places_link(const place_list_t *list, uint32_t i, uint32_t j) {
    const place_t a = list->place[i], b = list->place[j];
    list->place[a.tip].tip = b.tip;
    list->place[b.tip].tip = a.tip;
    places_mark(&list->spot[i]);
    places_mark(&list->spot[j]);
}

#endif
