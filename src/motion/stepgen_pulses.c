/* stepgen_pulses.c - the short way through steps and nothing else, a few dozen instructions an edge, for ports that
 * play edges by themselves. It comes to the same edges as the long way, stepgen_isr.c. */
#include "motion/stepgen_parts.h"

#define FAR_TICKS 0x40000000u

/* Nothing but steps is under way, and time runs as planned. */
static inline bool is_plain(void) {
    const bool want = __atomic_load_n(&stepgen.want_hold, __ATOMIC_ACQUIRE);
    if (want == stepgen.hold) stepgen.asked = false;
    return !stepgen.hold && !stepgen.stretched && !stepgen.set_pins && (!want || stepgen.asked);
}

static inline uint32_t earlier_of(uint32_t a, uint32_t b) {
    return hal_before(b, a) ? b : a;
}

static inline uint32_t pulse_at(const stepgen_motor_t *a, uint32_t otherwise) {
    return a->high ? a->fall : a->left ? (uint32_t)(a->next_q32 >> 32) : otherwise;
}

/* The other end of the pulse; when the motor is wanted then. */
static inline uint32_t toggle(stepgen_motor_t *a, uint32_t now, uint32_t far) {
    if (a->high) {
        a->high = false;
        return a->left ? (uint32_t)(a->next_q32 >> 32) : far;
    }
    stepgen_begin_pulse(a, now);
    return a->fall;
}

/* Time is stretched, for the rest of the slice evenly, and nothing else but steps is under way. */
static inline bool is_slowed(void) {
    for (int m = 0; m < 2; m++)
        if (stepgen.motor[m].left && stepgen.motor[m].turn) return false;
    return stepgen.stretched && !stepgen.set_pins && stepgen.now == stepgen.edge &&
           hal_before(stepgen.now, stepgen.slice_end) &&
           __atomic_load_n(&stepgen.want_hold, __ATOMIC_ACQUIRE) == stepgen.hold;
}

/* Ticks to the next deadline of pulses while time is stretched, plus one, as stepgen_stretch() has it, and what the
 * plan is put off by. 0: it is not one of them, or beyond the slice. */
static inline uint32_t slowed(const stepgen_motor_t *x, const stepgen_motor_t *y, uint32_t now, uint32_t *off) {
    int32_t fall = STEPGEN_NEVER, plan = STEPGEN_NEVER;
    for (int m = 0; m < 2; m++) {
        const stepgen_motor_t *a = m ? y : x;
        const int32_t in = (int32_t)((a->high ? a->fall : (uint32_t)(a->next_q32 >> 32)) - now);
        if (a->high)
            fall = in < fall ? in : fall;
        else if (a->left)
            plan = in < plan ? in : plan;
    }
    if (fall < 0 || plan < 0) return 0;
    const uint32_t slice = stepgen.slice_end - now;
    uint32_t in = (uint32_t)fall < slice ? (uint32_t)fall : slice;
    const uint32_t planned = (uint32_t)plan;
    if (planned <= in) { /* stretching makes it no shorter; a slice has less than 2^13 ticks */
        const uint32_t then = stepgen.stretch_q16 < 0x80000
                                  ? (planned * stepgen.stretch_q16) >> 16
                                  : (uint32_t)(((uint64_t)planned * stepgen.stretch_q16) >> 16);
        if (then <= in) {
            *off = then - planned;
            return then < slice ? then + 1 : 0;
        }
    }
    if (in == slice) return 0;
    *off = in - ((in * stepgen.rate_q16) >> 16);
    return in + 1;
}

/* Up to when all deadlines are pulses, if there are others. */
static inline bool plain_until(const stepgen_motor_t *a, uint32_t *until) {
    if (!a->turn || !a->left) return false;
    *until = earlier_of(*until, (uint32_t)(a->next_q32 >> 32) - stepgen.setup - STEPGEN_NEAR_TICKS);
    return true;
}

/* The other end of the motor's pulse: when it is wanted then. Whether a pulse is under way is seen in the level. */
static inline uint32_t toggle_plain(stepgen_motor_t *a, bool high, uint32_t now, uint32_t far) {
    if (high) return a->left ? (uint32_t)(a->next_q32 >> 32) : far;
    a->left--;
    a->next_q32 += a->interval_q32;
    a->interval_q32 += (uint64_t)a->add_q32;
    return a->fall = now + stepgen.pulse;
}

/* Pulses of the taken piece, to its last or as long as there is room for what they do to the pins. Both motors' next
 * deadlines stay in registers. The first comes after stepgen.now, or is it: at_once. False: there was none. */
static bool plain_pulses(bool at_once) {
    stepgen_motor_t *const x = &stepgen.motor[0], *const y = &stepgen.motor[1];
    const uint32_t far = stepgen.now + FAR_TICKS;
    uint32_t x_at = pulse_at(x, far), y_at = pulse_at(y, far), edge = stepgen.edge, level = stepgen.level,
             until = stepgen.ahead.until;
    const uint32_t first = earlier_of(x_at, y_at);
    if (at_once && first != stepgen.now) return false;
    bool turns = plain_until(x, &until);
    turns |= plain_until(y, &until);
    if (stepgen.asked) until = earlier_of(until, stepgen.asked_at);
    uint32_t *const from = &stepgen.ahead.word[stepgen.made], *word = from;
    const uint32_t *end = x->left | y->left ? &stepgen.ahead.word[stepgen.ahead.room - 1] : word + 1;
    while (word < end) {
        const int32_t y_later = (int32_t)(y_at - x_at);
        const uint32_t now = y_later < 0 ? y_at : x_at, ticks = now - edge;
        if (!hal_before(now, until) || (int32_t)ticks < (int32_t)HAL_EDGE_GAP) break;
        edge = now;
        if (y_later >= -(int32_t)STEPGEN_NEAR_TICKS) {
            x_at = toggle_plain(x, level & HAL_X_STEP, now, far);
            level ^= HAL_X_STEP;
        }
        if (y_later <= (int32_t)STEPGEN_NEAR_TICKS) {
            y_at = toggle_plain(y, level & HAL_Y_STEP, now, far);
            level ^= HAL_Y_STEP;
        }
        *word++ = hal_edge(level, ticks);
        if (!(x->left | y->left)) break;
    }
    if (word == from) return false;
    x->high = level & HAL_X_STEP;
    y->high = level & HAL_Y_STEP;
    if (stepgen.made == 0) stepgen.first = first;
    stepgen.made += (uint32_t)(word - from);
    stepgen.now = stepgen.edge = edge;
    stepgen.level = level;
    stepgen.next = earlier_of(x_at, y_at);
    stepgen.next_known = !turns && (x->left | y->left);
    return true;
}

static inline void toggle_slowed(stepgen_motor_t *a, uint32_t step, uint32_t now) {
    if (hal_before(now + STEPGEN_NEAR_TICKS, pulse_at(a, now + FAR_TICKS))) return;
    stepgen.level ^= step;
    (void)toggle(a, now, 0);
}

/* The same in a slice of stretched time. */
static bool slowed_pulses(void) {
    stepgen_motor_t *const x = &stepgen.motor[0], *const y = &stepgen.motor[1];
    const uint32_t made = stepgen.made;
    while (stepgen.made + 1 < stepgen.ahead.room && (x->left | y->left)) {
        uint32_t off, in = slowed(x, y, stepgen.now, &off);
        if (in-- == 0) break;
        if (in < HAL_EDGE_GAP) in = HAL_EDGE_GAP;
        const uint32_t now = stepgen.now + in;
        if (!hal_before(now, stepgen.ahead.until)) break;
        stepgen_put_off(off);
        toggle_slowed(x, HAL_X_STEP, now);
        toggle_slowed(y, HAL_Y_STEP, now);
        if (stepgen.made == 0) stepgen.first = now;
        stepgen.ahead.word[stepgen.made++] = hal_edge(stepgen.level, in);
        stepgen.now = stepgen.edge = now;
    }
    return stepgen.made != made;
}

bool stepgen_short_way(bool at_once) {
    bool any = false;
    stepgen.next_known = false;
    while (stepgen.made + 1 < stepgen.ahead.room) {
        const bool plain = is_plain();
        if (!plain && (at_once || !is_slowed())) break;
        if (!(plain ? plain_pulses(at_once) : slowed_pulses())) break;
        at_once = false;
        any = true;
        if (!stepgen_piece_done()) break;
        stepgen.next_known = false;
        stepgen_take_due();
    }
    return any;
}

bool stepgen_next_pulse(void) {
    if (!stepgen.next_known || stepgen.asked || __atomic_load_n(&stepgen.want_hold, __ATOMIC_ACQUIRE) != stepgen.hold)
        return false;
    if ((int32_t)(stepgen.next - stepgen.edge) < (int32_t)HAL_EDGE_GAP) return false;
    stepgen.now = stepgen.next;
    return true;
}
