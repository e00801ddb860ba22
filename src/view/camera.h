/* camera.h - the view: from world to page as one 3x4 matrix of scaled integers.
 *
 *     (X, Y, E) = M (x, y, z, 1);   page x = X / E, page y = Y / E, in lat (2^-15 mm)
 *
 * Parallel views have the last row 0 0 0 1. In perspective E is the depth in front of the eye in world units,
 * and only points with E > 0 are seen. */
#ifndef CAMERA_H
#define CAMERA_H

#include "num/num.h"

typedef struct camera {
    bool perspective;
    num_t m[3][4];
    /* What hidden-line kernels need: the eye, or for a parallel view the direction from the scene to the eye
     * (unnormalised). Visibility depends on nothing else. */
    num_t eye[3];
} camera_t;

#endif
