/* join.h - joins the pieces of a kernel into runs, straight through grid nodes.
 *
 * Pieces arrive an edge at a time; those of one line that touch, overlap, or leave a gap of at most a quarter step
 * on the page become one run. Each line has room for two open runs, because with the eye inside the grid a line
 * grows in both directions. The table is direct-mapped by the line's number: with fewer slots than lines nothing
 * goes wrong, runs are only finished earlier than they must (and the pool's pairing of ends joins them again, if
 * they meet there). A finished run leaves as an ink piece.
 * Cost: a few comparisons a piece; the map is asked only for a gap below 1/16 of a cell. */
#ifndef JOIN_H
#define JOIN_H

#include "hidden/ink.h"
#include "view/page.h"

typedef struct join_run {
    int64_t from, to; /* empty when from > to */
    int32_t line;
    uint8_t family, surface;
    bool recent; /* grew later than the other one of its pair */
} join_run_t;

#define JOIN_ROW_PAIRS 4 /* pairs kept apart for grid rows: columns stay open long, rows come and go */
#define JOIN_BYTES(columns) ((JOIN_ROW_PAIRS + (size_t)(columns)) * 2 * sizeof(join_run_t))

typedef struct join {
    join_run_t *run;
    uint32_t pairs;  /* for lines that are not rows; a power of two, >= 1 */
    int32_t gap_lat; /* a gap up to this on the page is closed */
    const ink_map_t *map;
    ink_sink_t out;
    int64_t pieces; /* taken so far */
} join_t;

/* mem: JOIN_BYTES(pairs) bytes, aligned for int64_t, owned by the caller until join_finish. */
void join_init(join_t *j, void *mem, uint32_t pairs, int32_t gap_lat, const ink_map_t *map, ink_sink_t out);
/* Takes one piece (from < to). Returns 0, or the error of `out`. */
int join_piece(join_t *j, const ink_piece_t *p);
/* Finishes all open runs. Returns 0, or the error of `out`. */
int join_finish(join_t *j);

#endif
