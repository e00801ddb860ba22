/* shadow_sides.c - see shadow_sides.h. */
#include "hidden/shadow_sides.h"

#include "num/wide.h"
#include "view/solid_side.h"

static void find_sides(shadows_t *s) {
    const solid_t *solid = s->map->solid;
    for (int32_t f = 0; f < solid->nf; f++) {
        solid_normal_t n = solid_face_normal(solid, f);
        int side = solid_side(s->map, &n, shadow_corner(s, f, 0));
        s->face[f] = side > 0 ? SHADOW_FRONT : side < 0 ? SHADOW_AWAY : SHADOW_EDGE_ON;
        const bool known = solid->object[solid->face[f].object].kind == SOLID_CONVEX;
        if (!known && !solid_face_is_convex(solid, f, &n)) s->face[f] |= SHADOW_BENT;
    }
}

/* A line from the eye along x: does it pass face f's picture along x, and is the face's plane in front of it there? */
static bool ray_meets(const shadows_t *s, int32_t f) {
    const solid_eye_t *e = &s->map->eye;
    const int32_t corners = s->map->solid->face[f].n;
    bool odd = false;
    for (int32_t k = 0; k < corners; k++) {
        const solid_vertex_t *p = shadow_corner(s, f, k), *q = shadow_corner(s, f, k + 1 < corners ? k + 1 : 0);
        int64_t py = p->at[1] * e->w - e->e[1], pz = p->at[2] * e->w - e->e[2];
        int64_t qy = q->at[1] * e->w - e->e[1], qz = q->at[2] * e->w - e->e[2];
        if ((pz > 0) == (qz > 0)) continue;
        int sign = wide_det_sign(py, pz, qy, qz);
        odd ^= qz > pz ? sign > 0 : sign < 0;
    }
    if (!odd) return false;
    solid_normal_t n = solid_face_normal(s->map->solid, f);
    int side = shadow_side_of(s, f) == SHADOW_FRONT ? 1 : shadow_side_of(s, f) == SHADOW_AWAY ? -1 : 0;
    return n.n[0] > 0 ? side < 0 : side > 0;
}

enum { ODD = 0x80, SEEN = 0x40 };

/* An eye inside of a closed object sees its faces from within: they are those of an open one. Inside, a line that goes
 * out meets an odd number of faces; and an object no face of which looks at the eye has it inside or in its surface. */
static void find_inside(shadows_t *s) {
    const solid_t *solid = s->map->solid;
    for (int32_t o = 0; o < solid->no; o++) s->object[o] = solid->object[o].kind;
    if (s->map->eye.w == 0) return;
    for (int32_t f = 0; f < solid->nf; f++) {
        uint8_t *o = &s->object[solid->face[f].object];
        if (ray_meets(s, f)) *o ^= ODD;
        if (shadow_side_of(s, f) == SHADOW_FRONT) *o |= SEEN;
    }
    for (int32_t o = 0; o < solid->no; o++)
        s->object[o] = (s->object[o] & (ODD | SEEN)) == SEEN ? solid->object[o].kind : SOLID_OPEN;
}

/* Kinds become flags, which faces take over. */
static void set_flags(shadows_t *s) {
    const solid_t *solid = s->map->solid;
    for (int32_t o = 0; o < solid->no; o++) {
        const bool whole = s->object[o] == SOLID_CONVEX && solid->object[o].faces <= SHADOW_FACES_MOST;
        s->object[o] = whole ? SHADOW_WHOLE : s->object[o] == SOLID_OPEN ? SHADOW_OPEN : 0;
        if (solid->object[o].smooth_q30) s->object[o] |= SHADOW_SMOOTH;
    }
    for (int32_t f = 0; f < solid->nf; f++) s->face[f] |= s->object[solid->face[f].object];
}

void shadow_sides_find(shadows_t *s) {
    find_sides(s);
    find_inside(s);
    set_flags(s);
}
