/* loop.c - walks every closed stroke once, looking for a free end to start it from. See loop.h. */
#include "path/loop.h"

#define PLACES_MAX (1 << 22)
#define CELLS_PER_PLACE 8 /* so many buckets that most of those asked for are so rightly */

/* A place on a closed stroke and the free end found there. */
typedef struct meeting {
    int32_t start; /* the end from which the run is walked */
    int64_t t;     /* where on the run */
    page_point_t at;
    int32_t free_end;
} meeting_t;

/* The vertex behind t of a run that ends at `end`; beyond it, when t is the last. */
static int64_t after(const run_t *r, int64_t t, int64_t end) {
    return t == end ? end + 1 : ink_next(run_family(r), t, end);
}

static bool point_of(const chain_t *c, const run_t *r, int64_t t, page_point_t *p) {
    return c->map->point(c->map->ctx, run_family(r), run_surface(r), run_line(r), t, p);
}

static bool find_on_run(const chain_t *c, int32_t start, meeting_t *m) {
    const run_t *r = &c->pool->run[start >> 1];
    int64_t t = run_t_of(r, 0), end = run_t_of(r, 1);
    m->start = start;
    for (; t <= end; t = after(r, t, end)) {
        m->t = t;
        if (point_of(c, r, t, &m->at) && chain_free_ends(c, m->at, &m->free_end, 1)) return true;
    }
    return false;
}

/* Walks the closed stroke through `first`, marking its runs; looks for a meeting until there is one. */
static bool walk(const chain_t *c, int32_t first, meeting_t *m) {
    bool found = false;
    int32_t e = first;
    do {
        c->pool->run[e >> 1].to_hi |= RUN_SEEN;
        if (!found) found = find_on_run(c, e, m);
        e = c->pool->mate[pool_other_end(e)];
    } while (e != first);
    return found;
}

static void set_far_ends(pool_t *p, int32_t e, int32_t f) {
    p->mate[e] = ~f;
    p->mate[f] = ~e;
}

/* Opens the stroke between the end e and the end it continues into. */
static void cut_at_end(chain_t *c, int32_t e) {
    int32_t f = c->pool->mate[e];
    set_far_ends(c->pool, e, f);
    chain_enter(c, e, c->point[e]);
    chain_enter(c, f, c->point[f]);
}

bool loop_find(chain_t *c) {
    const pool_t *pool = c->pool;
    int32_t places = 0;
    for (int32_t k = 0; k < pool->n; k++) {
        const run_t *r = &pool->run[k];
        if (chain_is_closed(pool, k) && places < PLACES_MAX)
            places += (int32_t)((run_t_of(r, 1) - run_t_of(r, 0)) >> ink_bits(run_family(r))) + 2;
    }
    if (places == 0) return false;
    chain_ask_begin(c, places * CELLS_PER_PLACE);
    for (int32_t k = 0; k < pool->n; k++) {
        const run_t *r = &pool->run[k];
        if (!chain_is_closed(pool, k)) continue;
        for (int64_t t = run_t_of(r, 0), end = run_t_of(r, 1); t <= end; t = after(r, t, end)) {
            page_point_t p;
            if (point_of(c, r, t, &p)) chain_ask(c, p);
        }
    }
    chain_ask_end(c);
    return true;
}

/* Cuts the run in two at t and opens the stroke there. The first part keeps the number. Returns the free end of the
 * second part. */
static int32_t cut_run(chain_t *c, int32_t r, int64_t t, page_point_t at) {
    pool_t *p = c->pool;
    int32_t s = p->n++, beyond = p->mate[2 * r + 1];
    p->run[s] = p->run[r];
    run_set_t(&p->run[r], 1, t);
    run_set_t(&p->run[s], 0, t);
    p->mate[2 * s + 1] = beyond;
    p->mate[beyond] = 2 * s + 1;
    c->point[2 * s + 1] = c->point[2 * r + 1];
    c->point[2 * r + 1] = at;
    chain_enter(c, 2 * s, at);
    set_far_ends(p, 2 * s, 2 * r + 1);
    return 2 * s;
}

/* Opens the closed stroke through the end `first`, with a free end as found. Returns the end that is free instead, or
 * -1. */
static __attribute__((noinline)) int32_t open_at(chain_t *c, int32_t first, bool found, const meeting_t *m) {
    pool_t *p = c->pool;
    const int32_t k = m->start >> 1;
    int32_t e = 2 * k;
    bool at_end = found && (m->t == pool_end_t(p, 2 * k) || m->t == pool_end_t(p, 2 * k + 1));
    if (!found || (!at_end && (p->n == p->cap || p->n == c->room))) {
        cut_at_end(c, first);
        return -1;
    }
    if (at_end) {
        e += m->t == pool_end_t(p, 2 * k + 1);
        cut_at_end(c, e);
    } else {
        e = cut_run(c, k, m->t, m->at);
    }
    int32_t far_of_loop = ~p->mate[e], far_of_other = ~p->mate[m->free_end];
    /* ... other -> free_end, then once round from far_of_loop's side to e: e stays free for the next loop */
    p->mate[far_of_loop] = m->free_end;
    p->mate[m->free_end] = far_of_loop;
    p->run[m->free_end >> 1].to_hi |= RUN_SEEN; /* it may have no free end from now on */
    set_far_ends(p, e, far_of_other);
    return e;
}

bool loop_open_at(chain_t *c, int32_t e, loop_joint_t *joint) {
    meeting_t m = {0};
    const bool found = walk(c, e, &m);
    *joint = (loop_joint_t){m.free_end, open_at(c, e, found, &m), m.at};
    return joint->end >= 0;
}

void loop_open(chain_t *c) {
    const pool_t *p = c->pool;
    const int32_t runs = p->n;
    for (int32_t r = 0; r < runs; r++) {
        loop_joint_t joint;
        if (!chain_is_closed(p, r)) continue;
        pool_tick(p);
        loop_open_at(c, 2 * r, &joint);
    }
}
