/* solid_double.c - faces that a mesh has twice, perhaps for both of its sides: each becomes one, since otherwise none
 * of its edges would be between two faces. Found in the memory of the edges' hash table. */
#include "config.h"
#include "num/heap_sort.h"
#include "scene/solid_build.h"
#include <string.h>

/* Does face f have the corners of face g, this way round or the other? */
static bool is_double(const solid_build_t *b, int32_t f, int32_t g) {
    const int32_t n = b->face[f].n, *c = b->corner + b->face[f].corner, *d = b->corner + b->face[g].corner;
    if (b->face[g].n != n || b->group[f] != b->group[g] || b->face[f].clear != b->face[g].clear) return false;
    int32_t first = 0, k = 0, step = 1;
    while (first < n && d[first] != c[0]) first++;
    if (first == n) return false;
    if (d[(first + 1) % n] != c[1]) step = n - 1;
    for (int32_t at = first; k < n && d[at] == c[k]; k++) at = (at + step) % n;
    return k == n;
}

/* The slot of a double of face f, or the one to put f into. */
static int32_t *slot_of_face(const solid_build_t *b, int32_t f) {
    uint32_t h = 0; /* whatever the order */
    for (int32_t k = 0; k < b->face[f].n; k++) h += (uint32_t)b->corner[b->face[f].corner + k] * 0x9e3779b1u;
    for (h ^= h >> 15;; h++) {
        int32_t *slot = &b->slot[h & (b->slots - 1)];
        if (*slot < 0 || is_double(b, f, *slot)) return slot;
    }
}

static bool is_before(const solid_edge_t *a, const solid_edge_t *b) {
    return a->face[0] != b->face[0] ? a->face[0] < b->face[0] : a->twin < b->twin;
}
HEAP_SORT(solid_edge_t, is_before)

/* Details go to the faces that stay, behind those that are there. Their tones, and the order on a face, are kept. */
static void move_details(solid_build_t *b) {
    for (int32_t k = 0; k < b->s->nd; k++) {
        solid_edge_t *e = &b->detail[k];
        e->face[0] = (int32_t)b->parent[e->face[0]];
        if (e->face[1] >= 0) e->face[1] = e->face[0];
        e->twin = k;
    }
    heap_sort(b->detail, b->s->nd);
    for (int32_t k = 0; k < b->s->nd; k++) b->detail[k].twin = -1;
}

bool solid_drop_doubles(solid_build_t *b) {
    solid_t *s = b->s;
    const int32_t all = s->nf;
    if ((uint32_t)all > b->slots / 8 * 7) return false; /* memory is short */
    memset(b->slot, 0xff, b->slots * sizeof *b->slot);
    s->nf = s->nc = 0;
    for (int32_t f = 0; f < all; f++) {
        int32_t *slot = slot_of_face(b, f), first = b->face[f].corner;
        b->parent[f] = (uint32_t)(*slot < 0 ? s->nf : *slot);
        if (*slot >= 0) continue;
        const int32_t to = *slot = s->nf++;
        b->face[to] = b->face[f];
        b->group[to] = b->group[f];
        b->face[to].corner = s->nc;
        for (int32_t k = 0; k < b->face[to].n; k++) {
            b->corner_face[s->nc] = to;
            b->corner[s->nc++] = b->corner[first + k];
        }
    }
    if (CONFIG_AREA && s->nf < all) move_details(b); /* others draw them as lines of their own */
    return s->nf < all;
}
