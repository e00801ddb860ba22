/* area_light.c - see area_light.h. */
#include "hidden/area/area_light.h"
#include "hidden/area/area_limit.h"
#include "hidden/area/area_mover.h"

#include "error.h"
#include "num/num_vec.h"
#include "scene/solid_math.h"

#if CONFIG_AREA

/* The scene seen from the light reaches so far from the origin: nearly as far as the lattice does at its finest, since
 * what a light that strokes a face makes of a unit is long. */
#define LIGHT_PAGE_LAT ((int64_t)1000 * LAT_PER_MM)
_Static_assert(LIGHT_PAGE_LAT + 16 < POLY_LIMIT >> AREA_LATTICE_BITS, "all of it on the finest lattice");

/* ---- directions ---- */

/* The middle of a face's corners, in the scene's coordinates. */
static void middle_of(const solid_t *s, int32_t face, num_t out[3]) {
    const solid_face_t *f = &s->face[face];
    for (int k = 0; k < 3; k++) {
        int64_t sum = 0;
        for (int32_t i = 0; i < f->n; i++) sum += s->vertex[s->corner[f->corner + i]].at[k];
        num_t at = num_div(num_from_i64(sum), num_from_i64(f->n));
        out[k] = num_add(s->origin[k], num_ldexp(at, -s->shift));
    }
}

int64_t light_slope(const light_t *l, const solid_map_t *m, int32_t face) {
    solid_normal_t n = solid_face_normal(m->solid, face);
    num_t normal[3], to[3];
    if (l->point) middle_of(m->solid, face, to);
    for (int k = 0; k < 3; k++) {
        const num_t unit = m->cam->unit[k]; /* a rotated view may show the axes in other proportions */
        normal[k] = num_div(num_from_i64(n.n[k]), unit);
        to[k] = num_mul(l->point ? num_sub(l->at[k], to[k]) : l->at[k], unit);
    }
    if (!num_vec_unit(normal) || !num_vec_unit(to)) return 0;
    int64_t q30 = num_to_fixed(num_vec_dot(normal, to), 30, NULL);
    return area_looks_at_eye(m, face) ? q30 : -q30;
}

/* ---- the view from a light ---- */

/* The scene's middle at the origin, all of it within LIGHT_PAGE_LAT. */
static int look_from(lit_t *s, const light_t *l, void *place) {
    const solid_t *solid = s->m->solid;
    camera_t *cam = &s->camera;
    const num_t zero = num_from_i64(0), one = num_from_i64(1);
    num_t up[3] = {zero, zero, one}, to[3], across[3], middle[3], half[3];
    for (int k = 0; k < 3; k++) {
        middle[k] = num_ldexp(num_add(solid->lo[k], solid->hi[k]), -1);
        half[k] = num_ldexp(num_sub(solid->hi[k], solid->lo[k]), -1);
        to[k] = l->point ? num_sub(l->at[k], middle[k]) : l->at[k];
    }
    num_t radius2 = num_vec_dot(half, half), away2 = num_vec_dot(to, to), radius = num_sqrt(radius2);
    if (radius.undef || num_sign(radius) == 0 || !num_vec_unit(to)) return ERR_VALUE;
    num_t beyond2 = num_sub(away2, radius2); /* of a point light, to where its rays touch the scene's sphere */
    if (l->point && num_cmp(beyond2, num_mul(radius2, num_from_decimal(5, -2))) < 0) return ERR_LIGHT;
    num_vec_cross(up, to, across);
    if (!num_vec_unit(across)) { /* straight from above or below */
        across[0] = one;
        across[1] = across[2] = zero;
    }
    num_vec_cross(to, across, up);
    num_t scale = num_div(num_from_i64(LIGHT_PAGE_LAT), radius);
    if (l->point) scale = num_mul(scale, num_sqrt(beyond2));
    *cam = (camera_t){.perspective = l->point};
    for (int k = 0; k < 3; k++) {
        cam->m[0][k] = num_mul(across[k], scale);
        cam->m[1][k] = num_mul(up[k], scale);
        cam->m[2][k] = l->point ? num_neg(to[k]) : zero;
        cam->eye[k] = l->point ? l->at[k] : to[k];
    }
    cam->m[0][3] = num_neg(num_vec_dot(cam->m[0], middle));
    cam->m[1][3] = num_neg(num_vec_dot(cam->m[1], middle));
    cam->m[2][3] = l->point ? num_vec_dot(to, l->at) : one;
    const int32_t far = (int32_t)LIGHT_PAGE_LAT + 16;
    cam->window = (page_window_t){-far, -far, far, far};
    int err = solid_map_setup(&s->map, solid, cam, place);
    s->map.through = true; /* what is translucent casts no shadow */
    if (!err && s->map.any_behind) return ERR_LIGHT;
    s->lattice = area_lattice(&s->map);
    return err;
}

/* ---- lit polygons ---- */

static int32_t limited(int64_t a) {
    return (int32_t)(a < -POLY_LIMIT ? -POLY_LIMIT : a > POLY_LIMIT ? POLY_LIMIT : a);
}

enum { NEXT, CONTOURS, VERTICES, HEAD };

/* A contour on its way to memory, clipped in space where the eye cannot have a picture of it. */
typedef struct lit_clip {
    lit_t *s;
    int32_t *w;
    REENTRANT_BORDER(area_place_t) at[AREA_BORDERS];
} lit_clip_t;

static int write(lit_clip_t *c, const area_place_t *p) {
    lit_t *s = c->s;
    const area_fine_t fine = area_fine(&s->eye_lattice, p);
    const poly_point_t at = area_round(&s->eye_lattice, &fine);
    if (s->word + s->words_max - c->w < 2) return ERR_FULL;
    *c->w++ = limited(at.x);
    *c->w++ = limited(at.y);
    return 0;
}

static int64_t inside_by(const lit_clip_t *c, int32_t border, const area_place_t *p) {
    return area_inside(&c->s->eye_lattice, border, p);
}

static bool is_inside(const lit_clip_t *c, int32_t border, const area_place_t *p) {
    return inside_by(c, border, p) >= 0;
}

static area_place_t crossing(const lit_clip_t *c, int32_t border, const area_place_t *a, const area_place_t *b) {
    const int64_t a_by = inside_by(c, border, a), b_by = inside_by(c, border, b);
    return a_by >= 0 ? area_cut(a, b, a_by, b_by) : area_cut(b, a, b_by, a_by);
}

REENTRANT(lit_clip_t, area_place_t, AREA_BORDERS)

static int take_lit(void *ctx, int32_t face, const poly_t *p) {
    lit_t *s = ctx;
    area_mover_t mv;
    if (area_is_turned_away(s->m, face, true) || !area_mover(&mv, &s->lattice, s->m, face)) return 0;
    if (HEAD + p->contours > s->words_max - s->words) return ERR_FULL;
    int32_t *block = s->word + s->words, *end = block + HEAD, *head = s->head + s->which * s->m->solid->nf + face;
    /* With nothing behind the eye, rounding alone puts something before what is nearest. */
    const int32_t border = !s->eye_lattice.clips ? AREA_BORDERS : s->m->any_behind ? 0 : 1;
    lit_clip_t c = {.s = s, .w = end + p->contours};
    const int32_t *const vertices = c.w;
    for (int32_t k = 0, i = 0; k < p->contours; k++) {
        int32_t *const start = c.w;
        int err = 0;
        for (int32_t before = p->end[k] - 1; i < p->end[k] && !err; before = i++)
            err = put(&c, border, area_move(&mv, p->v[i].at, (int32_t[]){p->v[before].tag, p->v[i].tag}));
        if (!err) err = put_end(&c, border);
        if (err) return err;
        if (c.w - start < 2 * 3) c.w = start;
        end[k] = (int32_t)(c.w - vertices) / 2;
    }
    if (c.w == vertices) return 0;
    block[NEXT] = *head;
    block[CONTOURS] = p->contours;
    block[VERTICES] = (int32_t)(c.w - vertices) / 2;
    *head = s->words;
    s->words = (int32_t)(c.w - s->word);
    return 0;
}

static int no_wire(void *ctx, int32_t edge, int32_t from_q30, int32_t to_q30) {
    (void)ctx, (void)edge, (void)from_q30, (void)to_q30;
    return 0;
}

static size_t heads_bytes(const solid_map_t *m, int32_t lights) {
    return ((size_t)m->solid->nf * (size_t)lights * sizeof(int32_t) + 7) & ~(size_t)7;
}

static size_t place_bytes(const solid_map_t *m) {
    return (SOLID_MAP_BYTES(m->solid->nv) + 7) & ~(size_t)7;
}

size_t lit_bytes(const solid_map_t *m, int32_t lights) {
    return heads_bytes(m, lights) + place_bytes(m);
}

int lit_make(lit_t *s, const solid_map_t *m, const light_t *light, int32_t lights, void *mem, size_t bytes,
             void *sort_mem, size_t sort_bytes) {
    size_t fixed = lit_bytes(m, lights);
    *s = (lit_t){.m = m, .eye_lattice = area_lattice(m), .lights = lights};
    if (bytes < fixed) return ERR_FULL;
    s->head = mem;
    void *place = (uint8_t *)mem + heads_bytes(m, lights);
    s->word = (int32_t *)(void *)((uint8_t *)mem + fixed);
    s->words_max = (int32_t)((bytes - fixed) / sizeof(int32_t) & 0x7fffffff);
    for (int32_t k = 0; k < lights * m->solid->nf; k++) s->head[k] = -1;
    for (s->which = 0; s->which < lights; s->which++) {
        const area_sink_t sink = {.ctx = s, .polygon = take_lit, .wire = no_wire};
        area_stats_t stats;
        int err = look_from(s, &light[s->which], place);
        if (!err) err = area_sort(&s->map, sort_mem, sort_bytes, &sink, NULL, NULL, &stats);
        if (err) return err;
        if (stats.intersections > s->intersections) s->intersections = stats.intersections;
    }
    return 0;
}

size_t lit_shrink(lit_t *s) {
    s->words_max = s->words;
    return (lit_bytes(s->m, s->lights) + (size_t)s->words * sizeof(int32_t) + 7) & ~(size_t)7;
}

/* A block in a window. */
static int limit(const int32_t *block, const area_box_t *window, clip_out_t *out) {
    const int32_t *end = block + HEAD, *w = end + block[CONTOURS];
    area_limit_t l;
    area_limit_init(&l, window, POLY_CUT, out);
    for (int32_t c = 0, k = 0; c < block[CONTOURS]; c++) {
        int err = 0;
        for (; k < end[c] && !err; k++) err = area_limit_put(&l, (poly_point_t){w[2 * k], w[2 * k + 1]});
        if (!err) err = area_limit_close(&l);
        if (err) return err;
    }
    return 0;
}

int lit_polygons(const lit_t *s, int32_t which, int32_t face, const area_box_t *window, clip_out_t *out) {
    for (int32_t at = s->head[which * s->m->solid->nf + face]; at >= 0; at = s->word[at + NEXT]) {
        const int32_t *block = s->word + at, *end = block + HEAD, *w = end + block[CONTOURS];
        if (window) {
            int err = limit(block, window, out);
            if (err) return err;
            continue;
        }
        if (out->n + block[VERTICES] > out->n_max || out->contours + block[CONTOURS] > out->contours_max)
            return ERR_FULL;
        for (int32_t k = 0, before = 0; k < block[CONTOURS]; before = end[k++])
            if (end[k] > before) out->end[out->contours++] = out->n + end[k];
        for (int32_t k = 0; k < block[VERTICES]; k++)
            out->v[out->n++] = (poly_vertex_t){{w[2 * k], w[2 * k + 1]}, POLY_CUT};
    }
    return 0;
}

#endif
