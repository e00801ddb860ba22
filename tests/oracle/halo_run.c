/* halo_run.c - see halo_run.h. */
#include "tests/oracle/halo_run.h"

#include <stdlib.h>

void halo_run_make(halo_run_t *r, int32_t n, size_t crossings) {
    r->bytes = HALO_BYTES(n, crossings);
    r->mem = malloc(r->bytes);
    if (!r->mem) abort();
}

void halo_run_add(halo_run_t *r, int32_t edge, double from, double to) {
    if (r->n == r->room) {
        r->room = 2 * r->room + 64;
        r->piece = realloc(r->piece, (size_t)r->room * sizeof *r->piece);
        if (!r->piece) abort();
    }
    r->piece[r->n++] = (halo_ref_piece_t){edge, from, to};
}

static int take(void *ctx, int32_t id, uint32_t from_q30, uint32_t to_q30) {
    halo_run_add(ctx, id, from_q30 * 0x1p-30, to_q30 * 0x1p-30);
    return 0;
}

int halo_run_draw(halo_run_t *r, const halo_edge_t *edge, int32_t n, int32_t width) {
    int err = 0;
    r->n = 0;
    halo_init(&r->h, r->mem, r->bytes);
    for (int32_t k = 0; k < n && !err; k++) err = halo_add(&r->h, k, edge[k].p, edge[k].q);
    if (!err) err = halo_cut(&r->h, 0);
    return err ? err : halo_draw(&r->h, width, &(halo_sink_t){r, take});
}

void halo_run_free(halo_run_t *r) {
    free(r->mem);
    free(r->piece);
    *r = (halo_run_t){0};
}
