/* area_tone.c - see area_tone.h. */
#include "hidden/area/area_tone.h"
#include "hidden/area/area_limit.h"
#include "hidden/area/area_patch.h"

#include "error.h"
#include "num/ints.h"
#include <string.h>

#if CONFIG_AREA

/* Where there are patches, a part of the toner's memory is theirs. What lit polygons leave of the rest, in tenths:
 * those of one face; parts before and after a light; the clipper.
 */
#define LEAST_BYTES 1024
#define LIT_EACH 32 /* what a light reaches of a face is some quadrilateral, or nothing */
#define PATCH_PART 4
enum { FACE_SHARE = 2, PARTS_SHARE = 1, SHARES = 10 };

#define WINDOWS_DEEP 16
#define WINDOW_LEAST_LAT (LAT_PER_MM / 8)
#define PARTS_MOST (1 << LIGHTS_MAX)
enum { OWN = 0 }; /* tag of edges that are no border of a shadow */

/* Room for polygons. */
typedef struct store {
    poly_vertex_t *v;
    int32_t *end;
    int32_t most; /* vertices, and contours */
} store_t;

typedef struct part {
    poly_t p;
    int64_t bright_q30; /* sum of cosines */
} part_t;

struct area_toner {
    area_tone_t tone;
    const solid_map_t *m;
    area_lattice_t lattice;
    bool patched;
    area_patches_t patches;
    int64_t full_q30; /* what a face gets that is turned squarely to all lights */
    lit_t lit;
    store_t face, parts[2];
    part_t part[2][PARTS_MOST];
    int32_t n; /* parts */
    void *clip_mem;
    size_t clip_bytes;
    size_t fixed; /* bytes that every polygon finds in use */
    int32_t lit_most, vertices_most,
        edges_most; /* vertices of what a light reaches, of parts; edges that were clipped */
};

/* ---- memory ---- */

static size_t eights(size_t bytes) {
    return (bytes + 7) & ~(size_t)7;
}

static uint8_t *lay_out_store(store_t *s, uint8_t *at, size_t bytes) {
    s->most = (int32_t)(bytes / (sizeof(poly_vertex_t) + sizeof(int32_t)));
    s->v = (poly_vertex_t *)(void *)at;
    s->end = (int32_t *)(void *)(s->v + s->most);
    return at + bytes;
}

size_t area_toner_bytes(const solid_map_t *m) {
    if (area_patch_any(m->solid)) return SIZE_MAX;
    return eights(sizeof(area_toner_t)) + LEAST_BYTES;
}

size_t area_toner_fixed(const solid_map_t *m, const area_tone_t *tone) {
    const size_t each = LIT_EACH * (size_t)m->solid->nf * (size_t)tone->lights;
    return eights(sizeof(area_toner_t)) + lit_bytes(m, tone->lights) + each;
}

/* The length of the sum of all directions: at least 1, or opposite lights would leave nothing. */
static int64_t full_light(const area_toner_t *t) {
    num_t sum[3], length2 = num_from_i64(0), one = num_from_i64(1);
    const solid_t *s = t->m->solid;
    for (int k = 0; k < 3; k++) sum[k] = num_from_i64(0);
    for (int32_t l = 0; l < t->tone.lights; l++) {
        num_t to[3], square = num_from_i64(0);
        for (int k = 0; k < 3; k++) {
            num_t middle = num_ldexp(num_add(s->lo[k], s->hi[k]), -1);
            to[k] = t->tone.light[l].point ? num_sub(t->tone.light[l].at[k], middle) : t->tone.light[l].at[k];
            to[k] = num_mul(to[k], t->m->cam->unit[k]);
            square = num_add(square, num_mul(to[k], to[k]));
        }
        num_t length = num_sqrt(square);
        if (num_sign(length) <= 0) continue;
        for (int k = 0; k < 3; k++) sum[k] = num_add(sum[k], num_div(to[k], length));
    }
    for (int k = 0; k < 3; k++) length2 = num_add(length2, num_mul(sum[k], sum[k]));
    if (num_cmp(length2, one) < 0) length2 = one;
    return num_to_fixed(num_sqrt(length2), 30, NULL);
}

int area_toner_make(area_toner_t **toner, const area_tone_t *tone, const solid_map_t *m, void *mem, size_t bytes,
                    void *sort_mem, size_t sort_bytes) {
    area_toner_t *t = mem;
    const size_t own = eights(sizeof *t);
    if (bytes < own + LEAST_BYTES) return ERR_FULL;
    memset(t, 0, sizeof *t);
    *toner = t;
    t->tone = *tone;
    t->m = m;
    t->lattice = area_lattice(m);
    t->full_q30 = full_light(t);
    t->patched = tone->hatch && area_patch_any(m->solid);
    if (tone->hatch) tone->hatch->bits = t->lattice.bits;
    if (tone->borders) tone->borders->bits = t->lattice.bits;
    uint8_t *at = (uint8_t *)mem + own;
    size_t left = bytes - own;
    if (t->patched) {
        const size_t part = left / PATCH_PART & ~(size_t)7;
        area_patches_init(&t->patches, &t->lattice, at, part);
        at += part;
        left -= part;
    }
    t->fixed = bytes - left;
    t->clip_mem = at;
    t->clip_bytes = left;
    if (!tone->shadow) return 0;
    int err = lit_make(&t->lit, m, tone->light, tone->lights, at, left, sort_mem, sort_bytes);
    if (err) return err;
    const size_t lit = lit_shrink(&t->lit);
    if (left < lit + LEAST_BYTES) return ERR_FULL;
    const size_t share = (left - lit) / SHARES & ~(size_t)7;
    at = lay_out_store(&t->face, at + lit, share * FACE_SHARE);
    for (int k = 0; k < 2; k++) at = lay_out_store(&t->parts[k], at, share * PARTS_SHARE);
    t->clip_mem = at;
    t->clip_bytes = share * (SHARES - FACE_SHARE - 2 * PARTS_SHARE);
    return 0;
}

/* ---- parts of a polygon ---- */

typedef struct cursor {
    store_t *store;
    int32_t n, contours;
    part_t *part;
    int32_t parts;
} cursor_t;

/* A part from result `which`, or nothing if that is empty. */
static int take_result(cursor_t *c, clip_t *clip, int which, int64_t bright_q30, poly_t *out) {
    clip_out_t to = {.v = c->store->v + c->n,
                     .end = c->store->end + c->contours,
                     .n_max = c->store->most - c->n,
                     .contours_max = c->store->most - c->contours};
    int err = clip_trace(clip, which, &to);
    *out = (poly_t){to.v, to.end, to.contours};
    if (err || to.contours == 0) return err;
    c->part[c->parts++] = (part_t){*out, bright_q30};
    c->n += to.n;
    c->contours += to.contours;
    return 0;
}

/* All edges are its own from now on. */
static void own(const cursor_t *c) {
    for (int32_t k = 0; k < c->n; k++) c->store->v[k].tag = OWN;
}

/* Each part falls into what light l reaches, which is brighter by `slope`, and what it does not. */
static int part_by(area_toner_t *t, const poly_t *lit, int64_t slope_q30) {
    cursor_t c = {.store = &t->parts[1], .part = t->part[1]};
    for (int32_t k = 0; k < t->n; k++) {
        const part_t *from = &t->part[0][k];
        const clip_job_t job = {from->p, *lit, CLIP_NONZERO, {CLIP_INSIDE, CLIP_OUTSIDE}};
        clip_t clip;
        poly_t dark, bright;
        int err = clip_run(&clip, &job, t->clip_mem, t->clip_bytes);
        if (!err) err = take_result(&c, &clip, 1, from->bright_q30, &dark);
        if (!err && t->tone.borders && dark.contours) err = borders_add(t->tone.borders, &dark, POLY_CUT);
        if (!err) err = take_result(&c, &clip, 0, from->bright_q30 + slope_q30, &bright);
        if (err) return err;
        if (clip.stats.most_edges > t->edges_most) t->edges_most = clip.stats.most_edges;
    }
    if (c.n > t->vertices_most) t->vertices_most = c.n;
    own(&c);
    t->n = c.parts;
    memcpy(t->part[0], t->part[1], (size_t)c.parts * sizeof(part_t));
    const store_t swap = t->parts[0];
    t->parts[0] = t->parts[1];
    t->parts[1] = swap;
    return 0;
}

/* The polygon, or what of it lies in a window, as the first part. */
static int begin(area_toner_t *t, const poly_t *p, const area_box_t *window) {
    store_t *s = &t->parts[0];
    clip_out_t out = {.v = s->v, .end = s->end, .n_max = s->most, .contours_max = s->most};
    area_limit_t l;
    int err = 0;
    if (window) {
        area_limit_init(&l, window, OWN, &out);
        for (int32_t c = 0, k = 0; c < p->contours && !err; c++) {
            for (; k < p->end[c] && !err; k++) err = area_limit_put(&l, p->v[k].at);
            if (!err) err = area_limit_close(&l);
        }
    } else {
        const int32_t n = poly_vertices(p);
        if (n > s->most || p->contours > s->most) return ERR_FULL;
        for (int32_t k = 0; k < n; k++) s->v[k] = (poly_vertex_t){p->v[k].at, OWN};
        for (int32_t k = 0; k < p->contours; k++) s->end[k] = p->end[k];
        out.contours = p->contours;
    }
    t->part[0][0] = (part_t){{s->v, s->end, out.contours}, 0};
    t->n = out.contours > 0;
    return err;
}

/* A visible polygon on its way to tones. */
typedef struct toning {
    area_toner_t *t;
    int32_t face, first_line;
    int64_t slope[LIGHTS_MAX], all; /* what each light gives, if it reaches the face; and their sum */
    intervals_t *to;
} toning_t;

static int hatch(const toning_t *w, const poly_t *p, int64_t bright_q30, int32_t percent) {
    const area_toner_t *t = w->t;
    if (!t->tone.hatch) return 0;
    int64_t share_q30 = ints_muldiv_round(bright_q30, INK_ONE, t->full_q30) * percent / 100;
    return hatch_polygon(t->tone.hatch, p, hatch_tone_of(share_q30), w->first_line, w->to);
}

/* A polygon, or what of it lies in a window. */
static int tone_window(const toning_t *w, const poly_t *p, const area_box_t *window, int32_t percent) {
    area_toner_t *t = w->t;
    area_box_t part = {0}, around = {0};
    if (window) { /* what the light reaches ends outside of it, so that no border of a shadow runs along it */
        const int32_t lat = 1 << t->lattice.bits, more = BORDERS_OVERLAP_LAT * lat;
        part = (area_box_t){window->x0, window->y0, window->x1 + more, window->y1 + more};
        around = (area_box_t){part.x0 - lat, part.y0 - lat, part.x1 + lat, part.y1 + lat};
    }
    int err = begin(t, p, window ? &part : NULL);
    for (int32_t l = 0; l < t->tone.lights && !err; l++) {
        if (w->slope[l] == 0 || t->n == 0) continue;
        clip_out_t lit = {.v = t->face.v, .end = t->face.end, .n_max = t->face.most, .contours_max = t->face.most};
        err = lit_polygons(&t->lit, l, w->face, window ? &around : NULL, &lit);
        if (lit.n > t->lit_most) t->lit_most = lit.n;
        const poly_t reached = {lit.v, lit.end, lit.contours};
        if (!err && reached.contours) err = part_by(t, &reached, w->slope[l]);
    }
    for (int32_t k = 0; k < t->n && !err; k++) err = hatch(w, &t->part[0][k].p, t->part[0][k].bright_q30, percent);
    return err;
}

typedef struct tone_box {
    area_box_t box;
    int32_t level;
} tone_box_t;

/* Puts what is to be done instead of a window in its place: after the whole polygon at once (level 0), its box, where
 * all that the light reaches elsewhere is left out; then the halves across the longer side. Returns how many: 0 if
 * windows get no smaller. */
static int32_t divide(tone_box_t part[2], int bits) {
    area_box_t half[2];
    const int32_t size = area_box_halve(&part[0].box, half);
    if (part[0].level++ == 0) return 1;
    if (part[0].level > WINDOWS_DEEP || size >> bits < WINDOW_LEAST_LAT) return 0;
    for (int k = 0; k < 2; k++) part[k] = (tone_box_t){half[k], part[0].level};
    return 2;
}

/* Where there is no memory for a polygon at once, it is done window by window. */
static int tone_part(void *ctx, const poly_t *p, int32_t percent) {
    const toning_t *w = ctx;
    area_toner_t *t = w->t;
    borders_t *b = t->tone.borders;
    if (!t->tone.shadow || w->all == 0) return hatch(w, p, w->all, percent);
    const int32_t all = b ? b->n : 0;
    tone_box_t todo[WINDOWS_DEEP + 2] = {{area_box_of(p->v, poly_vertices(p)), 0}};
    for (int32_t n = 1; n > 0;) {
        const tone_box_t *now = &todo[--n];
        const int32_t before = b ? b->n : 0;
        int err = tone_window(w, p, now->level ? &now->box : NULL, percent);
        if (err == ERR_FULL &&
            !(b && b->n == b->n_max)) { /* a light before the one that failed may have left borders */
            const int32_t parts = divide(&todo[n], t->lattice.bits);
            if (b) b->n = before;
            if (parts) err = 0;
            n += parts;
        } else if (!err && b && now->level && n == 0) {
            borders_join(b, all);
        }
        if (err) return err;
    }
    return 0;
}

int area_toner_polygon(area_toner_t *t, int32_t face, const poly_t *p, int32_t first_line, intervals_t *to) {
    toning_t w = {.t = t, .face = face, .first_line = first_line, .to = to};
    if (solid_is_clear(t->m->solid, face))
        return t->tone.hatch ? hatch_polygon(t->tone.hatch, p, HATCH_CLEAR, first_line, to) : 0;
    for (int32_t l = 0; l < t->tone.lights; l++) {
        w.slope[l] = light_slope(&t->tone.light[l], t->m, face);
        if (w.slope[l] <= LIGHT_GRAZING_Q30) w.slope[l] = 0;
        w.all += w.slope[l];
    }
    const area_patch_sink_t sink = {&w, tone_part};
    return t->patched ? area_patches_cut(&t->patches, face, p, t->clip_mem, t->clip_bytes, &sink)
                      : tone_part(&w, p, 100);
}

size_t area_toner_used(const area_toner_t *t) {
    const size_t vertices = (size_t)t->lit_most + 2 * (size_t)t->vertices_most;
    const size_t lit = t->tone.shadow ? lit_bytes(t->m, t->tone.lights) + (size_t)t->lit.words * sizeof(int32_t) : 0;
    return t->fixed + lit + vertices * (sizeof(poly_vertex_t) + sizeof(int32_t)) +
           CLIP_BYTES((size_t)t->edges_most) / 2;
}

int64_t area_toner_intersections(const area_toner_t *t) {
    return t->lit.intersections;
}

#endif
