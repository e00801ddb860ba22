/* profiles.c - the frame of the cutting planes, and functions sampled along them. */
#include "scene/profiles.h"

#include "error.h"

static num_t middle(num_t a, num_t b) {
    return num_ldexp(num_add(a, b), -1);
}

static num_t dot(const num_t a[2], num_t x, num_t y) {
    return num_add(num_mul(a[0], x), num_mul(a[1], y));
}

void profiles_frame(profiles_t *p, const camera_t *cam, const num_t x[2], const num_t y[2]) {
    p->away[0] = num_neg(cam->eye[0]);
    p->away[1] = num_neg(cam->eye[1]);
    if (cam->perspective) {
        p->away[0] = num_add(middle(x[0], x[1]), p->away[0]);
        p->away[1] = num_add(middle(y[0], y[1]), p->away[1]);
    }
    if (num_sign(p->away[0]) == 0 && num_sign(p->away[1]) == 0) p->away[1] = num_from_i64(1);
    p->side[0] = p->away[1];
    p->side[1] = num_neg(p->away[0]);
}

/* The interval of t in which lo <= from + t * step <= hi is taken from [t[0], t[1]]; where[k] remembers the exact
 * border that the interval's end k lies on. */
static void cut(num_t from, num_t step, num_t lo, num_t hi, int axis, num_t t[2], int where_axis[2], num_t where[2]) {
    if (num_sign(step) == 0) return;
    const num_t border[2] = {num_sign(step) > 0 ? lo : hi, num_sign(step) > 0 ? hi : lo};
    for (int k = 0; k < 2; k++) {
        num_t at = num_div(num_sub(border[k], from), step);
        if (where_axis[k] >= 0 && (k == 0 ? num_cmp(at, t[0]) <= 0 : num_cmp(at, t[1]) >= 0)) continue;
        t[k] = at;
        where_axis[k] = axis;
        where[k] = border[k];
    }
}

/* Finds the ends of profile k on the rectangle's border. */
static void find_ends(profiles_sampled_t *s, int32_t k) {
    if (s->at == k) return;
    s->at = k;
    num_t depth = num_add(s->depth0, num_mul(num_from_i64(k), s->depth_step));
    num_t square = dot(s->away, s->away[0], s->away[1]), t[2], where[2];
    num_t foot[2] = {num_div(num_mul(depth, s->away[0]), square), num_div(num_mul(depth, s->away[1]), square)};
    const num_t side[2] = {s->away[1], num_neg(s->away[0])};
    int where_axis[2] = {-1, -1};
    cut(foot[0], side[0], s->x0, s->x1, 0, t, where_axis, where);
    cut(foot[1], side[1], s->y0, s->y1, 1, t, where_axis, where);
    /* A plane that only touches a corner crosses nothing, whatever rounding makes of it. */
    num_t around = num_add(num_sub(s->x1, s->x0), num_sub(s->y1, s->y0));
    num_t least = num_ldexp(num_div(around, num_add(num_abs(side[0]), num_abs(side[1]))), -32);
    s->crosses = num_cmp(num_sub(t[1], t[0]), least) > 0;
    for (int e = 0; e < 2; e++) {
        for (int axis = 0; axis < 2; axis++) {
            num_t at = num_add(foot[axis], num_mul(t[e], side[axis]));
            const num_t lo = axis ? s->y0 : s->x0, hi = axis ? s->y1 : s->x1;
            if (num_cmp(at, lo) < 0) at = lo;
            if (num_cmp(at, hi) > 0) at = hi;
            s->end[e][axis] = where_axis[e] == axis ? where[e] : at;
        }
    }
}

static int32_t sampled_points(void *ctx, int32_t k) {
    profiles_sampled_t *s = ctx;
    find_ends(s, k);
    return s->crosses ? s->samples : 0;
}

static void sampled_point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    profiles_sampled_t *s = ctx;
    find_ends(s, k);
    num_t part = num_div(num_from_i64(v), num_from_i64(s->samples - 1));
    for (int axis = 0; axis < 2; axis++) {
        num_t way = num_sub(s->end[1][axis], s->end[0][axis]);
        xyz[axis] = v == s->samples - 1 ? s->end[1][axis] : num_add(s->end[0][axis], num_mul(way, part));
    }
    xyz[2] = s->z_of(s->fn_ctx, xyz[0], xyz[1]);
}

int profiles_from_function(profiles_t *p, profiles_sampled_t *s, const camera_t *cam, int32_t count) {
    if (count < 2 || s->samples < 2 || num_cmp(s->x0, s->x1) >= 0 || num_cmp(s->y0, s->y1) >= 0) return ERR_VALUE;
    *p = (profiles_t){.count = count, .max_points = s->samples, .ctx = s};
    p->points = sampled_points;
    p->point = sampled_point;
    const num_t x[2] = {s->x0, s->x1}, y[2] = {s->y0, s->y1};
    profiles_frame(p, cam, x, y);
    s->away[0] = p->away[0];
    s->away[1] = p->away[1];
    num_t nearest = dot(s->away, x[num_sign(s->away[0]) < 0], y[num_sign(s->away[1]) < 0]);
    num_t farthest = dot(s->away, x[num_sign(s->away[0]) > 0], y[num_sign(s->away[1]) > 0]);
    s->depth0 = nearest;
    s->depth_step = num_div(num_sub(farthest, nearest), num_from_i64(count - 1));
    s->at = -1;
    return 0;
}
