/* planner.h - how fast the pen may be at every vertex of a path: look-ahead over unrounded coordinates, integers only.
 *
 * The trick that keeps it cheap: with one acceleration a for everything, a speed v is stored as its *height*
 * h = v^2 / 2a, the distance that a stop from v takes. Heights and lengths then have one unit, q3 lat (1/8 lat, 4 nm),
 * accelerating along a line of length L adds L, braking takes L away, and no limit needs the acceleration:
 *
 *     junction deviation d, turn t   v^2 = a d s/(1-s)      h = d/2 * s/(1-s), s = cos(t/2)
 *     centripetal, radius R          v^2 = a R              h = R/2,  R = (L1 + L2) / (4 tan(t/2))
 *
 * R is the radius of the arc that turns by t over half of each neighbour: for vertices taken from a smooth curve it is
 * the curve's own radius however finely it was cut, where junction deviation alone would allow any speed as the
 * turns get smaller. (Junction deviation: Jeon, "Improving Grbl: cornering algorithm", 2011.)
 *
 * A run is the path from one stop to the next (pen lifts, the end). Its blocks wait in a ring; a block leaves once no
 * later block could change its plan, so the result is that of infinite look-ahead as long as the ring covers the
 * stopping distance. When it does not, the oldest sixteenth leaves with a plan that could still stop at the newest
 * vertex.
 *
 * Cost: one root and no division per block that does not limit the speed, one division more per limit that does.
 * Context: main loop only. */
#ifndef PLANNER_H
#define PLANNER_H

#include "view/page.h"
#include <stdbool.h>
#include <stdint.h>

#define PLANNER_Q3_PER_LAT 8
#define PLANNER_REACH_LAT (1 << 27) /* |coordinate| below this (4 m): a length of q3 lat fits 32 bits */
#define PLANNER_HEIGHT_MAX_Q3 (1u << 30)

typedef struct planner_block {
    page_point_t to;
    uint32_t length_q3;
    uint32_t cap_q3;   /* most that the vertex at its start allows, as a height */
    uint32_t entry_q3; /* planned height at its start: the backward pass */
} planner_block_t;

typedef struct planner {
    planner_block_t *ring;  /* caller's memory */
    uint32_t size;          /* blocks in the ring, any number from 2 */
    uint32_t first, count;  /* oldest block and how many */
    uint32_t final;         /* of those, how many may leave */
    page_point_t last;      /* where the newest block ends */
    int32_t ux_q30, uy_q30; /* its direction */
    page_point_t start;     /* where the oldest block begins */
    uint32_t entry_q3;      /* true height there */
    uint32_t top_q3;        /* this run's speed limit */
    uint32_t junction_q3;   /* junction deviation */
    uint32_t forced;        /* blocks that had to leave before their plan was final */
} planner_t;

/* One line with its speeds decided: rises from in to top, holds, falls to out. */
typedef struct planner_move {
    page_point_t from, to;
    uint32_t length_q3;
    uint32_t in_q3, out_q3;
    uint32_t top_q3;   /* limit of the run, not the peak reached */
    bool last;         /* the run ends at `to`; otherwise: */
    page_point_t then; /* the vertex after `to` */
} planner_move_t;

/* Height of a speed: v^2 / 2a. speed_um_s up to 4,000,000, accel_um_s2 from 1; saturates at PLANNER_HEIGHT_MAX_Q3. */
uint32_t planner_height_q3(uint32_t speed_um_s, uint32_t accel_um_s2);

/* ring: size blocks (at least 2), the caller's for as long as the planner is used. */
void planner_init(planner_t *p, planner_block_t *ring, uint32_t size, uint32_t junction_um);
/* Starts a run at rest at `at`. The run before must have been taken to its end. */
void planner_begin(planner_t *p, page_point_t at, uint32_t top_q3);
bool planner_full(const planner_t *p);
/* Appends a line to the run; not when full. |coordinates| < PLANNER_REACH_LAT. Returns its length in q3 lat; 0: the
 * point is where the run already was, and nothing was appended. */
uint32_t planner_add(planner_t *p, page_point_t to);
/* Takes the oldest line. While the run goes on (`ending` false) it gives lines only when the ring is full, so that
 * what comes out depends on the path alone and not on when it was asked. False if there is none to give. */
bool planner_take(planner_t *p, bool ending, planner_move_t *out);

#endif
