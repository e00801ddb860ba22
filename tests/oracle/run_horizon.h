/* run_horizon.h - profiles of doubles through the horizon kernel. */
#ifndef RUN_HORIZON_H
#define RUN_HORIZON_H

#include "tests/oracle/horizon_ref.h"
#include "tests/oracle/run_kernel.h"

/* Draws the profiles of r, which lie square to the ground direction `away` from the viewer; pieces come as the judge's,
 * family 0. Returns the kernel's result. */
int run_horizon(const horizon_ref_t *r, const double away[2], run_drawing_t *d, hidden_stats_t *stats);

#endif
