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

static void note_bits(int *most, num_t v) {
    const int b = bits_of(v);
    if (b > *most) *most = b;
}

int camera_scale(const camera_t *cam, const num_t lo[3], const num_t hi[3], line_space_t *lines) {
    extent_t x = {-NUM_EXP_LIMIT, -NUM_EXP_LIMIT, true};
    num_t middle[3], corner[8][3]; /* the eight corners of the box, as sums of the middle and a share for each axis */
    for (int n = 0; n < 3; n++) middle[n] = num_ldexp(num_add(lo[n], hi[n]), -1);
    camera_project(cam, middle, corner[0]);
    for (int n = 0; n < 3; n++)
        for (int k = 0; k < 3; k++) {
            const num_t below = num_mul(cam->m[k][n], num_sub(lo[n], middle[n])),
                        above = num_mul(cam->m[k][n], num_sub(hi[n], middle[n]));
            note_bits(k == 2 ? &x.bits_e : &x.bits_xy, below);
            note_bits(k == 2 ? &x.bits_e : &x.bits_xy, above);
            for (int c = 0; c < 1 << n; c++) {
                corner[c | 1 << n][k] = num_add(corner[c][k], above);
                corner[c][k] = num_add(corner[c][k], below);
            }
        }
    for (int c = 0; c < 8; c++) {
        for (int k = 0; k < 3; k++) note_bits(k == 2 ? &x.bits_e : &x.bits_xy, corner[c][k]);
        x.inside = x.inside && is_inside(&cam->window, corner[c]);
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
