/* sides.c - see sides.h. */
#include "hidden/surface/sides.h"

#define ONE_Q30 (INT32_C(1) << 30)

/* A corner of a cell: a line and a column. */
typedef struct corner {
    int line;
    int32_t i;
} corner_t;

/* End `end` of a side, 0 has the smaller index. */
static corner_t corner_of(int32_t i, int side, int end) {
    return side_is_column(side) ? (corner_t){end, i + side / 2} : (corner_t){side / 2, i + end};
}

static pencil_t at(const layer_t *l, corner_t c) {
    return l->line[c.line].at[c.i];
}

/* CHART_AROUND: where a corner is, relative to the eye. */
static int64_t z_at(const layer_t *l, corner_t c) {
    return l->line[c.line].z[c.i];
}
static int32_t x_at(const sweep_t *s, corner_t c) {
    return s->edges.chart.column[c.i].p;
}
static int32_t y_at(const layer_t *l, corner_t c) {
    return l->line[c.line].dy;
}

/* CHART_AROUND: how far two layers' heights may be apart and yet be meant to be equal. */
static int64_t noise_of(const sweep_t *s, const layer_t *l, const layer_t *m) {
    int bits = 0; /* of a unit of height */
    for (int k = 0; k < 2 && !s->edges.chart.tall; k++) {
        const grid_t *g = k ? m->grid : l->grid;
        const int unit = g->z_exp + s->edges.chart.z_bits;
        if (unit > bits && num_cmp(g->z_min, g->z_max) != 0) bits = unit;
    }
    return (int64_t)ENVELOPE_NOISE << (bits > 40 ? 40 : bits);
}

bool side_is_vertical(const sweep_t *s, const layer_t *l, int32_t i, int side) {
    return side_is_column(side) ? edges_column_is_vertical(&s->edges, &l->line[0], &l->line[1], i + side / 2)
                                : edges_row_is_vertical(&s->edges, &l->line[side / 2], i);
}

bool side_coincides(const sweep_t *s, const layer_t *l, const layer_t *m, int32_t i, int side) {
    const bool around = s->edges.chart.kind == CHART_AROUND;
    const int64_t noise = around ? noise_of(s, l, m) : ENVELOPE_NOISE;
    for (int end = 0; end < 2; end++) {
        const corner_t c = corner_of(i, side, end);
        if (l->line[c.line].hole[c.i] || m->line[c.line].hole[c.i]) return false;
        const int64_t apart = around ? z_at(l, c) - z_at(m, c) : (int64_t)at(l, c).w - at(m, c).w;
        if (apart > noise || apart < -noise) return false;
    }
    return true;
}

/* Turns an interval that counts from end 1 round. */
static shade_t turned(shade_t v, bool turn) {
    return turn ? (shade_t){ONE_Q30 - v.to_q30, ONE_Q30 - v.from_q30} : v;
}

static int32_t shade_around(const sweep_t *s, const layer_t *l, const layer_t *m, int32_t i, int side, shade_t out[2]) {
    int32_t d[2];
    int64_t k_z[2], m_z[2];
    const int64_t noise = noise_of(s, l, m);
    for (int end = 0; end < 2; end++) {
        const corner_t c = corner_of(i, side, end);
        d[end] = side_is_column(side) ? y_at(l, c) : x_at(s, c);
        k_z[end] = z_at(l, c);
        m_z[end] = z_at(m, c);
    }
    if (d[0] >= 0) {
        out[0] = shade_in_space(k_z, m_z, d, noise);
        return 1;
    }
    if (d[1] <= 0) {
        const int64_t k_back[2] = {k_z[1], k_z[0]}, m_back[2] = {m_z[1], m_z[0]};
        const int32_t d_back[2] = {-d[1], -d[0]};
        out[0] = turned(shade_in_space(k_back, m_back, d_back, noise), true);
        return 1;
    }
    /* It passes below the eye: two parts, each with its near end there. */
    const int32_t foot = (int32_t)pencil_fraction((uint32_t)-d[0], (uint64_t)((int64_t)d[1] - d[0]));
    const int64_t k_foot = edges_mix(k_z[0], k_z[1], foot), m_foot = edges_mix(m_z[0], m_z[1], foot);
    for (int end = 0; end < 2; end++) {
        const int64_t k_part[2] = {k_foot, k_z[end]}, m_part[2] = {m_foot, m_z[end]};
        const shade_t v = shade_in_space(k_part, m_part, (const int32_t[2]){0, end ? d[1] : -d[0]}, noise);
        const int32_t way = end ? ONE_Q30 - foot : -foot;
        const int32_t from = foot + (int32_t)(((int64_t)way * v.from_q30) >> 30);
        const int32_t to = foot + (int32_t)(((int64_t)way * v.to_q30) >> 30);
        out[end] = end ? (shade_t){from, to} : (shade_t){to, from};
    }
    return 2;
}

int32_t side_shade(const sweep_t *s, const layer_t *l, const layer_t *m, int32_t i, int side, shade_t out[2]) {
    const chart_t *c = &s->edges.chart;
    if (c->kind == CHART_AROUND) return shade_around(s, l, m, i, side, out);
    const bool turn = (side_is_column(side) ? c->side_y : c->side_x) > 0; /* end 1 is the near one */
    const corner_t near = corner_of(i, side, turn), far = corner_of(i, side, !turn);
    shade_t v =
        shade_in_chart((const pencil_t[2]){at(l, near), at(l, far)}, (const pencil_t[2]){at(m, near), at(m, far)});
    if (v.from_q30 >= v.to_q30) return 0;
    uint32_t g[2] = {1, 1}; /* reciprocal distances */
    if (side_is_column(side) && c->kind == CHART_NORTH) g[0] = l->line[near.line].r, g[1] = l->line[far.line].r;
    if (!side_is_column(side) && c->kind == CHART_EAST) g[0] = c->column[near.i].r, g[1] = c->column[far.i].r;
    v.from_q30 = (int32_t)(chart_unproject(v.from_q30, g[0], g[1]) >> 16);
    v.to_q30 = (int32_t)(chart_unproject(v.to_q30, g[0], g[1]) >> 16);
    out[0] = turned(v, turn);
    return 1;
}

near_edges_t side_near_edges(const chart_t *c, int32_t i, int far, bool fresh) {
    return (near_edges_t){
        .column = i > c->i0       ? i
                  : i < c->i0     ? i + 1
                  : c->side_x > 0 ? i + 1
                  : c->side_x < 0 ? i
                                  : -1,
        .line = !fresh          ? 1 - far
                : c->side_y > 0 ? 1
                : c->side_y < 0 ? 0
                                : -1,
    };
}

int side_outline(sweep_t *s, layer_t *l, int32_t i) {
    int err = 0;
    l->lines = 0;
    side_take_layer(s, l);
    s->edges.outline_only = true;
    for (int side = 0; side < SIDES && err == 0; side++) err = side_clip(s, l, i, side);
    s->edges.outline_only = false;
    if (s->edges.lines > OUTLINE_LINES) s->edges.lines = 0;
    l->lines = s->edges.lines;
    return err;
}
