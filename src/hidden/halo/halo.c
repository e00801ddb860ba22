/* halo.c - the edges of a wire frame: taking them in. CUT is in halo_cut.c, DRAW in halo_draw.c. */
#include "hidden/halo/halo.h"

#include "error.h"
#include <stdbool.h>

void halo_init(halo_t *h, void *mem, size_t bytes) {
    const size_t skip = -(uintptr_t)mem & (2 * sizeof mem - 1);
    *h = (halo_t){
        .mem = (uint8_t *)mem + (skip < bytes ? skip : bytes), .bytes = skip < bytes ? bytes - skip : 0, .contact = 1};
    h->edge = (halo_edge_t *)(void *)h->mem;
}

static bool in_range(const halo_point_t *p) {
    return p->x >= -HALO_XY_MAX && p->x <= HALO_XY_MAX && p->y >= -HALO_XY_MAX && p->y <= HALO_XY_MAX &&
           p->z >= -HALO_Z_MAX && p->z <= HALO_Z_MAX;
}

int halo_add(halo_t *h, int32_t id, halo_point_t p, halo_point_t q) {
    if (!in_range(&p) || !in_range(&q)) return ERR_VALUE;
    if (h->edges >= HALO_EDGES_MAX || (size_t)(h->edges + 1) * sizeof *h->edge > h->bytes) return ERR_FULL;
    h->edge[h->edges++] = (halo_edge_t){p, q, id};
    return 0;
}
