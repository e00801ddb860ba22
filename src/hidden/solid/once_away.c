/* once_away.c - see once_away.h. */
#include "hidden/solid/once_away.h"

#include "hidden/area/area_face.h"

static int64_t size(int64_t a) {
    return a < 0 ? -a : a;
}

/* Corners that tell: a convex body's faces are convex, and any three will do. */
static int32_t corners_of(const solid_t *s, const solid_face_t *f) {
    return s->object[f->object].kind == SOLID_CONVEX ? 3 : f->n;
}

/* Which way round a face of a body runs on the page: 1, -1, or 0 for what is too thin to tell, or no body's. The terms
 * of its area are off by no more than half a lat times the lengths of their sides. */
static int turn_of(const solid_map_t *m, const solid_face_t *f) {
    if (m->solid->object[f->object].kind == SOLID_OPEN) return 0;
    const int32_t *corner = &m->solid->corner[f->corner];
    const solid_place_t *p = &m->place[corner[0]], *q = &m->place[corner[1]];
    int64_t x = (int64_t)q->x - p->x, y = (int64_t)q->y - p->y, area = 0, off = size(x) + size(y) + 1;
    const int32_t n = corners_of(m->solid, f);
    for (int32_t k = 2; k < n; k++) {
        q = &m->place[corner[k]];
        const int64_t dx = (int64_t)q->x - p->x, dy = (int64_t)q->y - p->y;
        area += x * dy - y * dx;
        off += 2 * (size(dx) + size(dy) + 1);
        x = dx;
        y = dy;
    }
    return (area > off) - (area < -off);
}

bool once_find_away(const solid_map_t *m, uint8_t *away) {
    if (m->any_behind) return false;
    int front = 0; /* how faces run that look at the eye: one tells for all, for axes may be reversed */
    for (int32_t f = 0; f < m->solid->nf; f++) {
        const int turn = turn_of(m, &m->solid->face[f]);
        if (front == 0 && turn != 0) front = area_looks_at_eye(m, f) ? turn : -turn;
        away[f] = turn * front < 0;
    }
    return true;
}
