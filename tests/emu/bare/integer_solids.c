/* integer_solids.c - see integer_solids.h. Coordinates are 64ths. */
#include "tests/emu/bare/integer_solids.h"

#include "tests/emu/bare/integer_scene.h"

#define UNIT 64

typedef struct at {
    int32_t x, y, z;
} at_t;

static int32_t within(uint64_t *rng, int32_t lo, int32_t hi) {
    return lo + (int32_t)integer_below(rng, (uint32_t)(hi - lo + 1));
}

static at_t somewhere(uint64_t *rng, int32_t most) {
    at_t a;
    a.x = within(rng, -most, most); /* one call a statement: the order is each compiler's own */
    a.y = within(rng, -most, most);
    a.z = within(rng, -most, most);
    return a;
}

static at_t sum(at_t a, at_t b) {
    return (at_t){a.x + b.x, a.y + b.y, a.z + b.z};
}

static int32_t put(integer_solids_t *s, at_t a) {
    const int32_t at[3] = {a.x, a.y, a.z};
    for (int k = 0; k < 3; k++) s->vertex[s->mesh.nv][k] = packed_from_num(num_from_fixed(at[k], 6));
    return s->mesh.nv++;
}

static void element(integer_solids_t *s, enum mesh_kind kind, const int32_t *v, int32_t n, bool turned) {
    int32_t *w = s->word + INTEGER_SOLIDS_WORDS - s->mesh.words;
    *--w = n << 2 | (int32_t)kind;
    for (int32_t k = 0; k < n; k++) *--w = v[turned ? n - 1 - k : k];
    s->mesh.words += n + 1;
    if (kind == MESH_FACE) s->mesh.faces++, s->mesh.corners += n;
    if (kind == MESH_LINE) s->mesh.segments += n - 1;
}

/* A prism over n places, along `up`; missing: this face is left out. */
static void prism(integer_solids_t *s, const at_t *base, int32_t n, at_t up, int32_t missing, bool turned) {
    int32_t low[6], high[6], cap[6];
    for (int32_t k = 0; k < n; k++) low[k] = put(s, base[k]);
    for (int32_t k = 0; k < n; k++) high[k] = put(s, sum(base[k], up));
    for (int32_t k = 0; k < n; k++) cap[k] = low[n - 1 - k];
    if (missing != 0) element(s, MESH_FACE, cap, n, turned);
    if (missing != 1) element(s, MESH_FACE, high, n, false);
    for (int32_t k = 0; k < n; k++) {
        const int32_t next = (k + 1) % n, side[4] = {low[k], low[next], high[next], high[k]};
        if (missing != 2 + k) element(s, MESH_FACE, side, 4, false);
    }
}

static void box(integer_solids_t *s, at_t at, at_t a, at_t b, at_t up, int32_t missing) {
    const at_t base[4] = {at, sum(at, a), sum(sum(at, a), b), sum(at, b)};
    prism(s, base, 4, up, missing, false);
}

static void tetrahedron(integer_solids_t *s, at_t at, uint64_t *rng, bool turned) {
    static const uint8_t side[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    int32_t v[4], w[3];
    for (int k = 0; k < 4; k++) {
        const at_t off = somewhere(rng, 3 * UNIT / 2);
        v[k] = put(s, sum(at, off));
    }
    for (int f = 0; f < 4; f++) {
        for (int k = 0; k < 3; k++) w[k] = v[side[f][k]];
        element(s, MESH_FACE, w, 3, turned && (f & 1));
    }
}

static void bend(integer_solids_t *s, at_t at, int32_t size, int32_t height, bool turned) {
    static const uint8_t place[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    at_t base[6];
    for (int k = 0; k < 6; k++) base[k] = sum(at, (at_t){size * place[k][0], size * place[k][1], 0});
    prism(s, base, 6, (at_t){0, 0, height}, -1, turned);
}

static void sheet(integer_solids_t *s, at_t at, uint64_t *rng) {
    int32_t v[9];
    for (int k = 0; k < 9; k++) {
        const int32_t up = within(rng, -UNIT / 2, UNIT / 2);
        v[k] = put(s, sum(at, (at_t){UNIT * (k % 3), UNIT * (k / 3), up}));
    }
    for (int k = 0; k < 4; k++) {
        const int32_t *p = v + k / 2 * 3 + k % 2, a[3] = {p[0], p[1], p[4]}, b[3] = {p[0], p[4], p[3]};
        element(s, MESH_FACE, a, 3, k & 1);
        element(s, MESH_FACE, b, 3, false);
    }
}

static void object(integer_solids_t *s, bool lattice, uint64_t *rng) {
    at_t at = somewhere(rng, 3 * UNIT);
    const int32_t kind = within(rng, 0, 7), size = within(rng, UNIT / 3, UNIT), many = within(rng, -1, 5);
    if (lattice) { /* boxes that touch in faces, edges and corners */
        const int32_t a = within(rng, 1, 2), b = within(rng, 1, 2), c = within(rng, 1, 2);
        at = (at_t){at.x / UNIT * UNIT, at.y / UNIT * UNIT, at.z / UNIT * UNIT};
        box(s, at, (at_t){a * UNIT, 0, 0}, (at_t){0, b * UNIT, 0}, (at_t){0, 0, c * UNIT}, -1);
        return;
    }
    if (kind <= 2) {
        const at_t a = somewhere(rng, UNIT), b = somewhere(rng, UNIT), up = somewhere(rng, UNIT);
        box(s, at, a, b, up, kind == 2 ? many : -1);
    } else if (kind == 3) {
        tetrahedron(s, at, rng, many > 2);
    } else if (kind == 4 || kind == 5) {
        bend(s, at, size, within(rng, UNIT / 4, 2 * UNIT), many > 3);
    } else if (kind == 6) {
        sheet(s, at, rng);
    } else {
        int32_t v[6];
        for (int k = 0; k < 6; k++) {
            const at_t place = somewhere(rng, 3 * UNIT);
            v[k] = put(s, place);
        }
        element(s, MESH_LINE, v, many < 3 ? 6 : 3, false);
        if (many >= 3) element(s, MESH_LINE, v + 3, 3, false);
    }
}

static void put_eye(integer_solids_t *s, bool lattice, uint64_t *rng) {
    const int32_t kind = within(rng, 0, 5), far = within(rng, 1, 3);
    at_t at = somewhere(rng, 6 * UNIT);
    s->set.view.from = kind < 3;
    if (kind == 1 && lattice) at = (at_t){at.x / UNIT * UNIT, at.y / UNIT * UNIT, at.z / UNIT * UNIT};
    if (kind == 2) at = (at_t){at.x << 3 * far, at.y << 3 * far, at.z << 3 * far};
    const int32_t eye[3] = {at.x, at.y, at.z};
    for (int k = 0; k < 3; k++) s->set.view.eye[k] = num_from_fixed(eye[k], 6);
    s->set.view.rot_x = num_from_i64(kind == 3 ? 90 * within(rng, 0, 2) : within(rng, 0, 180));
    s->set.view.rot_z = num_from_i64(kind <= 4 ? 45 * within(rng, 0, 7) : within(rng, 0, 360));
}

void integer_solids_random(integer_solids_t *s, uint64_t seed, uint32_t drop) {
    uint64_t rng = seed ^ 0x50119u;
    s->mesh = (mesh_t){.top = s->word + INTEGER_SOLIDS_WORDS};
    settings_default(&s->set);
    const bool lattice = integer_below(&rng, 3) == 0;
    const int32_t n = within(&rng, 1, INTEGER_SOLIDS_OBJECTS);
    for (int32_t k = 0; k < n; k++) {
        uint64_t own = integer_next(&rng); /* the others do not depend on what is left out */
        if (!(drop >> k & 1)) object(s, lattice && integer_below(&own, 6), &own);
    }
    put_eye(s, lattice, &rng);
    s->mesh.vertex = (const packed_t(*)[3])s->vertex;
}
