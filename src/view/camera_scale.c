/* camera_scale.c - the fixed-point scale of homogeneous page coordinates, chosen per scene (block scaling).
 *
 * Bit budget: |X|, |Y| < 2^60 and 0 < E < 2^35, so that X - w * E with a window of |w| < 2^25 lat stays below 2^61. */
#include "error.h"
#include "num/ints.h"
#include "view/camera.h"

#include <stddef.h>

#define H_BITS 60
#define E_BITS 35
#define NEAR_SHIFT 20 /* nearest depth drawn where there is no exact way: 2^-20 of the farthest */

#define SPARE (1 << 27) /* that sums of rounded shares times a window's side are off at most: far less than a lat */

/* What a box is on the page: its middle, and how much half of each side moves it, rows as the camera's. */
typedef struct extent {
    num_t middle[3], share[3][3];
    int rows; /* two in a parallel view: E is one */
} extent_t;

/* Smallest b with |v| < 2^b. */
static int bits_of(num_t v) {
    return v.m == 0 ? -NUM_EXP_LIMIT : v.e + 63;
}

static void set_extent(extent_t *x, const camera_t *cam, const num_t lo[3], const num_t hi[3]) {
    num_t middle[3], half[3];
    x->rows = cam->perspective ? 3 : 2;
    for (int n = 0; n < 3; n++) {
        middle[n] = num_ldexp(num_add(lo[n], hi[n]), -1);
        half[n] = num_ldexp(num_sub(hi[n], lo[n]), -1);
    }
    for (int k = 0; k < x->rows; k++) {
        x->middle[k] = camera_project_row(cam, k, middle);
        for (int n = 0; n < 3; n++) x->share[k][n] = num_mul(cam->m[k][n], half[n]);
    }
}

/* Bits of the farthest corner, and so of each share. */
static int extent_bits(const extent_t *x, int k) {
    num_t sum = num_abs(x->middle[k]);
    for (int n = 0; n < 3; n++) sum = num_add(sum, num_abs(x->share[k][n]));
    return bits_of(sum);
}

static int64_t sum_abs(const int64_t a[3]) {
    return (int64_t)(ints_abs64(a[0]) + ints_abs64(a[1]) + ints_abs64(a[2]));
}

/* Is no corner beyond a side of the window? How far one is from a side is X - w E, which is linear. */
static bool is_inside(const extent_t *x, const page_window_t *window, int frac_bits) {
    /* one lat of grace: a picture fitted to the window touches it */
    const int32_t side[4] = {window->x0_lat - 1, window->y0_lat - 1, window->x1_lat + 1, window->y1_lat + 1};
    int64_t at[3][4] = {{0}}; /* shares, and the middle */
    for (int k = 0; k < x->rows; k++)
        for (int n = 0; n < 4; n++) at[k][n] = num_to_fixed(n < 3 ? x->share[k][n] : x->middle[k], frac_bits, NULL);
    if (x->rows == 2) at[2][3] = (int64_t)1 << frac_bits;
    if (at[2][3] <= sum_abs(at[2])) return false;
    for (int i = 0; i < 4; i++) {
        int64_t from[4];
        for (int n = 0; n < 4; n++) from[n] = at[i & 1][n] - side[i] * at[2][n];
        if ((i < 2 ? from[3] : -from[3]) < sum_abs(from) + SPARE) return false;
    }
    return true;
}

int camera_scale(const camera_t *cam, const num_t lo[3], const num_t hi[3], line_space_t *lines) {
    extent_t x;
    set_extent(&x, cam, lo, hi);
    const int bits_x = extent_bits(&x, 0), bits_y = extent_bits(&x, 1), bits_e = x.rows == 3 ? extent_bits(&x, 2) : 1;
    /* Two spare bits: a sum of three shares, and interpolation. */
    int by_xy = H_BITS - 2 - (bits_x > bits_y ? bits_x : bits_y), by_e = E_BITS - bits_e;
    lines->frac_bits = by_xy < by_e ? by_xy : by_e;
    /* A parallel view has E == 1: fewer bits than none means a page of 2^58 lat. */
    if (lines->frac_bits < (cam->perspective ? -900 : 1) || lines->frac_bits > 1000) return ERR_VALUE;
    int64_t far_e = num_to_fixed(num_ldexp(num_from_i64(1), bits_e), lines->frac_bits, NULL);
    lines->near_e = cam->perspective ? (far_e >> NEAR_SHIFT) + 1 : 1;
    lines->all_inside = is_inside(&x, &cam->window, lines->frac_bits);
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
