/* sort.c - one digit of a radix sort in place, the digit being the cell. See sort.h. */
#include "path/sort.h"

#define RUNS_PER_CELL 16
#define LEVELS_MAX 12 /* 2^12 cells across */

/* The bits of v, at most 16, with a zero before each. */
static uint32_t spread(uint32_t v) {
    v = (v | v << 8) & 0x00ff00ff;
    v = (v | v << 4) & 0x0f0f0f0f;
    v = (v | v << 2) & 0x33333333;
    return (v | v << 1) & 0x55555555;
}

typedef struct place {
    run_t run;
    page_point_t from, to;
    uint32_t key;
} place_t;

static place_t take(const pool_t *pool, const page_point_t *point, const uint32_t *key, int32_t r) {
    return (place_t){pool->run[r], point[2 * r], point[2 * r + 1], key[r]};
}

static void put(pool_t *pool, page_point_t *point, uint32_t *key, int32_t r, const place_t *p) {
    pool->run[r] = p->run;
    point[2 * r] = p->from;
    point[2 * r + 1] = p->to;
    key[r] = p->key;
}

static void find_keys(const pool_t *pool, const page_point_t *point, int levels, uint32_t *key) {
    page_point_t lo = point[0], hi = point[0];
    for (int32_t r = 1; r < pool->n; r++) {
        page_point_t p = point[2 * r];
        if (p.x_lat < lo.x_lat) lo.x_lat = p.x_lat;
        if (p.y_lat < lo.y_lat) lo.y_lat = p.y_lat;
        if (p.x_lat > hi.x_lat) hi.x_lat = p.x_lat;
        if (p.y_lat > hi.y_lat) hi.y_lat = p.y_lat;
    }
    uint32_t wide = (uint32_t)hi.x_lat - (uint32_t)lo.x_lat, high = (uint32_t)hi.y_lat - (uint32_t)lo.y_lat;
    int shift = 0;
    while ((wide | high) >> shift >> levels) shift++;
    for (int32_t r = 0; r < pool->n; r++) {
        uint32_t x = ((uint32_t)point[2 * r].x_lat - (uint32_t)lo.x_lat) >> shift;
        uint32_t y = ((uint32_t)point[2 * r].y_lat - (uint32_t)lo.y_lat) >> shift;
        key[r] = spread(x) | spread(y) << 1;
    }
}

void sort_runs(pool_t *pool, page_point_t *point, uint32_t *work) {
    int32_t n = pool->n;
    if (n < SORT_RUNS_MIN) return;
    int levels = 1;
    while (levels < LEVELS_MAX && (int64_t)RUNS_PER_CELL << (2 * levels + 2) <= n) levels++;
    uint32_t cells = 1u << 2 * levels, *key = work;
    /* Each cell's runs from next to end are not yet known to be in their place; end is where the next cell begins. */
    uint32_t *next = work + n, *end = next + cells, sum = 0;
    find_keys(pool, point, levels, key);
    for (uint32_t c = 0; c < cells; c++) end[c] = 0;
    for (int32_t r = 0; r < n; r++) end[key[r]]++;
    for (uint32_t c = 0; c < cells; c++) {
        next[c] = sum;
        sum += end[c];
        end[c] = sum;
    }
    for (uint32_t c = 0; c < cells; c++) {
        for (; next[c] < end[c]; next[c]++) {
            int32_t hole = (int32_t)next[c];
            if (key[hole] == c) continue;
            place_t p = take(pool, point, key, hole);
            while (p.key != c) {
                int32_t r = (int32_t)next[p.key]++;
                place_t q = take(pool, point, key, r);
                put(pool, point, key, r, &p);
                p = q;
            }
            put(pool, point, key, hole, &p);
        }
    }
}
