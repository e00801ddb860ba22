/* halo_run.h - haloes by the kernel, on their way to the judge (halo_ref.h). */
#ifndef HALO_RUN_H
#define HALO_RUN_H

#include "tests/oracle/halo_ref.h"

typedef struct halo_run {
    halo_t h;
    void *mem; /* lent to it */
    size_t bytes;
    halo_ref_piece_t *piece; /* what it draws */
    int n, room;
} halo_run_t;

/* Lends memory for n edges and so many crossings; *r is zero before. */
void halo_run_make(halo_run_t *r, int32_t n, size_t crossings);
/* Takes n edges through the kernel; edge k has the number k. Returns its error. */
int halo_run_draw(halo_run_t *r, const halo_edge_t *edge, int32_t n, int32_t width);
/* Adds a piece, from and to in fractions of its edge. */
void halo_run_add(halo_run_t *r, int32_t edge, double from, double to);
void halo_run_free(halo_run_t *r);

#endif
