/* surface_mesh.c - see surface_mesh.h. */
#include "scene/surface_mesh.h"

void surface_mesh_counts(const surface_t *s, bool triangles, mesh_t *m) {
    int32_t cells = (s->nx - 1) * (s->ny - 1);
    *m = triangles ? (mesh_t){.nv = s->nx * s->ny, .words = 8 * cells, .faces = 2 * cells, .corners = 6 * cells}
                   : (mesh_t){.nv = s->nx * s->ny, .words = 5 * cells, .faces = cells, .corners = 4 * cells};
    m->smooth_q30 = triangles ? MESH_GRID : 0;
}

/* Adds the polygon of corners first, first + 1, ... of a cell, those after 3 from 0 on. */
static int32_t *add_face(int32_t *word, const int32_t corner[4], int first, int n, mesh_t *m) {
    *--word = n << 2 | MESH_FACE;
    for (int k = 0; k < n; k++) *--word = corner[(first + k) % 4];
    m->faces++;
    m->corners += n;
    return word;
}

static packed_t height(const surface_t *s, int32_t i, int32_t j, const num_t *lo, const num_t *hi) {
    num_t z = s->z_of(s->ctx, i, j);
    if (z.undef || (lo && num_cmp(z, *lo) < 0) || (hi && num_cmp(z, *hi) > 0)) return PACKED_HOLE;
    return packed_from_num(z);
}

void surface_mesh(const surface_t *s, const num_t *lo, const num_t *hi, bool triangles, void *mem, mesh_t *m) {
    packed_t(*vertex)[3] = mem;
    surface_mesh_counts(s, triangles, m);
    int32_t *top = (int32_t *)(void *)(vertex + m->nv) + m->words, *word = top;
    for (int32_t j = 0; j < s->ny; j++) {
        for (int32_t i = 0; i < s->nx; i++) {
            packed_t *v = vertex[j * s->nx + i];
            v[0] = packed_from_num(s->x_of(s->ctx, i));
            v[1] = packed_from_num(s->y_of(s->ctx, j));
            v[2] = height(s, i, j, lo, hi);
        }
    }
    m->faces = m->corners = 0;
    for (int32_t j = 0; j + 1 < s->ny; j++) {
        for (int32_t i = 0; i + 1 < s->nx; i++) {
            const int32_t a = j * s->nx + i, corner[4] = {a, a + 1, a + s->nx + 1, a + s->nx};
            bool hole = false;
            for (int k = 0; k < 4; k++) hole |= vertex[corner[k]][2] == PACKED_HOLE;
            if (hole) continue;
            word = add_face(word, corner, 0, triangles ? 3 : 4, m);
            if (triangles) word = add_face(word, corner, 2, 3, m);
        }
    }
    m->words = (int32_t)(top - word);
    m->vertex = (const packed_t(*)[3])vertex;
    m->top = top;
}
