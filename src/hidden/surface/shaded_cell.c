/* shaded_cell.c - see shaded_cell.h. */
#include "hidden/surface/shaded_cell.h"

#include "num/ints.h"

#if CONFIG_AREA

const shaded_vertex_t *shaded_row(shaded_t *s, const layer_t *l, int32_t j) {
    const int32_t n = 2 * l->surface + (j & 1);
    shaded_vertex_t *row = s->row + (size_t)n * (size_t)s->nx;
    const line_space_t *space = &s->lines[l->surface];
    if (s->row_j[n] == j) return row;
    for (int32_t i = 0; i < s->nx; i++) {
        shaded_vertex_t *v = &row[i];
        v->good = grid_height(l->grid, i, j, &v->z) && space->at(space->ctx, INK_ROW, j, i * INK_GRID_ONE, &v->h);
        if (!space->perspective) v->h.e = (int64_t)1 << space->frac_bits;
        if (v->good && v->h.e < space->near_e) v->good = false;
    }
    s->row_j[n] = j;
    return row;
}

bool shaded_place(const shaded_t *s, const shaded_vertex_t *const v[4], poly_point_t page[4]) {
    const int64_t one = (int64_t)1 << s->hatch->bits;
    for (int k = 0; k < 4; k++) {
        const page_h_t *h = &v[k]->h;
        if (!v[k]->good) return false;
        int64_t x = ints_muldiv_round(h->x, one, h->e), y = ints_muldiv_round(h->y, one, h->e);
        if (x > POLY_LIMIT || x < -POLY_LIMIT || y > POLY_LIMIT || y < -POLY_LIMIT) return false;
        page[k] = (poly_point_t){(int32_t)x, (int32_t)y};
    }
    return true;
}

int64_t shaded_area2(const poly_point_t p[4]) {
    return poly_orient(p[0], p[1], p[2]) + poly_orient(p[0], p[2], p[3]);
}

/* Does a facet that runs round the page so show its upper side? */
static bool shows_upper(const shaded_t *s, int64_t area2) {
    const num_t *unit = s->cam->unit;
    return (area2 > 0) != (num_sign(unit[0]) * num_sign(unit[1]) * num_sign(unit[2]) < 0);
}

void shaded_chart(shaded_cell_t *f, const chart_t *c, const layer_t *l, int32_t i) {
    f->around = c->kind == CHART_AROUND;
    for (int k = 0; k < 4; k++) {
        const int32_t col = i + (k == 1 || k == 2);
        const chart_line_t *line = &l->line[k >= 2];
        f->at[k] = line->at[col];
        f->g[k] = c->kind == CHART_NORTH ? line->r : c->kind == CHART_EAST ? c->column[col].r : 1;
        if (!f->around) continue;
        f->x[k] = c->column[col].p;
        f->y[k] = line->dy;
        f->z[k] = line->z[col];
    }
}

void shaded_others(shaded_t *s, shaded_cell_t *f, const sweep_t *sw, const layer_t *l, int32_t i) {
    uint32_t most = 1;
    for (int k = 0; k < 4; k++) most = f->g[k] > most ? f->g[k] : most;
    for (int32_t m = 0; m < sw->layers && sw->layers > 1; m++) {
        const layer_t *o = &sw->layer[m];
        if (o == l || !o->present) continue;
        shaded_other_t *other = &f->other[f->others++];
        const shaded_vertex_t *row[2] = {shaded_row(s, o, o->line[0].j), shaded_row(s, o, o->line[1].j)};
        const shaded_vertex_t *const v[4] = {&row[0][i], &row[0][i + 1], &row[1][i + 1], &row[1][i]};
        poly_point_t page[4];
        other->layer = o;
        other->upper = shaded_place(s, v, page) && shows_upper(s, shaded_area2(page));
        for (int k = 0; k < 4; k++) {
            const int32_t col = i + (k == 1 || k == 2);
            const chart_line_t *line = &o->line[k >= 2];
            other->above[k] = f->around ? line->z[col] - f->z[k]
                                        : ints_muldiv_round((int64_t)line->at[col].w - f->at[k].w, most, f->g[k]);
        }
    }
}

bool shaded_is_hidden(const sweep_t *sw, const shaded_cell_t *f) {
    horizons_t *h = (horizons_t *)(uintptr_t)&sw->edges.horizons;
    pencil_t lo = f->at[0], hi = lo;
    if (sw->edges.chart.kind > CHART_EAST || sw->edges.cover != COVER_HORIZONS) return false;
    for (int k = 1; k < 4; k++) {
        lo = (pencil_t){pencil_min(lo.a, f->at[k].a), pencil_min(lo.w, f->at[k].w)};
        hi = (pencil_t){pencil_max(hi.a, f->at[k].a), pencil_max(hi.w, f->at[k].w)};
    }
    return (!h->has_upper || envelope_hides(&h->upper, lo.a, hi.a, hi.w)) &&
           (!h->has_lower || envelope_hides(&h->lower, lo.a, hi.a, -lo.w));
}

#endif
