/* tracer.c - see tracer.h.
 *
 * Units inside: distance along the line and heights q16 lat in int64 (16 m is 2^35 lat q0... 2^45 here), times q16
 * ticks.
 *
 *     speed
 *       |      top ________
 *       |        /         \
 *     in|_______/           \_____ out
 *       |   up      cruise    down          t = base + T(h_in + s)       up
 *       +---------------------------- s     t = base + s * per_lat       cruise
 *                                           t = base - T(h_out + L - s)  down
 */
#include "motion/tracer.h"
#include "hal/hal.h"
#include "motion/root.h"
#include "motion/stepgen.h"

#define Q16_PER_Q3 13                             /* shift */
#define CRUISE_PIECE_TICKS (HAL_TICK_HZ / 60)     /* longest piece at constant speed */
#define RISE_SHIFT 4                              /* a piece spans 1/16 of its height */
#define GAP_MAX_TICKS (1 << 28)                   /* a span without a step is handed over after this */
#define STEP ((int64_t)1 << KINEMATICS_STEP_BITS) /* one step as a position */
#define TURN (STEP * 35 / 100)

enum kind { UP, CRUISE, DOWN };

typedef struct span { /* one of the three parts of a line, and its time law */
    enum kind kind;
    int64_t from_q16, to_q16; /* distances along the line */
    int64_t base_q16;         /* ticks */
    int64_t speed_q16;        /* cruise: as time to a stop */
    int64_t height_q16;       /* up: height at s = 0; down: height at s = 0 of the mirrored law, h = height - s */
} span_t;

typedef struct axis { /* the steps of one motor on a line */
    int64_t next_q16; /* distance of the next step; below 0: a turn had left it over, it is due at once */
    int64_t pitch_q16;
    uint32_t left;
    bool forward;
} axis_t;

/* Ticks from rest to height h, q16. 2^45 of height gives a root below 2^32 and K below 2^29: 61 bits. */
static int64_t rise_time_q16(const tracer_t *t, int64_t height_q16) {
    if (height_q16 <= 0) return 0;
    unsigned s;
    uint32_t root = root_normal((uint64_t)height_q16, &s);
    return (int64_t)(((uint64_t)root * t->root_q20) >> (s + 4));
}

void tracer_init(tracer_t *t, const kinematics_t *kin, uint32_t accel_um_s2, uint32_t min_gap_ticks, bool estimate) {
    *t = (tracer_t){.kin = kin, .min_gap_ticks = min_gap_ticks, .estimate = estimate};
    /* T = f sqrt(2h/a), f = 16e6 ticks/s, h = H / 2^16 lat, a = accel * 32.768 lat/s^2:
     * T^2 = H * 2 f^2 / (2^16 * 32.768 accel) = H * f^2 1000 / (2^30 accel).  Kept as root_q20 = 2^20 sqrt(that / H).
     */
    uint64_t square_q40 = (((uint64_t)HAL_TICK_HZ * HAL_TICK_HZ / 1024 * 1000 * 64) / accel_um_s2) << 14;
    t->root_q20 = root_u64(square_q40);
    t->last_step_q16[0] = t->last_step_q16[1] = t->taken_q16 = -((int64_t)1 << 40);
}

void tracer_speed(tracer_t *t, uint32_t speed_um_s, uint32_t top_q3) {
    /* f / (v * 32.768 lat/um) in q24 = f * 1000 / 2^15 * 2^24 / v */
    t->per_lat_q24 = (uint64_t)HAL_TICK_HZ * 1000 * 512 / speed_um_s;
    t->cruise_q16 = (int64_t)(((uint64_t)CRUISE_PIECE_TICKS << 40) / t->per_lat_q24);
    t->top_q3 = top_q3;
    t->top_time_q16 = rise_time_q16(t, (int64_t)top_q3 << Q16_PER_Q3);
}

static inline int64_t min_i64(int64_t a, int64_t b) {
    return a < b ? a : b;
}

static int64_t cruise_time_q16(const tracer_t *t, int64_t s_q16) {
    uint64_t lat = (uint64_t)s_q16 >> 16, part = (uint64_t)s_q16 & 0xffff;
    return (int64_t)(((lat * t->per_lat_q24) >> 8) + ((part * t->per_lat_q24) >> 24));
}

/* The same between two steps `pitch` apart; only asked for when they are in one piece: below CRUISE_PIECE_TICKS. */
static int64_t cruise_interval_q32(const tracer_t *t, int64_t pitch_q16) {
    return (int64_t)(((uint64_t)pitch_q16 * t->per_lat_q24) >> 8);
}

static int64_t time_q16(const tracer_t *t, const span_t *sp, int64_t s_q16) {
    if (s_q16 < sp->from_q16) s_q16 = sp->from_q16;
    switch (sp->kind) {
    case UP:
        return sp->base_q16 + rise_time_q16(t, sp->height_q16 + s_q16);
    case CRUISE:
        return sp->base_q16 + cruise_time_q16(t, s_q16 - sp->from_q16);
    default:
        return sp->base_q16 - rise_time_q16(t, sp->height_q16 - s_q16);
    }
}

static stepgen_piece_t *wait_for_slot(const tracer_t *t) {
    stepgen_piece_t *p;
    while (!(p = stepgen_slot())) {
        stepgen_start();
        if (t->wait)
            t->wait(t->wait_ctx);
        else
            hal_idle();
    }
    return p;
}

/* Speed at a moment of a span, as the time that a stop from it takes. */
static void set_speed(stepgen_piece_t *p, const span_t *sp, int64_t time_q16) {
    static const int8_t SLOPE[] = {[UP] = 1, [CRUISE] = 0, [DOWN] = -1};
    int64_t speed_q16 = sp->kind == UP     ? time_q16 - sp->base_q16
                        : sp->kind == DOWN ? sp->base_q16 - time_q16
                                           : sp->speed_q16;
    p->speed = speed_q16 > 0 ? (uint32_t)(speed_q16 / (STEPGEN_SPEED_TICKS << 16)) : 0;
    p->slope = SLOPE[sp->kind];
}

/* Hands over a piece without steps that ends at tick `end`; sp may be NULL: at rest. */
static void push_empty(tracer_t *t, const span_t *sp, int64_t end_tick) {
    while (end_tick > t->piece_tick) {
        int64_t length = end_tick - t->piece_tick;
        if (length > GAP_MAX_TICKS) length = GAP_MAX_TICKS;
        stepgen_piece_t *p = wait_for_slot(t);
        p->axis[0].count = p->axis[1].count = 0;
        p->set_pins = false;
        p->rest = true;
        p->length = (uint32_t)length;
        p->speed = 0;
        p->slope = 0;
        if (sp) set_speed(p, sp, (t->piece_tick + length) << 16);
        stepgen_push();
        t->piece_tick += length;
    }
}

/* Fits `count` steps from a->next on into a piece. */
static void fit(tracer_t *t, const span_t *sp, const axis_t *a, int motor, uint32_t count, stepgen_axis_piece_t *out) {
    out->count = count;
    if (count == 0) return;
    int64_t first = time_q16(t, sp, a->next_q16), interval_q32 = 0, add_q32 = 0;
    uint32_t n = count - 1; /* intervals */
    if (n && sp->kind == CRUISE) {
        interval_q32 = cruise_interval_q32(t, a->pitch_q16);
    } else if (n == 1) {
        interval_q32 = (time_q16(t, sp, a->next_q16 + a->pitch_q16) - first) << 16;
    } else if (n) {
        /* t(k) = k I + k(k-1)/2 A through the steps m and 2m after the first */
        int64_t m = n / 2;
        int64_t to_m = (time_q16(t, sp, a->next_q16 + m * a->pitch_q16) - first) << 16;
        int64_t to_2m = (time_q16(t, sp, a->next_q16 + 2 * m * a->pitch_q16) - first) << 16;
        add_q32 = (to_2m - 2 * to_m) / (m * m);
        interval_q32 = to_m / m - (m - 1) * add_q32 / 2;
    }
    /* A step right after the one before, as happens where a motor turns round: keep the distance. */
    int64_t earliest = t->last_step_q16[motor];
    /* DIR can change when the piece is taken, which is at the last step of the one before, be it the other motor's. */
    if (a->forward != t->forward[motor]) earliest = t->taken_q16;
    t->forward[motor] = a->forward;
    earliest += (int64_t)t->min_gap_ticks << 16;
    if (first < earliest) first = earliest;
    int64_t offset = first - (t->piece_tick << 16);
    out->first_q32 = (uint64_t)(offset < 0 ? 0 : offset) << 16;
    out->interval_q32 = (uint64_t)interval_q32;
    out->add_q32 = add_q32;
    out->forward = a->forward;
    int64_t k = n;
    t->last_step_q16[motor] = first + ((k * interval_q32 + k * (k - 1) / 2 * add_q32) >> 16);
}

/* Steps of the axis before distance `to`. */
static uint32_t steps_before(const axis_t *a, int64_t to_q16) {
    if (a->left == 0 || a->next_q16 >= to_q16) return 0;
    int64_t n = (to_q16 - 1 - a->next_q16) / a->pitch_q16 + 1;
    return n < a->left ? (uint32_t)n : a->left;
}

/* One piece: the steps up to distance `to`, and the rest of the line's if it is the last. */
static void push_piece(tracer_t *t, const span_t *sp, axis_t axis[2], int64_t to_q16, bool last, bool rest) {
    uint32_t count[2];
    for (int m = 0; m < 2; m++) count[m] = last ? axis[m].left : steps_before(&axis[m], to_q16);
    int64_t end_q16 = time_q16(t, sp, to_q16), end = end_q16 >> 16;
    if (!(count[0] | count[1])) { /* its time joins the next piece's */
        if (rest || end - t->piece_tick > GAP_MAX_TICKS) push_empty(t, sp, end);
        return;
    }
    stepgen_piece_t *p = wait_for_slot(t);
    for (int m = 0; m < 2; m++) {
        fit(t, sp, &axis[m], m, count[m], &p->axis[m]);
        axis[m].next_q16 += count[m] * axis[m].pitch_q16;
        axis[m].left -= count[m];
    }
    p->length = (uint32_t)(end - t->piece_tick);
    set_speed(p, sp, end_q16);
    p->set_pins = false;
    p->rest = rest;
    t->piece_tick = end;
    t->taken_q16 = t->last_step_q16[0] > t->last_step_q16[1] ? t->last_step_q16[0] : t->last_step_q16[1];
    stepgen_push();
}

/* Distance along the line that a piece at distance s may span. */
static int64_t span_length(const tracer_t *t, const span_t *sp, int64_t s_q16, int64_t pitch_q16) {
    if (sp->kind == CRUISE) return t->cruise_q16;
    int64_t height = sp->kind == UP ? sp->height_q16 + s_q16 : sp->height_q16 - s_q16;
    int64_t length = height >> RISE_SHIFT;
    return length > pitch_q16 ? length : pitch_q16;
}

static void trace_span(tracer_t *t, const span_t *sp, axis_t axis[2], bool last, bool rest) {
    if (sp->to_q16 <= sp->from_q16 && !last) return;
    for (int64_t s = sp->from_q16; !stepgen_halted();) { /* a halt in a long line is to be heard of at once */
        int64_t pitch = INT64_MAX / 2;
        for (int m = 0; m < 2; m++)
            if (axis[m].left && axis[m].pitch_q16 < pitch) pitch = axis[m].pitch_q16;
        int64_t length = pitch == INT64_MAX / 2 ? pitch : span_length(t, sp, s, pitch);
        for (int m = 0; m < 2; m++) /* a step that is overdue is not on the law of the others: a piece of its own */
            if (axis[m].left && axis[m].next_q16 < s && axis[m].next_q16 + axis[m].pitch_q16 > s)
                length = min_i64(length, axis[m].next_q16 + axis[m].pitch_q16 - s);
        bool ends = length >= sp->to_q16 - s;
        s = ends ? sp->to_q16 : s + length;
        push_piece(t, sp, axis, s, last && ends, rest && ends);
        if (ends) return;
    }
}

/* The step at which a motor ends a line: nearest, but short of a step that the next line would take back at once. */
static int32_t target(int32_t steps, int64_t d, kinematics_pos_t end, int64_t then) {
    int32_t n = kinematics_round(end);
    if (d > 0) {
        if (then < 0 && end - ((int64_t)n * STEP - STEP / 2) < TURN) n--;
        return n > steps ? n : steps;
    }
    if (d < 0) {
        if (then > 0 && (int64_t)n * STEP + STEP / 2 - end < TURN) n++;
        return n < steps ? n : steps;
    }
    return steps;
}

/* Where on a line of length L a motor steps, that goes from pos by d and from step `steps` to `goal`. */
static axis_t axis_of(kinematics_pos_t pos, int64_t d, int32_t steps, int32_t goal, int64_t length_q16) {
    axis_t a = {.forward = goal > steps, .left = (uint32_t)(goal > steps ? goal - steps : steps - goal)};
    if (a.left == 0) return a;
    int64_t half = a.forward ? (int64_t)steps * STEP + STEP / 2 - pos : pos - ((int64_t)steps * STEP - STEP / 2);
    int64_t along = a.forward ? d : -d;
    int64_t along_q16 = along >> (KINEMATICS_STEP_BITS - 16);
    if (along_q16 <= 0) { /* a single step that a turn had left over */
        a.next_q16 = a.pitch_q16 = length_q16;
        return a;
    }
    if (half > along) half = along;
    a.pitch_q16 = (length_q16 << 16) / along_q16;
    a.next_q16 = ((half >> (KINEMATICS_STEP_BITS - 16)) * a.pitch_q16) >> 16;
    if (a.next_q16 > length_q16) a.next_q16 = length_q16;
    return a;
}

/* The time law of a line, its three parts of which some may be empty; the clock goes on to its end. */
static void lay_out(tracer_t *t, const planner_move_t *mv, span_t span[3]) {
    int64_t length = (int64_t)mv->length_q3 << Q16_PER_Q3;
    int64_t in = (int64_t)mv->in_q3 << Q16_PER_Q3, out = (int64_t)mv->out_q3 << Q16_PER_Q3;
    int64_t top = (int64_t)mv->top_q3 << Q16_PER_Q3;
    int64_t peak = (in + out + length) / 2;
    if (peak > top) peak = top;
    if (peak > t->peak_q16) t->peak_q16 = peak;
    int64_t t_in = t->out_time_q16;
    int64_t t_out = out == top ? t->top_time_q16 : rise_time_q16(t, out);
    int64_t t_peak = peak == top ? t->top_time_q16 : rise_time_q16(t, peak);
    t->out_time_q16 = t_out;
    int64_t risen = peak - in, fall = length - (peak - out);
    int64_t start = t->clock_q16;
    int64_t at_top = start + t_peak - t_in;
    int64_t leave_top = fall > risen ? at_top + cruise_time_q16(t, fall - risen) : at_top;
    t->clock_q16 = leave_top + t_peak - t_out;
    span[0] = (span_t){UP, 0, risen, start - t_in, 0, in};
    span[1] = (span_t){CRUISE, risen, fall, at_top, t_peak, 0};
    span[2] = (span_t){DOWN, fall, length, leave_top + t_peak, 0, out + length};
}

/* The steps of both motors on a line. */
static void set_out(tracer_t *t, const planner_move_t *mv, axis_t axis[2]) {
    kinematics_pos_t end[2], then[2];
    int64_t length = (int64_t)mv->length_q3 << Q16_PER_Q3;
    kinematics_motors(t->kin, mv->to, end);
    kinematics_motors(t->kin, mv->then, then);
    for (int m = 0; m < 2; m++) {
        int64_t d = end[m] - t->pos[m];
        int32_t goal = mv->last ? kinematics_round(end[m]) : target(t->steps[m], d, end[m], then[m] - end[m]);
        axis[m] = axis_of(t->pos[m], d, t->steps[m], goal, length);
        t->pulses[m] += axis[m].left;
        t->pos[m] = end[m];
        t->steps[m] = goal;
    }
}

void tracer_move(tracer_t *t, const planner_move_t *mv) {
    span_t span[3];
    axis_t axis[2];
    lay_out(t, mv, span);
    if (t->estimate) return;
    set_out(t, mv, axis);
    bool has_cruise = span[1].to_q16 > span[1].from_q16, has_down = span[2].from_q16 < span[2].to_q16;
    trace_span(t, &span[0], axis, !has_cruise && !has_down, false);
    if (has_cruise) trace_span(t, &span[1], axis, !has_down, false);
    if (has_down) trace_span(t, &span[2], axis, true, mv->last);
}

void tracer_wait(tracer_t *t, uint32_t wait_us, uint8_t pins) {
    int64_t ticks = ((int64_t)wait_us * (HAL_TICK_HZ / 1000000)) + 1;
    int64_t gap_q16 = (int64_t)t->min_gap_ticks << 16;
    for (int m = 0; m < 2; m++)
        if (t->clock_q16 < t->last_step_q16[m] + gap_q16) t->clock_q16 = t->last_step_q16[m] + gap_q16;
    int64_t start = (t->clock_q16 + 0xffff) >> 16;
    t->clock_q16 = (start + ticks) << 16;
    if (t->estimate) return;
    push_empty(t, NULL, start);
    stepgen_piece_t *p = wait_for_slot(t);
    p->axis[0].count = p->axis[1].count = 0;
    p->speed = 0;
    p->slope = 0;
    p->set_pins = p->rest = true;
    p->pins = pins;
    p->length = 1;
    stepgen_push();
    t->piece_tick = start + 1;
    t->taken_q16 = start << 16;
    push_empty(t, NULL, start + ticks);
}
