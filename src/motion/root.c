/* root.c - see root.h. Budget: v (q32) and y (q30, 1 < y <= 2) are chosen so that v y^2 = 1: every product stays near
 * 2^62. The residual m - r^2 of a root wrong by 60 units is below 2^39; 16 bits of it are dropped before it
 * meets y (31 bits), which costs less than a unit of the root. */
#include "motion/root.h"

/* 1/sqrt((i + 32.5) / 128) in q15. */
static const uint16_t SEED_Q15[96] = {
    65030, 64052, 63117, 62222, 61363, 60540, 59748, 58987, 58254, 57548, 56867, 56210, 55574, 54960, 54366, 53791,
    53233, 52693, 52169, 51660, 51165, 50685, 50218, 49763, 49321, 48890, 48470, 48061, 47663, 47273, 46894, 46523,
    46161, 45807, 45462, 45124, 44793, 44470, 44153, 43843, 43540, 43243, 42951, 42666, 42386, 42112, 41843, 41579,
    41320, 41065, 40816, 40571, 40330, 40093, 39861, 39632, 39408, 39187, 38970, 38756, 38546, 38340, 38136, 37936,
    37739, 37545, 37354, 37166, 36980, 36798, 36618, 36441, 36266, 36093, 35924, 35756, 35591, 35428, 35267, 35109,
    34953, 34798, 34646, 34496, 34347, 34201, 34056, 33913, 33772, 33633, 33496, 33360, 33225, 33093, 32962, 32832};

static inline uint32_t newton(uint32_t v_q32, uint32_t y_q30) {
    uint64_t y2_q30 = ((uint64_t)y_q30 * y_q30) >> 30;
    uint64_t one_q30 = (v_q32 * y2_q30) >> 32;
    return (uint32_t)((y_q30 * ((3ull << 30) - one_q30)) >> 31);
}

/* 1/sqrt(v), v in [1/4, 1), to 1.2e-8. */
static inline uint32_t inverse(uint32_t v_q32) {
    uint32_t y_q30 = (uint32_t)SEED_Q15[(v_q32 >> 25) - 32] << 15;
    return newton(v_q32, newton(v_q32, y_q30));
}

/* m in [2^62, 2^64), y_q30 its inverse root. */
static inline uint32_t finish(uint64_t m, uint32_t y_q30) {
    uint64_t r = ((m >> 32) * y_q30) >> 30;
    if (r > UINT32_MAX) r = UINT32_MAX;
    int64_t left = (int64_t)(m - r * r);
    r = (uint64_t)((int64_t)r + (((left >> 16) * (int64_t)y_q30) >> 47));
    if (r > UINT32_MAX) r = UINT32_MAX;
    while (r * r > m) r--;
    while (r < UINT32_MAX && (r + 1) * (r + 1) <= m) r++;
    return (uint32_t)r;
}

uint32_t root_normal(uint64_t x, unsigned *s) {
    unsigned half = (unsigned)__builtin_clzll(x) / 2;
    uint64_t m = x << (2 * half);
    *s = half;
    return finish(m, inverse((uint32_t)(m >> 32)));
}

uint32_t root_u64(uint64_t x) {
    if (x == 0) return 0;
    unsigned s;
    uint32_t r = root_normal(x, &s);
    return r >> s;
}

uint32_t root_vector(int32_t dx, int32_t dy, int32_t *ux_q30, int32_t *uy_q30) {
    uint64_t square = (uint64_t)((int64_t)dx * dx) + (uint64_t)((int64_t)dy * dy);
    unsigned half = (unsigned)__builtin_clzll(square) / 2; /* at least 3: square <= 2^57 */
    uint64_t m = square << (2 * half);
    uint32_t y_q30 = inverse((uint32_t)(m >> 32));
    uint64_t length = finish(m, y_q30);
    y_q30 = newton((uint32_t)(m >> 32), y_q30);
    /* |d| 2^half < 2^32 and y |d| 2^half / 2^32 <= 2^30 */
    *ux_q30 = (int32_t)((((int64_t)dx * ((int64_t)1 << half)) * y_q30) >> 32);
    *uy_q30 = (int32_t)((((int64_t)dy * ((int64_t)1 << half)) * y_q30) >> 32);
    unsigned down = half - 3;
    return (uint32_t)((length + ((1ull << down) >> 1)) >> down);
}
