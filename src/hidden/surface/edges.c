/* edges.c - clipping grid edges.
 *
 * Most edges are one line in the chart; for the others see edges_around.c. */
#include "hidden/surface/edges.h"

#include "hidden/surface/edges_parts.h"

/* The shade that hides the edge at `at`: moves at to its end and returns true; otherwise *next is where the next one
 * begins, no farther than it was. */
static bool in_shade(const edges_t *e, int64_t *at, int64_t *next) {
    for (int32_t k = 0; k < e->shades; k++) {
        const int64_t from = fine_of_q30(e->shade[k].from_q30), to = fine_of_q30(e->shade[k].to_q30);
        if (to <= *at || from >= to) continue;
        if (from <= *at) {
            *at = to;
            return true;
        }
        if (from < *next) *next = from;
    }
    return false;
}

/* Adds what of [from, to] lies in no shade. */
static int add_lit(edges_t *e, int64_t from, int64_t to) {
    const edges_edge_t *k = &e->edge;
    const int64_t base = k->cell * INK_GRID_ONE;
    while (from < to) {
        int64_t next = to;
        if (in_shade(e, &from, &next)) continue;
        int err = runs_add(&e->runs, k->run, k->family, k->line, base + from, base + next);
        if (err != 0) return err;
        from = next;
    }
    return 0;
}

/* Adds what of [from, to] has not been taken. */
static int add_new(edges_t *e, int64_t from, int64_t to) {
    const edges_taken_t whole = {from, to};
    while (from < to) {
        int64_t next = to;
        bool done = false;
        for (int32_t k = 0; k < e->edge.taken && !done; k++) {
            const edges_taken_t *t = &e->taken[k];
            if (t->to_q46 <= from) continue;
            done = t->from_q46 <= from;
            if (done) {
                from = t->to_q46;
            } else if (t->from_q46 < next) {
                next = t->from_q46;
            }
        }
        if (done) continue;
        int err = add_lit(e, from, next);
        if (err != 0) return err;
        from = next;
    }
    if (e->edge.taken < EDGES_TAKEN) e->taken[e->edge.taken++] = whole;
    return 0;
}

/* How far along the part that is being clipped a fraction of the chart is in space. */
static inline int64_t in_space(const edges_edge_t *k, int32_t at_q30) {
    if (at_q30 == 0) return 0;
    if (at_q30 == ONE_Q30) return k->way_q46;
    const int64_t at = chart_unproject(at_q30, k->g0, k->g1);
    return k->way_q46 == INK_GRID_ONE ? at : edges_scale(k->way_q46, at);
}

/* Places a part of the line on the edge in space. */
static int place_part(edges_t *e, int32_t from, int32_t to) {
    const edges_edge_t *k = &e->edge;
    const int64_t a = k->start_q46 + in_space(k, from), b = k->start_q46 + in_space(k, to);
    if (e->edge.taken > 0) return add_new(e, a, b);
    e->taken[e->edge.taken++] = (edges_taken_t){a, b};
    if (e->shades > 0) return add_lit(e, a, b);
    if (a >= b) return 0;
    const int64_t base = k->cell * INK_GRID_ONE;
    return runs_add(&e->runs, k->run, k->family, k->line, base + a, base + b);
}

int edges_take_part(void *ctx, envelope_part_t part, bool first) {
    edges_t *e = ctx;
    int32_t from = part.from_q30;
    (void)first;
    if (e->edge.quiet) return 0;
    if (e->behinds == 0) return place_part(e, from, part.to_q30);
    for (int32_t k = 0; k < e->behinds && from < part.to_q30; k++) {
        const windows_part_t *b = &e->behind[k];
        if (b->to_q30 <= from) continue;
        if (b->from_q30 > from) {
            int err = place_part(e, from, pencil_min(b->from_q30, part.to_q30));
            if (err != 0) return err;
        }
        from = b->to_q30;
    }
    return from < part.to_q30 ? place_part(e, from, part.to_q30) : 0;
}

int edges_take_unseen(edges_t *e, int64_t s0, int64_t s1) {
    e->edge.start_q46 = s0;
    e->edge.way_q46 = s1 - s0;
    if (e->outline_only || e->work == EDGES_COVER) return 0;
    if (e->cover == COVER_STRIP && !e->strip.first) return 0;
    return edges_take_part(e, (envelope_part_t){.to_q30 = ONE_Q30}, false);
}

/* Of a line that was cut to the strip. */
static int take_in_strip(void *ctx, envelope_part_t part, bool first) {
    const edges_t *e = ctx;
    return strip_keep(&e->strip, &part) ? edges_take_part(ctx, part, first) : 0;
}

bool edges_facet_is_right(const edges_t *e, pencil_t p0, pencil_t p1) {
    const int32_t lo = pencil_min(p0.a, p1.a) - 1, hi = pencil_max(p0.a, p1.a) + 1;
    for (int32_t k = 0; k < e->lines; k++) {
        const outline_line_t *s = &e->outline[k];
        if (s->p.a >= lo && s->p.a <= hi && s->q.a > hi) return true;
    }
    return false;
}

/* Is the edge at hand in a vertical plane through the eye, so that both sides bound it? A row is also if it is so only
 * nearly: rows are swept outward, so the side that is away from the eye has not been covered yet, and does not count.
 * Of a column both sides have been. */
static bool is_in_plane_of_eye(const edges_t *e) {
    const edges_edge_t *k = &e->edge;
    if (k->family == INK_CURVE) return false;
    return k->family == INK_ROW ? k->in_plane : chart_column_has_eye(&e->chart, k->line);
}

int edges_clip_line(edges_t *e, pencil_t p0, pencil_t p1) {
    if (e->chart.kind == CHART_VERTICAL) return edges_take_unseen(e, 0, INK_GRID_ONE);
    if (envelope_vertical(p0, p1)) e->horizons.in_plane = is_in_plane_of_eye(e);
    if (e->cover == COVER_STRIP && !strip_cut(&e->strip, &p0, &p1)) return 0;
    if (e->cover != COVER_WINDOWS && e->work != EDGES_COVER)
        return e->work == EDGES_LOOK ? horizons_look(&e->horizons, p0, p1) : horizons_clip(&e->horizons, p0, p1);
    if (e->cover != COVER_WINDOWS) {
        if (p0.a == p1.a) return 0;
        return p0.a < p1.a ? horizons_raise(&e->horizons, p0, p1) : horizons_raise(&e->horizons, p1, p0);
    }
    if (!e->outline_only) return edges_clip_windowed(e, p0, p1);
    if (p0.a == p1.a) return 0;
    if (e->lines < OUTLINE_LINES)
        e->outline[e->lines] = p0.a < p1.a ? (outline_line_t){p0, p1} : (outline_line_t){p1, p0};
    e->lines++;
    return 0;
}

/* Stretches for lowest.h, as a power of two: so many to a column, if that takes a small part of the memory; or -1. */
#define LOWEST_PER_COLUMN (CONFIG_64BIT ? 8 : 4)
#define LOWEST_PART (CONFIG_64BIT ? 8 : 16)
#define LOWEST_VERTICES(bits) ((((size_t)2 * sizeof(uint16_t)) << (bits)) / sizeof(pencil_t))

static int lowest_bits(int32_t columns, size_t vertices) {
    int bits = 1;
    while (bits < 24 && INT64_C(1) << bits < (int64_t)LOWEST_PER_COLUMN * columns) bits++;
    return LOWEST_VERTICES(bits) <= vertices / LOWEST_PART ? bits : -1;
}

int edges_init(edges_t *e, const ink_sink_t *sink, enum edges_cover cover, int8_t seen, pencil_t *pool, size_t count) {
    const bool windows = cover == COVER_WINDOWS;
    const bool upper = windows || seen >= 0, lower = windows || seen <= 0;
    e->runs = (runs_t){.sink = sink};
    e->cover = cover;
    if (windows) {
        count /= 2;
        const int32_t n = pencil_max(e->chart.grid->nx, e->chart.grid->ny);
        int err = windows_init(&e->windows, n, pool, count * sizeof *pool);
        if (err != 0) return err;
        pool += count;
    }
    int bits = windows || !CONFIG_LOWEST ? -1 : lowest_bits(e->chart.grid->nx, count);
    size_t lent = bits < 0 ? 0 : LOWEST_VERTICES(bits);
    int err = horizons_init(&e->horizons, upper, lower, pool + lent, count - lent,
                            cover == COVER_STRIP ? take_in_strip : edges_take_part, e);
    if (windows) {
        envelope_lend(&e->horizons.upper, &e->windows.spare);
        e->windows.above = &e->horizons.upper;
    }
    if (lent) horizons_lend(&e->horizons, (uint16_t *)(void *)pool, bits);
    return err;
}

/* The common case without a call more. */
static inline int clip_line(edges_t *e, pencil_t p0, pencil_t p1) {
    if (e->cover == COVER_HORIZONS && !envelope_vertical(p0, p1)) return horizons_clip(&e->horizons, p0, p1);
    return edges_clip_line(e, p0, p1);
}

/* `across` is the edge's constant distance from the eye in CHART_AROUND: an edge that is several lines there is
 * vertical only if it passes under the eye, or so close to that that its far part is. */
static bool is_vertical(const edges_t *e, pencil_t p0, pencil_t p1, const int32_t *across) {
    if (e->chart.kind == CHART_AROUND && !edges_is_straight(p0, p1)) return pencil_abs(*across) <= CHART_IN_PLANE;
    return envelope_vertical(p0, p1);
}

bool edges_row_is_vertical(const edges_t *e, const chart_line_t *line, int32_t i) {
    return is_vertical(e, line->at[i], line->at[i + 1], &line->dy);
}

bool edges_column_is_vertical(const edges_t *e, const chart_line_t *line, const chart_line_t *next, int32_t i) {
    return is_vertical(e, line->at[i], next->at[i], &e->chart.column[i].p);
}

/* Once or twice a facet: field by field, where an initialiser would be a call of memset. */
static inline void begin_edge(edges_edge_t *k, uint8_t family, int32_t line, int32_t cell, run_t *run) {
    k->family = family;
    k->in_plane = k->quiet = false;
    k->line = line;
    k->cell = cell;
    k->run = run;
    k->g0 = k->g1 = 1;
    k->start_q46 = 0;
    k->way_q46 = INK_GRID_ONE;
    k->taken = 0;
}

int edges_row(edges_t *e, const chart_line_t *line, int32_t i, run_t *run) {
    pencil_t p0 = line->at[i], p1 = line->at[i + 1];
    const chart_column_t *c = e->chart.column;
    begin_edge(&e->edge, INK_ROW, line->j, i, run);
    e->edge.in_plane = line->in_plane;
    e->clipped += !e->outline_only && e->work != EDGES_COVER;
    if (e->chart.kind == CHART_EAST) {
        e->edge.g0 = c[i].r;
        e->edge.g1 = c[i + 1].r;
    } else if (e->chart.kind == CHART_AROUND) {
        if (!edges_is_straight(p0, p1)) {
            return edges_clip_around(e, (edges_place_t){c[i].p, line->dy, line->z[i]},
                                     (edges_place_t){c[i + 1].p, line->dy, line->z[i + 1]});
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
    begin_edge(&e->edge, INK_COL, i, line->j, run);
    e->clipped += !e->outline_only && e->work != EDGES_COVER;
    if (e->chart.kind == CHART_NORTH) {
        e->edge.g0 = line->r;
        e->edge.g1 = next->r;
    } else if (e->chart.kind == CHART_AROUND) {
        if (!edges_is_straight(p0, p1)) {
            return edges_clip_around(e, (edges_place_t){c[i].p, line->dy, line->z[i]},
                                     (edges_place_t){c[i].p, next->dy, next->z[i]});
        }
        if (!(chart_sector_at(pencil_min(p0.a, p1.a)) & 1)) {
            e->edge.g0 = size32(next->dy);
            e->edge.g1 = size32(line->dy);
        }
    }
    return clip_line(e, p0, p1);
}
