/* solid_double.c - faces that a mesh has twice, perhaps for both of its sides: each becomes one, since otherwise none
 * of its edges would be between two faces. Found in the memory of the edges' hash table. */
#include "scene/solid_build.h"
#include <string.h>

/* Does face f have the corners of face g, this way round or the other? */
static bool is_double(const solid_build_t *b, int32_t f, int32_t g) {
    const int32_t n = b->face[f].n, *c = b->corner + b->face[f].corner, *d = b->corner + b->face[g].corner;
    if (b->face[g].n != n || b->group[f] != b->group[g]) return false;
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
    for (int32_t k = 0; k < s->nd; k++)
        b->detail[k].face[0] = b->detail[k].face[1] = (int32_t)b->parent[b->detail[k].face[0]];
    return s->nf < all;
}
