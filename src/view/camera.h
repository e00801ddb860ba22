/* camera.h - the view: from world to page as one 3x4 matrix of scaled integers.
 *
 *     (X, Y, E) = M (x, y, z, 1);   page x = X / E, page y = Y / E, in lat (2^-15 mm)
 *
 * Parallel views have the last row 0 0 0 1. In perspective E is the depth in front of the eye in world units,
 * and only points with E > 0 are seen.
 *
 * Two kinds of view:
 *   rotation     gnuplot's `set view rot_x, rot_z, scale, zscale`. The box of the axes becomes the cube [-1,1]^3, is
 * turned by rot_z about z and by rot_x about the page's x, and lands in the printable area with 4/7 of its width and
 * height to the unit times scale/2: gnuplot's own figures, so the pictures overlay. from ... to  a true perspective in
 * data coordinates, upright (z up), fitted to the printable area by the eight corners of the scene's box. Whatever lies
 * more than CAMERA_MAX_SLOPE off the axis does not count for the fit, so an eye inside the scene still gets a useful
 * picture; it is cut later. */
#ifndef CAMERA_H
#define CAMERA_H

#include "lang/settings.h"
#include "num/num.h"
#include "view/line_space.h"

#define CAMERA_MAX_SLOPE_TENTHS 15 /* 56 degrees to either side */

/* The scene's box: the axes' ranges, lo < hi; reverse turns an axis round (rotation view only). */
typedef struct view_box {
    num_t lo[3], hi[3];
    bool reverse[3];
    bool solid; /* rotation view: a unit is equally long along all axes, and at scale 1 the box fills the page */
} view_box_t;

typedef struct camera {
    bool perspective;
    num_t m[3][4];
    /* What hidden-line kernels need: the eye, or for a parallel view the direction from the scene to the eye
     * (unnormalised). Visibility depends on nothing else. */
    num_t eye[3];
#if CONFIG_AREA
    num_t unit[3]; /* the sides of the cube above count 2; what one of the world counts in them. From ... to: 1 */
#endif
    page_window_t window;
} camera_t;

/* Sets cam up. Returns 0; ERR_VALUE if the view is degenerate (eye at the point looked at, box
 * entirely behind the eye, paper smaller than its margins). */
int camera_setup(camera_t *cam, const settings_t *s, const view_box_t *box);
/* The flat view of `plot`: the axes' ranges fill the printable area, z is ignored. Returns as camera_setup. */
int camera_flat(camera_t *cam, const settings_t *s, const num_t lo[2], const num_t hi[2]);
/* Homogeneous page coordinates of a world point (exact to the precision of num_t; set-up and slow paths only). */
void camera_project(const camera_t *cam, const num_t world[3], num_t out[3]);
num_t camera_project_row(const camera_t *cam, int r, const num_t world[3]); /* one of them */

/* Prepares everything of a line space but ctx and at: the scale in which no homogeneous coordinate of the box [lo, hi]
 * needs more than 60 bits, and whether all of the box is inside the window. Returns 0, or ERR_VALUE for coordinates
 * beyond any use. */
int camera_scale(const camera_t *cam, const num_t lo[3], const num_t hi[3], line_space_t *lines);
/* A world point in the scale of lines. */
page_h_t camera_point(const camera_t *cam, const line_space_t *lines, const num_t world[3]);

#endif
