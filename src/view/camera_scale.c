/* camera_scale.c - the fixed-point scale of homogeneous page coordinates, chosen per scene (block scaling).
 *
 * Bit budget: |X|, |Y| < 2^60 and 0 < E < 2^35, so that X - w * E with a window of |w| < 2^25 lat stays below 2^61. */
#include "error.h"
#include "view/camera.h"

#include <stddef.h>

#define H_BITS 60
#define E_BITS 35
#define NEAR_SHIFT 20 /* nearest depth drawn where there is no exact way: 2^-20 of the farthest */

/* What a box is on the page: its middle, and how far to either side its corners may be. */
typedef struct extent {
    num_t half[3]; /* of the box's sides */
    num_t middle[3], reach[3];
} extent_t;

/* Smallest b with |v| < 2^b. */
static int bits_of(num_t v) {
    return v.m == 0 ? -NUM_EXP_LIMIT : v.e + 63;
}

static void set_extent(extent_t *x, const camera_t *cam, const num_t lo[3], const num_t hi[3]) {
    num_t middle[3];
    for (int n = 0; n < 3; n++) {
        middle[n] = num_ldexp(num_add(lo[n], hi[n]), -1);
        x->half[n] = num_ldexp(num_sub(hi[n], lo[n]), -1);
    }
    camera_project(cam, middle, x->middle);
    for (int k = 0; k < 3; k++) {
        x->reach[k] = num_from_i64(0);
        for (int n = 0; n < 3; n++) x->reach[k] = num_add(x->reach[k], num_abs(num_mul(cam->m[k][n], x->half[n])));
    }
}

/* Bits of the corners, and of each share of theirs. */
static int extent_bits(const extent_t *x, int k) {
    return bits_of(num_add(num_abs(x->middle[k]), x->reach[k]));
}

/* Is no corner beyond a side of the window? A corner's distance from one is X - w E, which is linear. */
static bool is_inside(const extent_t *x, const camera_t *cam) {
    const page_window_t *w = &cam->window;
    /* one lat of grace: a picture fitted to the window touches it */
    const int32_t side[4] = {w->x0_lat - 1, w->y0_lat - 1, w->x1_lat + 1, w->y1_lat + 1};
    if (num_cmp(x->middle[2], x->reach[2]) <= 0) return false;
    for (int i = 0; i < 4; i++) {
        const num_t at = num_from_i64(side[i]), *row = cam->m[i & 1];
        num_t inward = num_sub(x->middle[i & 1], num_mul(at, x->middle[2])), reach = x->reach[i & 1];
        if (i >= 2) inward = num_neg(inward);
        for (int n = 0; n < 3 && cam->perspective; n++) {
            if (n == 0) reach = num_from_i64(0);
            reach = num_add(reach, num_abs(num_mul(num_sub(row[n], num_mul(at, cam->m[2][n])), x->half[n])));
        }
        if (num_cmp(inward, reach) < 0) return false;
    }
    return true;
}

int camera_scale(const camera_t *cam, const num_t lo[3], const num_t hi[3], line_space_t *lines) {
    extent_t x;
    set_extent(&x, cam, lo, hi);
    const int bits_x = extent_bits(&x, 0), bits_y = extent_bits(&x, 1), bits_e = extent_bits(&x, 2);
    /* Two spare bits: a sum of three shares, and interpolation. */
    int by_xy = H_BITS - 2 - (bits_x > bits_y ? bits_x : bits_y), by_e = E_BITS - bits_e;
    lines->frac_bits = by_xy < by_e ? by_xy : by_e;
    /* A parallel view has E == 1: fewer bits than none means a page of 2^58 lat. */
    if (lines->frac_bits < (cam->perspective ? -900 : 1) || lines->frac_bits > 1000) return ERR_VALUE;
    int64_t far_e = num_to_fixed(num_ldexp(num_from_i64(1), bits_e), lines->frac_bits, NULL);
    lines->near_e = cam->perspective ? (far_e >> NEAR_SHIFT) + 1 : 1;
    lines->all_inside = is_inside(&x, cam);
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
