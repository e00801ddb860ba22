/* kinematics.c - see kinematics.h. */
#include "motion/kinematics.h"
#include "motion/planner.h" /* PLANNER_REACH_LAT */

_Static_assert(LAT_PER_MM_BITS + 16 == KINEMATICS_STEP_BITS, "lat times steps/mm in q16 is the unit of positions");
_Static_assert(2ll * PLANNER_REACH_LAT * (1ll << 32) < (1ll << 61), "sum of two coordinates times the largest scale");

void kinematics_init(kinematics_t *k, const machine_t *m) {
    for (int i = 0; i < 2; i++) {
        int64_t scale = m->steps_per_mm_q16[i];
        k->scale[i] = m->invert[i] ? -scale : scale;
    }
    k->swap_xy = m->swap_xy;
    k->kind = m->kinematics;
}

void kinematics_motors(const kinematics_t *k, page_point_t p, kinematics_pos_t out[2]) {
    int32_t u = k->swap_xy ? p.y_lat : p.x_lat;
    int32_t v = k->swap_xy ? p.x_lat : p.y_lat;
    if (k->kind == MACHINE_COREXY) {
        int32_t sum = u + v, difference = u - v;
        u = sum;
        v = difference;
    }
    out[0] = u * k->scale[0];
    out[1] = v * k->scale[1];
}

page_point_t kinematics_page(const kinematics_t *k, const int32_t steps[2]) {
    int64_t u = ((int64_t)steps[0] << KINEMATICS_STEP_BITS) / k->scale[0];
    int64_t v = ((int64_t)steps[1] << KINEMATICS_STEP_BITS) / k->scale[1];
    if (k->kind == MACHINE_COREXY) {
        int64_t sum = u + v, difference = u - v;
        u = sum / 2;
        v = difference / 2;
    }
    return k->swap_xy ? (page_point_t){(int32_t)v, (int32_t)u} : (page_point_t){(int32_t)u, (int32_t)v};
}
