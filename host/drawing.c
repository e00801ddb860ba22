/* drawing.c - two growing arrays. They double, so a point costs amortised constant time, and a page that is
 * drawn again reuses them.
 *
 * An array that begins to be large is moved to huge pages: to get memory by small ones costs more than the copy. */
#include "host/drawing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "host/huge_pages.h"

/* In bytes. Sizes are FIRST_ROOM * 2^k up to LARGE, then LARGE_ROOM * 2^k. */
#define FIRST_ROOM ((size_t)8 << 10)
#define LARGE ((size_t)512 << 10)
#define LARGE_ROOM ((size_t)8 << 20)

void drawing_init(drawing_t *d) {
    memset(d, 0, sizeof *d);
    drawing_clear(d);
    d->width_um = 297000;
    d->height_um = 210000;
    for (int i = 0; i < 2; i++) d->camera_mm[i][i] = 1;
    d->camera_mm[2][3] = 1;
}

void drawing_clear(drawing_t *d) {
    d->points = d->strokes = 0;
    d->changes = 0;
    d->lifted = true;
    d->over = (page_point_t){0, 0};
}

void drawing_free(drawing_t *d) {
    free(d->point);
    free(d->first);
    memset(d, 0, sizeof *d);
}

static double double_from_num(num_t a) {
    return a.undef ? (double)NAN : ldexp((double)a.m, a.e);
}

void drawing_set_camera(drawing_t *d, const camera_t *c) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            double v = double_from_num(c->m[i][j]);
            d->camera_mm[i][j] = i < 2 ? v / LAT_PER_MM : v;
        }
}

/* How many bytes the character of UTF-8 at s has; 0 if there is none: a byte out of place, an overlong form, a
 * surrogate, or beyond U+10FFFF. */
static size_t utf8_length(const char *s) {
    static const unsigned LEAST[] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned char first = (unsigned char)*s;
    size_t n = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
    if (n < 2) return n;
    unsigned code = first & (0x7fu >> n);
    for (size_t k = 1; k < n; k++) {
        if (((unsigned char)s[k] & 0xc0) != 0x80) return 0;
        code = code << 6 | ((unsigned char)s[k] & 0x3fu);
    }
    return code < LEAST[n] || code > 0x10ffff || code >> 11 == 0xd800 >> 11 ? 0 : n;
}

void drawing_set_title(drawing_t *d, const char *title) {
    size_t at = 0, n;
    for (const char *s = title; *s; s += n ? n : 1) {
        n = utf8_length(s);
        const char *c = n == 0 ? "?" : n == 1 && ((unsigned char)*s < ' ' || *s == 0x7f) ? " " : s;
        size_t take = n ? n : 1;
        if (at + take >= sizeof d->title) break;
        memcpy(d->title + at, c, take);
        at += take;
    }
    d->title[at] = 0;
}

static void ask_huge_pages(void *p, size_t bytes) {
    const uintptr_t from = ((uintptr_t)p + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE, end = (uintptr_t)p + bytes;
    if (bytes >= 2 * HUGE_PAGE) huge_pages_ask((void *)from, end - from);
}

/* What an array holds, in so much memory that begins with a huge page. */
static void *move_to_huge_pages(void *array, size_t used, size_t bytes) {
    void *p;
    if (posix_memalign(&p, HUGE_PAGE, bytes) != 0) return NULL;
    ask_huge_pages(p, bytes);
    memcpy(p, array, used);
    free(array);
    return p;
}

/* Makes *array hold at least one item more than `used`. It doubles, and is moved once, where it begins to be large. */
static bool make_room(void **array, size_t used, size_t *room, size_t item) {
    if (used < *room) return true;
    const bool begins = *room * item == LARGE;
    const size_t want = begins ? LARGE_ROOM / item : *room ? *room * 2 : FIRST_ROOM / item;
    if (want > SIZE_MAX / item) return false;
    void *p = begins ? move_to_huge_pages(*array, used * item, want * item) : realloc(*array, want * item);
    if (!p) return false;
    if (!begins) ask_huge_pages(p, want * item);
    *array = p;
    *room = want;
    return true;
}

static void hand_on(drawing_t *d) {
    if (d->points > 0) d->take(d->take_ctx, d->point, d->points);
    d->points = 0;
}

static int add_point(drawing_t *d, page_point_t p) {
    if (d->points == d->point_room && !make_room((void **)&d->point, d->points, &d->point_room, sizeof *d->point))
        return ERR_FULL;
    d->point[d->points++] = p;
    return 0;
}

void drawing_hand_on(drawing_t *d, drawing_take_t *take, void *ctx) {
    if (d->take) hand_on(d);
    d->take = take;
    d->take_ctx = ctx;
}

static int sink_move(void *ctx, page_point_t to) {
    drawing_t *d = ctx;
    if (d->take) hand_on(d);
    d->lifted = true;
    d->over = to;
    return 0;
}

static int begin_stroke(drawing_t *d) {
    if (!d->take) {
        if (d->strokes == d->stroke_room &&
            !make_room((void **)&d->first, d->strokes, &d->stroke_room, sizeof *d->first))
            return ERR_FULL;
        d->first[d->strokes] = d->points;
    }
    int err = add_point(d, d->over);
    if (err) return err;
    d->strokes++;
    d->lifted = false;
    return 0;
}

static int sink_draw(void *ctx, page_point_t to) {
    drawing_t *d = ctx;
    if (d->lifted) {
        int err = begin_stroke(d);
        if (err) return err;
    }
    return add_point(d, to);
}

pen_sink_t drawing_sink(drawing_t *d) {
    return (pen_sink_t){.ctx = d, .move = sink_move, .draw = sink_draw};
}

int drawing_pen(const drawing_t *d, size_t s) {
    int pen = 1;
    for (int k = 0; k < d->changes && d->change[k].stroke <= s; k++) pen = d->change[k].pen;
    return pen;
}

int drawing_take_pen(drawing_t *d, int pen) {
    if (drawing_pen(d, d->strokes) == pen) return 0;
    if (d->changes == DRAWING_CHANGES_MAX) return ERR_FULL;
    d->change[d->changes].stroke = d->strokes;
    d->change[d->changes++].pen = pen;
    return 0;
}

unsigned drawing_colour(int pen) {
    static const unsigned COLOUR[] = {0x000000, 0xc8201e, 0x1f4fb4, 0x23803a, 0x8a4a12, 0x7a2a96, 0xd97a00, 0x6f7580};
    return COLOUR[(unsigned)(pen - 1) % (sizeof COLOUR / sizeof COLOUR[0])];
}

bool drawing_has_pens(const drawing_t *d) {
    return d->changes > 0;
}

const page_point_t *drawing_stroke(const drawing_t *d, size_t s, size_t *n) {
    size_t end = s + 1 < d->strokes ? d->first[s + 1] : d->points;
    *n = end - d->first[s];
    return d->point + d->first[s];
}

static double distance_mm(page_point_t a, page_point_t b) {
    double x = (double)b.x_lat - a.x_lat, y = (double)b.y_lat - a.y_lat;
    return sqrt(x * x + y * y) / LAT_PER_MM;
}

drawing_length_t drawing_measure(const drawing_t *d) {
    drawing_length_t len = {0};
    page_point_t at = {0, 0};
    for (size_t s = 0; s < d->strokes; s++) {
        size_t n;
        const page_point_t *p = drawing_stroke(d, s, &n);
        len.up_mm += distance_mm(at, p[0]);
        for (size_t i = 1; i < n; i++) len.down_mm += distance_mm(p[i - 1], p[i]);
        at = p[n - 1];
    }
    if (d->strokes) len.up_mm += distance_mm(at, (page_point_t){0, 0});
    return len;
}
