/* once_build.c - which edges coincide on the page, see once.h. */
#include "config.h"
#include "error.h"
#include "hidden/solid/once.h"
#include "hidden/solid/once_away.h"
#include "hidden/solid/page_grid.h"
#include "view/cut.h"

#define NOWHERE (-1)

typedef struct search {
    const solid_map_t *map;
    uint8_t *away;         /* of each face: surely turned from the eye; NULL: that does not matter */
    int32_t *parent;       /* of each edge, a forest of groups; NOWHERE: takes no part */
    int32_t *point;        /* of each end, twice the edge and 1 more for its v[1]: which of: */
    page_point_t *at;      /* points: vertices, then where edges are cut by the border of the page */
    int32_t points, most;  /* there are, there is memory for */
    int32_t *head, *next;  /* of each point the first of the ends there, of each end another one; NOWHERE */
    page_grid_t grid;      /* of points */
    int32_t edge, v[2];    /* at hand, and its points */
    page_box_t box;        /* of its picture, and a margin */
    int64_t dx, dy, least; /* its ends' difference, and the larger of the two times ONCE_FLAT_LAT */
    bool any;
} search_t;

static const page_point_t *end_of(const search_t *s, int32_t edge, int end) {
    return &s->at[s->point[2 * edge + end]];
}

static int64_t size(int64_t a) {
    return a < 0 ? -a : a;
}

static bool is_inside(const solid_map_t *m, int32_t v) {
    const page_window_t *w = m->lines.window;
    const solid_place_t *p = &m->place[v];
    return !solid_map_is_behind(m, v) && p->x >= w->x0_lat && p->x <= w->x1_lat && p->y >= w->y0_lat &&
           p->y <= w->y1_lat;
}

static bool needs_cut(const solid_map_t *m, const solid_edge_t *e) {
    return !m->lines.all_inside && (!is_inside(m, e->v[0]) || !is_inside(m, e->v[1]));
}

/* The points of an edge that leaves the page; false if there is none of it on the page. */
static bool cut_edge(search_t *s, int32_t edge) {
    const solid_map_t *m = s->map;
    const line_space_t *lines = &m->lines;
    const solid_edge_t *e = &m->solid->edge[edge];
    const page_h_t h[2] = {solid_map_vertex(m, e->v[0]), solid_map_vertex(m, e->v[1])};
    int64_t t[2] = {0, INK_ONE};
    if (!cut_between(lines, lines->window, &h[0], &h[1], &t[0], &t[1])) return false;
    for (int k = 0; k < 2; k++) {
        s->point[2 * edge + k] = e->v[k];
        if (t[k] == k * INK_ONE) continue;
        if (!line_space_point(lines, INK_SEGMENT, edge, t[k], &s->at[s->points])) return false;
        s->head[s->points] = NOWHERE;
        s->point[2 * edge + k] = s->points++;
    }
    return true;
}

/* Does one of the bodies that share the edge hide it by itself? */
static bool is_behind_itself(const search_t *s, int32_t edge) {
    if (!CONFIG_ONCE_AWAY || !s->away) return false;
    for (int32_t k = edge; k >= 0; k = s->map->solid->edge[k].twin) {
        const solid_edge_t *e = &s->map->solid->edge[k];
        if (e->face[0] >= 0 && e->face[1] >= 0 && (s->away[e->face[0]] & s->away[e->face[1]])) return true;
    }
    return false;
}

/* Finds the edge's points. Does it take part? */
static bool place_edge(search_t *s, int32_t edge) {
    const solid_edge_t *e = &s->map->solid->edge[edge];
    if (e->first != edge || solid_is_cut(s->map->solid, e) || is_behind_itself(s, edge)) return false;
    for (int k = 0; k < 2; k++) s->point[2 * edge + k] = e->v[k];
    if (needs_cut(s->map, e) && !cut_edge(s, edge)) return false;
    const page_point_t *p = end_of(s, edge, 0), *q = end_of(s, edge, 1);
    return size(q->x_lat - p->x_lat) >= ONCE_LEAST_LAT || size(q->y_lat - p->y_lat) >= ONCE_LEAST_LAT;
}

/* Which edges take part, and where they end. */
static void list_ends(search_t *s) {
    const solid_t *solid = s->map->solid;
    for (int32_t v = 0; v < solid->nv; v++) {
        s->head[v] = NOWHERE;
        s->at[v] = (page_point_t){s->map->place[v].x, s->map->place[v].y};
    }
    s->points = solid->nv;
    for (int32_t e = 0; e < solid->ne; e++) {
        s->parent[e] = place_edge(s, e) ? e : NOWHERE;
        for (int32_t k = 2 * e; k < 2 * e + 2 && s->parent[e] >= 0; k++) {
            s->next[k] = s->head[s->point[k]];
            s->head[s->point[k]] = k;
        }
    }
}

static page_box_t point_box(void *ctx, int32_t k) {
    const search_t *s = ctx;
    if (s->head[k] < 0) return (page_box_t){INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN}; /* nowhere */
    return (page_box_t){s->at[k].x_lat, s->at[k].y_lat, s->at[k].x_lat, s->at[k].y_lat};
}

static int32_t find(int32_t *parent, int32_t e) {
    while (parent[e] != e) e = parent[e] = parent[parent[e]];
    return e;
}

/* Is v no farther from the line through p and q than ONCE_FLAT_LAT? *beside: its foot lies between them. The larger of
 * two differences stands for their length: it is less, so nothing is called near that is not. */
static bool is_near(const page_point_t *p, const page_point_t *q, const page_point_t *v, bool *beside) {
    const int64_t dx = q->x_lat - p->x_lat, dy = q->y_lat - p->y_lat, x = v->x_lat - p->x_lat, y = v->y_lat - p->y_lat;
    const int64_t t = dx * x + dy * y;
    *beside = t >= 0 && t <= dx * dx + dy * dy;
    return size(dx * y - dy * x) <= ONCE_FLAT_LAT * (size(dx) > size(dy) ? size(dx) : size(dy));
}

/* Do the pictures of two edges overlap, and are near each other at both ends of that? */
static bool coincide(const search_t *s, int32_t e, int32_t f) {
    int32_t lo = INT32_MAX, hi = INT32_MIN;
    for (int k = 0; k < 4; k++) {
        const int32_t on = k < 2 ? e : f;
        const page_point_t *v = end_of(s, k < 2 ? f : e, k & 1);
        bool beside;
        bool near = is_near(end_of(s, on, 0), end_of(s, on, 1), v, &beside);
        if (!beside) continue;
        if (!near) return false;
        const int32_t u = size(s->dx) >= size(s->dy) ? v->x_lat : v->y_lat;
        if (u < lo) lo = u;
        if (u > hi) hi = u;
    }
    return (int64_t)hi - lo >= ONCE_LEAST_LAT;
}

/* A point on the edge at hand: do edges that end there coincide with it? */
static void join(search_t *s, int32_t point) {
    for (int32_t end = s->head[point]; end >= 0; end = s->next[end]) {
        const int32_t a = find(s->parent, s->edge), b = find(s->parent, end >> 1);
        if (a == b || !coincide(s, s->edge, end >> 1)) continue;
        s->parent[a < b ? b : a] = a < b ? a : b;
        s->any = true;
    }
}

/* Points in cells along the edge at hand. Hardly any is on it, and what else they are cannot be predicted: one
 * branch. */
static bool visit(void *ctx, const int32_t *from, const int32_t *end) {
    search_t *s = ctx;
    const page_point_t *at = s->at, p = at[s->v[0]];
    const page_box_t box = s->box;
    for (; from < end; from++) {
        const page_point_t q = at[*from];
        const int64_t aside = size(s->dx * (q.y_lat - p.y_lat) - s->dy * (q.x_lat - p.x_lat));
        const int32_t beyond = (q.x_lat - box.x0) | (box.x1 - q.x_lat) | (q.y_lat - box.y0) | (box.y1 - q.y_lat);
        if ((aside <= s->least) & (beyond >= 0) & (*from != s->v[0]) & (*from != s->v[1])) join(s, *from);
    }
    return true;
}

static void look_along(search_t *s, int32_t edge) {
    const page_point_t p = *end_of(s, edge, 0), q = *end_of(s, edge, 1);
    const int32_t m = ONCE_FLAT_LAT;
    s->edge = edge;
    for (int k = 0; k < 2; k++) s->v[k] = s->point[2 * edge + k];
    s->box = (page_box_t){(p.x_lat < q.x_lat ? p.x_lat : q.x_lat) - m, (p.y_lat < q.y_lat ? p.y_lat : q.y_lat) - m,
                          (p.x_lat < q.x_lat ? q.x_lat : p.x_lat) + m, (p.y_lat < q.y_lat ? q.y_lat : p.y_lat) + m};
    s->dx = q.x_lat - p.x_lat;
    s->dy = q.y_lat - p.y_lat;
    s->least = ONCE_FLAT_LAT * (size(s->dx) > size(s->dy) ? size(s->dx) : size(s->dy));
    page_grid_walk(&s->grid, &(solid_place_t){p.x_lat, p.y_lat, 0}, &(solid_place_t){q.x_lat, q.y_lat, 0}, 0, visit, s);
}

/* The first and the last point along a group's line. */
typedef struct extent {
    int32_t lo, hi;
} extent_t;
enum { ALONE, STRAIGHT, BENT }; /* what a group is */

static int32_t place_along(const search_t *s, int32_t point, bool along_y) {
    return along_y ? s->at[point].y_lat : s->at[point].x_lat;
}

static bool runs_along_y(const search_t *s, int32_t edge) {
    const page_point_t *p = end_of(s, edge, 0), *q = end_of(s, edge, 1);
    return size(q->y_lat - p->y_lat) > size(q->x_lat - p->x_lat);
}

static void stretch(const search_t *s, extent_t *x, int32_t edge, bool along_y) {
    for (int k = 0; k < 2; k++) {
        const int32_t v = s->point[2 * edge + k], u = place_along(s, v, along_y);
        if (x->lo < 0 || u < place_along(s, x->lo, along_y)) x->lo = v;
        if (x->hi < 0 || u > place_along(s, x->hi, along_y)) x->hi = v;
    }
}

/* Parents become groups; returns how many edges are in one. */
static int32_t settle(search_t *s, extent_t *extent, uint8_t *kind) {
    const int32_t ne = s->map->solid->ne;
    int32_t *group = s->parent, grouped = 0;
    for (int32_t e = 0; e < ne; e++) {
        extent[e] = (extent_t){NOWHERE, NOWHERE};
        kind[e] = ALONE;
    }
    for (int32_t e = 0; e < ne; e++) {
        if (group[e] < 0) continue;
        group[e] = find(group, e);
        if (group[e] != e) kind[group[e]] = STRAIGHT;
        stretch(s, &extent[group[e]], e, runs_along_y(s, group[e]));
    }
    for (int32_t e = 0; e < ne; e++) {
        if (group[e] < 0 || kind[group[e]] != STRAIGHT) continue;
        const extent_t *x = &extent[group[e]];
        bool beside;
        for (int k = 0; k < 2; k++)
            if (!is_near(&s->at[x->lo], &s->at[x->hi], end_of(s, e, k), &beside)) kind[group[e]] = BENT;
    }
    for (int32_t e = 0; e < ne; e++) {
        if (group[e] < 0) continue;
        const int32_t first = group[e];
        group[e] = kind[first] == STRAIGHT ? 2 * first + runs_along_y(s, first) : NOWHERE;
        grouped += group[e] >= 0;
    }
    return grouped;
}

/* Memory from below, aligned to 8; NULL when there is no more. */
typedef struct lent {
    uint8_t *at, *end;
} lent_t;

static void *take(lent_t *m, int64_t n, size_t each) {
    const size_t bytes = ((size_t)n * each + 7) & ~(size_t)7;
    if (!m->at || bytes > (size_t)(m->end - m->at)) return m->at = NULL;
    void *at = m->at;
    m->at += bytes;
    return at;
}

static int64_t count_cut(const solid_map_t *m) {
    int64_t n = 0;
    for (int32_t e = 0; e < m->solid->ne; e++) n += needs_cut(m, &m->solid->edge[e]);
    return n;
}

int once_build(once_t *o, const solid_map_t *m, bool away, bool plenty, void *mem, size_t bytes) {
    const int32_t ne = m->solid->ne;
    const int64_t points = m->solid->nv + 2 * count_cut(m);
    lent_t lent = {mem, (uint8_t *)mem + bytes};
    search_t s = {.map = m};
    *o = (once_t){.map = m};
    if (ne > INT32_MAX / 8 || points > INT32_MAX / 4) return ERR_FULL;
    s.parent = take(&lent, ne, sizeof *s.parent);
    uint8_t *after = lent.at; /* for what is kept */
    s.point = take(&lent, ne, 2 * sizeof *s.point);
    s.at = take(&lent, points, sizeof *s.at);
    void *more = lent.at; /* for settle() */
    s.next = take(&lent, ne, 2 * sizeof *s.next);
    s.head = take(&lent, points, sizeof *s.head);
    if (!lent.at) return ERR_FULL;
    /* where the grid will be; a lack of memory is no reason to fail: then nothing is left out */
    if (CONFIG_ONCE_AWAY && !away && lent.end - lent.at >= m->solid->nf && once_find_away(m, lent.at)) s.away = lent.at;
    list_ends(&s);
    const page_box_t window = page_grid_window(m);
    int err = page_grid_build(&s.grid, &window, s.points, point_box, &s, lent.at, (size_t)(lent.end - lent.at));
    if (err) return err;
    for (int32_t e = 0; e < ne; e++)
        if (s.parent[e] >= 0) look_along(&s, e);
    if (!s.any) return 0;
    lent.at = more;
    extent_t *extent = take(&lent, ne, sizeof *extent);
    uint8_t *kind = take(&lent, ne, 1);
    if (!lent.at) return ERR_FULL;
    const int64_t grouped = settle(&s, extent, kind);
    if (grouped == 0) return 0;
    const size_t room = (size_t)(lent.end - after) / sizeof *o->piece;
    o->group = s.parent;
    int64_t enough = 4 * grouped + 8;
    if (plenty && (int64_t)(room / 4) > enough) enough = (int64_t)(room / 4);
    if (enough > (int64_t)room) enough = (int64_t)room;
    o->n_max = enough < INT32_MAX ? (int32_t)enough : INT32_MAX;
    o->n_least = (int32_t)(2 * grouped + 8);
    o->piece = (once_piece_t *)(void *)after;
    o->bytes = ((size_t)(after - (uint8_t *)mem) + (size_t)o->n_max * sizeof *o->piece + 7) & ~(size_t)7;
    return 0;
}

void once_spare(once_t *o, size_t bytes) {
    const size_t wanted = (bytes + sizeof *o->piece - 1) / sizeof *o->piece;
    if (o->n_max <= o->n_least) return;
    const size_t most = (size_t)(o->n_max - o->n_least), gone = wanted < most ? wanted : most;
    o->n_max -= (int32_t)gone;
    o->bytes -= gone * sizeof *o->piece;
}
