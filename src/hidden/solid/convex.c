/* convex.c - see convex.h: each edge in turn, what is left of it after each shadow near it. */
#include "hidden/solid/convex.h"

#include "error.h"
#include "hidden/solid/page_grid.h"
#include "hidden/solid/shadow.h"

#define PARTS_LEAST 16 /* visible parts of one edge there is room for at least */
#define OFF 2          /* lat, and units of depth: places are rounded */
#define NEAR_MOST 32   /* shadows near an object that are remembered while its edges are drawn */
#define FEW_MOST 16    /* so many shadows are looked through without a grid, */
#define FEW_ONCE 128   /* and so many where that is done once for an object */

/* A visible part of the edge at hand: parameters. */
typedef struct part {
    int32_t from, to;
} part_t;

typedef struct drawing {
    const solid_map_t *map;
    const ink_sink_t *sink, *hidden;
    hidden_stats_t *stats;
    shadows_t shadows;
    page_grid_t grid; /* not there (start) where shadows are few */
    part_t *part;     /* in order, disjoint */
    int32_t parts, parts_max;
    int32_t edge;     /* at hand */
    int32_t owner[2]; /* what its first two faces belong to (shadow.h) does not hide it */
    shadow_line_t line;
    page_box_t box; /* of the line's picture, and two lat for rounding */
    int32_t z;      /* its farthest depth, and as much */
    int32_t *near;  /* shadows that may hide edges of the one in `near_of` */
    int32_t nears;  /* of them; -1: too many */
    int32_t nears_max;
    int32_t near_of; /* owner, or INT32_MAX */
    bool full;
} drawing_t;

size_t convex_bytes(int32_t faces, int32_t corners, int32_t segments) {
    (void)segments;
    const int32_t nears = corners < FEW_ONCE ? corners : FEW_ONCE;
    return SHADOW_BYTES(faces, corners) + ((size_t)corners * 9 + (size_t)nears) * sizeof(int32_t) +
           PARTS_LEAST * sizeof(part_t) + 256;
}

static page_box_t shadow_box(void *ctx, int32_t k) {
    const shadow_t *s = &((const shadows_t *)ctx)->list[k];
    return (page_box_t){s->x0, s->y0, s->x1, s->y1};
}

/* Takes an interval off the parts that are left. */
static void take_off(drawing_t *d, int32_t from, int32_t to) {
    int32_t n = 0;
    for (int32_t k = 0; k < d->parts; k++) {
        part_t p = d->part[k];
        if (p.to <= from || p.from >= to) {
            d->part[n++] = p;
        } else if (p.from < from && to < p.to) { /* two of one, once in a walk: intervals are connected */
            if (d->parts == d->parts_max) {
                d->full = true;
                return;
            }
            for (int32_t i = d->parts++; i > k + 1; i--) d->part[i] = d->part[i - 1];
            d->part[k] = (part_t){p.from, from};
            d->part[k + 1] = (part_t){to, p.to};
            return;
        } else if (p.from < from) {
            d->part[n++] = (part_t){p.from, from};
        } else if (to < p.to) {
            d->part[n++] = (part_t){to, p.to};
        }
    }
    d->parts = n;
}

/* The signs of four differences of 31 bits at once: which of them it is nobody can predict. */
static inline bool is_apart(const page_box_t *b, const shadow_t *s) {
    return ((s->x1 - b->x0) | (b->x1 - s->x0) | (s->y1 - b->y0) | (b->y1 - s->y0)) < 0;
}

/* May it hide a part of the line? Else it is beside it, or all of it is behind. */
static inline bool is_near(const drawing_t *d, const shadow_t *s) {
    return !(is_apart(&d->box, s) | (s->z > d->z));
}

/* False: nothing is left, or there is no room. */
static bool compare(drawing_t *d, const shadow_t *s) {
    int32_t from, to;
    if (s->owner == d->owner[0] || s->owner == d->owner[1]) return true;
    d->stats->tests++;
    if (!shadow_hides(&d->shadows, s, &d->line, &from, &to)) return true;
    d->stats->crossings++;
    take_off(d, from, to);
    return d->parts > 0 && !d->full;
}

static bool compare_all(void *ctx, const int32_t *from, const int32_t *end) {
    drawing_t *d = ctx;
    for (; from < end; from++) {
        shadow_t *s = &d->shadows.list[*from];
        if (s->seen == d->edge) continue;
        s->seen = d->edge;
        if (is_near(d, s) && !compare(d, s)) return false;
    }
    return true;
}

/* False: there is no room. */
static bool note(drawing_t *d, int32_t k) {
    const shadow_t *s = &d->shadows.list[k];
    if (!is_near(d, s) || s->owner == d->owner[0]) return true;
    if (d->nears == d->nears_max) return false;
    d->near[d->nears++] = k;
    return true;
}

/* Notes those that may hide edges of the object whose box and farthest depth are at hand; false: too many. */
static bool note_all(void *ctx, const int32_t *from, const int32_t *end) {
    drawing_t *d = ctx;
    for (; from < end; from++) {
        shadow_t *s = &d->shadows.list[*from];
        if (s->seen == ~d->edge) continue;
        s->seen = ~d->edge;
        if (!note(d, *from)) return false;
    }
    return true;
}

/* Finds the few shadows near the whole object that the edge at hand belongs to, once for all of its edges. */
static void find_near(drawing_t *d) {
    const shadow_t *own = &d->shadows.list[d->shadows.part[~d->owner[0]]];
    d->box = (page_box_t){own->x0 - OFF, own->y0 - OFF, own->x1 + OFF, own->y1 + OFF};
    d->z = own->far < INT32_MAX - OFF ? own->far + OFF : INT32_MAX;
    d->near_of = d->owner[0];
    d->nears = 0;
    if (!d->grid.start) {
        for (int32_t k = 0; k < d->shadows.n; k++) note(d, k);
    } else if (!page_grid_visit(&d->grid, &d->box, note_all, d)) {
        d->nears = -1;
    }
}

/* Is it where nothing is drawn? */
static bool is_off_page(const solid_map_t *m, const page_box_t *b) {
    const page_window_t *w = m->lines.window;
    return !m->lines.all_inside && (b->x1 < w->x0_lat || b->x0 > w->x1_lat || b->y1 < w->y0_lat || b->y0 > w->y1_lat);
}

static void set_box(drawing_t *d, int32_t off_lat) {
    const solid_place_t *a = &d->line.end[0], *b = &d->line.end[1];
    const int32_t off = off_lat + OFF;
    d->box.x0 = (a->x < b->x ? a->x : b->x) - off;
    d->box.y0 = (a->y < b->y ? a->y : b->y) - off;
    d->box.x1 = (a->x < b->x ? b->x : a->x) + off;
    d->box.y1 = (a->y < b->y ? b->y : a->y) + off;
    d->z = (a->z > b->z ? a->z : b->z) + OFF;
}

/* Takes off what is hidden of the edge at hand. */
static void hide(drawing_t *d, int32_t off_lat) {
    const bool whole = CONFIG_MANY_BODIES && d->owner[0] < 0 && d->owner[0] == d->owner[1];
    if (whole && d->near_of != d->owner[0]) find_near(d);
    if (whole && d->nears == 0) return;
    set_box(d, off_lat);
    if (is_off_page(d->map, &d->box)) return;
    if (CONFIG_MANY_BODIES && d->grid.start && !(whole && d->nears > 0)) {
        page_grid_walk(&d->grid, &d->line.end[0], &d->line.end[1], off_lat, compare_all, d);
        return;
    }
    const int32_t n = whole ? d->nears : d->shadows.n;
    for (int32_t k = 0; k < n; k++) {
        const int32_t at = whole ? d->near[k] : k;
        const shadow_t *s = &d->shadows.list[at];
        if (!is_near(d, s) || compare(d, s)) continue;
        if (whole) { /* likely to hide all of its neighbours, too */
            d->near[k] = d->near[0];
            d->near[0] = at;
        }
        return;
    }
}

static int emit(drawing_t *d, const ink_sink_t *sink, int32_t from, int32_t to) {
    if (from >= to) return 0;
    const ink_piece_t piece = {INK_SEGMENT, 0, d->edge, from, to};
    d->stats->pieces += sink == d->sink;
    return sink->piece(sink->ctx, &piece);
}

static int emit_parts(drawing_t *d, int32_t from, int32_t to) {
    int32_t at = from;
    for (int32_t k = 0; k < d->parts; k++) {
        int err = d->hidden ? emit(d, d->hidden, at, d->part[k].from) : 0;
        if (!err) err = emit(d, d->sink, d->part[k].from, d->part[k].to);
        if (err) return err;
        at = d->part[k].to;
    }
    return d->hidden ? emit(d, d->hidden, at, to) : 0;
}

/* Is it between faces of smooth surfaces, and no outline of one? */
static bool is_left_out(const drawing_t *d, int32_t edge) {
    const solid_t *s = d->map->solid;
    for (int32_t k = edge; k >= 0; k = s->edge[k].twin) {
        const solid_edge_t *e = &s->edge[k];
        if (e->face[0] < 0 || !(d->shadows.face[e->face[0]] & SHADOW_SMOOTH) || !solid_is_smooth(s, e) ||
            shadows_is_outline(&d->shadows, e))
            return false;
    }
    return true;
}

/* What becomes of an edge. */
enum fate {
    NO_LINE,
    DROPPED, /* one of the objects that share it hides it by itself */
    LINE,
};

static enum fate fate_of(const drawing_t *d, int32_t edge) {
    const solid_edge_t *all = d->map->solid->edge, *e = &all[edge];
    if (e->first != edge || solid_is_cut(d->map->solid, e) || is_left_out(d, edge)) return NO_LINE;
    for (int32_t k = edge; k >= 0; k = all[k].twin)
        if (!shadows_is_candidate(&d->shadows, &all[k])) return DROPPED;
    return LINE;
}

/* Between two faces of one whole object, as most edges are? */
static inline bool is_plain_edge(const drawing_t *d, int32_t edge) {
    const solid_edge_t *e = &d->map->solid->edge[edge];
    return CONFIG_MANY_BODIES && e->twin < 0 && e->first == edge && e->face[0] >= 0 && e->face[1] >= 0 &&
           e->face[0] != e->face[1] && (d->shadows.face[e->face[0]] & (SHADOW_WHOLE | SHADOW_SMOOTH)) == SHADOW_WHOLE;
}

static int draw_edge(drawing_t *d, int32_t edge) {
    const solid_map_t *m = d->map;
    const solid_edge_t *e = &m->solid->edge[edge];
    const uint8_t *face = d->shadows.face;
    const bool plain = is_plain_edge(d, edge);
    const enum fate fate =
        plain ? (face[e->face[0]] | face[e->face[1]]) & SHADOW_FRONT ? LINE : DROPPED : fate_of(d, edge);
    if (fate == NO_LINE) return 0;
    d->stats->edges++;
    if (fate == DROPPED && !d->hidden) return 0;
    int64_t t_q30[2] = {0, INK_ONE};
    int32_t off_lat = 0;
    shadow_line_t *line = &d->line;
    line->exact = false;
    if (m->all_good) {
        line->end[0] = m->place[e->v[0]];
        line->end[1] = m->place[e->v[1]];
    } else {
        if (!solid_map_edge(m, edge, line->end, t_q30, &off_lat)) return 0;
        line->exact = !solid_map_is_good(m, e->v[0]) || !solid_map_is_good(m, e->v[1]);
    }
    if (line->end[0].x == line->end[1].x && line->end[0].y == line->end[1].y) return 0; /* end-on */
    d->edge = edge;
    d->parts = 0;
    if (fate == LINE) {
        for (int k = 0; k < 2; k++)
            d->owner[k] = k && plain       ? d->owner[0]
                          : e->face[k] < 0 ? INT32_MAX
                                           : shadows_owner(&d->shadows, e->face[k]);
        line->v[0] = e->v[0];
        line->v[1] = e->v[1];
        d->part[0] = (part_t){(int32_t)t_q30[0], (int32_t)t_q30[1]};
        d->parts = 1;
        hide(d, off_lat);
        if (d->full) return ERR_FULL;
    }
    return emit_parts(d, (int32_t)t_q30[0], (int32_t)t_q30[1]);
}

/* Are shadows so few that all are looked through? If they all are whole objects', and hardly any edge is not theirs,
 * that is done once for an object. */
static bool are_few(const shadows_t *s) {
    const solid_t *solid = s->map->solid;
    const bool once = s->n == s->whole && solid->ne - solid->nc / 2 <= solid->ne / 16;
    return !CONFIG_MANY_BODIES || s->n <= (once ? FEW_ONCE : FEW_MOST);
}

/* Divides the memory: shadows, those near, room for parts, the grid; what the grid leaves goes to parts too. */
static int set_up(drawing_t *d, const hidden_job_t *job) {
    int err = shadows_build(&d->shadows, d->map, job->mem, job->bytes);
    if (err) return err;
    const bool few = are_few(&d->shadows);
    const int32_t most = few ? (d->shadows.n + 1) & ~1 : NEAR_MOST;
    uint8_t *at = (uint8_t *)job->mem + d->shadows.bytes;
    size_t left = job->bytes - d->shadows.bytes, used = CONFIG_MANY_BODIES ? (size_t)most * sizeof(int32_t) : 0;
    const size_t least = PARTS_LEAST * sizeof(part_t);
    if (left < used + least) return ERR_FULL;
    d->near = (int32_t *)(void *)at;
    d->near_of = INT32_MAX;
    d->nears_max = most;
    if (!few) {
        const page_box_t window = page_grid_window(d->map);
        err = page_grid_build(&d->grid, &window, d->shadows.n, shadow_box, &d->shadows, at + used, left - used - least);
        if (err) return err;
        used += (d->grid.bytes + 7) & ~(size_t)7;
    }
    d->part = (part_t *)(void *)(at + used);
    size_t parts = (left - used) / sizeof(part_t);
    d->parts_max = parts < INT32_MAX ? (int32_t)parts : INT32_MAX;
    d->stats->bytes = d->shadows.bytes + used + least;
    return 0;
}

int convex_draw(const solid_map_t *m, const ink_sink_t *hidden, const hidden_job_t *job, hidden_stats_t *stats) {
    const int32_t edges = m->solid->ne;
    drawing_t d = {.map = m, .sink = job->sink, .hidden = hidden, .stats = stats};
    *stats = (hidden_stats_t){.facets = m->solid->nf};
    if (!job->mem) return ERR_FULL;
    int err = set_up(&d, job);
    for (int32_t e = 0; e < edges && !err; e++) {
        err = draw_edge(&d, e);
        if (job->tick && (e & 255) == 0) job->tick(job->tick_ctx, e, edges);
    }
    return err;
}
