/* clip_families.c - see clip_families.h. Every shape is made on a small lattice and then blown up, mirrored, turned by
 * quarters and jittered by a unit or not at all, since much that goes wrong does so for one direction of the sweep. */
#include "tests/oracle/clip_families.h"

#include <math.h>
#include <stdlib.h>

#include "tests/oracle/scenes.h"

static uint64_t rng;

static int below(int n) {
    return scene_below(&rng, n);
}
static int between(int lo, int hi) {
    return lo + below(hi - lo + 1);
}

/* How lattice points become coordinates. */
static struct {
    int64_t scale, dx, dy;
    int jitter, quarter;
    bool mirror;
} frame;

static void put(clip_shape_t *s, int64_t x, int64_t y) {
    int64_t px = x * frame.scale + frame.dx, py = y * frame.scale + frame.dy;
    if (frame.jitter) {
        px += below(2 * frame.jitter + 1) - frame.jitter;
        py += below(2 * frame.jitter + 1) - frame.jitter;
    }
    if (frame.mirror) px = -px;
    for (int k = 0; k < frame.quarter; k++) {
        const int64_t swap = px;
        px = -py, py = swap;
    }
    if (llabs(px) > POLY_LIMIT || llabs(py) > POLY_LIMIT) abort();
    clip_shape_add(s, (int32_t)px, (int32_t)py);
}

static void box(clip_shape_t *s, int x0, int y0, int x1, int y1) {
    put(s, x0, y0), put(s, x1, y0), put(s, x1, y1), put(s, x0, y1);
    clip_shape_close(s);
}

static void triangle(clip_shape_t *s, int x0, int y0, int x1, int y1, int x2, int y2) {
    put(s, x0, y0), put(s, x1, y1), put(s, x2, y2);
    clip_shape_close(s);
}

/* ---- one shape each: of a pair both are of the same family ---- */

/* Teeth of whole units between two levels, some as narrow as one, some meeting in points. */
static void comb(clip_shape_t *s) {
    const int teeth = between(2, 7), deep = between(1, 6), x0 = below(3), y0 = below(3);
    put(s, x0, y0);
    for (int k = 0; k < teeth; k++) {
        put(s, x0 + 2 * k + below(2), y0 + deep);
        put(s, x0 + 2 * k + 2, y0 + below(2));
    }
    put(s, x0 + 2 * teeth, y0 - below(3));
    put(s, x0, y0 - below(3));
    clip_shape_close(s);
}

/* Stairs up and down: all edges upright or level, many of them on common lines. */
static void terraces(clip_shape_t *s) {
    const int steps = between(2, 8);
    int x = below(4), y = below(4), y_back[9];
    put(s, x, y);
    for (int k = 0; k < steps; k++) {
        y_back[k] = y;
        x += below(3), put(s, x, y);
        y += between(-2, 3), put(s, x, y);
    }
    for (int k = steps - 1; k >= 0; k--) {
        put(s, x, y_back[k] - between(1, 3));
        x -= below(3);
        put(s, x, y_back[k] - between(0, 3));
    }
    clip_shape_close(s);
}

/* Squares of a checkerboard, which meet in corners: unions have holes that touch in points. */
static void checkers(clip_shape_t *s) {
    const int n = between(2, 5), phase = below(2);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            if ((i + j + phase) % 2 == 0 && below(8)) box(s, 2 * i, 2 * j, 2 * i + 2, 2 * j + 2);
    if (!s->out.contours) box(s, 0, 0, 1, 1);
}

/* Rings in rings whose corners touch the sides of the next, as diamonds in squares do. */
static void rings(clip_shape_t *s) {
    int r = 1 << between(1, 4), x = between(-2, 2), y = between(-2, 2);
    for (int k = 0; r > 0; k++) {
        if (k % 2 == 0) {
            box(s, x - r, y - r, x + r, y + r);
        } else {
            put(s, x - r, y), put(s, x, y - r), put(s, x + r, y), put(s, x, y + r);
            clip_shape_close(s);
            r /= 2;
        }
    }
}

/* Triangles round a common corner, which may overlap. */
static void fan(clip_shape_t *s) {
    const int n = between(2, 7), x = between(-1, 1), y = between(-1, 1);
    for (int k = 0; k < n; k++)
        triangle(s, x, y, x + between(-6, 6), y + between(-6, 6), x + between(-6, 6), y + between(-6, 6));
}

/* Slivers a unit wide and as long as there is room, through or past one place. */
static void needles(clip_shape_t *s) {
    const int n = between(1, 4);
    for (int k = 0; k < n; k++) {
        const int x = between(-9, 9), y = between(-9, 9), u = between(-1, 1), v = between(-1, 1);
        if (below(2))
            triangle(s, x, y, -x + u, -y + v, -x, -y);
        else
            put(s, x, y), put(s, x + u, y + v), put(s, -x, -y), put(s, u - x, v - y), clip_shape_close(s);
    }
}

/* A walk that goes anywhere, back over itself, and stands still. */
static void walk(clip_shape_t *s) {
    const int n = between(4, 20);
    int x = below(6), y = below(6);
    for (int k = 0; k < n; k++) {
        put(s, x, y);
        x += between(-3, 3), y += between(-3, 3);
    }
    clip_shape_close(s);
}

/* A zigzag forth, and back another way: a strip that crosses itself in places, with edges shared in others. */
static void ribbon(clip_shape_t *s) {
    const int n = between(2, 8);
    int y[9];
    for (int k = 0; k <= n; k++) put(s, k, y[k] = below(5));
    for (int k = n; k >= 0; k--) put(s, k, below(3) ? y[k] : y[k] + between(-1, 1));
    clip_shape_close(s);
}

/* A spiral of upright and level edges, one or two units wide. */
static void spiral(clip_shape_t *s) {
    static const int way[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const int n = between(3, 9), step = between(1, 2);
    int x[10], y[10], length = step;
    x[0] = between(-1, 1), y[0] = between(-1, 1);
    for (int k = 0; k < n; k++) {
        x[k + 1] = x[k] + way[k % 4][0] * length, y[k + 1] = y[k] + way[k % 4][1] * length;
        if (k % 2) length += step;
    }
    for (int k = 0; k <= n; k++) put(s, x[k], y[k]);
    const int out = below(2);
    for (int k = n; k >= 0; k--) put(s, x[k] + out, y[k] + out);
    clip_shape_close(s);
}

/* Windows in a wall: holes that touch the wall's outline, each other, or share a part of an edge. */
static void windows(clip_shape_t *s) {
    const int n = between(1, 5);
    box(s, 0, 0, 8, 8);
    for (int k = 0; k < n; k++) {
        const int x = below(8), y = below(8), w = between(1, 8 - x), h = between(1, 8 - y);
        if (below(3))
            box(s, x, y, x + w, y + h);
        else
            triangle(s, x, y, x + w, y, x, y + h);
    }
}

typedef void shape_make_t(clip_shape_t *s);
static const struct {
    const char *name;
    shape_make_t *make;
} families[] = {
    {"combs", comb},
    {"terraces", terraces},
    {"checkerboards", checkers},
    {"rings that touch", rings},
    {"fans", fan},
    {"needles", needles},
    {"walks", walk},
    {"ribbons", ribbon},
    {"spirals", spiral},
    {"windows", windows},
};

int clip_family_count(void) {
    return (int)(sizeof families / sizeof *families);
}
const char *clip_family_name(int family) {
    return families[family].name;
}

/* Another frame for the clip polygon: the same, a unit beside it, turned, mirrored. */
static void reframe(void) {
    switch (below(6)) {
    case 0:
        frame.quarter = below(4);
        break;
    case 1:
        frame.mirror = !frame.mirror;
        break;
    case 2:
        frame.dx += between(-1, 1), frame.dy += between(-1, 1);
        break;
    case 3:
        frame.dx += between(-2, 2) * frame.scale, frame.dy += between(-2, 2) * frame.scale;
        break;
    case 4:
        frame.dx += frame.scale / 2, frame.dy += frame.scale / 3;
        break;
    default:
        break;
    }
}

void clip_family_make(int family, uint64_t seed, clip_shape_t *subject, clip_shape_t *clip, enum clip_fill *rule) {
    static const int64_t scales[] = {1, 1, 2, 3, 5, 16, 101, 4099, 1 << 18, 20000000};
    rng = seed;
    frame.scale = scales[below(sizeof scales / sizeof *scales)];
    frame.jitter = frame.scale > 4 && below(3) == 0 ? between(1, 2) : 0;
    frame.dx = frame.dy = 0;
    frame.quarter = below(4);
    frame.mirror = below(2);
    *rule = below(4) == 0 ? CLIP_NONZERO : CLIP_EVEN_ODD;
    const uint64_t again = rng;
    clip_shape_clear(subject);
    families[family].make(subject);
    reframe();
    clip_shape_clear(clip);
    const int partner = below(4);
    if (partner == 0) rng = again; /* the same shape, framed otherwise */
    families[partner == 1 ? below(clip_family_count()) : family].make(clip);
}
