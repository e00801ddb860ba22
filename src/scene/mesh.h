/* mesh.h - vertices and what is made of them, as one file or one inline element lists it, in the data pool.
 *
 * Vertices are packed (packed.h): 24 bytes each. Faces, lines and the beginnings of objects follow one another as words
 * of 4 bytes, from `top` downwards: a head (count << 2 | kind), then `count` indices of vertices. A walk reads them:
 *
 *     mesh_walk_t w = mesh_walk(m);
 *     while (mesh_next(&w)) use(w.kind, w.count, mesh_at(&w, k));
 *
 * Two readings of it: a scene of solids (solid.h), and a terrain, which has one height over each (x, y) and is cut into
 * profiles (profiles_mesh.h); polygons are then fans of triangles, and triangles that overlap in plan are the file's
 * mistake and are not detected. */
#ifndef MESH_H
#define MESH_H

#include "scene/packed.h"
#include <stdbool.h>
#include <stdint.h>

/* In place of a cosine in smooth_q30: a surface whose cells are two triangles each. What runs across a cell is a line
 * only where it is an outline: there the cell is folded for the eye. */
#define MESH_GRID (-1)

enum mesh_kind {
    MESH_FACE,   /* a polygon of count >= 3 vertices, which need not be different */
    MESH_LINE,   /* a polyline of count >= 2 vertices */
    MESH_OBJECT, /* count 0: what follows belongs to another object; 1: is translucent (word not 0) or not */
    MESH_DETAIL, /* a polyline of count >= 2 vertices on the face before it; a closed one may have a word behind them
                    that is negative: mesh_tone() */
};

/* Of a detail: percent of the light that it gives back; or it is a line, and has none. */
#define MESH_PLAIN 127
/* first: the first contour of its polygon. */
static inline int32_t mesh_tone_word(int32_t percent, bool first) {
    return ~(percent << 1 | (int32_t)first);
}

typedef struct mesh {
    int32_t nv;             /* vertices */
    int32_t words;          /* of elements */
    int32_t faces, corners; /* polygons, and their vertices in all */
    int32_t segments;       /* of all polylines */
    int32_t details;        /* segments on faces */
    int32_t smooth_q30;     /* cosine of `crease`: edges where faces meet at less are drawn only as outlines; 0: all */
    bool clear;             /* `translucent`: what is behind it is drawn, too; of all but for MESH_OBJECT's words */
    const packed_t (*vertex)[3]; /* x, y, z: unpack with packed_num() */
    const int32_t *top;          /* word k is top[-1 - k]; 0 <= index < nv */
} mesh_t;

typedef struct mesh_walk {
    const int32_t *at, *end; /* at: one above the next head */
    const int32_t *first;    /* one above the element's first index */
    enum mesh_kind kind;
    int32_t count;
    int32_t fan; /* next triangle of mesh_triangle */
} mesh_walk_t;

static inline mesh_walk_t mesh_walk(const mesh_t *m) {
    return (mesh_walk_t){.at = m->top, .end = m->top - m->words, .kind = MESH_OBJECT};
}
/* The next element; false at the end. */
static inline bool mesh_next(mesh_walk_t *w) {
    if (w->at == w->end) return false;
    int32_t head = *--w->at;
    w->kind = (enum mesh_kind)(head & 3);
    w->count = head >> 2;
    w->first = w->at;
    w->at -= w->count;
    return true;
}
/* Vertex k of the element, 0 <= k < count. */
static inline int32_t mesh_at(const mesh_walk_t *w, int32_t k) {
    return w->first[-1 - k];
}
/* The word behind a detail's vertices; w->count is their number afterwards. */
static inline int32_t mesh_tone(mesh_walk_t *w) {
    const int32_t word = w->count ? mesh_at(w, w->count - 1) : 0;
    if (word >= 0) return mesh_tone_word(MESH_PLAIN, true);
    w->count--;
    return word;
}
/* The next triangle of all fans, those with a vertex twice left out; false at the end. Not to be mixed with mesh_next.
 */
static inline bool mesh_triangle(mesh_walk_t *w, int32_t v[3]) {
    for (;;) {
        if (w->kind != MESH_FACE || w->fan + 2 >= w->count) {
            if (!mesh_next(w)) return false;
            w->fan = 0;
            continue;
        }
        v[0] = mesh_at(w, 0);
        v[1] = mesh_at(w, w->fan + 1);
        v[2] = mesh_at(w, w->fan + 2);
        w->fan++;
        if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) return true;
    }
}

#endif
