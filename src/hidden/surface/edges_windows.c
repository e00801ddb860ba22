/* edges_windows.c - one grid edge against two horizons and the windows between them. */
#include "hidden/surface/edges_parts.h"

/* Takes parts of a line; turn: they count from end 1. */
static int take_parts(edges_t *e, const windows_part_t *part, int32_t n, bool turn) {
    int err = 0;
    for (int32_t k = 0; k < n && err == 0; k++) {
        const int32_t from = part[k].from_q30, to = part[k].to_q30;
        err = edges_take_part(e,
                              turn ? (envelope_part_t){.from_q30 = ONE_Q30 - to, .to_q30 = ONE_Q30 - from}
                                   : (envelope_part_t){.from_q30 = from, .to_q30 = to},
                              false);
    }
    return err;
}

/* Adds what shows of a vertical line at abscissa x, to its left or right: beyond the horizons, or in a window. */
static int32_t add_beside(edges_t *e, int32_t x, int32_t low, int32_t high, windows_part_t part[WINDOWS_PARTS],
                          int32_t n) {
    const int32_t top = envelope_limits(&e->horizons.upper, x).left;
    const int32_t bottom = -envelope_limits(&e->horizons.lower, x).left;
    const uint32_t height = (uint32_t)(high - low);
    n = windows_clip_vertical(&e->windows, x, low, high, part, n);
    if (high > top + ENVELOPE_NOISE) {
        const int32_t from = top <= low ? 0 : (int32_t)pencil_fraction((uint32_t)(top - low), height);
        n = windows_add_part(part, n, (windows_part_t){from, ONE_Q30});
    }
    if (low < bottom - ENVELOPE_NOISE) {
        const int32_t to = bottom >= high ? ONE_Q30 : (int32_t)pencil_fraction((uint32_t)(bottom - low), height);
        n = windows_add_part(part, n, (windows_part_t){0, to});
    }
    return n;
}

/* A line in the eye's own plane shows where it would to the side on which the facet at hand is. If it is vertical only
 * nearly, rounding does not say on which side it is: it shows where it would on either. */
static int __attribute__((noinline)) clip_vertical_windowed(edges_t *e, pencil_t p0, pencil_t p1) {
    const int32_t low = pencil_min(p0.w, p1.w), high = pencil_max(p0.w, p1.w);
    const bool both = !e->horizons.in_plane, right = edges_facet_is_right(e, p0, p1);
    windows_part_t part[WINDOWS_PARTS];
    int32_t n = 0;
    if (low == high) return 0;
    if (both || right) n = add_beside(e, pencil_max(p0.a, p1.a) + 1, low, high, part, n);
    if (both || !right) n = add_beside(e, pencil_min(p0.a, p1.a) - 1, low, high, part, n);
    return take_parts(e, part, n, p1.w < p0.w);
}

/* Notes what the other surfaces' facets in the cell hide of a line from left to right; turn: p0 is on the right. */
static void look_behind(edges_t *e, pencil_t l, pencil_t r, bool turn) {
    const outline_line_t line = {l, r};
    int32_t n = 0;
    for (int32_t k = 0; k < e->sheets; k++) {
        const edges_sheet_t *s = &e->sheet[k];
        n = windows_behind(s->span, s->spans, s->below, &line, s->open, e->behind, n);
    }
    e->behinds = n;
    for (int32_t k = 0; turn && k < (n + 1) / 2; k++) {
        const windows_part_t a = e->behind[k], b = e->behind[n - 1 - k];
        e->behind[k] = (windows_part_t){ONE_Q30 - b.to_q30, ONE_Q30 - b.from_q30};
        e->behind[n - 1 - k] = (windows_part_t){ONE_Q30 - a.to_q30, ONE_Q30 - a.from_q30};
    }
}

/* Takes what of a line is in windows. Apart: the parts need not be on the stack while the horizons are looked at. */
static int __attribute__((noinline)) take_in_windows(edges_t *e, pencil_t l, pencil_t r, bool turn) {
    windows_part_t part[WINDOWS_PARTS];
    return take_parts(e, part, windows_clip(&e->windows, l, r, part), turn);
}

/* Takes what is visible of a line; the cover stays as it is. */
static int look(edges_t *e, pencil_t p0, pencil_t p1, pencil_t l, pencil_t r, bool turn) {
    look_behind(e, l, r, turn);
    int err = take_in_windows(e, l, r, turn);
    if (err == 0) err = horizons_look(&e->horizons, p0, p1);
    e->behinds = 0;
    return err;
}

/* Opens windows between a bare line and the horizons. */
static int open_windows(edges_t *e, pencil_t l, pencil_t r) {
    int err = windows_open(&e->windows, &e->horizons.upper, l, r, false);
    if (err != 0) return err;
    return windows_open(&e->windows, &e->horizons.lower, (pencil_t){l.a, -l.w}, (pencil_t){r.a, -r.w}, true);
}

int edges_clip_windowed(edges_t *e, pencil_t p0, pencil_t p1) {
    const bool turn = p1.a < p0.a;
    const pencil_t l = turn ? p1 : p0, r = turn ? p0 : p1;
    const bool vertical = envelope_vertical(l, r);
    int err = 0;
    if (vertical && e->work != EDGES_COVER) err = clip_vertical_windowed(e, p0, p1);
    if (err != 0 || l.a == r.a) return err;
    if (e->work == EDGES_LOOK) return vertical ? 0 : look(e, p0, p1, l, r, turn);
    if (!vertical && e->work == EDGES_CLIP && e->windows.present > 0) err = take_in_windows(e, l, r, turn);
    if (err == 0 && e->bare) err = open_windows(e, l, r);
    if (err != 0) return err;
    return vertical || e->work == EDGES_COVER ? horizons_raise(&e->horizons, l, r)
                                              : horizons_clip(&e->horizons, p0, p1);
}

int edges_cover_below(edges_t *e, const windows_span_t *span, int32_t spans, int8_t below) {
    envelope_t *h = below > 0 ? &e->horizons.lower : &e->horizons.upper;
    for (int32_t k = 0; k < spans; k++) {
        if (span[k].lo != span[k].hi) continue;
        const pencil_t l = {span[k].a0, PENCIL_LIMIT}, r = {span[k].a1, PENCIL_LIMIT}; /* the lower one has w negated */
        int n = envelope_clip(h, l, r, NULL, NULL, &e->horizons.count);
        if (n < 0) return n;
    }
    return 0;
}
