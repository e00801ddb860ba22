/* solid.c - see solid.h: from meshes to vertices, faces and free segments on the lattice; solid_join.c goes on. */
#include "scene/solid.h"

#include "config.h"
#include "error.h"
#include "scene/solid_build.h"
#include <string.h>

/* Lent memory: what stays is taken from its lower end, what does not from its upper. */
typedef struct lent {
    uint8_t *low, *high;
    bool full;
} lent_t;

static size_t whole(int64_t n, size_t size) {
    return ((size_t)n * size + 7) & ~(size_t)7;
}

static void *take(lent_t *m, int64_t n, size_t size, bool keep) {
    const size_t bytes = whole(n, size);
    if (m->full || bytes > (size_t)(m->high - m->low)) {
        m->full = true;
        return NULL;
    }
    if (!keep) return m->high -= bytes;
    void *at = m->low;
    m->low += bytes;
    return at;
}

typedef struct totals {
    int32_t vertices, vertices_most, faces, corners, segments, details; /* vertices_most: of one mesh */
} totals_t;

static totals_t total(const mesh_t *const *mesh, int32_t n) {
    totals_t t = {0};
    for (int32_t k = 0; k < n; k++) {
        t.vertices += mesh[k]->nv;
        if (mesh[k]->nv > t.vertices_most) t.vertices_most = mesh[k]->nv;
        t.faces += mesh[k]->faces;
        t.corners += mesh[k]->corners;
        t.segments += mesh[k]->segments;
        t.details += mesh[k]->details;
    }
    return t;
}

/* Slots of a hash table for so many things. */
static uint32_t slots_for(int32_t n) {
    uint32_t slots = 32; /* at least one object's sums in solid_join.c and solid_convex.c */
    while (slots / 3 * 2 <= (uint32_t)n) slots *= 2;
    return slots;
}

/* Edges there is room for beside a table of so many slots, which finds them. */
static int32_t edges_room(size_t left, uint32_t slots, int64_t edges) {
    const size_t table = slots * sizeof(int32_t), found = slots / 8 * 7;
    size_t room = left > table ? (left - table) / sizeof(solid_edge_t) : 0;
    if (room > found) room = found;
    return room < (size_t)edges ? (int32_t)room : (int32_t)edges;
}

size_t solid_bytes(const mesh_t *const *mesh, int32_t n) {
    totals_t t = total(mesh, n);
    size_t edges = (size_t)t.corners + (size_t)t.segments, details = (size_t)t.details;
    size_t slots = slots_for(t.vertices > (int32_t)edges ? t.vertices : (int32_t)edges);
    return (size_t)t.vertices * sizeof(solid_vertex_t) + (edges + 2 * details) * sizeof(solid_edge_t) +
           (size_t)t.faces * (sizeof(solid_face_t) + sizeof(solid_object_t) + 8) + (size_t)t.corners * 12 +
           (size_t)t.vertices_most * 4 + slots * 4 + 16 * 8;
}

size_t solid_bytes_least(const mesh_t *const *mesh, int32_t n) {
    const totals_t t = total(mesh, n);
    const int32_t edges = t.corners / 2 + t.segments + t.details;
    uint32_t slots = slots_for(t.vertices);
    while (slots / 8 * 7 < (uint32_t)edges) slots *= 2;
    return whole(t.vertices, sizeof(solid_vertex_t)) + 3 * whole(t.corners, 4) + whole(t.faces, sizeof(solid_face_t)) +
           whole(t.faces, sizeof(solid_object_t)) + 2 * whole(t.faces, 4) + whole(t.vertices_most, 4) +
           whole(t.details, sizeof(solid_edge_t)) + slots * 4 + (size_t)edges * sizeof(solid_edge_t);
}

/* Packed numbers as integers in the same order: the bits of a negative one count down. */
static uint64_t key_of(packed_t p) {
    return p >> 63 ? ~p : p | (uint64_t)1 << 63;
}
static num_t number_of(uint64_t key) {
    return packed_num(key >> 63 ? key & ~((uint64_t)1 << 63) : ~key);
}

/* The box of all vertices that something refers to. */
static bool measure(solid_t *s, const mesh_t *const *mesh, int32_t n) {
    uint64_t lo[3] = {UINT64_MAX, UINT64_MAX, UINT64_MAX}, hi[3] = {0, 0, 0};
    for (int32_t k = 0; k < n; k++) {
        mesh_walk_t w = mesh_walk(mesh[k]);
        while (mesh_next(&w)) {
            if (w.kind == MESH_OBJECT) continue;
            if (CONFIG_AREA && w.kind == MESH_DETAIL) mesh_tone(&w);
            for (int32_t c = 0; c < w.count; c++) {
                const packed_t *v = mesh[k]->vertex[mesh_at(&w, c)];
                for (int axis = 0; axis < 3; axis++) {
                    uint64_t key = key_of(v[axis]);
                    if (key < lo[axis]) lo[axis] = key;
                    if (key > hi[axis]) hi[axis] = key;
                }
            }
        }
    }
    for (int axis = 0; axis < 3 && lo[0] <= hi[0]; axis++) {
        s->lo[axis] = number_of(lo[axis]);
        s->hi[axis] = number_of(hi[axis]);
    }
    return lo[0] <= hi[0];
}

#define FAR_BITS 48 /* a scene may be so many times its size off the origin: its numbers hold no more than 53 bits */

/* Half of the longest side becomes at most 2^(SOLID_BITS - 1), and more than half of that. */
static int choose_scale(solid_t *s) {
    int32_t bits = INT32_MIN;
    for (int axis = 0; axis < 3; axis++) {
        num_t half = num_ldexp(num_sub(s->hi[axis], s->lo[axis]), -1);
        if (half.undef) return ERR_VALUE;
        s->origin[axis] = num_ldexp(num_add(s->lo[axis], s->hi[axis]), -1);
        if (half.m != 0 && half.e + 63 > bits) bits = half.e + 63; /* half < 2^(e + 63) */
    }
    for (int axis = 0; axis < 3 && bits > INT32_MIN; axis++)
        if (s->origin[axis].m != 0 && s->origin[axis].e + 63 > bits + FAR_BITS) return ERR_VALUE;
    s->shift = bits == INT32_MIN ? 0 : SOLID_BITS - 1 - bits;
    /* A needle seen from its end may fill the page, and the rounding of its vertices must not take them off it. */
    const num_t thin = num_ldexp(num_from_i64(1), 21 - s->shift), rounding = num_ldexp(num_from_i64(1), -1 - s->shift);
    for (int axis = 0; axis < 3; axis++) {
        num_t *lo = &s->lo[axis], *hi = &s->hi[axis], span = num_sub(*hi, *lo);
        if (num_sign(span) <= 0 || num_cmp(span, thin) >= 0) continue;
        *lo = num_sub(*lo, rounding);
        *hi = num_add(*hi, rounding);
    }
    return 0;
}

static uint32_t hash(uint32_t a, uint32_t b, uint32_t c) {
    uint32_t h = a * 0x9e3779b1u ^ (b * 0x85ebca6bu + 0x27d4eb2fu) ^ c * 0xc2b2ae35u;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    return h ^ h >> 13;
}

/* The number of the vertex at this place, which may be a new one. */
static int32_t place_vertex(solid_build_t *b, const solid_vertex_t *v) {
    uint32_t at = hash((uint32_t)v->at[0], (uint32_t)v->at[1], (uint32_t)v->at[2]);
    for (;; at++) {
        int32_t *slot = &b->slot[at & (b->slots - 1)];
        if (*slot < 0) {
            b->vertex[b->s->nv] = *v;
            *slot = b->s->nv++;
        }
        if (memcmp(&b->vertex[*slot], v, sizeof *v) == 0) return *slot;
    }
}

/* A packed number times 2^bits, to nearest, for |it| < 2^62. */
static int64_t fixed_of(packed_t p, int32_t bits) {
    const int32_t exponent = (int32_t)(p >> 52) & 2047, shift = exponent - 1075 + bits;
    if (exponent == 0 || shift < -54) return 0;
    int64_t m = (int64_t)((p & (((uint64_t)1 << 52) - 1)) | (uint64_t)1 << 52);
    m = shift >= 0 ? m * ((int64_t)1 << shift) : (m + ((int64_t)1 << (-shift - 1))) >> -shift;
    return p >> 63 ? -m : m;
}

/* Vertices go to the lattice through integers with SPARE_BITS more, where they fit. */
#define SPARE_BITS 20
#define SPARE_LEAST 4

static void choose_bits(solid_build_t *b) {
    const solid_t *s = b->s;
    int32_t most = INT16_MIN; /* all coordinates below 2^most */
    for (int axis = 0; axis < 3; axis++) {
        if (s->lo[axis].m != 0 && s->lo[axis].e + 63 > most) most = s->lo[axis].e + 63;
        if (s->hi[axis].m != 0 && s->hi[axis].e + 63 > most) most = s->hi[axis].e + 63;
    }
    b->bits = s->shift + SPARE_BITS;
    if (most > INT16_MIN && b->bits > 61 - most) b->bits = 61 - most;
    for (int axis = 0; axis < 3; axis++) b->origin[axis] = num_to_fixed(s->origin[axis], b->bits, NULL);
}

static int32_t coordinate(const solid_build_t *b, packed_t p, int axis) {
    const int32_t spare = b->bits - b->s->shift;
    if (spare < SPARE_LEAST)
        return (int32_t)num_to_fixed(num_sub(packed_num(p), b->s->origin[axis]), b->s->shift, NULL);
    int64_t d = fixed_of(p, b->bits) - b->origin[axis], half = (int64_t)1 << (spare - 1);
    return (int32_t)(d < 0 ? -((half - d) >> spare) : (d + half) >> spare);
}

static int32_t vertex_of(solid_build_t *b, const mesh_t *m, int32_t v) {
    if (b->map[v] < 0) {
        solid_vertex_t at;
        for (int axis = 0; axis < 3; axis++) at.at[axis] = coordinate(b, m->vertex[v][axis], axis);
        b->map[v] = place_vertex(b, &at);
    }
    return b->map[v];
}

static void add_face(solid_build_t *b, const mesh_t *m, const mesh_walk_t *w, int32_t group, bool clear) {
    solid_t *s = b->s;
    int32_t *c = b->corner + s->nc, n = 0;
    for (int32_t k = 0; k < w->count; k++) {
        int32_t v = vertex_of(b, m, mesh_at(w, k));
        if (n == 0 || c[n - 1] != v) c[n++] = v;
    }
    while (n > 1 && c[n - 1] == c[0]) n--;
    if (n < 3) return;
    /* solid_join.c moves what stands for the object. */
    b->face[s->nf] = (solid_face_t){.corner = s->nc, .n = n & INT32_MAX >> 1, .clear = clear, .object = m->smooth_q30};
    for (int32_t k = 0; k < n; k++) b->corner_face[s->nc + k] = s->nf;
    b->group[s->nf] = group;
    s->nc += n;
    s->nf++;
}

static void add_line(solid_build_t *b, const mesh_t *m, const mesh_walk_t *w) {
    for (int32_t k = 0; k + 1 < w->count; k++) {
        int32_t p = vertex_of(b, m, mesh_at(w, k)), q = vertex_of(b, m, mesh_at(w, k + 1));
        if (p != q) solid_new_edge(b, p, q);
    }
}

/* Kept until all edges are there. face: -1 if that had no area. */
static void add_detail(solid_build_t *b, const mesh_t *m, mesh_walk_t w, int32_t face) {
    const int32_t word = CONFIG_AREA ? ~mesh_tone(&w) : MESH_PLAIN << 1, percent = word >> 1;
    bool contour = true;
    if (word & 1) b->new_polygon = true;
    for (int32_t k = 0; k + 1 < w.count && face >= 0; k++) {
        const int32_t p = vertex_of(b, m, mesh_at(&w, k)), q = vertex_of(b, m, mesh_at(&w, k + 1));
        if (p == q) continue;
        const int32_t tone = percent << 3 | b->new_polygon << 2 | contour << 1 | (p > q);
        b->detail[b->s->nd++] =
            (solid_edge_t){{p < q ? p : q, p < q ? q : p}, {face, percent == MESH_PLAIN ? face : ~tone}, -1, -1};
        b->new_polygon = contour = false;
    }
}

static void place_details(solid_build_t *b) {
    solid_t *s = b->s;
    for (int32_t k = 0; k < s->nd; k++) {
        b->edge[s->ne + k] = b->detail[k];
        b->edge[s->ne + k].first = s->ne + k;
    }
}

void solid_free_details(solid_t *s) {
    solid_edge_t *edge = (solid_edge_t *)(uintptr_t)s->edge;
    for (int32_t k = s->ne; k < s->ne + s->nd; k++) edge[k].face[0] = edge[k].face[1] = -1;
    s->ne += s->nd;
    s->nd = 0;
}

static void fill(solid_build_t *b, const mesh_t *const *mesh, int32_t n) {
    int32_t group = 0, face = -1;
    for (int32_t k = 0; k < n; k++, group++) {
        memset(b->map, 0xff, (size_t)mesh[k]->nv * sizeof *b->map);
        mesh_walk_t w = mesh_walk(mesh[k]);
        bool clear = mesh[k]->clear;
        while (mesh_next(&w)) {
            if (w.kind == MESH_OBJECT && w.count) clear = mesh_at(&w, 0) != 0;
            if (w.kind == MESH_OBJECT && !w.count) group++;
            if (w.kind == MESH_FACE) {
                int32_t before = b->s->nf;
                add_face(b, mesh[k], &w, group, clear);
                face = b->s->nf > before ? before : -1;
            }
            if (w.kind == MESH_DETAIL) add_detail(b, mesh[k], w, face);
            if (w.kind == MESH_LINE) add_line(b, mesh[k], &w);
        }
    }
}

int solid_build(solid_t *s, const mesh_t *const *mesh, int32_t n, void *mem, size_t bytes) {
    *s = (solid_t){0};
    if (!measure(s, mesh, n)) return ERR_EMPTY;
    int err = choose_scale(s);
    if (err) return err;
    totals_t t = total(mesh, n);
    int64_t edges = (int64_t)t.corners + t.segments + t.details;
    if (edges > INT32_MAX / 4) return ERR_FULL;
    lent_t m = {mem, (uint8_t *)mem + (bytes & ~(size_t)7), mem == NULL};
    solid_build_t b = {.s = s};
    b.vertex = take(&m, t.vertices, sizeof *b.vertex, true);
    b.corner = take(&m, t.corners, sizeof *b.corner, true);
    b.face = take(&m, t.faces, sizeof *b.face, true);
    b.object = take(&m, t.faces, sizeof *b.object, false); /* mostly far fewer, and moved behind the edges */
    b.detail = take(&m, t.details, sizeof *b.detail, false);
    b.map = take(&m, t.vertices_most, sizeof *b.map, false);
    b.corner_face = take(&m, t.corners, sizeof *b.corner_face, false);
    b.corner_next = take(&m, t.corners, sizeof *b.corner_next, false);
    b.parent = take(&m, t.faces, sizeof *b.parent, false);
    b.group = take(&m, t.faces, sizeof *b.group, false);
    if (m.full) return ERR_FULL;
    /* The rest is for edges and their hash table. Most edges have two faces: when memory is short that is what there is
     * room for. */
    const size_t left = (size_t)(m.high - m.low);
    b.slots = slots_for(t.vertices > edges ? t.vertices : (int32_t)edges);
    while (b.slots > slots_for(t.vertices) && edges_room(left, b.slots / 2, edges) > edges_room(left, b.slots, edges))
        b.slots /= 2;
    b.slot = take(&m, b.slots, sizeof *b.slot, false);
    if (m.full) return ERR_FULL;
    b.edge = (solid_edge_t *)(void *)m.low;
    b.edges_max = edges_room(left, b.slots, edges);
    s->vertex = b.vertex;
    s->corner = b.corner;
    s->face = b.face;
    s->object = b.object;
    s->edge = b.edge;
    memset(b.slot, 0xff, b.slots * sizeof *b.slot);
    choose_bits(&b);
    fill(&b, mesh, n);
    solid_join(&b);
    if (b.full || s->ne > b.edges_max - s->nd) return ERR_FULL;
    place_details(&b);
    s->object = memmove(b.edge + s->ne + s->nd, b.object, (size_t)s->no * sizeof *b.object);
    s->bytes = (size_t)((const uint8_t *)(s->object + s->no) - (uint8_t *)mem);
    return s->ne == 0 ? ERR_EMPTY : 0;
}
