/* places.c - sorting by counting. See places.h. */
#include "path/places.h"
#include <stddef.h>

#if CONFIG_MANY_STROKES

#define CROWD 1           /* ends to a cell: the search looks at the fewest */
#define FINE_CELL_BITS 11 /* a cell is at most so many bits wide */

static int32_t *take_list(place_list_t *list, int32_t *mem, int32_t n) {
    list->n = n;
    list->spot = (uint32_t *)(void *)mem;
    list->place = (place_t *)(void *)(mem + n);
    return mem + 3 * (ptrdiff_t)n;
}

static inline uint32_t spot_of(const places_t *p, page_point_t at) {
    return PLACES_SPOT((at.x_lat - p->box.x0) >> p->fine & PLACES_MASK,
                       (at.y_lat - p->box.y0) >> p->fine & PLACES_MASK);
}

/* Cells for so many ends, nothing in them, and not smaller than what is near. */
static void make_cells(places_t *p, int32_t ends, int32_t crowd) {
    const near_extent_t *box = &p->box;
    int x, y;
    near_size(ends / crowd, (box->x1 - box->x0) >> box->shift, (box->y1 - box->y0) >> box->shift, &x, &y);
    p->cell_x = x + box->shift;
    p->cell_y = y + box->shift;
    while (1 << p->cell_x < 2 * p->chain->near_lat) p->cell_x++;
    while (1 << p->cell_y < 2 * p->chain->near_lat) p->cell_y++;
    const int most = p->cell_x > p->cell_y ? p->cell_x : p->cell_y;
    p->fine = most < FINE_CELL_BITS ? 0 : most - FINE_CELL_BITS;
    p->nx = ((box->x1 - box->x0) >> p->cell_x) + 1;
    p->ny = ((box->y1 - box->y0) >> p->cell_y) + 1;
    for (int32_t k = 0; k < p->nx * p->ny + 2; k++) p->start[k] = 0;
}

/* Where a cell's ends go is counted up in the start of the next; the counts that make it are one further yet. So when
 * all are sorted, every start is where it should be. */
static inline void count(places_t *p, page_point_t a, page_point_t b) {
    places_cell(p, a)[2]++;
    places_cell(p, b)[2]++;
}
static void add_up(places_t *p) {
    for (int32_t k = 2; k < p->nx * p->ny + 2; k++) p->start[k] += p->start[k - 1];
}
/* Returns the place of the first. */
static inline uint32_t put(const places_t *p, const place_list_t *to, int32_t end_a, int32_t end_b) {
    const page_point_t a = p->chain->point[end_a], b = p->chain->point[end_b];
    const uint32_t i = places_cell(p, a)[1]++, j = places_cell(p, b)[1]++;
    to->spot[i] = spot_of(p, a);
    to->spot[j] = spot_of(p, b);
    to->place[i] = (place_t){end_a, (int32_t)j};
    to->place[j] = (place_t){end_b, (int32_t)i};
    return i;
}

/* Both differences at most by? */
static inline bool is_close(page_point_t a, page_point_t b, int32_t by) {
    const uint32_t dx = (uint32_t)(a.x_lat - b.x_lat + by), dy = (uint32_t)(a.y_lat - b.y_lat + by);
    return (dx <= 2 * (uint32_t)by) & (dy <= 2 * (uint32_t)by);
}

static void enter_runs(places_t *p, int32_t brief_lat) {
    const pool_t *pool = p->chain->pool;
    const page_point_t *point = p->chain->point;
    const int32_t runs = pool->n;
    make_cells(p, p->now.n, CROWD);
    count(p, point[p->pen], point[p->pen + 1]);
    for (int32_t r = 0; r < runs; r++) {
        count(p, point[2 * r], point[2 * r + 1]);
        pool->mate[2 * r] = ~(2 * r + 1);
        pool->mate[2 * r + 1] = ~(2 * r);
    }
    add_up(p);
    put(p, &p->now, p->pen, p->pen + 1);
    for (int32_t r = 0; r < runs; r++) {
        const uint32_t i = put(p, &p->now, 2 * r, 2 * r + 1);
        if (!is_close(point[2 * r], point[2 * r + 1], brief_lat)) continue;
        p->brief[p->briefs][0] = (int32_t)i;
        p->brief[p->briefs++][1] = p->now.place[i].tip;
    }
    p->strokes = runs;
}

/* The pen may be elsewhere. */
static page_point_t nearest(const near_extent_t *box, page_point_t at) {
    return (page_point_t){at.x_lat < box->x0   ? box->x0
                          : at.x_lat > box->x1 ? box->x1
                                               : at.x_lat,
                          at.y_lat < box->y0   ? box->y0
                          : at.y_lat > box->y1 ? box->y1
                                               : at.y_lat};
}

bool places_sort(places_t *p, chain_t *c, page_point_t at, page_point_t home, int32_t brief_lat) {
    if (!c->plain || c->pool->n == 0) return false;
    *p = (places_t){.chain = c, .box = c->box, .pen = 2 * c->room};
    near_fit(&p->box);
    const int32_t ends = 2 * c->pool->n + 2; /* the pen's is a stroke, too */
    p->start = (uint32_t *)(void *)take_list(&p->now, c->behind, ends);
    p->next = (int32_t *)(void *)(p->start + ends + 3);
    p->brief = (int32_t(*)[2])(void *)p->next;
    c->point[p->pen] = nearest(&p->box, home);
    c->point[p->pen + 1] = nearest(&p->box, at);
    enter_runs(p, brief_lat);
    p->loop = (int32_t *)(void *)(p->brief + p->briefs);
    return true;
}

void places_drop(places_t *p, int32_t at) {
    places_mark(&p->now.spot[at]);
    places_mark(&p->now.spot[p->now.place[at].tip]);
    p->strokes--;
}

/* Is there the first end of a chain of strokes in place k? */
static inline bool is_left(const place_list_t *list, int32_t k) {
    return !places_is_marked(list->spot[k]) && k < list->place[k].tip;
}

void places_thin(places_t *p, int32_t chains, int32_t crowd) {
    const place_list_t from = p->now;
    const page_point_t *point = p->chain->point;
    place_list_t to;
    take_list(&to, p->next, 2 * chains);
    make_cells(p, 2 * chains, crowd);
    for (int32_t k = 0; k < from.n; k++) {
        if (is_left(&from, k)) count(p, point[from.place[k].end], point[from.place[from.place[k].tip].end]);
    }
    add_up(p);
    for (int32_t k = 0; k < from.n; k++) {
        if (is_left(&from, k)) put(p, &to, from.place[k].end, from.place[from.place[k].tip].end);
    }
    p->now = to;
    p->next = (int32_t *)(void *)from.spot;
}

/* The cells in which an end may be that is near a point, and its spot; none if x0 > x1. */
typedef struct window {
    int32_t x0, y0, x1, y1;
    uint32_t at;
    uint32_t by;
} window_t;

static window_t window_near(const places_t *p, page_point_t at) {
    const near_extent_t *box = &p->box;
    const int32_t by = p->chain->near_lat, x = at.x_lat - box->x0, y = at.y_lat - box->y0;
    window_t w = {(x - by) >> p->cell_x, (y - by) >> p->cell_y, (x + by) >> p->cell_x,
                  (y + by) >> p->cell_y, spot_of(p, at),        (uint32_t)(by >> p->fine) + PLACES_NEAR_MARGIN};
    if (w.x0 < 0) w.x0 = 0;
    if (w.y0 < 0) w.y0 = 0;
    if (w.x1 >= p->nx) w.x1 = p->nx - 1;
    if (w.y1 >= p->ny) w.y1 = p->ny - 1;
    return w;
}

static inline bool is_in(const window_t *w, uint32_t spot) {
    const uint32_t x = ((spot - w->at) >> 1) + w->by, y = (spot >> 17) - (w->at >> 17) + w->by;
    return ((x & PLACES_MASK) <= 2 * w->by) & ((y & PLACES_MASK) <= 2 * w->by) & !places_is_marked(spot);
}

/* Cells side by side are one stretch of places. */
static void stretch(const places_t *p, const window_t *w, int32_t row, uint32_t *from, uint32_t *to) {
    const uint32_t *cells = &p->start[row * p->nx];
    *from = cells[w->x0];
    *to = cells[w->x1 + 1];
}

int places_near(const places_t *p, page_point_t at, uint32_t *out, int max) {
    const window_t w = window_near(p, at);
    const chain_t *c = p->chain;
    int n = 0;
    if (w.x0 > w.x1) return 0;
    for (int32_t row = w.y0; row <= w.y1; row++) {
        uint32_t from, to;
        stretch(p, &w, row, &from, &to);
        if (to - from > PLACES_CROWD) to = from + PLACES_CROWD;
        for (uint32_t k = from; k < to; k++) {
            if (!is_in(&w, p->now.spot[k]) || p->now.place[k].end >= p->pen) continue;
            if (!chain_is_near(c, c->point[p->now.place[k].end], at)) continue;
            out[n++] = k;
            if (n == max) return n;
        }
    }
    return n;
}

uint32_t places_find(const places_t *p, int32_t e, page_point_t at) {
    const window_t w = window_near(p, at);
    for (int32_t row = w.y0; w.x0 <= w.x1 && row <= w.y1; row++) {
        uint32_t from, to;
        stretch(p, &w, row, &from, &to);
        for (uint32_t k = from; k < to; k++) {
            if (p->now.place[k].end == e && !places_is_marked(p->now.spot[k])) return k;
        }
    }
    return PLACES_NONE;
}

#endif
