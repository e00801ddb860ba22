/* edges.c - clipping grid edges.
 *
 * Most edges are one line in the chart. In CHART_AROUND those that cross a diagonal are split there, in space, and
 * each part is clipped in its sector: both parts take the same height at the diagonal and its exact abscissa, so the
 * horizon stays closed. What is too steep for the chart, close to the point right below the eye, is cut off in space
 * as well and drawn as it is: nothing is in front of it. */
#include "hidden/edges.h"

#define ONE_Q30 (INT32_C(1) << 30)

static inline uint32_t size32(int32_t v) {
    return v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
}

static int32_t scale_q30(int32_t whole, int32_t part_q30) {
    return (int32_t)(((int64_t)whole * part_q30 + (1 << 29)) >> 30);
}

/* The shade that hides the edge at `at`: moves at to its end and returns true; otherwise *next is where the next one
 * begins, no farther than it was. */
static bool in_shade(const edges_t *e, int32_t *at, int32_t *next) {
    for (int32_t k = 0; k < e->shades; k++) {
        const shade_t *v = &e->shade[k];
        if (v->to_q30 <= *at || v->from_q30 >= v->to_q30) continue;
        if (v->from_q30 <= *at) {
            *at = v->to_q30;
            return true;
        }
        *next = pencil_min(*next, v->from_q30);
    }
    return false;
}

/* Adds what of [from, to] lies in no shade. */
static int add_lit(edges_t *e, int32_t from, int32_t to) {
    const edges_edge_t *k = &e->edge;
    const int64_t base = k->cell * INK_ONE;
    while (from < to) {
        int32_t next = to;
        if (in_shade(e, &from, &next)) continue;
        int err = runs_add(&e->runs, k->run, k->family, k->line, base + from, base + next);
        if (err != 0) return err;
        from = next;
    }
    return 0;
}

/* Takes a visible part, in fractions of the chart, and places it on the edge in space. */
static int take_part(void *ctx, envelope_part_t part) {
    edges_t *e = ctx;
    edges_edge_t *k = &e->edge;
    int32_t from = part.from_q30, to = part.to_q30;
    if (k->quiet) return 0;
    if (from != 0 || to != ONE_Q30) {
        from = chart_unproject(from, k->g0, k->g1);
        to = chart_unproject(to, k->g0, k->g1);
    }
    if (k->way_q30 != ONE_Q30) {
        from = scale_q30(k->way_q30, from);
        to = scale_q30(k->way_q30, to);
    }
    return add_lit(e, k->start_q30 + from, k->start_q30 + to);
}

/* Takes the part [s0, s1] of the edge without asking what is in front of it. */
static int take_unseen(edges_t *e, int32_t s0, int32_t s1) {
    e->edge.start_q30 = s0;
    e->edge.way_q30 = s1 - s0;
    if (e->outline_only || e->horizons.upper_apart) return 0;
    return take_part(e, (envelope_part_t){.to_q30 = ONE_Q30});
}

/* Is the facet at hand to the right of a vertical line? Then one of its sides begins there. */
static bool facet_is_right(const edges_t *e, pencil_t p0, pencil_t p1) {
    const int32_t lo = pencil_min(p0.a, p1.a) - 1, hi = pencil_max(p0.a, p1.a) + 1;
    for (int32_t k = 0; k < e->lines; k++) {
        const bands_line_t *s = &e->outline[k];
        if (s->p.a >= lo && s->p.a <= hi && s->q.a > hi) return true;
    }
    return false;
}

/* Clips a line of the chart, or notes it as a side of the facet at hand. */
static int clip_line(edges_t *e, pencil_t p0, pencil_t p1) {
    if (e->chart.kind == CHART_VERTICAL) return take_unseen(e, 0, ONE_Q30);
    if (!e->gaps) return horizons_clip(&e->horizons, p0, p1);
    if (!e->outline_only) {
        e->right = facet_is_right(e, p0, p1);
        e->line = (bands_line_t){p0, p1};
        return bands_clip(&e->bands, p0, p1, e->right);
    }
    if (p0.a != p1.a && e->lines < BANDS_LINES) {
        e->outline[e->lines++] = p0.a < p1.a ? (bands_line_t){p0, p1} : (bands_line_t){p1, p0};
    }
    return 0;
}

/* What the cells before leave of a line, the other surfaces of this cell may hide. */
static int take_open(void *ctx, envelope_part_t part) {
    edges_t *e = ctx;
    if (e->filter == NULL) return take_part(e, part);
    e->window = part;
    return bands_clip(e->filter, e->line.p, e->line.q, e->right);
}

static int take_filtered(void *ctx, envelope_part_t part) {
    edges_t *e = ctx;
    part.from_q30 = pencil_max(part.from_q30, e->window.from_q30);
    part.to_q30 = pencil_min(part.to_q30, e->window.to_q30);
    return part.from_q30 < part.to_q30 ? take_part(e, part) : 0;
}

int edges_init(edges_t *e, const ink_sink_t *sink, bool gaps, int8_t seen, int turn, pencil_t *pool, size_t count) {
    e->runs = (runs_t){.sink = sink};
    e->gaps = gaps;
    if (gaps) return bands_init(&e->bands, e->chart.narrow, (int32_t *)(void *)pool, 2 * count, take_open, e);
    bool upper = seen >= 0 && turn >= 0, lower = seen <= 0 && turn <= 0;
    int err = horizons_init(&e->horizons, upper, lower, e->chart.narrow, pool, count, take_part, e);
    e->horizons.upper_apart = turn < 0;
    return err;
}

int edges_filter(edges_t *e, bands_t *filter, int32_t *pool, size_t words) {
    e->filter = filter;
    return bands_init(filter, e->chart.narrow, pool, words, take_filtered, e);
}

/* A point of an edge relative to the eye. */
typedef struct place {
    int32_t x, y;
    int64_t z; /* |z| < 2^60 */
} place_t;

static place_t place_at(place_t p, place_t q, int32_t s_q30) {
    if (s_q30 == 0) return p;
    if (s_q30 == ONE_Q30) return q;
    return (place_t){p.x + scale_q30(q.x - p.x, s_q30), p.y + scale_q30(q.y - p.y, s_q30), edges_mix(p.z, q.z, s_q30)};
}

/* Where on p-q the line of sight is as steep as the chart allows; one end is steeper, the other is not. */
static int32_t steep_limit(const edges_t *e, int sector, place_t p, place_t q, bool p_steep) {
    int32_t in = p_steep ? ONE_Q30 : 0, out = p_steep ? 0 : ONE_Q30; /* bisection: a rare case, exact to the chart */
    pencil_t at;
    while (in - out > 1 || out - in > 1) {
        int32_t m = in + (out - in) / 2;
        place_t t = place_at(p, q, m);
        if (chart_around(&e->chart, sector, t.x, t.y, t.z, &at)) {
            in = m;
        } else {
            out = m;
        }
    }
    return in;
}

/* The part [s0, s1] of an edge, steeper than the chart allows: nothing is in front of it unless it be another surface.
 * It bounds what is covered as the steepest line of sight would; there is none right below the eye. */
static int take_steep(edges_t *e, pencil_t at0, pencil_t at1, int32_t s0, int32_t s1) {
    const bool charted = at0.a != CHART_NONE && at1.a != CHART_NONE && at0.a != at1.a;
    int err = e->several && charted ? 0 : take_unseen(e, s0, s1);
    if (err != 0 || !charted) return err;
    at0.w = at1.w = at0.w < 0 ? -PENCIL_LIMIT : PENCIL_LIMIT;
    e->edge.start_q30 = s0;
    e->edge.way_q30 = s1 - s0;
    e->edge.g0 = e->edge.g1 = 1;
    e->edge.quiet = !e->several;
    err = clip_line(e, at0, at1);
    e->edge.quiet = false;
    return err;
}

/* Where a value that goes from v0 to v1 is zero. */
static int32_t parting(int64_t v0, int64_t v1) {
    const uint64_t n = v0 < 0 ? 0 - (uint64_t)v0 : (uint64_t)v0, m = v1 < 0 ? 0 - (uint64_t)v1 : (uint64_t)v1;
    return (int32_t)pencil_fraction(n, n + m);
}

/* A part of an edge in one sector: its ends in space, in the chart, and as fractions of the edge. */
typedef struct piece {
    int sector;
    place_t end[2];
    pencil_t at[2];
    int32_t s[2];
} piece_t;

/* Clips a part that is a line of the chart. */
static int clip_straight(edges_t *e, const piece_t *p) {
    const bool by_x = p->sector & 1;
    e->edge.start_q30 = p->s[0];
    e->edge.way_q30 = p->s[1] - p->s[0];
    e->edge.g0 = size32(by_x ? p->end[1].x : p->end[1].y);
    e->edge.g1 = size32(by_x ? p->end[0].x : p->end[0].y);
    return clip_line(e, p->at[0], p->at[1]);
}

/* Cuts off the beginning of a part: up to the border `w` between two zones, at height(k) of the way. */
static piece_t cut_at_border(const edges_t *e, piece_t *p, int k, int sign) {
    const chart_t *c = &e->chart;
    int64_t over[2];
    for (int n = 0; n < 2; n++) {
        const int32_t d = pencil_abs(p->sector & 1 ? p->end[n].x : p->end[n].y);
        over[n] = p->end[n].z - sign * chart_zone_height(c, k, d);
    }
    const int32_t t = parting(over[0], over[1]);
    piece_t head = *p;
    head.end[1] = place_at(p->end[0], p->end[1], t);
    head.s[1] = p->s[0] + scale_q30(p->s[1] - p->s[0], t);
    chart_around(c, p->sector, head.end[1].x, head.end[1].y, head.end[1].z, &head.at[1]);
    head.at[1].w = sign * chart_zone_border[k];
    p->end[0] = head.end[1];
    p->s[0] = head.s[1];
    p->at[0] = head.at[1];
    return head;
}

/* Clips a part that has coordinates at both ends, zone by zone. */
static int clip_zones(edges_t *e, piece_t p) {
    const int rise = p.at[1].w < p.at[0].w ? -1 : 1;
    for (int m = 1 - CHART_ZONES;
         m <= CHART_ZONES - 1 && !chart_in_one_zone(pencil_min(p.at[0].w, p.at[1].w), pencil_max(p.at[0].w, p.at[1].w));
         m++) {
        const int number = rise * m; /* borders are numbered ..., -2, -1, 1, 2, ... */
        if (number == 0) continue;
        const int sign = number < 0 ? -1 : 1, k = number * sign - 1;
        const int32_t w = sign * chart_zone_border[k];
        if (rise > 0 ? w <= p.at[0].w || w >= p.at[1].w : w >= p.at[0].w || w <= p.at[1].w) continue;
        const piece_t head = cut_at_border(e, &p, k, sign);
        int err = clip_straight(e, &head);
        if (err != 0) return err;
    }
    return clip_straight(e, &p);
}

/* Clips the part a-b of an edge, [s0, s1] of its way, which lies in one sector and on one side of the eye's level if
 * it is steep at both ends. */
static int clip_piece(edges_t *e, int sector, place_t a, place_t b, int32_t s0, int32_t s1) {
    piece_t p = {.sector = sector, .end = {a, b}, .s = {s0, s1}};
    const bool in0 = chart_around(&e->chart, sector, a.x, a.y, a.z, &p.at[0]);
    const bool in1 = chart_around(&e->chart, sector, b.x, b.y, b.z, &p.at[1]);
    if (!in0 && !in1) return take_steep(e, p.at[0], p.at[1], s0, s1);
    if (in0 != in1) {
        const int32_t t = steep_limit(e, sector, a, b, in1), s = s0 + scale_q30(s1 - s0, t);
        const place_t c = place_at(a, b, t);
        pencil_t limit;
        chart_around(&e->chart, sector, c.x, c.y, c.z, &limit);
        int err = in1 ? take_steep(e, p.at[0], limit, s0, s) : take_steep(e, limit, p.at[1], s, s1);
        if (err != 0) return err;
        p.end[in1 ? 0 : 1] = c;
        p.at[in1 ? 0 : 1] = limit;
        p.s[in1 ? 0 : 1] = s;
    }
    return clip_zones(e, p);
}

/* Clips the part a-b of an edge, [s0, s1] of its way, which lies in one sector. */
static int clip_in_sector(edges_t *e, place_t a, place_t b, int32_t s0, int32_t s1) {
    const place_t m = place_at(a, b, ONE_Q30 / 2);
    const int sector = chart_sector(m.x, m.y);
    if ((a.z < 0) == (b.z < 0)) return clip_piece(e, sector, a, b, s0, s1);
    const int32_t t = parting(a.z, b.z), s = s0 + scale_q30(s1 - s0, t);
    place_t level = place_at(a, b, t);
    level.z = 0;
    int err = clip_piece(e, sector, a, level, s0, s);
    return err != 0 ? err : clip_piece(e, sector, level, b, s, s1);
}

/* x + (y - x) * num / den, 0 <= num <= den < 2^32, |x|, |y| < 2^60. */
static int64_t between(int64_t x, int64_t y, int64_t num, int64_t den) {
    const int64_t d = y - x;
    return x + d / den * num + d % den * num / den;
}

/* An edge of CHART_AROUND that is not one line of the chart: cut at the diagonals, or right below the eye. */
static int clip_around(edges_t *e, place_t p, place_t q) {
    bool along_x = e->edge.family == INK_ROW;
    int32_t fixed = along_x ? p.y : p.x, v0 = along_x ? p.x : p.y, v1 = along_x ? q.x : q.y;
    int32_t side = (int32_t)size32(fixed), cuts = fixed == 0 ? 1 : 2, from_q30 = 0;
    place_t from = p;
    for (int32_t c = 0; c < cuts; c++) {
        int32_t cut = c == 0 ? -side : side;
        if (cut <= v0 || cut >= v1) continue;
        int64_t part = (int64_t)cut - v0, way = (int64_t)v1 - v0;
        place_t to = {along_x ? cut : p.x, along_x ? p.y : cut, between(p.z, q.z, part, way)};
        int32_t to_q30 = (int32_t)pencil_fraction((uint64_t)part, (uint64_t)way);
        int err = clip_in_sector(e, from, to, from_q30, to_q30);
        if (err != 0) return err;
        from = to;
        from_q30 = to_q30;
    }
    return clip_in_sector(e, from, q, from_q30, ONE_Q30);
}

/* `across` is the edge's constant distance from the eye in CHART_AROUND: an edge that is several lines there is
 * vertical only if it passes under the eye. */
static bool is_vertical(const edges_t *e, pencil_t p0, pencil_t p1, int32_t across) {
    if (e->chart.kind == CHART_AROUND && !edges_is_straight(p0, p1)) return across == 0;
    return envelope_vertical(p0, p1, e->chart.narrow);
}

bool edges_row_is_vertical(const edges_t *e, const chart_line_t *line, int32_t i) {
    return is_vertical(e, line->at[i], line->at[i + 1], line->dy);
}

bool edges_column_is_vertical(const edges_t *e, const chart_line_t *line, const chart_line_t *next, int32_t i) {
    return is_vertical(e, line->at[i], next->at[i], e->chart.column[i].p);
}

int edges_row(edges_t *e, const chart_line_t *line, int32_t i, run_t *run) {
    pencil_t p0 = line->at[i], p1 = line->at[i + 1];
    const chart_column_t *c = e->chart.column;
    e->edge =
        (edges_edge_t){.family = INK_ROW, .line = line->j, .cell = i, .run = run, .g0 = 1, .g1 = 1, .way_q30 = ONE_Q30};
    e->clipped += !e->outline_only;
    if (e->chart.kind == CHART_EAST) {
        e->edge.g0 = c[i].r;
        e->edge.g1 = c[i + 1].r;
    } else if (e->chart.kind == CHART_AROUND) {
        if (!edges_is_straight(p0, p1)) {
            return clip_around(e, (place_t){c[i].p, line->dy, line->z[i]},
                               (place_t){c[i + 1].p, line->dy, line->z[i + 1]});
        }
        if (chart_sector_at(pencil_min(p0.a, p1.a)) & 1) {
            e->edge.g0 = size32(c[i + 1].p);
            e->edge.g1 = size32(c[i].p);
        }
    }
    return clip_line(e, p0, p1);
}

int edges_column(edges_t *e, const chart_line_t *line, const chart_line_t *next, int32_t i, run_t *run) {
    pencil_t p0 = line->at[i], p1 = next->at[i];
    const chart_column_t *c = e->chart.column;
    e->edge =
        (edges_edge_t){.family = INK_COL, .line = i, .cell = line->j, .run = run, .g0 = 1, .g1 = 1, .way_q30 = ONE_Q30};
    e->clipped += !e->outline_only;
    if (e->chart.kind == CHART_NORTH) {
        e->edge.g0 = line->r;
        e->edge.g1 = next->r;
    } else if (e->chart.kind == CHART_AROUND) {
        if (!edges_is_straight(p0, p1)) {
            return clip_around(e, (place_t){c[i].p, line->dy, line->z[i]}, (place_t){c[i].p, next->dy, next->z[i]});
        }
        if (!(chart_sector_at(pencil_min(p0.a, p1.a)) & 1)) {
            e->edge.g0 = size32(next->dy);
            e->edge.g1 = size32(line->dy);
        }
    }
    return clip_line(e, p0, p1);
}
