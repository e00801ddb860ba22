/* intervals.c - see intervals.h. */
#include "hidden/intervals.h"

#include "error.h"
#include "num/heap_sort.h"
#include <stdbool.h>

void intervals_init(intervals_t *s, void *mem, size_t bytes) {
    size_t n = bytes / sizeof(interval_t);
    *s = (intervals_t){mem, 0, n > INT32_MAX ? INT32_MAX : (int32_t)n, 0};
}

static bool is_before(const interval_t *a, const interval_t *b) {
    return a->line != b->line ? a->line < b->line : a->from_q30 < b->from_q30;
}

HEAP_SORT(interval_t, is_before)

/* Sorted, neighbours that overlap or touch become one. */
static void unite(intervals_t *s) {
    interval_t *p = s->part;
    if (s->n > s->most) s->most = s->n;
    heap_sort(p, s->n);
    int32_t n = 0;
    for (int32_t k = 0; k < s->n; k++) {
        if (n > 0 && p[n - 1].line == p[k].line && p[k].from_q30 <= p[n - 1].to_q30) {
            if (p[k].to_q30 > p[n - 1].to_q30) p[n - 1].to_q30 = p[k].to_q30;
        } else {
            p[n++] = p[k];
        }
    }
    s->n = n;
}

int intervals_add(intervals_t *s, int32_t line, int32_t from_q30, int32_t to_q30) {
    if (from_q30 >= to_q30) return 0;
    if (s->n == s->n_max) {
        unite(s);
        if (s->n > s->n_max / 8 * 7) return ERR_FULL; /* sorting again and again would take forever */
    }
    s->part[s->n++] = (interval_t){line, from_q30, to_q30};
    return 0;
}

void intervals_drop(intervals_t *s, int32_t line) {
    int32_t n = 0;
    for (int32_t k = 0; k < s->n; k++)
        if (s->part[k].line != line) s->part[n++] = s->part[k];
    s->n = n;
}

/* The parts of s united, and gaps up to the least closed: those that intervals_finish gives, and crumbs. */
static void close_gaps(intervals_t *s, const interval_use_t *use) {
    int32_t n = 0;
    unite(s);
    for (int32_t k = 0; k < s->n;) {
        interval_t whole = s->part[k++];
        int32_t least = use->least(use->ctx, whole.line);
        while (k < s->n && s->part[k].line == whole.line && s->part[k].from_q30 - whole.to_q30 <= least)
            whole.to_q30 = s->part[k++].to_q30;
        s->part[n++] = whole;
    }
    s->n = n;
}

static int give(const interval_use_t *use, int32_t line, int32_t from_q30, int32_t to_q30) {
    const interval_t part = {line, from_q30, to_q30};
    return to_q30 - from_q30 > use->least(use->ctx, line) ? use->part(use->ctx, &part) : 0;
}

int intervals_finish(intervals_t *s, const interval_use_t *use) {
    int err = 0;
    close_gaps(s, use);
    for (int32_t k = 0; k < s->n && !err; k++) err = give(use, s->part[k].line, s->part[k].from_q30, s->part[k].to_q30);
    return err;
}

int intervals_less(intervals_t *a, intervals_t *b, const interval_use_t *use) {
    int err = 0;
    int32_t i = 0;
    close_gaps(a, use);
    close_gaps(b, use);
    for (int32_t k = 0; k < a->n && !err; k++) {
        const interval_t *p = &a->part[k];
        int32_t at = p->from_q30;
        while (i < b->n && (b->part[i].line < p->line || (b->part[i].line == p->line && b->part[i].to_q30 <= at))) i++;
        for (int32_t m = i; m < b->n && b->part[m].line == p->line && b->part[m].from_q30 < p->to_q30 && !err; m++) {
            if (b->part[m].from_q30 > at) err = give(use, p->line, at, b->part[m].from_q30);
            if (b->part[m].to_q30 > at) at = b->part[m].to_q30;
        }
        if (!err && at < p->to_q30) err = give(use, p->line, at, p->to_q30);
    }
    return err;
}
