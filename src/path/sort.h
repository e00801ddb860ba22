/* sort.h - puts runs that are near each other on the page near each other in memory.
 *
 * All that comes after placing the runs (pairing their ends, ordering the strokes, walking them to draw) goes from a
 * run to its neighbours on the page. A rough surface of a million facets leaves 20 MB of runs, and each visit to a
 * neighbour waits for memory; sorted, most are in the cache: the stages together take half the time. Few runs fit the
 * cache anyhow and are left as they are, so small drawings do not depend on this. */
#ifndef SORT_H
#define SORT_H

#include "path/pool.h"

#define SORT_RUNS_MIN 4096

/* Sorts the pool's runs, and point[2 * run + side] with them, along a Z-order curve (Morton 1966) through square cells
 * of some 16 runs, by where they begin. work: 8 bytes per run. Cost: linear, each run moves about once (a radix sort in
 * place, "American flag" of McIlroy, Bostic and McIlroy 1993). */
void sort_runs(pool_t *pool, page_point_t *point, uint32_t *work);

#endif
