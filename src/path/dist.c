/* dist.c - table square root. See dist.h. */
#include "path/dist.h"

const uint16_t DIST_ROOT_Q14[97] = {
    16384, 16638, 16888, 17135, 17378, 17618, 17854, 18087, 18318, 18545, 18770, 18992, 19212, 19429,
    19644, 19856, 20066, 20274, 20480, 20684, 20886, 21085, 21283, 21480, 21674, 21867, 22058, 22247,
    22435, 22621, 22806, 22989, 23170, 23351, 23530, 23707, 23884, 24059, 24232, 24405, 24576, 24746,
    24915, 25083, 25249, 25415, 25580, 25743, 25905, 26067, 26227, 26387, 26545, 26703, 26859, 27015,
    27170, 27324, 27477, 27629, 27780, 27931, 28081, 28230, 28378, 28525, 28672, 28818, 28963, 29108,
    29251, 29394, 29537, 29678, 29819, 29960, 30099, 30238, 30377, 30515, 30652, 30788, 30924, 31059,
    31194, 31328, 31462, 31595, 31727, 31859, 31991, 32122, 32252, 32382, 32511, 32640, 32768};

uint32_t dist_of(int32_t dx, int32_t dy) {
    uint32_t ax = dx < 0 ? 0u - (uint32_t)dx : (uint32_t)dx, ay = dy < 0 ? 0u - (uint32_t)dy : (uint32_t)dy;
    uint32_t big = ax > ay ? ax : ay;
    int shift = big < 1u << 15 ? 0 : 17 - __builtin_clz(big); /* to 15 bits, rounded */
    if (shift > 0) {
        uint32_t half = 1u << (shift - 1);
        ax = (ax + half) >> shift;
        ay = (ay + half) >> shift;
    }
    return dist_root_up(ax * ax + ay * ay, shift);
}

uint32_t dist_between(page_point_t a, page_point_t b) {
    return dist_of(a.x_lat - b.x_lat, a.y_lat - b.y_lat);
}
