/* solid_join.c - from corners to edges, objects and their kinds.
 *
 * Corners whose edges lie between the same two vertices are chained through a hash table. Where there are just two,
 * their faces belong to one object, and a union-find whose links know whether both faces run the same way round
 * collects it and turns its faces alike. Edges of more faces (bodies that touch) connect those of one `o` or `g`, if
 * they are two; they become one edge for each object, twins of each other. */
#include "config.h"
#include "num/wide.h"
#include "scene/solid_build.h"
#include "scene/solid_math.h"
#include <string.h>

static int32_t corner_end(const solid_build_t *b, int32_t c) {
    const solid_face_t *f = &b->face[b->corner_face[c]];
    return b->corner[c + 1 < f->corner + f->n ? c + 1 : f->corner];
}

/* Does the edge behind corner c run from its smaller vertex to its larger? */
static bool runs_up(const solid_build_t *b, int32_t c) {
    return b->corner[c] < corner_end(b, c);
}

/* The slot of the edge between p < q; -1 in it if there is none yet. */
static int32_t *slot_of(const solid_build_t *b, int32_t p, int32_t q) {
    uint32_t h = (uint32_t)p * 0x9e3779b1u ^ ((uint32_t)q * 0x85ebca6bu + 0x27d4eb2fu);
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 13;
    for (;; h++) {
        int32_t *slot = &b->slot[h & (b->slots - 1)];
        if (*slot < 0) return slot;
        const solid_edge_t *e = &b->edge[*slot];
        if (e->v[0] == p && e->v[1] == q) return slot;
    }
}

/* Free segments that are there twice are one. */
static void chain_segments(solid_build_t *b) {
    memset(b->slot, 0xff, b->slots * sizeof *b->slot);
    int32_t n = 0;
    for (int32_t e = 0; e < b->s->ne; e++) {
        int32_t *slot = slot_of(b, b->edge[e].v[0], b->edge[e].v[1]);
        if (*slot >= 0) continue;
        b->edge[n] = b->edge[e];
        b->edge[n].first = n;
        b->edge[n].face[0] = -1; /* if corners were chained already */
        *slot = n++;
    }
    b->s->ne = n;
}

/* One edge for each pair of vertices; face[0] is the first corner of its chain, or -1. */
static void chain_corners(solid_build_t *b) {
    for (int32_t c = 0; c < b->s->nc; c++) {
        int32_t p = b->corner[c], q = corner_end(b, c);
        int32_t *slot = slot_of(b, p < q ? p : q, p < q ? q : p);
        if (*slot < 0) {
            *slot = b->s->ne;
            if (!solid_new_edge(b, p, q)) return;
        }
        b->corner_next[c] = b->edge[*slot].face[0];
        b->edge[*slot].face[0] = c;
    }
}

/* Has any edge more than two faces? */
static bool is_crowded(const solid_build_t *b) {
    for (int32_t e = 0; e < b->s->ne; e++) {
        const int32_t c = b->edge[e].face[0];
        if (c >= 0 && b->corner_next[c] >= 0 && b->corner_next[b->corner_next[c]] >= 0) return true;
    }
    return false;
}

/* The face that stands for f's object; *turned: does f run the other way? Halves the path. */
static uint32_t find(solid_build_t *b, uint32_t f, bool *turned) {
    uint32_t turn = 0;
    while (b->parent[f] >> 1 != f) {
        uint32_t up = b->parent[f] >> 1, link = b->parent[f] & 1;
        uint32_t next = b->parent[up];
        b->parent[f] = (next & ~1u) | (link ^ (next & 1));
        turn ^= b->parent[f] & 1;
        f = b->parent[f] >> 1;
    }
    *turned = turn != 0;
    return f;
}

/* corner_next doubles as a mark at the end: objects that cannot be turned consistently are marked in object[root]. */
static void unite(solid_build_t *b, int32_t c, int32_t d) {
    bool turned_c, turned_d, against = runs_up(b, c) == runs_up(b, d);
    uint32_t f = find(b, (uint32_t)b->corner_face[c], &turned_c), g = find(b, (uint32_t)b->corner_face[d], &turned_d);
    if (f == g) {
        if ((turned_c ^ turned_d) != against) b->object[f].kind = 1; /* twisted */
        return;
    }
    if (g < f) {
        uint32_t swap = f;
        f = g;
        g = swap;
    }
    b->parent[g] = f << 1 | (uint32_t)(turned_c ^ turned_d ^ against);
    b->object[f].kind |= b->object[g].kind;
}

/* Bodies that touch: of an edge with more faces, the two of each group belong together. A chain has its corners in
 * order, and so its groups. */
static void unite_groups(solid_build_t *b, int32_t first) {
    for (int32_t c = first, after; c >= 0; c = after) {
        const int32_t next = b->corner_next[c];
        int32_t n = 0;
        for (after = c; after >= 0 && b->group[b->corner_face[after]] == b->group[b->corner_face[c]]; n++)
            after = b->corner_next[after];
        if (n == 2 && b->corner_face[next] != b->corner_face[c]) unite(b, c, next);
    }
}

static void unite_all(solid_build_t *b) {
    for (int32_t f = 0; f < b->s->nf; f++) {
        b->parent[f] = (uint32_t)f << 1;
        b->object[f] = (solid_object_t){.faces = 0};
    }
    for (int32_t e = 0; e < b->s->ne; e++) {
        int32_t c = b->edge[e].face[0];
        if (c < 0) continue;
        int32_t d = b->corner_next[c];
        if (d < 0) continue;
        if (b->corner_next[d] >= 0)
            unite_groups(b, c);
        else if (b->corner_face[c] != b->corner_face[d])
            unite(b, c, d);
    }
}

/* Numbers the objects; parent[f] becomes 1 where f has to be turned. Objects start closed, unless twisted. */
static void number_objects(solid_build_t *b) {
    solid_t *s = b->s;
    for (int32_t f = 0; f < s->nf; f++) {
        bool turned;
        int32_t root = (int32_t)find(b, (uint32_t)f, &turned);
        if (root == f) {
            uint8_t kind = b->object[f].kind ? SOLID_OPEN : SOLID_CLOSED;
            b->object[s->no] = (solid_object_t){0, b->face[f].object /* add_face() */, kind, false};
            b->face[f].object = s->no++;
        } else {
            b->face[f].object = b->face[root].object; /* a root is the first face of its object */
        }
        solid_object_t *o = &b->object[b->face[f].object];
        o->faces++;
        o->clear |= b->face[f].clear;
    }
    for (int32_t f = 0; f < s->nf; f++) {
        bool turned;
        find(b, (uint32_t)f, &turned);
        b->corner_face[b->face[f].corner] = turned ? ~f : f; /* parent is still needed by the others */
    }
    for (int32_t f = 0; f < s->nf; f++) {
        int32_t *mark = &b->corner_face[b->face[f].corner];
        b->parent[f] = *mark < 0;
        *mark = f;
    }
}

static void put_face(const solid_build_t *b, solid_edge_t *e, int32_t c) {
    int32_t f = b->corner_face[c];
    int side = runs_up(b, c) == (b->parent[f] != 0);
    e->face[e->face[side] < 0 ? side : 1 - side] = f;
}

/* Spreads the corners of one pair of vertices over edges: two corners of an object to each. group[object] is the edge
 * at hand of each, in the memory of what is not needed any more; -1 before and after. */
static void spread_corners(solid_build_t *b, int32_t first) {
    const int32_t head = b->edge[first].face[0];
    int32_t last = -1;
    if (head < 0) return;
    b->edge[first].face[0] = -1;
    for (int32_t c = head; c >= 0; c = b->corner_next[c]) {
        const int32_t object = b->face[b->corner_face[c]].object;
        int32_t *e = &b->group[object];
        if (*e >= 0 && b->edge[*e].face[0] >= 0 && b->edge[*e].face[1] >= 0) { /* more than two */
            b->object[object].kind = SOLID_OPEN;
            *e = -1;
        }
        if (*e < 0) {
            *e = last < 0 ? first : b->s->ne;
            if (last >= 0) {
                solid_edge_t *twin = solid_new_edge(b, b->edge[first].v[0], b->edge[first].v[1]);
                if (!twin) return;
                twin->first = first;
                b->edge[last].twin = *e;
            }
            last = *e;
        }
        put_face(b, &b->edge[*e], c);
    }
    for (int32_t c = head; c >= 0; c = b->corner_next[c]) {
        const int32_t object = b->face[b->corner_face[c]].object, e = b->group[object];
        if (e >= 0 && (b->edge[e].face[0] < 0 || b->edge[e].face[1] < 0)) b->object[object].kind = SOLID_OPEN;
        b->group[object] = -1;
    }
}

static void reverse(solid_build_t *b, int32_t f) {
    int32_t *c = b->corner + b->face[f].corner;
    for (int32_t i = 0, j = b->face[f].n - 1; i < j; i++, j--) {
        int32_t swap = c[i];
        c[i] = c[j];
        c[j] = swap;
    }
}

/* Six times the volume to the origin of the lattice. */
static wide_t volume(const solid_build_t *b, int32_t f) {
    static const solid_vertex_t zero;
    const int32_t *c = b->corner + b->face[f].corner;
    wide_t sum = {0, 0};
    for (int32_t k = 1; k + 1 < b->face[f].n; k++) {
        solid_normal_t n = solid_cross(solid_sub(&b->vertex[c[k]], &zero), solid_sub(&b->vertex[c[k + 1]], &zero));
        sum = wide_add(sum, solid_dot(&n, solid_sub(&b->vertex[c[0]], &zero)));
    }
    return sum;
}

/* Adds up volumes in the memory of the edges' hash table, which is not needed any more. */
static void turn_outward(solid_build_t *b) {
    solid_t *s = b->s;
    wide_t *sum = (wide_t *)(void *)b->slot;
    size_t room = b->slots * sizeof *b->slot / sizeof *sum;
    for (int32_t from = 0; from < s->no; from += (int32_t)room) {
        int32_t to = s->no - from < (int32_t)room ? s->no : from + (int32_t)room;
        memset(sum, 0, (size_t)(to - from) * sizeof *sum);
        for (int32_t f = 0; f < s->nf; f++) {
            int32_t o = b->face[f].object;
            if (o >= from && o < to) sum[o - from] = wide_add(sum[o - from], volume(b, f));
        }
        for (int32_t o = from; o < to; o++) {
            int sign = wide_sign(sum[o - from]);
            if (sign == 0) b->object[o].kind = SOLID_OPEN;
            b->object[o].faces = sign < 0 ? -b->object[o].faces : b->object[o].faces; /* negative: inside out */
        }
    }
    for (int32_t e = 0; e < s->ne; e++) {
        solid_edge_t *edge = &b->edge[e];
        if (edge->face[0] < 0 && edge->face[1] < 0) continue;
        if (b->object[b->face[edge->face[edge->face[0] < 0]].object].faces > 0) continue;
        int32_t swap = edge->face[0];
        edge->face[0] = edge->face[1];
        edge->face[1] = swap;
    }
    for (int32_t f = 0; f < s->nf; f++)
        if (b->object[b->face[f].object].faces < 0) reverse(b, f);
    for (int32_t o = 0; o < s->no; o++)
        if (b->object[o].faces < 0) b->object[o].faces = -b->object[o].faces;
}

void solid_join(solid_build_t *b) {
    solid_t *s = b->s;
    if (b->full) return;
    chain_segments(b);
    const int32_t segments = s->ne;
    chain_corners(b);
    if (CONFIG_DOUBLES && !b->full && is_crowded(b) && solid_drop_doubles(b)) {
        s->ne = segments;
        chain_segments(b);
        chain_corners(b);
    }
    if (b->full) return;
    unite_all(b);
    number_objects(b);
    memset(b->group, 0xff, (size_t)s->no * sizeof *b->group);
    int32_t pairs = s->ne;
    for (int32_t e = 0; e < pairs; e++) spread_corners(b, e);
    if (b->full) return;
    for (int32_t f = 0; f < s->nf; f++)
        if (b->parent[f]) reverse(b, f);
    turn_outward(b);
    for (int32_t o = 0; o < s->no; o++)
        b->object[o].kind = b->object[o].kind == SOLID_CLOSED ? SOLID_CONVEX : SOLID_OPEN;
    solid_find_convex(b);
}
