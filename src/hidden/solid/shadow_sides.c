/* shadow_sides.c - see shadow_sides.h. */
#include "hidden/solid/shadow_sides.h"

#include "num/wide.h"
#include "view/solid_side.h"

#define LARGE ((int64_t)1 << 34) /* no margin is: differences of places have 31 bits */

/* Which side of a triangle or quadrilateral is seen in a parallel view, from its picture: the sign of its area, or 0
 * if it is not sure. */
static int side_on_page(const shadows_t *s, const solid_face_t *face) {
    const solid_place_t *place = s->map->place;
    const int32_t *c = s->map->solid->corner + face->corner, n = face->n;
    if (s->map->eye.w != 0 || !s->map->all_good || n > 4) return 0;
    const solid_place_t *a = &place[c[0]], *b = &place[c[1]], *d = &place[c[2]], *e = &place[c[n == 4 ? 3 : 0]];
    /* diagonals, or sides: off by a lat and a hair */
    const int32_t ux = d->x - a->x, uy = d->y - a->y, vx = e->x - b->x, vy = e->y - b->y;
    const int64_t area = wide_mul_s32(ux, vy) - wide_mul_s32(uy, vx);
    if (area <= LARGE && area >= -LARGE) {
        const int64_t margin = (int64_t)(2 * (solid_abs(ux) + solid_abs(uy) + solid_abs(vx) + solid_abs(vy))) + 8;
        if (area <= margin && area >= -margin) return 0;
    }
    return area > 0 ? 1 : -1;
}

static void find_sides(shadows_t *s) {
    const solid_t *solid = s->map->solid;
    for (int32_t f = 0; f < solid->nf; f++) {
        const solid_face_t *face = &solid->face[f];
        const bool known = solid->object[face->object].kind == SOLID_CONVEX;
        int side = CONFIG_MANY_BODIES && (known || face->n == 3) ? side_on_page(s, face) : 0;
        bool bent = false;
        if (side == 0) {
            solid_normal_t n = solid_face_normal(solid, f);
            side = solid_side(s->map, &n, shadow_corner(s, f, 0));
            bent = !known && !solid_face_is_convex(solid, f, &n);
        }
        s->face[f] = (uint8_t)((side > 0   ? SHADOW_FRONT
                                : side < 0 ? SHADOW_AWAY
                                           : SHADOW_EDGE_ON) |
                               (bent ? SHADOW_BENT : 0));
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

/* Kinds become flags. Returns how many objects have one shadow. */
static int32_t set_flags(shadows_t *s) {
    const solid_t *solid = s->map->solid;
    int32_t wholes = 0;
    for (int32_t o = 0; o < solid->no; o++) {
        const bool whole = s->object[o] == SOLID_CONVEX && solid->object[o].faces <= SHADOW_FACES_MOST;
        s->object[o] = whole ? SHADOW_WHOLE : s->object[o] == SOLID_OPEN ? SHADOW_OPEN : 0;
        if (solid->object[o].smooth_q30) s->object[o] |= SHADOW_SMOOTH;
        wholes += whole;
    }
    return wholes;
}

int32_t shadow_sides_find(shadows_t *s) {
    find_sides(s);
    find_inside(s);
    return set_flags(s);
}
