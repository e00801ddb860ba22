/* windows_close.c - a facet closes windows. */
#include "error.h"
#include "hidden/surface/windows_pool.h"

/* The facet over [a0, a1]: all between two lines that do not cross there. */
typedef struct shutter {
    int32_t a0, a1;
    outline_line_t lo, hi;
    int32_t low, high;
} shutter_t;

/* Enters the abscissa where lines s and t cross between the first and the last of the sorted cuts. */
static int32_t add_cut(int32_t cut[6], int32_t n, const outline_line_t *s, const outline_line_t *t) {
    const int32_t a0 = cut[0], a1 = cut[n - 1];
    const int64_t d0 = (int64_t)windows_line_at(s, a0) - windows_line_at(t, a0);
    const int64_t d1 = (int64_t)windows_line_at(s, a1) - windows_line_at(t, a1);
    if (d0 == 0 || d1 == 0 || (d0 < 0) == (d1 < 0)) return n;
    const int32_t x = windows_crossing(a0, a1, d0, d1);
    int32_t at = n;
    while (at > 0 && cut[at - 1] >= x) at--;
    if (at == 0 || cut[at] == x) return n;
    for (int32_t k = n; k > at; k--) cut[k] = cut[k - 1];
    cut[at] = x;
    return n + 1;
}

/* Twice the height of a line's middle over [a0, a1]. */
static int64_t level(const outline_line_t *s, int32_t a0, int32_t a1) {
    return (int64_t)windows_line_at(s, a0) + windows_line_at(s, a1);
}

/* Puts back what a shutter leaves of a window. */
static int leave(windows_t *w, const window_t *v, const shutter_t *t) {
    int32_t cut[6] = {pencil_max(v->a0, t->a0), pencil_min(v->a1, t->a1)}, n = 2;
    n = add_cut(cut, n, &t->lo, &v->lo);
    n = add_cut(cut, n, &t->lo, &v->hi);
    n = add_cut(cut, n, &t->hi, &v->lo);
    n = add_cut(cut, n, &t->hi, &v->hi);
    int err = windows_insert(w, v->a0, cut[0], &v->lo, &v->hi);
    if (err == 0) err = windows_insert(w, cut[n - 1], v->a1, &v->lo, &v->hi);
    for (int32_t k = 0; k + 1 < n && err == 0; k++) {
        const int32_t a0 = cut[k], a1 = cut[k + 1];
        const int64_t lo = level(&v->lo, a0, a1), hi = level(&v->hi, a0, a1);
        const int64_t bottom = level(&t->lo, a0, a1), top = level(&t->hi, a0, a1);
        if (top < hi) err = windows_insert(w, a0, a1, top > lo ? &t->hi : &v->lo, &v->hi);
        if (err == 0 && bottom > lo && !(top < hi && top <= lo))
            err = windows_insert(w, a0, a1, &v->lo, bottom < hi ? &t->lo : &v->hi);
    }
    return err;
}

static bool touches(const window_t *v, const shutter_t *t) {
    return v->a0 < t->a1 && v->a1 > t->a0 && v->low < t->high && v->high > t->low;
}

/* Takes the windows that the shutter touches out of a list, and puts back what is left of them. */
static int close_list(windows_t *w, int32_t *list, const shutter_t *t) {
    int32_t hit = -1;
    for (int32_t *link = list; *link >= 0;) {
        const int32_t k = *link;
        if (!touches(&w->pool[k], t)) {
            link = &w->pool[k].next;
            continue;
        }
        *link = w->pool[k].next;
        w->pool[k].next = hit;
        hit = k;
    }
    while (hit >= 0) {
        const window_t v = w->pool[hit];
        w->pool[hit].next = w->free;
        w->free = hit;
        w->present--;
        hit = v.next;
        int err = leave(w, &v, t);
        if (err != 0) return err;
    }
    return 0;
}

static int close_between(windows_t *w, const shutter_t *t) {
    for (int32_t b = windows_bin(w, t->a0), last = windows_bin(w, t->a1 - 1); b <= last; b++) {
        const windows_lists_t lists = windows_lists(w, b, t->low, t->high);
        for (int32_t l = 0; l <= lists.last; l = windows_next_list(&lists, l)) {
            if (lists.of[l] < 0) continue;
            int err = close_list(w, &lists.of[l], t);
            if (err != 0) return err;
        }
    }
    return 0;
}

int32_t windows_ends(const outline_line_t *line, int32_t n, int32_t end[WINDOWS_ENDS]) {
    int32_t ends = 0;
    for (int32_t k = 0; k < n; k++) { /* sorted insertion: there are few */
        for (int e = 0; e < 2; e++) {
            int32_t a = e ? line[k].q.a : line[k].p.a, at = ends;
            while (at > 0 && end[at - 1] >= a) at--;
            if (at < ends && end[at] == a) continue;
            for (int32_t m = ends++; m > at; m--) end[m] = end[m - 1];
            end[at] = a;
        }
    }
    return ends;
}

bool windows_span(const outline_line_t *line, int32_t n, int32_t a0, int32_t a1, windows_span_t *v) {
    int32_t lo[2] = {0, 0}, hi[2] = {0, 0};
    *v = (windows_span_t){.a0 = a0, .a1 = a1};
    for (int32_t k = 0; k < n; k++) {
        const outline_line_t *s = &line[k];
        if (s->p.a > a0 || s->q.a < a1) continue;
        const int32_t w0 = windows_line_at(s, a0), w1 = windows_line_at(s, a1);
        if (v->lo == NULL || (int64_t)w0 + w1 < (int64_t)lo[0] + lo[1]) v->lo = s, lo[0] = w0, lo[1] = w1;
        if (v->hi == NULL || (int64_t)w0 + w1 >= (int64_t)hi[0] + hi[1]) v->hi = s, hi[0] = w0, hi[1] = w1;
    }
    v->low = pencil_min(pencil_min(lo[0], lo[1]), pencil_min(hi[0], hi[1]));
    v->high = pencil_max(pencil_max(lo[0], lo[1]), pencil_max(hi[0], hi[1]));
    v->cross = lo[0] > hi[0] || lo[1] > hi[1];
    return v->lo != NULL;
}

int32_t windows_spans(const outline_line_t *line, int32_t n, windows_span_t span[WINDOWS_SPANS]) {
    int32_t end[WINDOWS_ENDS], spans = 0;
    const int32_t ends = windows_ends(line, n, end);
    for (int32_t c = 0; c + 1 < ends && spans < WINDOWS_SPANS; c++) {
        spans += windows_span(line, n, end[c], end[c + 1], &span[spans]);
    }
    return spans;
}

/* A span as two lines that do not cross over [a0, a1]: parts 0 and 1 to the left and right of where they cross. False
 * if there is no such part. */
static bool part_of_span(const windows_span_t *v, int below, int part, shutter_t *t) {
    *t = (shutter_t){v->a0, v->a1, *v->lo, *v->hi, v->low, v->high};
    if (v->lo == v->hi) { /* down or up from a single line */
        outline_line_t *end = below > 0 ? &t->lo : &t->hi;
        const int32_t limit = below > 0 ? ENVELOPE_FLOOR : ENVELOPE_LIMIT;
        *end = (outline_line_t){{v->a0, limit}, {v->a1, limit}};
        *(below > 0 ? &t->low : &t->high) = limit;
        return below != 0 && part == 0;
    }
    if (!v->cross) return part == 0;
    const int64_t d0 = (int64_t)windows_line_at(v->lo, v->a0) - windows_line_at(v->hi, v->a0);
    const int64_t d1 = (int64_t)windows_line_at(v->lo, v->a1) - windows_line_at(v->hi, v->a1);
    *(part == 0 ? &t->a1 : &t->a0) = windows_crossing(v->a0, v->a1, d0, d1);
    if ((part == 0 ? d0 : d1) > 0) t->lo = *v->hi, t->hi = *v->lo;
    return t->a0 < t->a1;
}

int windows_close(windows_t *w, const windows_span_t *span, int32_t spans, int below) {
    for (int32_t k = 0; k < spans && w->present > 0; k++) {
        for (int part = 0; part < 2; part++) {
            shutter_t t;
            if (!part_of_span(&span[k], below, part, &t)) continue;
            int err = close_between(w, &t);
            if (err != 0) return err;
        }
    }
    return 0;
}

int32_t windows_behind(const windows_span_t *span, int32_t spans, int below, const outline_line_t *edge, bool open,
                       windows_part_t part[WINDOWS_PARTS], int32_t n) {
    const int32_t low = pencil_min(edge->p.w, edge->q.w), high = pencil_max(edge->p.w, edge->q.w);
    for (int32_t k = 0; k < spans; k++) {
        const windows_span_t *v = &span[k];
        if (v->a1 <= edge->p.a || v->a0 >= edge->q.a) continue;
        if (v->lo != v->hi && (v->low > high + ENVELOPE_NOISE || v->high < low - ENVELOPE_NOISE)) continue;
        for (int half = 0; half < 2; half++) {
            shutter_t t;
            if (part_of_span(v, below, half, &t))
                n = windows_add_between(&t.lo, &t.hi, t.a0, t.a1, edge, open, part, n);
        }
    }
    return n;
}
