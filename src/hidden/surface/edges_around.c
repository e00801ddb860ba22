/* edges_around.c - grid edges of CHART_AROUND that are several lines there.
 *
 * Edges that cross a diagonal are split there, in space, and each part is clipped in its sector: both parts take the
 * same height at the diagonal and its exact abscissa, so the horizon stays closed. So are those that go from zone to
 * zone. What is too steep for the chart, close to the point right below the eye, is cut off in space as well and drawn
 * as it is: nothing is in front of it. */
#include "hidden/surface/edges_parts.h"
#include "num/wide.h"

int64_t edges_scale(int64_t whole, int64_t part_q46) {
    return (int64_t)wide_sar(wide_mul_s64(whole, part_q46), INK_GRID_BITS).lo;
}

int64_t edges_fraction(uint64_t num, uint64_t den) {
    uint64_t rest;
    return den == 0 ? 0 : (int64_t)wide_div_u64(num >> (64 - INK_GRID_BITS), num << INK_GRID_BITS, den, &rest);
}

static int64_t nearest_q46(int64_t whole, int64_t part_q46) {
    return (edges_scale(2 * whole, part_q46) + 1) >> 1;
}

static edges_place_t place_at(edges_place_t p, edges_place_t q, int64_t s_q46) {
    if (s_q46 == 0) return p;
    if (s_q46 == INK_GRID_ONE) return q;
    return (edges_place_t){(int32_t)(p.x + nearest_q46((int64_t)q.x - p.x, s_q46)),
                           (int32_t)(p.y + nearest_q46((int64_t)q.y - p.y, s_q46)),
                           p.z + edges_scale(q.z - p.z, s_q46)};
}

/* Where on p-q the line of sight is as steep as the chart allows; one end is steeper, the other is not. */
static int64_t steep_limit(const edges_t *e, int sector, edges_place_t p, edges_place_t q, bool p_steep) {
    int64_t in = p_steep ? INK_GRID_ONE : 0,
            out = p_steep ? 0 : INK_GRID_ONE; /* bisection: a rare case, exact to the chart */
    pencil_t at;
    while (in - out > 1 || out - in > 1) {
        const int64_t m = in + (out - in) / 2;
        edges_place_t t = place_at(p, q, m);
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
static int take_steep(edges_t *e, pencil_t at0, pencil_t at1, int64_t s0, int64_t s1) {
    const bool charted = at0.a != CHART_NONE && at1.a != CHART_NONE && at0.a != at1.a;
    int err = e->several && charted ? 0 : edges_take_unseen(e, s0, s1);
    if (err != 0 || !charted) return err;
    at0.w = at1.w = at0.w < 0 ? -PENCIL_LIMIT : PENCIL_LIMIT;
    e->edge.start_q46 = s0;
    e->edge.way_q46 = s1 - s0;
    e->edge.g0 = e->edge.g1 = 1;
    e->edge.quiet = !e->several;
    err = edges_clip_line(e, at0, at1);
    e->edge.quiet = false;
    return err;
}

/* Where a value that goes from v0 to v1 is zero. */
static int64_t parting(int64_t v0, int64_t v1) {
    const uint64_t n = v0 < 0 ? 0 - (uint64_t)v0 : (uint64_t)v0, m = v1 < 0 ? 0 - (uint64_t)v1 : (uint64_t)v1;
    return edges_fraction(n, n + m);
}

/* A part of an edge in one sector: its ends in space, in the chart, and as fractions of the edge. */
typedef struct piece {
    int sector;
    edges_place_t end[2];
    pencil_t at[2];
    int64_t s[2];
} piece_t;

/* Clips a part that is a line of the chart. */
static int clip_straight(edges_t *e, const piece_t *p) {
    const bool by_x = p->sector & 1;
    e->edge.start_q46 = p->s[0];
    e->edge.way_q46 = p->s[1] - p->s[0];
    e->edge.g0 = size32(by_x ? p->end[1].x : p->end[1].y);
    e->edge.g1 = size32(by_x ? p->end[0].x : p->end[0].y);
    return edges_clip_line(e, p->at[0], p->at[1]);
}

/* Cuts off the beginning of a part: up to the border `w` between two zones, at height(k) of the way. */
static piece_t cut_at_border(const edges_t *e, piece_t *p, int k, int sign) {
    const chart_t *c = &e->chart;
    int64_t over[2];
    for (int n = 0; n < 2; n++) {
        const int32_t d = pencil_abs(p->sector & 1 ? p->end[n].x : p->end[n].y);
        over[n] = p->end[n].z - sign * chart_zone_height(c, k, d);
    }
    const int64_t t = parting(over[0], over[1]);
    piece_t head = *p;
    head.end[1] = place_at(p->end[0], p->end[1], t);
    head.s[1] = p->s[0] + edges_scale(p->s[1] - p->s[0], t);
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
static int clip_piece(edges_t *e, int sector, edges_place_t a, edges_place_t b, int64_t s0, int64_t s1) {
    piece_t p = {.sector = sector, .end = {a, b}, .s = {s0, s1}};
    const bool in0 = chart_around(&e->chart, sector, a.x, a.y, a.z, &p.at[0]);
    const bool in1 = chart_around(&e->chart, sector, b.x, b.y, b.z, &p.at[1]);
    if (!in0 && !in1) return take_steep(e, p.at[0], p.at[1], s0, s1);
    if (in0 != in1) {
        const int64_t t = steep_limit(e, sector, a, b, in1), s = s0 + edges_scale(s1 - s0, t);
        const edges_place_t c = place_at(a, b, t);
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

/* The sector of the middle of a-b: of the sum of its ends, for a unit from the eye half a unit may not be rounded. */
static int sector_of_middle(edges_place_t a, edges_place_t b) {
    const int64_t x = (int64_t)a.x + b.x, y = (int64_t)a.y + b.y;
    const int64_t ax = x < 0 ? -x : x, ay = y < 0 ? -y : y;
    return ax > ay ? (x > 0 ? 1 : 3) : (y > 0 ? 2 : 0);
}

int edges_clip_in_sector(edges_t *e, edges_place_t a, edges_place_t b, int64_t s0, int64_t s1) {
    const int sector = sector_of_middle(a, b);
    if ((a.z < 0) == (b.z < 0)) return clip_piece(e, sector, a, b, s0, s1);
    const int64_t t = parting(a.z, b.z), s = s0 + edges_scale(s1 - s0, t);
    edges_place_t level = place_at(a, b, t);
    level.z = 0;
    int err = clip_piece(e, sector, a, level, s0, s);
    return err != 0 ? err : clip_piece(e, sector, level, b, s, s1);
}

/* x + (y - x) * num / den, 0 <= num <= den < 2^32, |x|, |y| < 2^60. */
static int64_t between(int64_t x, int64_t y, int64_t num, int64_t den) {
    const int64_t d = y - x;
    return x + d / den * num + d % den * num / den;
}

static int clip_sectors(edges_t *e, edges_place_t p, edges_place_t q) {
    bool along_x = e->edge.family == INK_ROW;
    int32_t fixed = along_x ? p.y : p.x, v0 = along_x ? p.x : p.y, v1 = along_x ? q.x : q.y;
    int32_t side = (int32_t)size32(fixed), cuts = fixed == 0 ? 1 : 2;
    int64_t from_q46 = 0;
    edges_place_t from = p;
    for (int32_t c = 0; c < cuts; c++) {
        int32_t cut = c == 0 ? -side : side;
        if (cut <= v0 || cut >= v1) continue;
        int64_t part = (int64_t)cut - v0, way = (int64_t)v1 - v0;
        edges_place_t to = {along_x ? cut : p.x, along_x ? p.y : cut, between(p.z, q.z, part, way)};
        const int64_t to_q46 = edges_fraction((uint64_t)part, (uint64_t)way);
        int err = edges_clip_in_sector(e, from, to, from_q46, to_q46);
        if (err != 0) return err;
        from = to;
        from_q46 = to_q46;
    }
    return edges_clip_in_sector(e, from, q, from_q46, INK_GRID_ONE);
}

/* All parts are looked at before any of them covers: one that is vertical in the chart, as a cliff is close to the
 * level of the eye, would be hidden by the next one, which begins where it ends. */
int edges_clip_around(edges_t *e, edges_place_t p, edges_place_t q) {
    if (e->work != EDGES_CLIP || e->outline_only) return clip_sectors(e, p, q);
    e->work = EDGES_LOOK;
    int err = clip_sectors(e, p, q);
    e->work = EDGES_COVER;
    if (err == 0) err = clip_sectors(e, p, q);
    e->work = EDGES_CLIP;
    return err;
}
