/* planner.c - look-ahead in heights; see planner.h.
 *
 * Backward pass: a vertex may be passed at most at min(its cap, height at the next vertex + length between). The pass
 * starts at the newest vertex twice over, once as if the path ended there (0) and once as if it went straight on (top).
 * Where both come together, nothing that is appended later can make a difference:
 *
 *     height       ______________          as if it went on
 *                 /       \      \____
 *           _____/         \               as if it ended
 *                 final     \__________
 *     oldest                      newest
 *
 * The forward pass needs no array: it is the true height at which the oldest block is entered. One pass is made only
 * when the ring is full and no block is final, and frees at least a sixteenth of it: 16 visits per block at worst. */
#include "motion/planner.h"
#include "motion/root.h"

#define ONE_Q30 (1u << 30)
/* A turn that rounding may have made (directions are within 4 units): with a junction deviation of 0 it would stop. */
#define STRAIGHT_Q30 16

_Static_assert((uint64_t)PLANNER_HEIGHT_MAX_Q3 <= ONE_Q30, "height times a q30 fits 60 bits");
/* The longest line: 2 * reach in both, times sqrt(2), in q3. */
_Static_assert(2ull * PLANNER_REACH_LAT * PLANNER_Q3_PER_LAT * 1415 / 1000 < UINT32_MAX, "lengths fit 32 bits");

static inline uint32_t min_u32(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}
/* a + b of heights and lengths, both below 2^32, kept at or below top. */
static inline uint32_t raised(uint32_t height_q3, uint32_t length_q3, uint32_t top_q3) {
    return length_q3 >= top_q3 ? top_q3 : min_u32(height_q3 + length_q3, top_q3);
}

uint32_t planner_height_q3(uint32_t speed_um_s, uint32_t accel_um_s2) {
    /* 2^15 lat * 8 / 1000 um = 2^18 / 1000; v^2 < 2^44 */
    uint64_t h = ((((uint64_t)speed_um_s * speed_um_s) << 18) / (2ull * accel_um_s2)) / 1000;
    return h > PLANNER_HEIGHT_MAX_Q3 ? PLANNER_HEIGHT_MAX_Q3 : (uint32_t)h;
}

void planner_init(planner_t *p, planner_block_t *ring, uint32_t size, uint32_t junction_um) {
    *p = (planner_t){.ring = ring, .size = size};
    p->junction_q3 = (uint32_t)(((uint64_t)junction_um << 18) / 1000);
}

void planner_begin(planner_t *p, page_point_t at, uint32_t top_q3) {
    p->first = p->count = p->final = 0;
    p->last = p->start = at;
    p->ux_q30 = p->uy_q30 = 0;
    p->entry_q3 = 0;
    p->top_q3 = top_q3;
}

bool planner_full(const planner_t *p) {
    return p->count == p->size;
}

static inline planner_block_t *block(const planner_t *p, uint32_t i) {
    uint32_t k = p->first + i;
    return &p->ring[k < p->size ? k : k - p->size];
}

/* What the turn from the newest block's direction to u allows, as a height of at most top. */
static uint32_t corner_q3(const planner_t *p, int32_t ux_q30, int32_t uy_q30, uint32_t length_q3) {
    int64_t cross = ((int64_t)p->ux_q30 * uy_q30 - (int64_t)p->uy_q30 * ux_q30) >> 30;
    int64_t dot = ((int64_t)p->ux_q30 * ux_q30 + (int64_t)p->uy_q30 * uy_q30) >> 30;
    uint64_t turn = (uint64_t)(cross < 0 ? -cross : cross);                      /* sin t, q30 */
    uint64_t one_dot = dot <= -(int64_t)ONE_Q30 ? 0 : (uint64_t)(ONE_Q30 + dot); /* 1 + cos t, q30 */
    uint64_t sin2_q31 = dot >= (int64_t)ONE_Q30 ? 0 : (uint64_t)(ONE_Q30 - dot); /* sin^2(t/2), q31 */
    uint64_t cos2_q31 = (1ull << 31) > sin2_q31 ? (1ull << 31) - sin2_q31 : 0;
    uint32_t h = p->top_q3;
    if (turn <= STRAIGHT_Q30 && dot > 0) return h;

    /* Centripetal: h = R/2, R = (L1 + L2) / (4 tan(t/2)), tan(t/2) = sin t / (1 + cos t). 33 + 31 bits, L below 2^31.6.
     */
    uint64_t arc = (((uint64_t)block(p, p->count - 1)->length_q3 + length_q3) * one_dot) >> 3;
    if (turn * h > arc) h = (uint32_t)(arc / turn);

    /* Junction deviation: d/2 s/(1-s) = d [s(1+s)/2] / sin^2(t/2), and s(1+s)/2 >= s^2 tells cheaply when it is no
     * limit. */
    if (h * sin2_q31 > p->junction_q3 * cos2_q31) {
        uint64_t s_q31 = root_u64(cos2_q31 << 31);
        uint64_t factor_q31 = (s_q31 * ((1ull << 31) + s_q31)) >> 32;
        uint64_t limit = p->junction_q3 * factor_q31 / sin2_q31;
        if (limit < h) h = (uint32_t)limit;
    }
    return h;
}

uint32_t planner_add(planner_t *p, page_point_t to) {
    int32_t dx = to.x_lat - p->last.x_lat, dy = to.y_lat - p->last.y_lat;
    if ((dx | dy) == 0) return 0;
    int32_t ux_q30, uy_q30;
    uint32_t length_q3 = root_vector(dx, dy, &ux_q30, &uy_q30);
    uint32_t cap_q3 = p->count ? corner_q3(p, ux_q30, uy_q30, length_q3) : 0;
    planner_block_t *b = block(p, p->count++);
    *b = (planner_block_t){.to = to, .length_q3 = length_q3, .cap_q3 = cap_q3};
    p->last = to;
    p->ux_q30 = ux_q30;
    p->uy_q30 = uy_q30;
    return length_q3;
}

static void plan(planner_t *p, bool ending) {
    uint32_t ends = 0, goes_on = ending ? 0 : p->top_q3, final = 0;
    for (uint32_t i = p->count; i-- > 0;) {
        if (final == 0 && ends == goes_on) final = i + 1;
        planner_block_t *b = block(p, i);
        goes_on = min_u32(b->cap_q3, raised(goes_on, b->length_q3, p->top_q3));
        ends = min_u32(b->cap_q3, raised(ends, b->length_q3, p->top_q3));
        b->entry_q3 = ends;
    }
    uint32_t least = p->size / 16 ? p->size / 16 : 1;
    if (final < least && !ending) {
        p->forced += least - final;
        final = least;
    }
    p->final = final;
}

bool planner_take(planner_t *p, bool ending, planner_move_t *out) {
    if (p->count == 0) return false;
    if (ending && p->final < p->count) plan(p, true);
    if (p->final == 0) {
        if (!planner_full(p)) return false;
        plan(p, false);
    }
    planner_block_t *b = block(p, 0);
    planner_block_t *next = p->count > 1 ? block(p, 1) : 0;
    uint32_t out_q3 = next ? min_u32(next->entry_q3, raised(p->entry_q3, b->length_q3, p->top_q3)) : 0;
    *out = (planner_move_t){
        .from = p->start,
        .to = b->to,
        .length_q3 = b->length_q3,
        .in_q3 = p->entry_q3,
        .out_q3 = out_q3,
        .top_q3 = p->top_q3,
        .last = !next,
        .then = next ? next->to : b->to,
    };
    p->start = b->to;
    p->entry_q3 = out_q3;
    p->first = p->first + 1 < p->size ? p->first + 1 : 0;
    p->count--;
    p->final--;
    return true;
}
