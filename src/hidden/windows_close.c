/* windows_close.c - a facet closes windows. */
#include "error.h"
#include "hidden/windows_pool.h"

/* The facet over [a0, a1]: all between two lines that do not cross there. */
typedef struct shutter {
    int32_t a0, a1;
    bands_line_t lo, hi;
    int32_t low, high;
} shutter_t;

/* Enters the abscissa where lines s and t cross between the first and the last of the sorted cuts. */
static int32_t add_cut(int32_t cut[6], int32_t n, const bands_line_t *s, const bands_line_t *t) {
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
static int64_t level(const bands_line_t *s, int32_t a0, int32_t a1) {
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

static int close_between(windows_t *w, int32_t a0, int32_t a1, const bands_line_t *lo, const bands_line_t *hi) {
    const int32_t lo0 = windows_line_at(lo, a0), lo1 = windows_line_at(lo, a1);
    const int32_t hi0 = windows_line_at(hi, a0), hi1 = windows_line_at(hi, a1);
    const shutter_t t = {a0, a1, *lo, *hi, pencil_min(lo0, lo1), pencil_max(hi0, hi1)};
    for (int32_t b = windows_bin(w, a0), last = windows_bin(w, a1 - 1); b <= last; b++) {
        const windows_lists_t lists = windows_lists(w, b, t.low, t.high);
        for (int32_t l = 0; l <= lists.last; l = windows_next_list(&lists, l)) {
            int err = close_list(w, &lists.of[l], &t);
            if (err != 0) return err;
        }
    }
    return 0;
}

/* Closes between two lines over [a0, a1] that may cross once. */
static int close_pair(windows_t *w, int32_t a0, int32_t a1, const bands_line_t *s, const bands_line_t *t) {
    int32_t cut[6] = {a0, a1};
    const int32_t n = add_cut(cut, 2, s, t);
    for (int32_t k = 0; k + 1 < n; k++) {
        const bool up = level(s, cut[k], cut[k + 1]) < level(t, cut[k], cut[k + 1]);
        int err = close_between(w, cut[k], cut[k + 1], up ? s : t, up ? t : s);
        if (err != 0) return err;
    }
    return 0;
}

int32_t windows_spans(const bands_line_t *line, int32_t n, windows_span_t span[2 * BANDS_LINES]) {
    int32_t cut[2 * BANDS_LINES], cuts = 0, spans = 0;
    for (int32_t k = 0; k < n; k++) { /* sorted insertion: there are few */
        for (int e = 0; e < 2; e++) {
            int32_t a = e ? line[k].q.a : line[k].p.a, at = cuts;
            while (at > 0 && cut[at - 1] >= a) at--;
            if (at < cuts && cut[at] == a) continue;
            for (int32_t m = cuts++; m > at; m--) cut[m] = cut[m - 1];
            cut[at] = a;
        }
    }
    for (int32_t c = 0; c + 1 < cuts; c++) {
        windows_span_t *v = &span[spans];
        *v = (windows_span_t){.a0 = cut[c], .a1 = cut[c + 1]};
        for (int32_t k = 0; k < n; k++) {
            const bands_line_t *s = &line[k];
            if (s->p.a > v->a0 || s->q.a < v->a1) continue;
            if (v->lo == NULL || level(s, v->a0, v->a1) < level(v->lo, v->a0, v->a1)) v->lo = s;
            if (v->hi == NULL || level(s, v->a0, v->a1) >= level(v->hi, v->a0, v->a1)) v->hi = s;
        }
        spans += v->lo != NULL;
    }
    return spans;
}

int windows_close(windows_t *w, const bands_line_t *line, int32_t n, int below) {
    windows_span_t span[2 * BANDS_LINES];
    if (w->present == 0) return 0;
    const int32_t spans = windows_spans(line, n, span);
    int err = 0;
    for (int32_t k = 0; k < spans && err == 0; k++) {
        const windows_span_t *v = &span[k];
        const int32_t limit = below > 0 ? ENVELOPE_FLOOR : ENVELOPE_LIMIT;
        const bands_line_t end = {{v->a0, limit}, {v->a1, limit}};
        if (v->lo == v->hi && below == 0) continue;
        err = close_pair(w, v->a0, v->a1, v->lo, v->lo == v->hi ? &end : v->hi);
    }
    return err;
}
