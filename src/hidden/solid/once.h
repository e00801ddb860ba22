/* once.h - solids and wires: what falls together on the page is drawn once.
 *
 * Edges of bodies that stand flush coincide in part, and edges exactly behind each other have one picture. A pen should
 * not draw it twice. Before a kernel runs, edges whose pictures overlap, no farther apart than ONCE_FLAT_LAT anywhere,
 * are put into groups, each of which lies along one line of the page; what a kernel then emits for them is kept, united
 * along that line, and given on at the end. Ink of all other edges, which is nearly all of it, passes straight through.
 * A dashed part is left out where something visible is drawn, and a crease where a silhouette is.
 *
 * Where two pictures overlap, the overlap ends at a vertex of one of them that lies on the other. So the ends of edges
 * are sorted into a page grid, and every edge looks in the cells along it for ends that are on it: no pair of edges is
 * compared but those, and the cost is linear like the walk.
 *
 * Left alone, and drawn twice if they coincide: edges shorter on the page than ONCE_LEAST_LAT, and groups that are not
 * straight: the spokes of a wheel that is so small that each falls together with the next.
 *
 * Memory: while looking 20 bytes an edge and 20 a vertex; afterwards none, or if anything coincides 4 an edge and 96
 * for each edge that does. Cost: printed by make bench-solids. */
#ifndef ONCE_H
#define ONCE_H

#include "hidden/ink.h"
#include "view/solid_map.h"

#define ONCE_FLAT_LAT 4 /* a hundredth of a step: places are rounded to a lat, and bodies that were turned to a few */
#define ONCE_LEAST_LAT 256 /* of an edge, and of the part in common */

/* Where two kinds of ink fall together, the first is drawn. */
enum once_rank { ONCE_SILHOUETTE, ONCE_CREASE, ONCE_HIDDEN, ONCE_RANKS };

typedef struct once_piece {
    int32_t rank;   /* four times the group, and an enum once_rank */
    int32_t u0, u1; /* where on the group's line: x or y, lat; u0 <= u1 */
    int32_t edge, from_q30, to_q30;
} once_piece_t;

typedef struct once {
    const solid_map_t *map;
    ink_sink_t seen, dashed;   /* where ink goes */
    int32_t *group;            /* of each edge: twice the first of its edges, and 1 more if its line runs along y; -1 */
    once_piece_t *piece;       /* of edges in groups */
    int32_t n, n_max, n_least; /* pieces there are, there is room for, there should be room for */
    uint8_t surface[ONCE_RANKS]; /* of the pieces of a rank (hidden/line_class.h) */
    size_t bytes;                /* of the lent memory that stay in use */
} once_t;

/* Bytes that suffice for so many edges, but for views in which nearly all of them coincide or leave the page. */
#define ONCE_BYTES(edges) ((size_t)(edges)*48 + 512)

/* What once_build gets through with at the least, where nothing leaves the page. */
#define ONCE_BYTES_LEAST(edges, vertices) ((size_t)(edges)*20 + (size_t)(vertices) * (sizeof(page_point_t) + 8) + 32)

/* Finds out what coincides, in mem (aligned to 8), which lives as long as o. away: will the kernel draw edges of bodies
 * between faces turned from the eye? If not, they are not looked at, which saves a sixth of the time (and if it draws
 * one after all, that passes through). Of edges that coincide four visible parts each are kept; where many bodies stand
 * in front of them there are more, and the sinks end in ERR_FULL. plenty: as many as a quarter of the memory takes.
 * Returns 0 or ERR_FULL. */
int once_build(once_t *o, const solid_map_t *m, bool away, bool plenty, void *mem, size_t bytes);
/* Gives back what it can of the lent memory, up to so many bytes: it keeps room for four pieces of each edge, and where
 * others lack memory two must do. Before the first piece. */
void once_spare(once_t *o, size_t bytes);
/* Sinks for what is visible and what is hidden; next and dashes are where it goes to. Ink must be cut to the page
 * (view/cut.h) where the map is not all inside; what is not an edge's passes through. */
ink_sink_t once_seen(once_t *o, ink_sink_t next);
ink_sink_t once_dashed(once_t *o, ink_sink_t dashes);
/* Gives what was kept to the sinks. Returns 0 or their error. */
int once_finish(once_t *o);

#endif
