/* kinematics.h - which motor positions belong to a point of the page.
 *
 * (u, v) is the page point (x, y), or (y, x) with swap_xy. Cartesian: A = u, B = v. CoreXY: A = u + v, B = u - v.
 * Then each is multiplied by its motor's steps per mm and negated if the motor is inverted. Home is the page's origin.
 */
#ifndef KINEMATICS_H
#define KINEMATICS_H

#include "motion/machine.h"
#include "view/page.h"

/* Motor positions are unrounded, in 2^-31 steps: lat (2^-15 mm) times steps/mm in q16 needs no shift and
 * loses nothing. Budget: |lat| < 2^27, sum of two < 2^28, steps/mm < 2^16 so q16 < 2^32: below 2^60. */
#define KINEMATICS_STEP_BITS 31
typedef int64_t kinematics_pos_t;

typedef struct kinematics {
    int64_t scale[2]; /* steps per mm, q16, negative if inverted */
    bool swap_xy;
    enum machine_kinematics kind;
} kinematics_t;

void kinematics_init(kinematics_t *k, const machine_t *m);
/* |coordinates| < PLANNER_REACH_LAT. Exact. */
void kinematics_motors(const kinematics_t *k, page_point_t p, kinematics_pos_t out[2]);
/* The page point where the motors stand at these steps, rounded to lat. One division a motor. */
page_point_t kinematics_page(const kinematics_t *k, const int32_t steps[2]);
/* The step nearest to a position; halves go up. */
static inline int32_t kinematics_round(kinematics_pos_t pos) {
    return (int32_t)((pos + ((int64_t)1 << (KINEMATICS_STEP_BITS - 1))) >> KINEMATICS_STEP_BITS);
}

#endif
