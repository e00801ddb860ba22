/* windows.c - see windows.h: keeping them, opening them, looking through them. */
#include "hidden/surface/windows.h"

#include "error.h"
#include "hidden/surface/windows_pool.h"

#define ONE_Q30 (INT32_C(1) << 30)

static int32_t lists_of(const windows_t *w, int32_t bands) {
    return (INT32_C(1) << (31 - w->shift)) * (1 + bands);
}

static void lay_out(windows_t *w, int32_t bands) {
    w->bands = bands;
    for (int32_t k = 0, lists = lists_of(w, bands); k < lists; k++) w->list[k] = -1;
}

/* How many bands there may be, and what the lists take then. */
static size_t plan(windows_t *w, int32_t n, size_t bytes) {
    size_t size = sizeof(int32_t) * (size_t)lists_of(w, 0);
    for (int32_t bands = WINDOWS_BANDS; bands == WINDOWS_BANDS || (CONFIG_64BIT && bands <= n / 8); bands *= 2) {
        const size_t more = sizeof(int32_t) * (size_t)lists_of(w, bands);
        if (more > bytes / 4) break;
        size = more;
        w->most_bands = bands;
    }
    return (size + 7) / 8 * 8;
}

int windows_init(windows_t *w, int32_t n, void *mem, size_t bytes) {
    int32_t bits = 3; /* a scene fills a fourth of the abscissae at least */
    while (bits < 14 && (INT32_C(1) << bits) < 2 * n && (sizeof(int32_t) << bits) < bytes / 16) bits++;
    *w = (windows_t){.list = mem, .shift = (int8_t)(31 - bits), .free = -1};
    size_t size = plan(w, n, bytes);
    size_t levels = WINDOWS_LEVELS * sizeof *w->band_of;
    if (!CONFIG_64BIT || w->most_bands == 0 || levels > bytes / 16) levels = 0;
    if (bytes < size + levels + 4 * sizeof(window_t)) return ERR_FULL;
    if (levels != 0) {
        w->band_of = (uint16_t *)(void *)((uint8_t *)mem + size);
        for (int32_t k = 0; k < WINDOWS_LEVELS; k++) w->band_of[k] = (uint16_t)(k / (WINDOWS_LEVELS / WINDOWS_BANDS));
    }
    size += levels;
    w->pool = (window_t *)(void *)((uint8_t *)mem + size);
    w->spare = (envelope_spare_t){(uint8_t *)w->pool, (uint8_t *)mem + bytes};
    lay_out(w, w->most_bands == 0 ? 0 : WINDOWS_BANDS);
    w->few = lists_of(w, w->bands) / 2;
    return 0;
}

/* Takes all windows off their lists. Returns the first of the one that they make then. */
static int32_t take_off(windows_t *w) {
    int32_t all = -1;
    for (int32_t l = 0, lists = lists_of(w, w->bands); l < lists; l++) {
        for (int32_t k = w->list[l], next; k >= 0; k = next) {
            next = w->pool[k].next;
            w->pool[k].next = all;
            all = k;
        }
    }
    return all;
}

/* Divides the ordinates among the bands: half of them evenly, half as the windows lie. */
static void divide(windows_t *w, int32_t all) {
    uint16_t *share = w->band_of;
    int64_t sum = 0, below = 0;
    int32_t even = w->present / WINDOWS_LEVELS + 1;
    even = pencil_min(even, UINT16_MAX / 2);
    for (int32_t k = 0; k < WINDOWS_LEVELS; k++) share[k] = (uint16_t)even;
    for (int32_t k = all; k >= 0; k = w->pool[k].next) {
        uint16_t *s = &share[windows_level(w->pool[k].low)];
        if (*s < UINT16_MAX) ++*s;
    }
    for (int32_t k = 0; k < WINDOWS_LEVELS; k++) sum += share[k];
    for (int32_t k = 0; k < WINDOWS_LEVELS; k++) {
        const int32_t here = share[k];
        share[k] = (uint16_t)(below * w->bands / sum);
        below += here;
    }
}

/* Makes twice as many bands, if there may be. */
static void refine(windows_t *w) {
    const int32_t all = take_off(w);
    lay_out(w, pencil_min(2 * w->bands, w->most_bands));
    divide(w, all);
    for (int32_t k = all, next; k >= 0; k = next) {
        window_t *v = &w->pool[k];
        int32_t *list = windows_list_of(w, windows_bin(w, v->a0), v->low, v->high);
        next = v->next;
        v->next = *list;
        *list = k;
    }
    w->few = 2 * w->present;
}

size_t windows_bytes(const windows_t *w) {
    return (size_t)((const uint8_t *)(w->pool + w->used) - (const uint8_t *)w->list);
}

bool windows_any(const windows_t *w, int32_t a0, int32_t a1, int32_t low, int32_t high) {
    if (w->present == 0) return false;
    for (int32_t b = windows_bin(w, a0), last = windows_bin(w, a1); b <= last; b++) {
        const windows_lists_t lists = windows_lists(w, b, low, high);
        for (int32_t l = 0; l <= lists.last; l = windows_next_list(&lists, l)) {
            for (int32_t k = lists.of[l]; k >= 0; k = w->pool[k].next) {
                const window_t *v = &w->pool[k];
                if (v->a0 <= a1 && v->a1 >= a0 && v->low <= high && v->high >= low) return true;
            }
        }
    }
    return false;
}

static bool same_line(const outline_line_t *s, const outline_line_t *t) {
    return envelope_same(s->p, t->p) && envelope_same(s->q, t->q);
}

/* Makes a window of the list longer if v continues it and the list is still right for both. */
static bool join(windows_t *w, int32_t bin, const int32_t *list, const window_t *v) {
    for (int32_t k = *list; k >= 0; k = w->pool[k].next) {
        window_t *u = &w->pool[k];
        if (u->a1 != v->a0 && u->a0 != v->a1) continue;
        if (!same_line(&u->lo, &v->lo) || !same_line(&u->hi, &v->hi)) continue;
        const int32_t low = pencil_min(u->low, v->low), high = pencil_max(u->high, v->high);
        if (windows_list_of(w, bin, low, high) != list) continue;
        *u = (window_t){.a0 = pencil_min(u->a0, v->a0),
                        .a1 = pencil_max(u->a1, v->a1),
                        .lo = u->lo,
                        .hi = u->hi,
                        .low = low,
                        .high = high,
                        .next = u->next};
        return true;
    }
    return false;
}

/* Is it within the noise when two lines are so far apart at some abscissa? Along steep lines the noise is across them:
 * a unit of a is worth many of w. */
static bool is_noise(const outline_line_t *s, const outline_line_t *t, int64_t apart) {
    const int64_t size = apart < 0 ? -apart : apart;
    if (size <= ENVELOPE_NOISE) return true;
    return size * (s->q.a - s->p.a) <= envelope_noise(s->p, s->q) &&
           size * (t->q.a - t->p.a) <= envelope_noise(t->p, t->q);
}

/* Is a window so low at one of its ends that nothing shows through? */
static bool is_closed(const outline_line_t *lo, const outline_line_t *hi, int64_t height) {
    return height <= 0 || is_noise(lo, hi, height);
}

int windows_insert(windows_t *w, int32_t a0, int32_t a1, const outline_line_t *lo, const outline_line_t *hi) {
    while (a0 < a1) {
        const int32_t bin = windows_bin(w, a0);
        const int64_t border = (((int64_t)bin + 1) << w->shift) - (INT64_C(1) << 30);
        const int32_t end = border < a1 ? (int32_t)border : a1;
        const int32_t lo0 = windows_line_at(lo, a0), lo1 = windows_line_at(lo, end);
        const int32_t hi0 = windows_line_at(hi, a0), hi1 = windows_line_at(hi, end);
        window_t v = {
            .a0 = a0, .a1 = end, .lo = *lo, .hi = *hi, .low = pencil_min(lo0, lo1), .high = pencil_max(hi0, hi1)};
        a0 = end;
        if (is_closed(lo, hi, (int64_t)hi0 - lo0) && is_closed(lo, hi, (int64_t)hi1 - lo1)) continue;
        int32_t *list = windows_list_of(w, bin, v.low, v.high);
        if (join(w, bin, list, &v)) continue;
        int32_t at = w->free;
        if (at >= 0) {
            w->free = w->pool[at].next;
        } else {
            const bool fits = (size_t)(w->spare.to - w->spare.from) >= sizeof *w->pool;
            if (!fits && !(w->above != NULL && envelope_give_back(w->above, sizeof *w->pool))) return ERR_FULL;
            w->spare.from += sizeof *w->pool;
            at = w->used++;
        }
        v.next = *list;
        w->pool[at] = v;
        *list = at;
        w->present++;
    }
    return 0;
}

/* Opens a window over [a0, a1] where hi is above lo by more than the noise at one end at least. */
static int open_between(windows_t *w, int32_t a0, int32_t a1, const outline_line_t *lo, const outline_line_t *hi) {
    const int64_t d0 = (int64_t)windows_line_at(hi, a0) - windows_line_at(lo, a0);
    const int64_t d1 = (int64_t)windows_line_at(hi, a1) - windows_line_at(lo, a1);
    if (d0 <= ENVELOPE_NOISE && d1 <= ENVELOPE_NOISE) return 0;
    const int32_t x = windows_crossing(a0, a1, d0, d1);
    return windows_insert(w, d0 < 0 ? x : a0, d1 < 0 ? x : a1, lo, hi);
}

int windows_open(windows_t *w, envelope_t *h, pencil_t p, pencil_t q, bool lower) {
    const outline_line_t edge = lower ? (outline_line_t){{p.a, -p.w}, {q.a, -q.w}} : (outline_line_t){p, q};
    if (CONFIG_64BIT && w->band_of != NULL && w->present > w->few) refine(w);
    envelope_seek(h, p.a);
    pencil_t v = h->l[-1];
    int err = 0;
    pencil_t r;
    for (int32_t k = 0; v.a < q.a && err == 0; v = r) {
        r = h->r[k++]; /* horizons move to make room */
        const int32_t a0 = pencil_max(v.a, p.a), a1 = pencil_min(r.a, q.a);
        if (a0 >= a1 || v.w == ENVELOPE_FLOOR || r.w == ENVELOPE_FLOOR) continue;
        const outline_line_t old = lower ? (outline_line_t){{v.a, -v.w}, {r.a, -r.w}} : (outline_line_t){v, r};
        err = lower ? open_between(w, a0, a1, &edge, &old) : open_between(w, a0, a1, &old, &edge);
    }
    return err;
}

int32_t windows_add_part(windows_part_t part[WINDOWS_PARTS], int32_t n, windows_part_t v) {
    int32_t from = n, to = n; /* the parts [from, to) touch it */
    while (from > 0 && part[from - 1].to_q30 >= v.from_q30) from--;
    while (to > from && part[to - 1].from_q30 > v.to_q30) to--;
    if (from < to) {
        v.from_q30 = pencil_min(v.from_q30, part[from].from_q30);
        v.to_q30 = pencil_max(v.to_q30, part[to - 1].to_q30);
    } else if (n == WINDOWS_PARTS) {
        return n;
    }
    const int32_t by = from + 1 - to;
    if (by > 0) {
        for (int32_t k = n; k > to; k--) part[k] = part[k - 1];
    } else {
        for (int32_t k = to; by < 0 && k < n; k++) part[k + by] = part[k];
    }
    part[from] = v;
    return n + by;
}

static int32_t at_zero(int64_t d0, int64_t d1) {
    const uint64_t n = (uint64_t)(d0 < 0 ? -d0 : d0), m = (uint64_t)(d1 < 0 ? -d1 : d1);
    return (int32_t)pencil_fraction(n, n + m);
}

/* How far the edge is above the line at x. What is within the noise lies on it. */
static int64_t off(const outline_line_t *edge, const outline_line_t *line, int32_t x) {
    const int64_t d = (int64_t)windows_line_at(edge, x) - windows_line_at(line, x);
    return is_noise(edge, line, d) ? 0 : d;
}

/* The part of [s, t] in which the edge is between two lines; open: and off them. False if none. */
static bool inside(const outline_line_t *lo, const outline_line_t *hi, const outline_line_t *edge, int32_t s, int32_t t,
                   bool open, windows_part_t *out) {
    const int64_t over[2] = {off(edge, lo, s), off(edge, lo, t)};
    const int64_t under[2] = {-off(edge, hi, s), -off(edge, hi, t)};
    *out = (windows_part_t){0, ONE_Q30};
    for (int k = 0; k < 2; k++) {
        const int64_t d0 = k ? under[0] : over[0], d1 = k ? under[1] : over[1];
        if (d0 <= 0 && d1 <= 0 && (open || d0 < 0 || d1 < 0)) return false;
        if (d0 < 0) out->from_q30 = pencil_max(out->from_q30, at_zero(d0, d1));
        if (d1 < 0) out->to_q30 = pencil_min(out->to_q30, at_zero(d0, d1));
    }
    return out->from_q30 < out->to_q30;
}

int32_t windows_add_between(const outline_line_t *lo, const outline_line_t *hi, int32_t a0, int32_t a1,
                            const outline_line_t *edge, bool open, windows_part_t part[WINDOWS_PARTS], int32_t n) {
    const pencil_t p = edge->p, q = edge->q;
    const int32_t s = pencil_max(p.a, a0), t = pencil_min(q.a, a1);
    const uint32_t run = (uint32_t)(q.a - p.a);
    windows_part_t in;
    if (s >= t || !inside(lo, hi, edge, s, t, open, &in)) return n;
    const int32_t f0 = s == p.a ? 0 : (int32_t)pencil_fraction((uint32_t)(s - p.a), run);
    const int32_t f1 = t == q.a ? ONE_Q30 : (int32_t)pencil_fraction((uint32_t)(t - p.a), run);
    const int32_t from = in.from_q30 == 0 ? f0 : f0 + (int32_t)(((int64_t)(f1 - f0) * in.from_q30) >> 30);
    const int32_t to = in.to_q30 == ONE_Q30 ? f1 : f0 + (int32_t)(((int64_t)(f1 - f0) * in.to_q30) >> 30);
    return from < to ? windows_add_part(part, n, (windows_part_t){from, to}) : n;
}

/* Adds the part of an edge that is in window v, if any. */
static int32_t clip_one(const window_t *v, const outline_line_t *edge, windows_part_t part[WINDOWS_PARTS], int32_t n) {
    const pencil_t p = edge->p, q = edge->q;
    if (v->low > pencil_max(p.w, q.w) || v->high < pencil_min(p.w, q.w)) return n;
    return windows_add_between(&v->lo, &v->hi, v->a0, v->a1, edge, true, part, n);
}

int32_t windows_clip(const windows_t *w, pencil_t p, pencil_t q, windows_part_t part[WINDOWS_PARTS]) {
    const int32_t low = pencil_min(p.w, q.w), high = pencil_max(p.w, q.w), units = pencil_max(q.a - p.a, high - low);
    const outline_line_t edge = {p, q};
    int32_t n = 0, kept = 0;
    if (w->present == 0) return 0;
    for (int32_t b = windows_bin(w, p.a), last = windows_bin(w, q.a - 1); b <= last; b++) {
        const windows_lists_t lists = windows_lists(w, b, low, high);
        for (int32_t l = 0; l <= lists.last; l = windows_next_list(&lists, l)) {
            for (int32_t k = lists.of[l]; k >= 0; k = w->pool[k].next) n = clip_one(&w->pool[k], &edge, part, n);
        }
    }
    for (int32_t k = 0; k < n; k++) {
        const bool noise = ((int64_t)(part[k].to_q30 - part[k].from_q30) * units) >> 30 <= ENVELOPE_NOISE;
        if (!noise || (part[k].from_q30 == 0 && part[k].to_q30 == ONE_Q30)) part[kept++] = part[k];
    }
    return kept;
}

int32_t windows_clip_vertical(const windows_t *w, int32_t x, int32_t low, int32_t high,
                              windows_part_t part[WINDOWS_PARTS], int32_t n) {
    const windows_lists_t lists = windows_lists(w, windows_bin(w, x), low, high);
    const uint32_t height = (uint32_t)(high - low);
    for (int32_t l = 0; l <= lists.last; l = windows_next_list(&lists, l)) {
        for (int32_t k = lists.of[l]; k >= 0; k = w->pool[k].next) {
            const window_t *v = &w->pool[k];
            if (v->a0 > x || v->a1 < x) continue;
            const int32_t from = pencil_max(low, windows_line_at(&v->lo, x));
            const int32_t to = pencil_min(high, windows_line_at(&v->hi, x));
            if (to - from <= ENVELOPE_NOISE) continue;
            const windows_part_t in = {(int32_t)pencil_fraction((uint32_t)(from - low), height),
                                       (int32_t)pencil_fraction((uint32_t)(to - low), height)};
            n = windows_add_part(part, n, in);
        }
    }
    return n;
}
