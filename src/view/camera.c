/* camera.c - see camera.h. All of it is set-up, once a picture, so it is written in num_t and for clarity. */
#include "view/camera.h"

#include "error.h"
#include "num/func.h"
#include "num/num_vec.h"

#include <stddef.h>

enum { X, Y, Z };

static num_t half(num_t a) {
    return num_ldexp(a, -1);
}

static num_t middle(const view_box_t *b, int axis) {
    return half(num_add(b->lo[axis], b->hi[axis]));
}

static int window_setup(page_window_t *w, const settings_t *s) {
    /* um to lat: * 2^15 / 1000. */
    int64_t margin = s->paper.margin_um;
    int64_t x1 = s->paper.width_um - margin, y1 = s->paper.height_um - margin;
    if (margin < 0 || x1 <= margin || y1 <= margin) return ERR_VALUE;
    w->x0_lat = (int32_t)(margin * LAT_PER_MM / 1000);
    w->y0_lat = w->x0_lat;
    w->x1_lat = (int32_t)(x1 * LAT_PER_MM / 1000);
    w->y1_lat = (int32_t)(y1 * LAT_PER_MM / 1000);
    return 0;
}

/* Row `row` of the matrix := direction . (world - origin) * scale + offset * (row E). */
static void set_row(camera_t *cam, int row, const num_t direction[3], const num_t origin[3], num_t scale) {
    for (int k = 0; k < 3; k++) cam->m[row][k] = num_mul(direction[k], scale);
    cam->m[row][3] = num_neg(num_mul(num_vec_dot(direction, origin), scale));
}

/* The largest scale at which the box's picture (rows right and up times world - origin) fits the window. */
static num_t fit_solid(const page_window_t *w, const view_box_t *box, const num_t right[3], const num_t up[3]) {
    const num_t *const row[2] = {right, up};
    const int32_t room[2] = {w->x1_lat - w->x0_lat, w->y1_lat - w->y0_lat};
    num_t scale = num_undef();
    for (int r = 0; r < 2; r++) {
        num_t span = num_from_i64(0);
        for (int k = 0; k < 3; k++) span = num_add(span, num_abs(num_mul(row[r][k], num_sub(box->hi[k], box->lo[k]))));
        num_t fits = num_div(num_from_i64(room[r] - 8), span); /* as FIT_SPARE_LAT */
        if (!fits.undef && (scale.undef || num_cmp(fits, scale) < 0)) scale = fits;
    }
    return scale;
}

/* set view equal: x and y get the unit of the longer of the two, and so does z if three axes are meant. Senses stay. */
static void equalise(num_t unit[3], int axes) {
    num_t x = num_abs(unit[X]), y = num_abs(unit[Y]), least = num_cmp(x, y) < 0 ? x : y;
    for (int k = 0; k < axes; k++) unit[k] = num_sign(unit[k]) < 0 ? num_neg(least) : least;
}

static int setup_rotation(camera_t *cam, const settings_t *s, const view_box_t *box) {
    const num_t right_angle = num_from_i64(90);
    const num_t sx = func_sin_degrees(s->view.rot_x), cx = func_sin_degrees(num_add(s->view.rot_x, right_angle));
    const num_t sz = func_sin_degrees(s->view.rot_z), cz = func_sin_degrees(num_add(s->view.rot_z, right_angle));

    num_t unit[3], origin[3]; /* world unit -> cube unit */
    for (int k = 0; k < 3; k++) {
        num_t span = num_sub(box->hi[k], box->lo[k]);
        if (box->solid) span = num_from_i64(2);
        unit[k] = num_div(num_from_i64(box->reverse[k] ? -2 : 2), span);
        origin[k] = middle(box, k);
    }
    if (!box->solid) equalise(unit, s->view.equal);
    if (s->view.equal < 3) unit[Z] = num_mul(unit[Z], s->view.zscale); /* gnuplot's xyz leaves zscale out */
    if (num_sign(unit[Z]) == 0 || unit[Z].undef) return ERR_VALUE;

#if CONFIG_AREA
    for (int k = 0; k < 3; k++) cam->unit[k] = unit[k];
#endif
    const num_t right[3] = {num_mul(cz, unit[X]), num_mul(sz, unit[Y]), num_from_i64(0)};
    const num_t up[3] = {num_neg(num_mul(num_mul(sz, cx), unit[X])), num_mul(num_mul(cz, cx), unit[Y]),
                         num_mul(sx, unit[Z])};
    /* The cube's side is 2; gnuplot gives it 4/7 of the window at scale 1. */
    const num_t per_unit = num_mul(half(s->view.scale), num_div(num_from_i64(4), num_from_i64(7)));
    const page_window_t *w = &cam->window;
    num_t across = num_mul(per_unit, num_from_i64(w->x1_lat - w->x0_lat));
    num_t upward = num_mul(per_unit, num_from_i64(w->y1_lat - w->y0_lat));
    if (s->view.equal) across = upward = num_cmp(across, upward) < 0 ? across : upward;
    if (box->solid) across = upward = num_mul(fit_solid(w, box, right, up), s->view.scale);
    set_row(cam, 0, right, origin, across);
    set_row(cam, 1, up, origin, upward);
    cam->m[0][3] = num_add(cam->m[0][3], num_from_fixed((int64_t)w->x0_lat + w->x1_lat, 1));
    cam->m[1][3] = num_add(cam->m[1][3], num_from_fixed((int64_t)w->y0_lat + w->y1_lat, 1));
    cam->m[2][3] = num_from_i64(1);

    /* The direction that both rows send to zero, towards the eye. */
    cam->eye[X] = num_div(num_mul(sx, sz), unit[X]);
    cam->eye[Y] = num_neg(num_div(num_mul(sx, cz), unit[Y]));
    cam->eye[Z] = num_div(cx, unit[Z]);
    num_vec_near_one(cam->eye, 2);
    return 0;
}

/* Bounds of the slopes (X/E, Y/E) over the box's corners in front of the eye, clamped to the useful cone. */
typedef struct slopes {
    num_t lo[2], hi[2];
    bool any;
} slopes_t;

static void slopes_add(slopes_t *s, const num_t h[3]) {
    const num_t limit = num_from_decimal(CAMERA_MAX_SLOPE_TENTHS, -1);
    for (int k = 0; k < 2; k++) {
        num_t v = num_div(h[k], h[2]);
        if (num_cmp(v, limit) > 0) v = limit;
        if (num_cmp(v, num_neg(limit)) < 0) v = num_neg(limit);
        if (!s->any || num_cmp(v, s->lo[k]) < 0) s->lo[k] = v;
        if (!s->any || num_cmp(v, s->hi[k]) > 0) s->hi[k] = v;
    }
    s->any = true;
}

/* Corners, and where an edge of the box passes behind the eye, the point just in front of it. */
static void slopes_of_box(slopes_t *s, const camera_t *cam, const view_box_t *box) {
    num_t h[8][3], near = num_from_i64(0);
    for (int c = 0; c < 8; c++) {
        num_t p[3];
        for (int k = 0; k < 3; k++) p[k] = c >> k & 1 ? box->hi[k] : box->lo[k];
        camera_project(cam, p, h[c]);
        if (num_cmp(h[c][2], near) > 0) near = h[c][2];
    }
    near = num_ldexp(near, -40); /* a box may be a million times as high as it is wide */
    for (int c = 0; c < 8; c++) {
        bool front = num_cmp(h[c][2], near) > 0;
        if (front) slopes_add(s, h[c]);
        for (int k = 0; k < 3; k++) {
            int d = c | 1 << k;
            if (d == c || front == (num_cmp(h[d][2], near) > 0)) continue;
            num_t t = num_div(num_sub(near, h[c][2]), num_sub(h[d][2], h[c][2])), q[3];
            for (int n = 0; n < 3; n++) q[n] = num_add(h[c][n], num_mul(t, num_sub(h[d][n], h[c][n])));
            slopes_add(s, q);
        }
    }
}

/* A picture that is fitted stays so far from the window's border: an edge exactly there would be cut off by the last
 * bit of its rounding. */
#define FIT_SPARE_LAT 4

static int setup_perspective(camera_t *cam, const settings_t *s, const view_box_t *box) {
    num_t forward[3], right[3], up[3] = {num_from_i64(0), num_from_i64(0), num_from_i64(1)};
    for (int k = 0; k < 3; k++) {
        cam->eye[k] = s->view.eye[k];
        forward[k] = num_sub(s->view.has_to ? s->view.to[k] : middle(box, k), cam->eye[k]);
    }
    if (!num_vec_unit(forward)) return ERR_VALUE;
    num_vec_cross(forward, up, right);
    if (!num_vec_unit(right)) { /* straight up or down: y is up on the page */
        up[Y] = num_from_i64(1);
        up[Z] = num_from_i64(0);
        num_vec_cross(forward, up, right);
        num_vec_unit(right);
    }
    num_vec_cross(right, forward, up);

    const num_t one = num_from_i64(1);
    set_row(cam, 0, right, cam->eye, one);
    set_row(cam, 1, up, cam->eye, one);
    set_row(cam, 2, forward, cam->eye, one);
    slopes_t fit = {.any = false};
    slopes_of_box(&fit, cam, box);
    if (!fit.any) return ERR_VALUE;

    const page_window_t *w = &cam->window;
    num_t span_x = num_sub(fit.hi[0], fit.lo[0]), span_y = num_sub(fit.hi[1], fit.lo[1]);
    num_t width = num_from_i64(w->x1_lat - w->x0_lat - 2 * FIT_SPARE_LAT);
    num_t height = num_from_i64(w->y1_lat - w->y0_lat - 2 * FIT_SPARE_LAT);
    /* width / span_x against height / span_y without dividing by a span that may be zero */
    bool wide = num_cmp(num_mul(width, span_y), num_mul(height, span_x)) <= 0;
    if (num_sign(wide ? span_x : span_y) <= 0) return ERR_VALUE;
    num_t scale = wide ? num_div(width, span_x) : num_div(height, span_y);
    const num_t centre[2] = {num_from_fixed((int64_t)w->x0_lat + w->x1_lat, 1),
                             num_from_fixed((int64_t)w->y0_lat + w->y1_lat, 1)};
    for (int r = 0; r < 2; r++) {
        num_t shift = num_sub(centre[r], num_mul(scale, half(num_add(fit.lo[r], fit.hi[r]))));
        for (int k = 0; k < 4; k++) cam->m[r][k] = num_add(num_mul(cam->m[r][k], scale), num_mul(cam->m[2][k], shift));
    }
    return 0;
}

int camera_flat(camera_t *cam, const settings_t *s, const num_t lo[2], const num_t hi[2]) {
    *cam = (camera_t){.perspective = false};
    int err = window_setup(&cam->window, s);
    if (err) return err;
    const page_window_t *w = &cam->window;
    const int32_t from[2] = {w->x0_lat, w->y0_lat}, to[2] = {w->x1_lat, w->y1_lat};
    for (int k = 0; k < 2; k++) {
        num_t scale = num_div(num_from_i64(to[k] - from[k]), num_sub(hi[k], lo[k]));
        if (scale.undef) return ERR_VALUE;
        cam->m[k][k] = scale;
        cam->m[k][3] = num_sub(num_from_i64(from[k]), num_mul(scale, lo[k]));
    }
    cam->m[2][3] = num_from_i64(1);
    cam->eye[Z] = num_from_i64(1);
    return 0;
}

int camera_setup(camera_t *cam, const settings_t *s, const view_box_t *box) {
    *cam = (camera_t){.perspective = s->view.from};
#if CONFIG_AREA
    for (int k = 0; k < 3; k++) cam->unit[k] = num_from_i64(1);
#endif
    int err = window_setup(&cam->window, s);
    if (err) return err;
    err = s->view.from ? setup_perspective(cam, s, box) : setup_rotation(cam, s, box);
    if (err) return err;
    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 4; k++)
            if (cam->m[r][k].undef) return ERR_VALUE;
    for (int k = 0; k < 3; k++)
        if (cam->eye[k].undef) return ERR_VALUE;
    return 0;
}

num_t camera_project_row(const camera_t *cam, int r, const num_t world[3]) {
    return num_add(num_vec_dot(cam->m[r], world), cam->m[r][3]);
}

void camera_project(const camera_t *cam, const num_t world[3], num_t out[3]) {
    for (int r = 0; r < 3; r++) out[r] = camera_project_row(cam, r, world);
}
