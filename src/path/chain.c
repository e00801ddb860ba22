/* chain.c - clusters of ends on a hash over page cells. See chain.h. */
#include "path/chain.h"
#include "path/census.h"
#include "path/cluster.h"
#include "path/places.h"

#define SCAN_MAX 256   /* ends looked at in one bucket; more only where thousands crowd: then any will do */
#define CELL_BITS 4    /* a cell is at least 2^4 tolerances wide, so most queries see a single cell */
#define CENSUS_FINER 3 /* the census counts in cells so many times halved: two tolerances wide at the least */
/* What is worked in lies close together, with room for so many runs more that loop.h makes: a large pool that is not
 * full would touch memory that nothing else needs. */
#define ROOM_PART 8
#define ROOM_MORE 1024
#define MANY_ROOM_PART 32
#define NOBODY (-1) /* in a bucket */
#define NOBODY_ASKS (-2)
#define ASKED_CROWD 8   /* free ends to a bucket when few of them are asked for */
#define FREE (-1)       /* in mate, until chain_close: not paired */
#define ALONE (-2)      /* and nobody near */
#define FETCH_CENSUS 24 /* ends ahead that the census asks memory for */
_Static_assert((POOL_RUNS_MIN + 1) * 4 * sizeof(int32_t) >= CENSUS_BYTES_MIN, "the census lies over links and buckets");
_Static_assert(POOL_WORK_PER_RUN >= 2 * sizeof(page_point_t) + 4 * sizeof(int32_t), "points, next, head");

static uint32_t bucket(const chain_t *c, int32_t cx, int32_t cy) {
    /* neighbours in x stay neighbours in memory: runs arrive in an order that has locality, and caches like it */
    return ((uint32_t)cx + (uint32_t)cy * 0x9E3779B1u) & c->mask;
}

static int32_t *bucket_of(const chain_t *c, page_point_t p) {
    return &c->head[bucket(c, p.x_lat >> c->shift, p.y_lat >> c->shift)];
}

/* The cells in which an end may be that is near p. */
typedef struct cells {
    int32_t x0, y0, x1, y1;
} cells_t;

static cells_t cells_near(const chain_t *c, page_point_t p) {
    return (cells_t){(p.x_lat - c->near_lat) >> c->shift, (p.y_lat - c->near_lat) >> c->shift,
                     (p.x_lat + c->near_lat) >> c->shift, (p.y_lat + c->near_lat) >> c->shift};
}

void chain_enter(chain_t *c, int32_t e, page_point_t p) {
    c->point[e] = p;
#if CONFIG_MANY_STROKES
    if (c->places) return; /* there it is already */
#endif
    int32_t *head = bucket_of(c, p);
    c->next[e] = *head;
    *head = e;
}

/* Empty buckets, one for each of so many ends. */
static void make_buckets(chain_t *c, int32_t ends, int32_t empty) {
    c->mask = 0;
    while ((int32_t)c->mask < ends && (int64_t)2 * c->mask + 2 <= 2 * (int64_t)c->room) c->mask = 2 * c->mask + 1;
    for (uint32_t b = 0; b <= c->mask; b++) c->head[b] = empty;
}

void chain_ask_begin(chain_t *c, int32_t places) {
    const int32_t some = c->free / ASKED_CROWD;
    make_buckets(c, places > some ? places : some, NOBODY_ASKS);
}

void chain_ask(chain_t *c, page_point_t p) {
    const cells_t near = cells_near(c, p);
    for (int32_t y = near.y0; y <= near.y1; y++) {
        for (int32_t x = near.x0; x <= near.x1; x++) c->head[bucket(c, x, y)] = NOBODY;
    }
}

void chain_ask_end(chain_t *c) {
    const int32_t ends = 2 * c->pool->n;
    for (int32_t e = 0; e < ends; e++) {
        if (c->pool->mate[e] < 0 && *bucket_of(c, c->point[e]) != NOBODY_ASKS) chain_enter(c, e, c->point[e]);
    }
}

/* Are there so many runs, and memory, that all ends can be sorted by their places? Then links, points and all else
 * lie right behind the runs. */
static bool lay_out_many(chain_t *c) {
#if CONFIG_MANY_STROKES
    pool_t *const pool = c->pool;
    const int64_t n = pool->n, room = n + n / MANY_ROOM_PART + ROOM_MORE, plain = room / 32 + 1;
    const int64_t run = sizeof(run_t) / 4, all = pool_end(pool) - (uint32_t *)(void *)pool->run;
    const int64_t words = (run + 6) * room + 6 + plain; /* with links and points, and the pen's */
    if (n < CHAIN_MANY || words + CHAIN_BEHIND_WORDS(n) > all) return false;
    c->room = (int32_t)room;
    pool->mate = (int32_t *)(void *)(pool->run + room);
    c->point = (page_point_t *)(void *)(pool->mate + 2 * room + 2);
    c->plain = (uint32_t *)(void *)(c->point + 2 * room + 2);
    c->behind = (int32_t *)(void *)(c->plain + plain);
    c->box = (near_extent_t){INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN, 0};
    for (int64_t k = 0; k < plain; k++) c->plain[k] = 0;
    return true;
#else
    (void)c;
    return false;
#endif
}

static void lay_out(chain_t *c) {
    pool_t *const pool = c->pool;
    const int64_t room = (int64_t)pool->n + pool->n / ROOM_PART + ROOM_MORE;
    c->room = room < pool->cap ? (int32_t)room : pool->cap + 1;
    pool->mate = pool_own_mate(pool);
    c->point = (page_point_t *)(void *)pool->work;
    c->next = (int32_t *)(void *)(c->point + 2 * c->room);
    c->head = c->next + 2 * c->room;
}

/* The run r has been placed. */
static inline void note(chain_t *c, int32_t r) {
#if CONFIG_MANY_STROKES
    if (!c->plain) return;
    c->plain[r / 32] |= (uint32_t)run_is_plain(&c->pool->run[r]) << r % 32;
    near_include(&c->box, c->point[2 * r]);
    near_include(&c->box, c->point[2 * r + 1]);
#else
    (void)c, (void)r;
#endif
}

int32_t chain_place(chain_t *c, pool_t *pool, const ink_map_t *map, int32_t near_lat) {
    int32_t lost = 0;
    *c = (chain_t){.pool = pool, .map = map, .near_lat = near_lat};
    while (near_lat << CELL_BITS > 1 << c->shift) c->shift++;
    if (!lay_out_many(c)) lay_out(c);
    for (int32_t r = 0; r < pool->n; r++) {
        page_point_t *p = &c->point[2 * r];
        pool_tick(pool);
        while (r < pool->n && !pool_run_points(pool, map, r, p)) {
            pool->run[r] = pool->run[--pool->n];
            lost++;
        }
        if (r < pool->n) note(c, r);
    }
    return lost;
}

static inline void fetch_census(const chain_t *c, const census_t *census, int32_t e, int32_t ends) {
    if (CONFIG_FETCH && e + FETCH_CENSUS < ends) census_fetch(census, c->point[e + FETCH_CENSUS]);
}

/* Enters the ends that may have a neighbour, and marks them FREE; those that have certainly nobody near ALONE. The
 * census is taken in the memory of the links and buckets, which come after it. */
static void enter_all(chain_t *c) {
    const int32_t ends = 2 * c->pool->n;
    int32_t left = 0;
    census_t census;
    census_init(&census, (uint32_t *)c->next, sizeof *c->next * 4 * (size_t)c->room, ends, c->shift - CENSUS_FINER);
    for (int32_t e = 0; e < ends; e++) {
        fetch_census(c, &census, e, ends);
        census_enter(&census, c->point[e]);
    }
    for (int32_t e = 0; e < ends; e++) {
        fetch_census(c, &census, e, ends);
        const bool alone = census_is_alone(&census, c->point[e], c->near_lat);
        c->pool->mate[e] = alone ? ALONE : FREE;
        left += !alone;
    }
    make_buckets(c, left, NOBODY);
    for (int32_t e = 0; e < ends; e++) {
        if (c->pool->mate[e] == FREE) chain_enter(c, e, c->point[e]);
    }
}

#if CONFIG_MANY_STROKES
static int free_in_places(const places_t *places, page_point_t p, int32_t *out, int max) {
    uint32_t at[CHAIN_CLUSTER];
    const int n = places_near(places, p, at, max);
    for (int k = 0; k < n; k++) out[k] = places->now.place[at[k]].end;
    return n;
}
#endif

int chain_free_ends(const chain_t *c, page_point_t p, int32_t *out, int max) {
#if CONFIG_MANY_STROKES
    if (c->places) return free_in_places(c->places, p, out, max);
#endif
    const cells_t near = cells_near(c, p);
    int n = 0;
    for (int32_t y = near.y0; y <= near.y1; y++) {
        for (int32_t x = near.x0; x <= near.x1; x++) {
            int32_t *link = &c->head[bucket(c, x, y)];
            for (int left = SCAN_MAX; *link >= 0 && left > 0; left--) {
                int32_t e = *link;
                if (c->pool->mate[e] >=
                    0) { /* no longer free: forgotten, or crowds would be searched again and again */
                    *link = c->next[e];
                    continue;
                }
                bool here = c->point[e].x_lat >> c->shift == x && c->point[e].y_lat >> c->shift == y;
                if (here && chain_is_near(c, c->point[e], p) && n < max) out[n++] = e;
                link = &c->next[e];
            }
        }
    }
    return n;
}

void chain_pair(chain_t *c) {
    const int32_t ends = 2 * c->pool->n;
    enter_all(c);
    for (int32_t e = 0; e < ends; e++) {
        int32_t cluster[CHAIN_CLUSTER];
        if (e % 16 == 0) pool_tick(c->pool);
        if (c->pool->mate[e] != FREE) continue;
        int n = chain_free_ends(c, c->point[e], cluster, CHAIN_CLUSTER), k = 0;
        while (k < n && cluster[k] != e) k++;
        if (k == n) cluster[n < CHAIN_CLUSTER ? n++ : n - 1] = e; /* in a crowd it may not be found: its turn is now */
        cluster_pair(c, cluster, n);
    }
}

/* Goes from the free end e to the other of its stroke; sees every run on the way. */
static int32_t close_stroke(const pool_t *p, int32_t e) {
    for (;;) {
        p->run[e >> 1].to_hi |= RUN_SEEN;
        e = pool_other_end(e);
        if (p->mate[e] < 0) return e;
        e = p->mate[e];
    }
}

int32_t chain_close(chain_t *c) {
    pool_t *p = c->pool;
    int32_t strokes = 0;
    for (int32_t r = 0; r < p->n; r++) {
        int32_t *mate = &p->mate[2 * r];
        if (mate[0] < 0 && mate[1] < 0) { /* as most of a rough surface are: it need not be looked at */
            mate[0] = ~(2 * r + 1);
            mate[1] = ~(2 * r);
            strokes++;
        } else if ((mate[0] < 0 || mate[1] < 0) && !(p->run[r].to_hi & RUN_SEEN)) {
            const int32_t e = 2 * r + (mate[0] >= 0), far = close_stroke(p, e);
            p->mate[e] = ~far;
            p->mate[far] = ~e;
            strokes++;
        }
    }
    c->free = 2 * strokes;
    return strokes;
}
