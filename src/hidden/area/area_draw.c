/* area_draw.c - visible edges from visible polygons: where one ends in an edge of the scene, the edge is visible. */
#include "config.h"
#include "hidden/area/area.h"
#include "hidden/area/area_detail.h"
#include "hidden/area/area_face.h"
#include "hidden/area/area_tone.h"
#include "hidden/intervals.h"
#include "hidden/line_class.h"

#include "error.h"
#include "num/ints.h"

#if CONFIG_AREA

/* Of the memory, in eighths: to the parts of lines, and with hatching to the toner; the sort gets the rest. */
enum { SHARES = 8, INTERVALS_SHARES = 2, TONE_SHARES = 3, SHADED_SORT_SHARES = 3, SHADED_TONE_SHARES = 2 };
/* The same for hatch lines, where shadows end at the border of a face only within what rounding leaves. */
#define HATCH_LEAST_LAT (LAT_PER_MM / 10)
/* Gaps up to this in an edge are closed and parts no longer left out (2^-5 lat on the finest lattice): where areas were
 * cut, edges have moved by about as much. */
#define LEAST_LAT 64

typedef struct edge_ink {
    area_lattice_t lattice;
    intervals_t parts;   /* what is seen: edges and hatch lines */
    intervals_t through; /* what can be seen of edges, if not only through what is translucent */
    intervals_t *edges;  /* where those of this pass go */
    bool clear;          /* the second pass: the first has hatched what is not translucent */
    const ink_sink_t *sink;
    hidden_stats_t *stats;
    area_toner_t *toner; /* NULL: no hatching */
    const area_tone_t *tone;
} edge_ink_t;

/* The edge's way on the page along its longer axis, as a place of the first end and a signed length. */
static int32_t along(const poly_point_t end[2], poly_point_t p, int64_t *length) {
    int64_t dx = end[1].x - end[0].x, dy = end[1].y - end[0].y;
    bool wide = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
    *length = wide ? dx : dy;
    return wide ? p.x - end[0].x : p.y - end[0].y;
}

/* The parameter on the page of a point on (or next to) an edge. Near an end it is that end, so that lines which meet in
 * a vertex do. */
static int32_t parameter(const poly_point_t end[2], poly_point_t p) {
    int64_t length, at = along(end, p, &length);
    if (length < 0) at = -at, length = -length;
    if (length == 0 || at <= 2) return 0;
    if (at >= length - 2) return (int32_t)INK_ONE;
    return (int32_t)(at * INK_ONE / length);
}

/* Lines of the intervals: edges, details, then those of the hatching. */
static int32_t hatch_first(const edge_ink_t *ink) {
    return ink->lattice.m->solid->ne + ink->lattice.m->solid->nd;
}

static int take_polygon(void *ctx, int32_t face, const poly_t *p) {
    edge_ink_t *ink = ctx;
    int err = area_details(&ink->lattice, face, p, ink->edges);
    if (err) return err;
    if (ink->toner && (!ink->clear || solid_is_clear(ink->lattice.m->solid, face))) {
        err = area_toner_polygon(ink->toner, face, p, hatch_first(ink), &ink->parts);
        if (err) return err;
    }
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int32_t k = first; k < p->end[c]; k++) {
            area_edge_t e;
            if (p->v[k].tag < 0 || !area_edge(&ink->lattice, p->v[k].tag, &e)) continue;
            int32_t a = parameter(e.end, p->v[k].at), b = parameter(e.end, p->v[k + 1 < p->end[c] ? k + 1 : first].at);
            err = intervals_add(ink->edges, p->v[k].tag, a < b ? a : b, a < b ? b : a);
            if (err) return err;
        }
    return 0;
}

static int take_wire(void *ctx, int32_t edge, int32_t from_q30, int32_t to_q30) {
    edge_ink_t *ink = ctx;
    return intervals_add(ink->edges, edge, from_q30, to_q30);
}

static void forget(void *ctx, int32_t edge) {
    edge_ink_t *ink = ctx;
    intervals_drop(ink->edges, edge);
}

static int32_t least(void *ctx, int32_t line) {
    edge_ink_t *ink = ctx;
    area_edge_t e;
    int64_t length, some = (int64_t)LEAST_LAT << ink->lattice.bits >> AREA_LATTICE_BITS;
    if (line >= hatch_first(ink))
        return (int32_t)(HATCH_LEAST_LAT * INK_ONE / (2 * (int64_t)ink->tone->hatch->reach_lat));
    if (!area_edge(&ink->lattice, line, &e)) return 0;
    along(e.end, (poly_point_t){0, 0}, &length);
    if (length < 0) length = -length;
    return length <= some ? (int32_t)INK_ONE - 1 : (int32_t)(some * INK_ONE / length);
}

static int emit(void *ctx, const interval_t *part) {
    edge_ink_t *ink = ctx;
    if (part->line >= hatch_first(ink)) {
        const ink_piece_t stroke = {INK_CURVE, LINE_HATCH, part->line - hatch_first(ink), part->from_q30, part->to_q30};
        ink->stats->pieces++;
        return ink->sink->piece(ink->sink->ctx, &stroke);
    }
    area_edge_t e;
    if (!area_edge(&ink->lattice, part->line, &e)) return 0;
    const ink_piece_t piece = {.family = INK_SEGMENT,
                               .surface = part->line < ink->lattice.m->solid->ne ? 0 : LINE_DETAIL,
                               .line = part->line,
                               .from = area_space(&ink->lattice, &e, part->from_q30),
                               .to = area_space(&ink->lattice, &e, part->to_q30)};
    if (piece.from >= piece.to) return 0;
    ink->stats->pieces++;
    return ink->sink->piece(ink->sink->ctx, &piece);
}

static int emit_borders(edge_ink_t *ink) {
    borders_t *b = ink->tone->borders;
    borders_settle(b);
    for (int32_t k = 0; k < b->n; k++) {
        const ink_piece_t piece = {INK_CURVE, LINE_SHADOW, k, 0, INK_ONE};
        ink->stats->pieces++;
        int err = ink->sink->piece(ink->sink->ctx, &piece);
        if (err) return err;
    }
    return 0;
}

/* What goes to the sort and to the toner. With shadows both have much that is there for every face whatever comes, so
 * each gets that first, and its share of what is left. */
static void divide(const solid_map_t *m, const area_tone_t *tone, size_t bytes, size_t *sort, size_t *toner) {
    size_t part = bytes / SHARES & ~(size_t)7;
    *toner = tone ? part * TONE_SHARES : 0;
    if (tone && !tone->shadow && area_toner_bytes(m) < *toner) *toner = area_toner_bytes(m);
    *sort = part * (SHARES - INTERVALS_SHARES) - *toner;
    if (!tone || !tone->shadow) return;
    const size_t sorts = area_fixed_bytes(m), tones = area_toner_fixed(m, tone);
    if (sorts + tones >= bytes) return;
    part = (bytes - sorts - tones) / SHARES;
    *sort = (sorts + part * SHADED_SORT_SHARES) & ~(size_t)7;
    *toner = (tones + part * SHADED_TONE_SHARES) & ~(size_t)7;
}

static bool has_clear(const solid_t *s) {
    for (int32_t o = 0; o < s->no; o++)
        if (s->object[o].clear) return true;
    return false;
}

int area_draw(const solid_map_t *m, const area_tone_t *tone, const ink_sink_t *behind, const hidden_job_t *job,
              hidden_stats_t *stats, area_stats_t *area) {
    *stats = (hidden_stats_t){.edges = m->solid->ne};
    edge_ink_t ink = {.lattice = area_lattice(m), .sink = job->sink, .stats = stats, .tone = tone};
    ink.clear = behind && has_clear(m->solid);
    size_t sorted = 0, sort_bytes, tone_bytes;
    divide(m, tone, job->bytes, &sort_bytes, &tone_bytes);
    const size_t part = (job->bytes - sort_bytes - tone_bytes) / (ink.clear ? 2 : 1) & ~(size_t)7;
    uint8_t *mem = job->mem, *intervals = mem + sort_bytes + tone_bytes;
    intervals_init(&ink.parts, intervals, part);
    intervals_init(&ink.through, intervals + part, ink.clear ? part : 0);
    int err = 0;
    if (tone) err = area_toner_make(&ink.toner, tone, m, mem + sort_bytes, tone_bytes, mem, sort_bytes);
    const area_sink_t sink = {.ctx = &ink,
                              .polygon = take_polygon,
                              .wire = take_wire,
                              .again = forget,
                              .overlap = tone && tone->shadow && tone->borders};
    if (!err && ink.clear) { /* all that is seen as if nothing translucent were there */
        solid_map_t through = *m;
        through.through = true;
        ink.edges = &ink.through;
        ink.clear = false;
        err = area_sort(&through, mem, sort_bytes, &sink, NULL, NULL, area);
        sorted = area->bytes;
        ink.clear = true;
    }
    ink.edges = &ink.parts;
    if (!err) err = area_sort(m, mem, sort_bytes, &sink, job->tick, job->tick_ctx, area);
    if (tone && !err && area_toner_intersections(ink.toner) > area->intersections)
        area->intersections = area_toner_intersections(ink.toner);
    stats->facets = area->polygons;
    const interval_use_t use = {&ink, least, emit};
    if (!err) err = intervals_finish(&ink.parts, &use);
    if (!err && tone && tone->borders) err = emit_borders(&ink);
    if (!err && ink.clear) {
        ink.sink = behind;
        err = intervals_less(&ink.through, &ink.parts, &use);
    }
    stats->bytes = (area->bytes > sorted ? area->bytes : sorted) + (ink.toner ? area_toner_used(ink.toner) : 0) +
                   ((size_t)ink.parts.most + (size_t)ink.through.most) * sizeof(interval_t);
    return err;
}

#endif
