/* simplify.c - cone intersection. See simplify.h.
 *
 *          apex                         v1's offsets:  v1 +- (0, tol) if |dx| >= |dy|, else v1 +- (tol, 0)
 *            *-----______  left         cone: directions between right and left, counter-clockwise
 *             \    v1 |  ------         next vertex inside: it may replace all before; the cone shrinks by its offsets
 *              \______|__                          outside: the vertex before it becomes the apex
 *                  right
 */
#include "path/simplify.h"

static int64_t cross(const int32_t a[2], const int32_t b[2]) {
    return (int64_t)a[0] * b[1] - (int64_t)a[1] * b[0];
}
static int64_t dot(const int32_t a[2], const int32_t b[2]) {
    return (int64_t)a[0] * b[0] + (int64_t)a[1] * b[1];
}
static int32_t magnitude(int32_t v) {
    return v < 0 ? -v : v;
}
static bool is_same(page_point_t a, page_point_t b) {
    return a.x_lat == b.x_lat && a.y_lat == b.y_lat;
}

static void between(page_point_t a, page_point_t b, int32_t v[2]) {
    v[0] = b.x_lat - a.x_lat;
    v[1] = b.y_lat - a.y_lat;
}

void simplify_init(simplify_t *s, int32_t tol_lat, pen_sink_t out) {
    *s = (simplify_t){.tol_lat = tol_lat, .out = out};
}

/* Gives out `last`; it is the next apex. */
static int give(simplify_t *s) {
    int err = 0;
    if (!s->moved) err = s->out.move(s->out.ctx, s->apex);
    s->moved = true;
    s->apex = s->last;
    s->pending = s->cone = false;
    return err ? err : s->out.draw(s->out.ctx, s->apex);
}

/* Shrinks the cone by the offsets of a vertex at v from the apex. A vertex within the tolerance of the apex leaves all
 * directions open. Otherwise the larger component exceeds tol / 2, so the offsets span less than half a turn, and any
 * direction between them makes an acute angle with v: the foot of the vertex lies on the segment, not before it. */
static void narrow(simplify_t *s, const int32_t v[2]) {
    int32_t left[2] = {v[0], v[1]}, right[2] = {v[0], v[1]};
    int32_t ax = magnitude(v[0]), ay = magnitude(v[1]), tol = s->tol_lat;
    if (ax <= tol && ax + ay <= tol) return;
    if (ax >= ay) {
        left[1] += v[0] > 0 ? tol : -tol;
        right[1] -= v[0] > 0 ? tol : -tol;
    } else {
        left[0] -= v[1] > 0 ? tol : -tol;
        right[0] += v[1] > 0 ? tol : -tol;
    }
    if (!s->cone || cross(s->left, left) < 0) s->left[0] = left[0], s->left[1] = left[1];
    if (!s->cone || cross(s->right, right) > 0) s->right[0] = right[0], s->right[1] = right[1];
    s->cone = true;
}

/* May p be reached from the apex in one go? `ahead` is from the apex to the last vertex, v to p. */
static bool is_straight(const simplify_t *s, const int32_t ahead[2], const int32_t v[2], page_point_t p) {
    int32_t step[2];
    between(s->last, p, step);
    if (dot(ahead, step) < 0) return false;
    return !s->cone || (cross(s->right, v) >= 0 && cross(s->left, v) <= 0 && dot(ahead, v) > 0);
}

int simplify_move(simplify_t *s, page_point_t p) {
    int err = simplify_finish(s);
    s->apex = s->last = p;
    s->open = true;
    return err;
}

int simplify_draw(simplify_t *s, page_point_t p) {
    int32_t ahead[2], v[2];
    if (is_same(p, s->last)) return 0;
    between(s->apex, s->last, ahead);
    between(s->apex, p, v);
    if (s->pending && !is_straight(s, ahead, v, p)) {
        int err = give(s);
        if (err) return err;
        between(s->apex, p, v);
    }
    narrow(s, v);
    s->last = p;
    s->pending = true;
    return 0;
}

int simplify_finish(simplify_t *s) {
    int err = s->open && s->pending ? give(s) : 0;
    s->open = s->pending = s->cone = s->moved = false;
    return err;
}

int simplify_line(simplify_t *s, page_point_t a, page_point_t b) {
    int err = simplify_finish(s);
    if (err || is_same(a, b)) return err;
    err = s->out.move(s->out.ctx, a);
    return err ? err : s->out.draw(s->out.ctx, b);
}
