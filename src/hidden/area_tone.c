/* area_tone.c - see area_tone.h. */
#include "hidden/area_tone.h"

#include "error.h"
#include "hidden/area_face.h"
#include "num/ints.h"
#include "scene/solid_math.h"
#include <string.h>

#define LIGHT_PAGE_LAT ((int64_t)100 * LAT_PER_MM) /* the scene seen from the light reaches so far from the origin */

/* Of the toner's memory, in sixteenths: the lit polygons, those of one face moved, results, the clipper. */
#define LEAST_BYTES 1024
enum { LIT_SHARE = 6, MOVED_SHARE = 2, RESULT_SHARE = 3 };

struct area_toner {
    area_tone_t tone;
    const solid_map_t *m;
    area_lattice_t eye_lattice, light_lattice;
    camera_t light_camera;
    solid_map_t light;
    num_t unit[3]; /* to the light, in the scene's coordinates */
    /* Lit polygons: blocks of words, a list for each face: next, contours, vertices, ends, places. */
    int32_t *head, *word;
    int32_t words, words_max;
    poly_vertex_t *moved;
    int32_t *moved_end;
    int32_t moved_max;
    poly_vertex_t *result;
    int32_t *result_end;
    int32_t result_max;
    void *clip_mem;
    size_t clip_bytes;
};

enum { NEXT, CONTOURS, VERTICES, HEAD };

static int take_lit(void *ctx, int32_t face, const poly_t *p) {
    area_toner_t *t = ctx;
    int32_t n = poly_vertices(p), size = HEAD + p->contours + 2 * n;
    if (size > t->words_max - t->words) return ERR_FULL;
    int32_t *block = t->word + t->words, *w = block + HEAD;
    block[NEXT] = t->head[face];
    block[CONTOURS] = p->contours;
    block[VERTICES] = n;
    for (int32_t k = 0; k < p->contours; k++) *w++ = p->end[k];
    for (int32_t k = 0; k < n; k++) {
        *w++ = p->v[k].at.x;
        *w++ = p->v[k].at.y;
    }
    t->head[face] = t->words;
    t->words += size;
    return 0;
}

static int no_wire(void *ctx, int32_t edge, int32_t from_q30, int32_t to_q30) {
    (void)ctx, (void)edge, (void)from_q30, (void)to_q30;
    return 0;
}

/* ---- the view from the light ---- */

static num_t dot(const num_t a[3], const num_t b[3]) {
    return num_add(num_add(num_mul(a[0], b[0]), num_mul(a[1], b[1])), num_mul(a[2], b[2]));
}

static bool unit_of(const num_t a[3], num_t out[3]) {
    num_t length = num_sqrt(dot(a, a));
    if (length.undef || num_sign(length) == 0) return false;
    for (int k = 0; k < 3; k++) out[k] = num_div(a[k], length);
    return true;
}

static void cross(const num_t a[3], const num_t b[3], num_t out[3]) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = num_sub(num_mul(a[i], b[j]), num_mul(a[j], b[i]));
    }
}

/* A parallel view along the light, the middle of the scene at the origin. */
static int look_from_light(area_toner_t *t, void *place) {
    const solid_t *s = t->m->solid;
    camera_t *cam = &t->light_camera;
    const num_t zero = num_from_i64(0), one = num_from_i64(1);
    num_t up[3] = {zero, zero, one}, across[3], middle[3], half[3];
    if (!unit_of(t->tone.light, t->unit)) return ERR_VALUE;
    cross(up, t->unit, across);
    if (!unit_of(across, across)) { /* straight from above or below */
        across[0] = one;
        across[1] = across[2] = zero;
    }
    cross(t->unit, across, up);
    for (int k = 0; k < 3; k++) {
        middle[k] = num_ldexp(num_add(s->lo[k], s->hi[k]), -1);
        half[k] = num_ldexp(num_sub(s->hi[k], s->lo[k]), -1);
    }
    num_t radius = num_sqrt(dot(half, half));
    if (radius.undef || num_sign(radius) == 0) return ERR_VALUE;
    num_t scale = num_div(num_from_i64(LIGHT_PAGE_LAT), radius);
    *cam = (camera_t){.perspective = false};
    for (int k = 0; k < 3; k++) {
        cam->m[0][k] = num_mul(across[k], scale);
        cam->m[1][k] = num_mul(up[k], scale);
        cam->m[2][k] = zero;
        cam->eye[k] = t->unit[k];
    }
    cam->m[0][3] = num_neg(dot(cam->m[0], middle));
    cam->m[1][3] = num_neg(dot(cam->m[1], middle));
    cam->m[2][3] = one;
    const int32_t far = (int32_t)LIGHT_PAGE_LAT + 16;
    cam->window = (page_window_t){-far, -far, far, far};
    return solid_map_setup(&t->light, s, cam, place);
}

/* ---- memory ---- */

static size_t eights(size_t bytes) {
    return (bytes + 7) & ~(size_t)7;
}

static int lay_out(area_toner_t *t, uint8_t *at, size_t left, void **place) {
    const solid_t *s = t->m->solid;
    size_t heads = eights((size_t)s->nf * sizeof(int32_t)), fixed = heads + eights(SOLID_MAP_BYTES(s->nv));
    if (left < fixed + LEAST_BYTES) return ERR_FULL;
    t->head = (int32_t *)(void *)at;
    *place = at + heads;
    at += fixed;
    left -= fixed;
    size_t part = left / 16 & ~(size_t)7, each = sizeof(poly_vertex_t) + sizeof(int32_t);
    t->word = (int32_t *)(void *)at;
    t->words_max = (int32_t)(part * LIT_SHARE / sizeof(int32_t));
    at += part * LIT_SHARE;
    t->moved = (poly_vertex_t *)(void *)at;
    t->moved_max = (int32_t)(part * MOVED_SHARE / each);
    t->moved_end = (int32_t *)(void *)(t->moved + t->moved_max);
    at += part * MOVED_SHARE;
    t->result = (poly_vertex_t *)(void *)at;
    t->result_max = (int32_t)(part * RESULT_SHARE / each);
    t->result_end = (int32_t *)(void *)(t->result + t->result_max);
    at += part * RESULT_SHARE;
    t->clip_mem = at;
    t->clip_bytes = part * (16 - LIT_SHARE - MOVED_SHARE - RESULT_SHARE);
    return 0;
}

size_t area_toner_bytes(const solid_map_t *m) {
    return eights(sizeof(area_toner_t)) + eights((size_t)m->solid->nf * sizeof(int32_t)) +
           eights(SOLID_MAP_BYTES(m->solid->nv)) + LEAST_BYTES;
}

int area_toner_make(area_toner_t **toner, const area_tone_t *tone, const solid_map_t *m, void *mem, size_t bytes,
                    void *sort_mem, size_t sort_bytes) {
    area_toner_t *t = mem;
    size_t own = eights(sizeof *t);
    if (bytes < own) return ERR_FULL;
    memset(t, 0, sizeof *t);
    *toner = t;
    t->tone = *tone;
    t->m = m;
    t->eye_lattice = area_lattice(m);
    void *place;
    int err = lay_out(t, (uint8_t *)mem + own, bytes - own, &place);
    if (!err) err = look_from_light(t, place);
    if (err) return err;
    t->light_lattice = area_lattice(&t->light);
    for (int32_t k = 0; k < m->solid->nf; k++) t->head[k] = -1;
    if (!tone->shadow) return 0;
    const area_sink_t sink = {t, take_lit, no_wire};
    area_stats_t stats;
    return area_sort(&t->light, sort_mem, sort_bytes, &sink, NULL, NULL, &stats);
}

/* ---- tones ---- */

/* The cosine between the side of the face that the eye sees and the light, q30; negative where it looks away. */
static int64_t slope_to_light(const area_toner_t *t, int32_t face) {
    solid_normal_t n = solid_face_normal(t->m->solid, face);
    num_t normal[3];
    for (int k = 0; k < 3; k++) normal[k] = num_from_i64(n.n[k]);
    if (!unit_of(normal, normal)) return 0;
    int64_t q30 = num_to_fixed(dot(normal, t->unit), 30, NULL);
    return area_looks_at_eye(t->m, face) ? q30 : -q30;
}

static enum hatch_tone tone_of(int64_t slope_q30) {
    const int64_t tenth = INK_ONE / 10;
    return slope_q30 >= 8 * tenth   ? HATCH_NONE
           : slope_q30 >= 5 * tenth ? HATCH_LIGHT
           : slope_q30 >= 2 * tenth ? HATCH_MIDDLE
                                    : HATCH_DARK;
}

/* ---- from the light's view to the eye's ---- */

typedef struct mover {
    poly_point_t a, b, c; /* corners as the light sees them */
    page_h_t ha, hb, hc;  /* and as the eye does */
    int64_t whole;
} mover_t;

/* The three corners that span the face widest, seen from the light. False if it sees the face edge-on. */
static bool find_corners(const area_toner_t *t, int32_t face, mover_t *mv) {
    const solid_t *s = t->m->solid;
    const solid_face_t *f = &s->face[face];
    const int32_t *corner = s->corner + f->corner;
    int64_t z;
    int32_t b = 0, c = 0;
    uint64_t far = 0, wide = 0;
    mv->a = mv->b = mv->c = area_vertex(&t->light_lattice, corner[0], &z);
    for (int32_t k = 1; k < f->n; k++) {
        poly_point_t p = area_vertex(&t->light_lattice, corner[k], &z);
        int64_t dx = p.x - mv->a.x, dy = p.y - mv->a.y;
        uint64_t d = (uint64_t)(dx * dx + dy * dy);
        if (d > far) far = d, b = k, mv->b = p;
    }
    if (far == 0) return false;
    for (int32_t k = 1; k < f->n; k++) {
        poly_point_t p = area_vertex(&t->light_lattice, corner[k], &z);
        uint64_t d = ints_abs64(poly_orient(mv->a, mv->b, p));
        if (d > wide) wide = d, c = k, mv->c = p;
    }
    mv->whole = poly_orient(mv->a, mv->b, mv->c);
    if (mv->whole == 0) return false;
    mv->ha = solid_map_vertex(t->m, corner[0]);
    mv->hb = solid_map_vertex(t->m, corner[b]);
    mv->hc = solid_map_vertex(t->m, corner[c]);
    return true;
}

static int64_t mix(int64_t a, int64_t b, int64_t c, int64_t to_b, int64_t to_c, int64_t whole) {
    return a + ints_muldiv_round(to_b, b - a, whole) + ints_muldiv_round(to_c, c - a, whole);
}

static int32_t limited(int64_t a) {
    return (int32_t)(a < -POLY_LIMIT ? -POLY_LIMIT : a > POLY_LIMIT ? POLY_LIMIT : a);
}

static poly_point_t move(const area_toner_t *t, const mover_t *mv, poly_point_t p) {
    int64_t to_b = poly_orient(mv->a, p, mv->c), to_c = poly_orient(mv->a, mv->b, p), one = (int64_t)1;
    int64_t x = mix(mv->ha.x, mv->hb.x, mv->hc.x, to_b, to_c, mv->whole);
    int64_t y = mix(mv->ha.y, mv->hb.y, mv->hc.y, to_b, to_c, mv->whole);
    int64_t e = one << t->m->lines.frac_bits;
    if (t->m->lines.perspective) e = mix(mv->ha.e, mv->hb.e, mv->hc.e, to_b, to_c, mv->whole);
    if (e < 1) e = 1;
    return (poly_point_t){limited(ints_muldiv_round(x, one << t->eye_lattice.bits, e)),
                          limited(ints_muldiv_round(y, one << t->eye_lattice.bits, e))};
}

/* All that is lit of the face, as the eye sees it. */
static int move_lit(area_toner_t *t, int32_t face, poly_t *out) {
    mover_t mv;
    int32_t n = 0, contours = 0;
    *out = (poly_t){t->moved, t->moved_end, 0};
    if (t->head[face] < 0 || !find_corners(t, face, &mv)) return 0;
    for (int32_t at = t->head[face]; at >= 0; at = t->word[at + NEXT]) {
        const int32_t *block = t->word + at, *end = block + HEAD, *w = end + block[CONTOURS];
        if (n + block[VERTICES] > t->moved_max) return ERR_FULL;
        for (int32_t k = 0; k < block[CONTOURS]; k++) t->moved_end[contours++] = n + end[k];
        for (int32_t k = 0; k < block[VERTICES]; k++)
            t->moved[n++] = (poly_vertex_t){move(t, &mv, (poly_point_t){w[2 * k], w[2 * k + 1]}), POLY_CUT};
    }
    out->contours = contours;
    return 0;
}

static int hatch_result(area_toner_t *t, clip_t *clip, int which, enum hatch_tone tone, int32_t first,
                        intervals_t *to) {
    clip_out_t out = {.v = t->result, .end = t->result_end, .n_max = t->result_max, .contours_max = t->result_max};
    int err = clip_trace(clip, which, &out);
    const poly_t p = {out.v, out.end, out.contours};
    return err ? err : hatch_polygon(t->tone.hatch, &p, tone, first, to);
}

int area_toner_polygon(area_toner_t *t, int32_t face, const poly_t *p, int32_t first_line, intervals_t *to) {
    int64_t slope = slope_to_light(t, face);
    t->tone.hatch->bits = t->eye_lattice.bits;
    if (!t->tone.shadow || slope <= 0) return hatch_polygon(t->tone.hatch, p, tone_of(slope), first_line, to);
    poly_t lit;
    int err = move_lit(t, face, &lit);
    if (err) return err;
    if (lit.contours == 0) return hatch_polygon(t->tone.hatch, p, HATCH_DARK, first_line, to);
    clip_t clip;
    const clip_job_t job = {*p, lit, CLIP_NONZERO, {CLIP_INSIDE, CLIP_OUTSIDE}};
    err = clip_run(&clip, &job, t->clip_mem, t->clip_bytes);
    if (!err) err = hatch_result(t, &clip, 0, tone_of(slope), first_line, to);
    return err ? err : hatch_result(t, &clip, 1, HATCH_DARK, first_line, to);
}
