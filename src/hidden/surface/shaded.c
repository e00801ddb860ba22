/* shaded.c - see shaded.h. */
#include "hidden/surface/shaded.h"

#include "config.h"
#include "error.h"
#include "hidden/surface/shaded_cell.h"
#include "hidden/surface/shaded_light.h"
#include "num/ints.h"

#if CONFIG_AREA

#define ONE_Q30 (INT32_C(1) << 30)
#define LEAST_LAT (LAT_PER_MM / 10) /* shorter parts are dots, shorter gaps rounding */

/* ---- rows ---- */

size_t shaded_bytes(int32_t nx, int32_t surfaces) {
    return (size_t)surfaces * 2 * ((size_t)nx * sizeof(shaded_vertex_t) + sizeof(int32_t)) + 16;
}

int shaded_init(shaded_t *s, int32_t nx, int32_t surfaces, void *mem, size_t bytes) {
    const size_t rows = (size_t)surfaces * 2, fixed = shaded_bytes(nx, surfaces);
    if (bytes < fixed + 16 * sizeof(interval_t)) return ERR_FULL;
    s->nx = nx;
    s->row = mem;
    s->row_j = (int32_t *)(void *)(s->row + rows * (size_t)nx);
    for (size_t k = 0; k < rows; k++) s->row_j[k] = -1;
    intervals_init(&s->parts, (uint8_t *)mem + fixed, bytes - fixed);
    shaded_weigh_lights(s);
    return 0;
}

/* ---- lines across a facet ---- */

static const uint8_t side_end[4][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}};

/* One end of a line across a facet. */
typedef struct crossing {
    int32_t t_q30; /* on the hatch line */
    int side;
    int32_t part_q30; /* of the side, on the page */
} crossing_t;

/* Share of the way in space for a share of the way on the page, between depths e0 and e1; and back with these the other
 * way round. */
static int32_t share_of(int32_t part_q30, int64_t e0, int64_t e1) {
    if (part_q30 == 0 || part_q30 == ONE_Q30 || e0 == e1) return part_q30;
    return (int32_t)line_space_share(part_q30, ONE_Q30 - part_q30, e0, e1, INK_ONE);
}

typedef struct stretch {
    shaded_t *s;
    int32_t line, t_q30[2];
    int64_t e[2];
    int64_t above[2][CONFIG_PLOT_ITEMS]; /* of the others */
} stretch_t;

static int flush(shaded_t *s);

static int add_part(shaded_t *s, int32_t line, int32_t from, int32_t to) {
    int err = intervals_add(&s->parts, line, from, to);
    if (err != ERR_FULL) return err;
    err = flush(s);
    return err ? err : intervals_add(&s->parts, line, from, to);
}

/* The parameter of the hatch line at a share of the stretch in space. */
static int32_t line_at(const stretch_t *k, int32_t share_q30) {
    int32_t part = share_of(share_q30, k->e[1], k->e[0]);
    if (part == ONE_Q30) return k->t_q30[1];
    return k->t_q30[0] + (int32_t)(((int64_t)k->t_q30[1] - k->t_q30[0]) * part >> 30);
}

/* A visible part, in space. */
static int take_part(void *ctx, const ink_piece_t *p) {
    const stretch_t *k = ctx;
    return add_part(k->s, k->line, line_at(k, (int32_t)(p->from >> (INK_GRID_BITS - 30))),
                    line_at(k, (int32_t)(p->to >> (INK_GRID_BITS - 30))));
}

static int32_t mix32(int32_t a, int32_t b, int32_t share_q30) {
    return a + (int32_t)(((int64_t)b - a) * share_q30 >> 30);
}

/* Puts end n of a segment where a side of the facet is crossed. */
static void put_end(const shaded_cell_t *f, const crossing_t *c, edges_segment_t *seg, stretch_t *k, int n) {
    const int a = side_end[c->side][0], b = side_end[c->side][1];
    const int64_t ea = f->v[a]->h.e, eb = f->v[b]->h.e;
    const int32_t share = share_of(c->part_q30, ea, eb);
    if (f->around) {
        seg->x[n] = mix32(f->x[a], f->x[b], share);
        seg->y[n] = mix32(f->y[a], f->y[b], share);
        seg->z[n] = edges_mix(f->z[a], f->z[b], share);
    } else {
        const int64_t ga = f->g[a], gb = f->g[b];
        const int32_t u = share_of(share, ga, gb);
        seg->at[n] = (pencil_t){mix32(f->at[a].a, f->at[b].a, u), mix32(f->at[a].w, f->at[b].w, u)};
        const int64_t d = edges_mix(gb, ga, share); /* 1 / g is linear in space */
        seg->g[n] = ga == gb ? (uint32_t)ga : (uint32_t)ints_muldiv_round(ga, gb, d ? d : 1);
    }
    k->e[n] = ea + ints_muldiv_round(eb - ea, share, INK_ONE);
    k->t_q30[n] = c->t_q30;
    for (int32_t m = 0; m < f->others; m++)
        k->above[n][m] = edges_mix(f->other[m].above[a], f->other[m].above[b], share);
}

/* The part [from, to] of a segment, as one of its own. */
static edges_segment_t part_of(const edges_segment_t *seg, bool around, int32_t from_q30, int32_t to_q30) {
    edges_segment_t part = *seg;
    for (int n = 0; n < 2; n++) {
        const int32_t share = n ? to_q30 : from_q30;
        if (around) {
            part.x[n] = mix32(seg->x[0], seg->x[1], share);
            part.y[n] = mix32(seg->y[0], seg->y[1], share);
            part.z[n] = edges_mix(seg->z[0], seg->z[1], share);
            continue;
        }
        const int64_t g0 = seg->g[0], g1 = seg->g[1], d = edges_mix(g1, g0, share);
        const int32_t u = share_of(share, g0, g1);
        part.at[n] = (pencil_t){mix32(seg->at[0].a, seg->at[1].a, u), mix32(seg->at[0].w, seg->at[1].w, u)};
        part.g[n] = g0 == g1 ? (uint32_t)g0 : (uint32_t)ints_muldiv_round(g0, g1, d ? d : 1);
    }
    return part;
}

/* A part in which the others keep their sides. */
static int look_at_part(sweep_t *sw, const shaded_cell_t *f, const edges_segment_t *seg, const stretch_t *k,
                        int32_t from, int32_t to) {
    edges_t *e = &sw->edges;
    const int32_t middle = from + (to - from) / 2;
    stretch_t part = *k;
    for (int32_t m = 0; m < f->others; m++) {
        const int64_t above = edges_mix(k->above[0][m], k->above[1][m], middle);
        const layer_t *o = f->other[m].layer;
        if (above != 0 && (above > 0) == f->other[m].upper)
            e->sheet[e->sheets++] = (edges_sheet_t){.span = o->span, .spans = o->spans, .below = o->below};
    }
    part.t_q30[0] = line_at(k, from);
    part.t_q30[1] = line_at(k, to);
    part.e[0] = k->e[0] + ints_muldiv_round(k->e[1] - k->e[0], from, INK_ONE);
    part.e[1] = k->e[0] + ints_muldiv_round(k->e[1] - k->e[0], to, INK_ONE);
    const edges_segment_t piece = part_of(seg, f->around, from, to);
    const ink_sink_t sink = {&part, take_part};
    int err = edges_look_at(e, &piece, &sink);
    e->sheets = 0;
    return err;
}

/* The line between two crossings, cut where it passes through another surface. */
static int hatch_stretch(shaded_t *s, sweep_t *sw, const shaded_cell_t *f, const crossing_t c[2], int32_t line) {
    edges_segment_t seg = {.g = {1, 1}};
    stretch_t k = {.s = s, .line = line};
    if (c[0].t_q30 >= c[1].t_q30) return 0;
    if (sw->edges.chart.kind == CHART_VERTICAL) return add_part(s, line, c[0].t_q30, c[1].t_q30);
    for (int n = 0; n < 2; n++) put_end(f, &c[n], &seg, &k, n);
    if (f->others == 0) {
        const ink_sink_t sink = {&k, take_part};
        return edges_look_at(&sw->edges, &seg, &sink);
    }
    for (int32_t at = 0, to; at < ONE_Q30; at = to) {
        to = ONE_Q30;
        for (int32_t m = 0; m < f->others; m++) {
            const int64_t a = k.above[0][m], b = k.above[1][m];
            if ((a > 0) == (b > 0) || a == 0 || b == 0) continue;
            const int32_t cut = (int32_t)pencil_fraction(ints_abs64(a), ints_abs64(a) + ints_abs64(b));
            if (cut > at && cut < to) to = cut;
        }
        int err = look_at_part(sw, f, &seg, &k, at, to);
        if (err) return err;
    }
    return 0;
}

static int hatch_line(shaded_t *s, sweep_t *sw, const shaded_cell_t *f, bool second, int32_t k) {
    crossing_t c[4];
    int n = 0;
    for (int side = 0; side < 4; side++) {
        const hatch_place_t *a = &f->place[side_end[side][0]], *b = &f->place[side_end[side][1]];
        crossing_t x = {.side = side};
        if (!hatch_cross(s->hatch, *a, *b, hatch_line_at(s->hatch, k), &x.t_q30, &x.part_q30)) continue;
        int i = n++;
        for (; i > 0 && c[i - 1].t_q30 > x.t_q30; i--) c[i] = c[i - 1];
        c[i] = x;
    }
    int err = 0;
    for (int i = 0; i + 1 < n && !err; i += 2) err = hatch_stretch(s, sw, f, c + i, hatch_number(s->hatch, second, k));
    return err;
}

static int hatch_family(shaded_t *s, sweep_t *sw, shaded_cell_t *f, bool second, int32_t step) {
    int64_t low = INT64_MAX, high = INT64_MIN;
    int32_t lo, hi;
    for (int k = 0; k < 4; k++) {
        f->place[k] = hatch_place(s->hatch, second, f->page[k]);
        low = f->place[k].w < low ? f->place[k].w : low;
        high = f->place[k].w > high ? f->place[k].w : high;
    }
    hatch_range(s->hatch, low, high, &lo, &hi);
    int err = 0;
    for (int32_t k = (lo + step - 1) & -step; k <= hi && !err; k += step) err = hatch_line(s, sw, f, second, k);
    return err;
}

int shaded_facet(shaded_t *s, sweep_t *sw, const layer_t *l, int32_t i) {
    const int32_t j = l->line[0].j;
    const shaded_vertex_t *row[2] = {shaded_row(s, l, j), shaded_row(s, l, j + 1)};
    shaded_cell_t f = {.v = {&row[0][i], &row[0][i + 1], &row[1][i + 1], &row[1][i]}};
    if (!shaded_place(s, f.v, f.page)) return 0;
    const int64_t area2 = shaded_area2(f.page);
    shaded_chart(&f, &sw->edges.chart, l, i);
    if (area2 == 0 || shaded_is_hidden(sw, &f)) return 0;
    shaded_others(s, &f, sw, l, i);
    enum hatch_tone tone = hatch_tone_of(shaded_brightness(s, l->grid, i, j, f.v, area2 < 0));
    int err = 0;
    for (int second = 0; second < 2 && !err; second++) {
        int32_t step = hatch_step(tone, second);
        if (step) err = hatch_family(s, sw, &f, second, step);
    }
    return err;
}

/* ---- what has come together ---- */

static int32_t least(void *ctx, int32_t line) {
    const shaded_t *s = ctx;
    (void)line;
    return (int32_t)(LEAST_LAT * INK_ONE / (2 * (int64_t)s->hatch->reach_lat));
}

static int emit(void *ctx, const interval_t *part) {
    shaded_t *s = ctx;
    const ink_piece_t piece = {INK_CURVE, s->space, part->line, part->from_q30, part->to_q30};
    s->pieces++;
    return s->sink->piece(s->sink->ctx, &piece);
}

static int flush(shaded_t *s) {
    const interval_use_t use = {s, least, emit};
    int err = intervals_finish(&s->parts, &use);
    s->parts.n = 0;
    return err;
}

int shaded_finish(shaded_t *s) {
    return flush(s);
}

#endif
