/* naive_solids.h - solids and haloes as they are usually done: what the report sets beside ours.
 *
 * Solids: faces are painted into a depth buffer of NAIVE_COLUMNS columns in single precision, and an edge is drawn
 * where it is not deeper than the buffer by more than a thousandth of the scene. Haloes: of two edges that cross the
 * one whose middle is nearer interrupts the other. */
#ifndef NAIVE_SOLIDS_H
#define NAIVE_SOLIDS_H

#include "tests/oracle/halo_run.h"
#include "tests/oracle/judge.h"
#include "tests/oracle/solid_ref.h"

/* Pieces of the scene's edges, to be freed. r has its eye. */
judge_piece_t *naive_solids(const solid_ref_t *r, const page_view_t *v, size_t *n);
/* Adds pieces of edges. */
void naive_halo(halo_run_t *out, const halo_edge_t *edge, int n, int32_t width);

#endif
