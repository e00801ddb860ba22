/* camera_scale.c - the fixed-point scale of homogeneous page coordinates, chosen per scene (block scaling).
 *
 * Bit budget: |X|, |Y| < 2^60 and 0 < E < 2^35, so that X - w * E with a window of |w| < 2^25 lat stays below 2^61. */
#include "error.h"
#include "view/camera.h"

#include <stddef.h>

#define H_BITS 60
#define E_BITS 35
#define NEAR_SHIFT 20 /* nearest depth drawn where there is no exact way: 2^-20 of the farthest */

typedef struct extent {
    int bits_xy, bits_e; /* of single shares and of sums */
    bool inside;
} extent_t;

/* Smallest b with |v| < 2^b. */
static int bits_of(num_t v) {
    return v.m == 0 ? -NUM_EXP_LIMIT : v.e + 63;
}

static bool is_inside(const page_window_t *w, const num_t h[3]) {
    const int32_t lo[2] = {w->x0_lat, w->y0_lat}, hi[2] = {w->x1_lat, w->y1_lat};
    if (num_sign(h[2]) <= 0) return false;
    for (int k = 0; k < 2; k++) {
        /* one lat of grace: a picture fitted to the window touches it */
        if (num_cmp(h[k], num_mul(num_from_i64(lo[k] - 1), h[2])) < 0) return false;
        if (num_cmp(h[k], num_mul(num_from_i64(hi[k] + 1), h[2])) > 0) return false;
    }
    return true;
}

/* One corner p of the box around middle: the sums, and the single shares of what is summed. */
static void extent_corner(extent_t *x, const camera_t *cam, const num_t p[3], const num_t middle[3]) {
    num_t h[3];
    camera_project(cam, p, h);
    for (int k = 0; k < 3; k++) {
        int *most = k == 2 ? &x->bits_e : &x->bits_xy;
        for (int n = 0; n < 4; n++) {
            int b = bits_of(n < 3 ? num_mul(cam->m[k][n], num_sub(p[n], middle[n])) : h[k]);
            if (b > *most) *most = b;
        }
    }
    if (!is_inside(&cam->window, h)) x->inside = false;
}

int camera_scale(const camera_t *cam, const num_t lo[3], const num_t hi[3], line_space_t *lines) {
    extent_t x = {-NUM_EXP_LIMIT, -NUM_EXP_LIMIT, true};
    num_t middle[3];
    for (int k = 0; k < 3; k++) middle[k] = num_ldexp(num_add(lo[k], hi[k]), -1);
    for (int c = 0; c < 8; c++) {
        const num_t p[3] = {c & 1 ? hi[0] : lo[0], c & 2 ? hi[1] : lo[1], c & 4 ? hi[2] : lo[2]};
        extent_corner(&x, cam, p, middle);
    }
    /* Two spare bits: a sum of three shares, and interpolation. */
    int by_xy = H_BITS - 2 - x.bits_xy, by_e = E_BITS - x.bits_e;
    lines->frac_bits = by_xy < by_e ? by_xy : by_e;
    /* A parallel view has E == 1: fewer bits than none means a page of 2^58 lat. */
    if (lines->frac_bits < (cam->perspective ? -900 : 1) || lines->frac_bits > 1000) return ERR_VALUE;
    int64_t far_e = num_to_fixed(num_ldexp(num_from_i64(1), x.bits_e), lines->frac_bits, NULL);
    lines->near_e = cam->perspective ? (far_e >> NEAR_SHIFT) + 1 : 1;
    lines->all_inside = x.inside;
    lines->perspective = cam->perspective;
    lines->window = &cam->window;
    return 0;
}

page_h_t camera_point(const camera_t *cam, const line_space_t *lines, const num_t world[3]) {
    num_t h[3];
    camera_project(cam, world, h);
    return (page_h_t){num_to_fixed(h[0], lines->frac_bits, NULL), num_to_fixed(h[1], lines->frac_bits, NULL),
                      num_to_fixed(h[2], lines->frac_bits, NULL)};
}
