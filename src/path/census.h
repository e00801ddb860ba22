/* census.h - which ends have nobody near, found out without looking for neighbours.
 *
 * Most runs of a rough surface end where something hides them, far from any other end; looking for neighbours that are
 * not there is what pairing would spend its time on. So the ends are counted first, none, one or more to a cell of the
 * page, two bits each. Cells are counted in tiles of 16 x 16, 64 bytes; tiles may share those bytes (a hash), so the
 * answer "not alone" may be wrong, "alone" never is. Cost: linear, some ten operations an end. */
#ifndef CENSUS_H
#define CENSUS_H

#include "view/page.h"
#include <stddef.h>

typedef struct census {
    uint32_t *word; /* 16 to a tile */
    uint32_t mask;  /* tiles - 1 */
    int shift;      /* cells are 2^shift lat wide */
} census_t;

#define CENSUS_BYTES_MIN 64

/* An empty census in mem (CENSUS_BYTES_MIN bytes or more; of them no more than are of use for so many ends). */
void census_init(census_t *c, uint32_t *mem, size_t bytes, int32_t ends, int shift);
void census_enter(census_t *c, page_point_t p);
/* Asks the cache for what the other two read. */
void census_fetch(const census_t *c, page_point_t p);
/* Is certainly no other end within near_lat of p, which has been entered itself? near_lat <= 2^(shift - 1). */
bool census_is_alone(const census_t *c, page_point_t p, int32_t near_lat);

#endif
