/* area_light.c - see area_light.h. */
#include "hidden/area_light.h"

#include "error.h"
#include "num/ints.h"
#include "scene/solid_math.h"

#if CONFIG_AREA

#define LIGHT_PAGE_LAT ((int64_t)100 * LAT_PER_MM) /* the scene seen from the light reaches so far from the origin */

/* ---- directions ---- */

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
    if (!unit_of(normal, normal) || !unit_of(to, to)) return 0;
    int64_t q30 = num_to_fixed(dot(normal, to), 30, NULL);
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
    num_t radius2 = dot(half, half), away2 = dot(to, to), radius = num_sqrt(radius2);
    if (radius.undef || num_sign(radius) == 0 || !unit_of(to, to)) return ERR_VALUE;
    num_t beyond2 = num_sub(away2, radius2); /* of a point light, to where its rays touch the scene's sphere */
    if (l->point && num_cmp(beyond2, num_mul(radius2, num_from_decimal(5, -2))) < 0) return ERR_LIGHT;
    cross(up, to, across);
    if (!unit_of(across, across)) { /* straight from above or below */
        across[0] = one;
        across[1] = across[2] = zero;
    }
    cross(to, across, up);
    num_t scale = num_div(num_from_i64(LIGHT_PAGE_LAT), radius);
    if (l->point) scale = num_mul(scale, num_sqrt(beyond2));
    *cam = (camera_t){.perspective = l->point};
    for (int k = 0; k < 3; k++) {
        cam->m[0][k] = num_mul(across[k], scale);
        cam->m[1][k] = num_mul(up[k], scale);
        cam->m[2][k] = l->point ? num_neg(to[k]) : zero;
        cam->eye[k] = l->point ? l->at[k] : to[k];
    }
    cam->m[0][3] = num_neg(dot(cam->m[0], middle));
    cam->m[1][3] = num_neg(dot(cam->m[1], middle));
    cam->m[2][3] = l->point ? dot(to, l->at) : one;
    const int32_t far = (int32_t)LIGHT_PAGE_LAT + 16;
    cam->window = (page_window_t){-far, -far, far, far};
    int err = solid_map_setup(&s->map, solid, cam, place);
    s->map.through = true; /* what is translucent casts no shadow */
    if (!err && s->map.any_behind) return ERR_LIGHT;
    s->lattice = area_lattice(&s->map);
    return err;
}

/* ---- from the light's view to the eye's ---- */

#define BORDER_MOST 8

typedef struct mover {
    poly_point_t at[3]; /* corners as the light sees them */
    page_h_t from[3];   /* the same, homogeneous */
    page_h_t to[3];     /* and as the eye does */
    int64_t whole;
    struct {
        poly_point_t at;
        page_h_t from[1], to[1];
    } border[BORDER_MOST]; /* all corners, if they are not many: n, else 0 */
    int32_t n;
} mover_t;

/* The three corners that span the face widest, seen from the light. False if it sees the face edge-on. */
static bool find_corners(const lit_t *s, int32_t face, mover_t *mv) {
    const solid_face_t *f = &s->m->solid->face[face];
    const int32_t *corner = s->m->solid->corner + f->corner;
    int32_t at[3] = {0, 0, 0};
    uint64_t far = 0, wide = 0;
    for (int k = 0; k < 3; k++) mv->at[k] = area_vertex(&s->lattice, corner[0]);
    for (int32_t k = 1; k < f->n; k++) {
        poly_point_t p = area_vertex(&s->lattice, corner[k]);
        int64_t dx = p.x - mv->at[0].x, dy = p.y - mv->at[0].y;
        uint64_t d = (uint64_t)(dx * dx + dy * dy);
        if (d > far) far = d, at[1] = k, mv->at[1] = p;
    }
    if (far == 0) return false;
    for (int32_t k = 1; k < f->n; k++) {
        poly_point_t p = area_vertex(&s->lattice, corner[k]);
        uint64_t d = ints_abs64(poly_orient(mv->at[0], mv->at[1], p));
        if (d > wide) wide = d, at[2] = k, mv->at[2] = p;
    }
    mv->whole = poly_orient(mv->at[0], mv->at[1], mv->at[2]);
    for (int k = 0; k < 3; k++) {
        mv->from[k] = solid_map_vertex(&s->map, corner[at[k]]);
        mv->to[k] = solid_map_vertex(s->m, corner[at[k]]);
    }
    mv->n = f->n <= BORDER_MOST ? f->n : 0;
    for (int32_t k = 0; k < mv->n; k++) {
        mv->border[k].at = area_vertex(&s->lattice, corner[k]);
        *mv->border[k].from = solid_map_vertex(&s->map, corner[k]);
        *mv->border[k].to = solid_map_vertex(s->m, corner[k]);
    }
    return mv->whole != 0;
}

static int32_t limited(int64_t a) {
    return (int32_t)(a < -POLY_LIMIT ? -POLY_LIMIT : a > POLY_LIMIT ? POLY_LIMIT : a);
}

/* A share of a difference; far outside of a face it may be anything, but stays summable. */
static int64_t share_of(int64_t a, int64_t p, int64_t whole) {
    int64_t most = (int64_t)1 << 61, part = ints_muldiv_round(p, a, whole);
    return part < -most ? -most : part > most ? most : part;
}

/* a + (b - a) p / whole + (c - a) q / whole */
static int64_t mix(int64_t a, int64_t b, int64_t c, int64_t p, int64_t q, int64_t whole) {
    return a + share_of(b - a, p, whole) + share_of(c - a, q, whole);
}

static area_place_t place(const lit_t *s, int64_t x, int64_t y, int64_t e) {
    if (!s->m->lines.perspective) return (area_place_t){.x = x, .y = y, .e = (int64_t)1 << s->m->lines.frac_bits};
    const int64_t most = INT64_MAX >> SOLID_FINE_E;
    return (area_place_t){.x = x, .y = y, .e = (e > most ? most : e < -most ? -most : e) * (1 << SOLID_FINE_E)};
}

/* A point on the border stays on it, also where a face of a file is flat only nearly: the light sees that it is not. */
static bool move_on_border(const lit_t *s, const mover_t *mv, poly_point_t p, area_place_t *to) {
    for (int32_t k = 0; k < mv->n; k++) {
        const int32_t m = k + 1 < mv->n ? k + 1 : 0;
        const poly_point_t a = mv->border[k].at, b = mv->border[m].at;
        const int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y, px = (int64_t)p.x - a.x,
                      py = (int64_t)p.y - a.y;
        const int64_t wide = dx < 0 ? -dx : dx, high = dy < 0 ? -dy : dy, size = wide > high ? wide : high;
        const int64_t along = wide > high ? (dx < 0 ? -px : px) : (dy < 0 ? -py : py), off = dx * py - dy * px;
        if (size == 0 || along < 0 || along > size || off > 2 * size || off < -2 * size) continue;
        const page_h_t *f = mv->border[k].from, *h = mv->border[k].to, *g = mv->border[m].to;
        int64_t share = ints_muldiv_round(INK_ONE, along, size);
        if (s->map.lines.perspective && share > 0 && share < INK_ONE) {
            /* as in the picture, to in space */
            const int64_t far = mv->border[m].from->e;
            share = ints_muldiv_round(INK_ONE, ints_muldiv_round(share, f->e, far),
                                      ints_muldiv_round(share, f->e, far) + INK_ONE - share);
        }
        const page_h_t at = line_space_mix(h, g, (int32_t)(share > INK_ONE - 1 ? INK_ONE - 1 : share));
        *to = share == INK_ONE ? place(s, g->x, g->y, g->e) : place(s, at.x, at.y, at.e);
        return true;
    }
    return false;
}

static area_place_t move(const lit_t *s, const mover_t *mv, poly_point_t p) {
    const page_h_t *h = mv->to;
    area_place_t on_border;
    if (move_on_border(s, mv, p, &on_border)) return on_border;
    int64_t to_b = poly_orient(mv->at[0], p, mv->at[2]), to_c = poly_orient(mv->at[0], mv->at[1], p);
    int64_t whole = mv->whole;
    if (s->map.lines.perspective) {
        /* A share l of a corner in the picture is a share l / E of it in space, in the sum of these. */
        const int64_t fine = INK_ONE * 256;
        int64_t share[3] = {0, ints_muldiv_round(to_b, fine, whole), ints_muldiv_round(to_c, fine, whole)};
        share[0] = fine - share[1] - share[2];
        for (int k = 0; k < 3; k++)
            share[k] = ints_muldiv_round(share[k], s->lattice.near >> SOLID_FINE_E, mv->from[k].e);
        whole = share[0] + share[1] + share[2];
        to_b = share[1];
        to_c = share[2];
        if (whole == 0) whole = 1;
    }
    int64_t x = mix(h[0].x, h[1].x, h[2].x, to_b, to_c, whole);
    int64_t y = mix(h[0].y, h[1].y, h[2].y, to_b, to_c, whole);
    int64_t e = s->m->lines.perspective ? mix(h[0].e, h[1].e, h[2].e, to_b, to_c, whole) : 0;
    return place(s, x, y, e);
}

/* ---- lit polygons ---- */

enum { NEXT, CONTOURS, VERTICES, HEAD };

/* A contour on its way to memory, clipped in space where the eye cannot have a picture of it: by one border after the
 * other (Sutherland & Hodgman), each of which keeps no more than where the contour began and where it is. */
typedef struct lit_clip {
    lit_t *s;
    int32_t *w;
    struct {
        area_place_t first, last;
        bool any;
    } at[AREA_BORDERS];
} lit_clip_t;

static int write_place(lit_clip_t *c, const area_place_t *p) {
    lit_t *s = c->s;
    const area_fine_t fine = area_fine(&s->eye_lattice, p);
    const poly_point_t at = area_round(&s->eye_lattice, &fine);
    if (s->word + s->words_max - c->w < 2) return ERR_FULL;
    *c->w++ = limited(at.x);
    *c->w++ = limited(at.y);
    return 0;
}

/* Where the way from a to b crosses a border; false if it does not. */
static bool crossing(const lit_clip_t *c, int32_t border, const area_place_t *a, const area_place_t *b,
                     area_place_t *at) {
    const int64_t a_by = area_inside(&c->s->eye_lattice, border, a), b_by = area_inside(&c->s->eye_lattice, border, b);
    if ((a_by >= 0) == (b_by >= 0)) return false;
    *at = a_by >= 0 ? area_cut(a, b, a_by, b_by) : area_cut(b, a, b_by, a_by);
    return true;
}

/* The next place of a contour, for the borders from `border` on. */
static int put_place(lit_clip_t *c, int32_t border, area_place_t p) {
    struct {
        area_place_t p;
        int32_t border;
    } todo[AREA_BORDERS + 2] = {{p, border}};
    for (int32_t n = 1; n > 0;) {
        p = todo[--n].p;
        border = todo[n].border;
        if (border == AREA_BORDERS) {
            int err = write_place(c, &p);
            if (err) return err;
            continue;
        }
        area_place_t cut;
        const bool crosses = c->at[border].any && crossing(c, border, &c->at[border].last, &p, &cut);
        if (!c->at[border].any) c->at[border].first = p;
        c->at[border].any = true;
        c->at[border].last = p;
        if (area_inside(&c->s->eye_lattice, border, &p) >= 0) todo[n].p = p, todo[n++].border = border + 1;
        if (crosses) todo[n].p = cut, todo[n++].border = border + 1;
    }
    return 0;
}

/* The way back to where the contour began. */
static int close_contour(lit_clip_t *c, int32_t from) {
    for (int32_t b = from; b < AREA_BORDERS; b++) {
        area_place_t cut;
        const bool crosses = c->at[b].any && crossing(c, b, &c->at[b].last, &c->at[b].first, &cut);
        c->at[b].any = false;
        int err = crosses ? put_place(c, b + 1, cut) : 0;
        if (err) return err;
    }
    return 0;
}

static int take_lit(void *ctx, int32_t face, const poly_t *p) {
    lit_t *s = ctx;
    mover_t mv;
    if (area_is_turned_away(s->m, face, true) || !find_corners(s, face, &mv)) return 0;
    if (HEAD + p->contours > s->words_max - s->words) return ERR_FULL;
    int32_t *block = s->word + s->words, *end = block + HEAD, *head = s->head + s->which * s->m->solid->nf + face;
    /* With nothing behind the eye, rounding alone puts something before what is nearest. */
    const int32_t border = !s->eye_lattice.clips ? AREA_BORDERS : s->m->any_behind ? 0 : 1;
    lit_clip_t c = {.s = s, .w = end + p->contours};
    const int32_t *const vertices = c.w;
    for (int32_t k = 0, i = 0; k < p->contours; k++) {
        int32_t *const start = c.w;
        int err = 0;
        for (; i < p->end[k] && !err; i++) err = put_place(&c, border, move(s, &mv, p->v[i].at));
        if (!err) err = close_contour(&c, border);
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

int lit_polygons(const lit_t *s, int32_t which, int32_t face, clip_out_t *out) {
    for (int32_t at = s->head[which * s->m->solid->nf + face]; at >= 0; at = s->word[at + NEXT]) {
        const int32_t *block = s->word + at, *end = block + HEAD, *w = end + block[CONTOURS];
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
