/* stepgen_isr.c - the interrupt's body; see stepgen.h.
 *
 *     stepgen_isr: serve -> take -> pulses -> next_deadline -+-> a port that plays edges by itself has room: go on
 *                    ^                                       |
 *                    +---------------------------------------+-> else: arm it
 *
 * stepgen_pulses.c is the short way through steps and nothing else, a few dozen instructions an edge; whatever else
 * happens takes the long way round, edge by edge. Both come to the same edges. Where a port plays none ahead, and so on
 * the simulator, all go the long way.
 *
 * Time in the interrupt is `stepgen.now`, the tick that was armed, not the tick at which the port got round to it: a
 * latency of less than stepgen.slack moves single edges but never the plan. Times are compared by the sign of their
 * difference, so the clock may wrap; pieces are shorter than 2^30 ticks.
 *
 * Each motor has at most one deadline: the end of its pulse while it is high, else its next step, and before it the
 * change of DIR if the step is the first of another direction. */
#include "motion/stepgen_parts.h"

#define EARLY_TICKS 16 /* called earlier than this before the deadline: stepgen_hold() armed the timer */

static const uint8_t STEP_PIN[2] = {HAL_X_STEP, HAL_Y_STEP};
static const uint8_t DIR_PIN[2] = {HAL_X_DIR, HAL_Y_DIR};

/* When the motor is next wanted, if it is. */
static inline bool motor_due(const stepgen_motor_t *a, uint32_t *at) {
    if (a->high)
        *at = a->fall;
    else if (a->left)
        *at = (uint32_t)(a->next_q32 >> 32) - (a->turn ? stepgen.setup : 0);
    return a->high || a->left;
}

/* Begins or ends the motor's pulse, or turns it round, if that is due by `near`; a turn by `turn`. */
static uint32_t run_motor(int m, uint32_t level, uint32_t near, uint32_t turn, uint32_t actual) {
    stepgen_motor_t *a = &stepgen.motor[m];
    uint32_t at = 0;
    if (!motor_due(a, &at) || hal_before(a->turn && !a->high ? turn : near, at)) return level;
    if (a->high) {
        a->high = false;
        return level & ~STEP_PIN[m];
    }
    if (a->turn) {
        a->turn = false;
        return a->forward ? level | DIR_PIN[m] : level & ~DIR_PIN[m];
    }
    stepgen_begin_pulse(a, actual);
    return level | STEP_PIN[m];
}

/* What is due at stepgen.now, and if there is something, what comes right after it. Motors that turn round at about the
 * same time do so together: what counts is that DIR stands before the step. */
static inline void serve(uint32_t actual) {
    uint32_t at = 0, level = stepgen.level;
    bool due = stepgen.set_pins && !hal_before(stepgen.now, stepgen.set_at), turns = false;
    for (int m = 0; m < 2; m++) {
        const stepgen_motor_t *a = &stepgen.motor[m];
        if (!motor_due(a, &at) || hal_before(stepgen.now, at)) continue;
        due = true;
        turns |= a->turn && !a->high;
    }
    if (!due) return;
    const uint32_t near = stepgen.now + STEPGEN_NEAR_TICKS, turn = turns ? stepgen.now + stepgen.setup : near;
    level = run_motor(0, level, near, turn, actual);
    level = run_motor(1, level, near, turn, actual);
    if (stepgen.set_pins && !hal_before(near, stepgen.set_at)) {
        stepgen.set_pins = false;
        level = (level & ~(uint32_t)(HAL_PEN | HAL_ENABLE)) | stepgen.pins;
    }
    if (level != stepgen.level) stepgen_put(level);
}

static inline void take_axis(int m, const stepgen_axis_piece_t *p) {
    stepgen_motor_t *a = &stepgen.motor[m];
    if (p->count == 0) return;
    a->left = p->count;
    a->goal += p->forward ? (int32_t)p->count : -(int32_t)p->count;
    a->next_q32 = ((uint64_t)stepgen.end << 32) + p->first_q32;
    a->interval_q32 = p->interval_q32;
    a->add_q32 = p->add_q32;
    a->turn = p->forward != (bool)(stepgen.level & DIR_PIN[m]);
    a->forward = p->forward;
}

/* Takes the next piece, if there is one. */
static bool take(void) {
    uint32_t tail = stepgen.tail;
    if (tail == __atomic_load_n(&stepgen.head, __ATOMIC_ACQUIRE)) return false;
    const stepgen_piece_t *p = &stepgen.queue[tail & stepgen.mask];
    if (p->set_pins) {
        stepgen.set_pins = true;
        stepgen.set_at = stepgen.end;
        stepgen.pins = p->pins;
    }
    take_axis(0, &p->axis[0]);
    take_axis(1, &p->axis[1]);
    stepgen.rest = p->rest;
    stepgen.speed = p->speed;
    stepgen.slope = p->slope;
    stepgen.end += p->length;
    __atomic_store_n(&stepgen.tail, tail + 1, __ATOMIC_RELEASE);
    return true;
}

void stepgen_take_due(void) {
    while (stepgen_piece_done() && take()) continue;
}

static inline int32_t earlier(int32_t best, uint32_t at) {
    int32_t in = (int32_t)(at - stepgen.now);
    return in < best ? in : best;
}

static void slip(uint32_t late) {
    stepgen_put_off(late);
    stepgen.motor[0].fall += late;
    stepgen.motor[1].fall += late;
    stepgen.slice_end += late;
    stepgen.asked_at += late;
    stepgen.begun += late;
    stepgen.edge += late;
    stepgen.now += late;
    stepgen.late++;
}

/* The deadline that follows, in stepgen.now. False if there is none: at the end, and when held. */
static bool next_deadline(void) {
    int32_t fall = STEPGEN_NEVER, plan = STEPGEN_NEVER, turn = STEPGEN_NEVER;
    for (int m = 0; m < 2; m++) {
        const stepgen_motor_t *a = &stepgen.motor[m];
        if (a->high)
            fall = earlier(fall, a->fall);
        else if (a->left && a->turn)
            turn = earlier(turn, (uint32_t)(a->next_q32 >> 32) - stepgen.setup);
        else if (a->left)
            plan = earlier(plan, (uint32_t)(a->next_q32 >> 32));
    }
    if (turn != STEPGEN_NEVER)
        plan = earlier(plan, stepgen.now + (uint32_t)(turn > 0 ? turn : 0)); /* taken late: at once */
    if (stepgen.set_pins) plan = earlier(plan, stepgen.set_at);
    if (fall == STEPGEN_NEVER && plan == STEPGEN_NEVER) {
        if (!hal_before(stepgen.now, stepgen.end)) { /* ran dry */
            if (!stepgen.rest || (stepgen.pins & HAL_PEN)) stepgen.starved++;
            stepgen.stretched = false;
            stepgen_stop_running();
            return false;
        }
        plan = earlier(plan, stepgen.end); /* look again when the piece is over */
    }
    int32_t in = plan < fall ? plan : fall, ask = stepgen_follow_hold();
    if (stepgen.hold || stepgen.stretched) in = stepgen_stretch(fall, plan, ask);
    if (in == STEPGEN_NEVER) { /* held */
        if (stepgen.stop)
            stepgen_put(stepgen_cut(true));
        else
            __atomic_store_n(&stepgen.parked, true, __ATOMIC_RELEASE);
        return false;
    }
    if (ask < in) in = ask;
    if (in < 0) { /* planned for a time that had gone by when its piece was taken */
        stepgen.late++;
        in = 0;
    }
    const int32_t since = (int32_t)(stepgen.now - stepgen.edge);
    if (since >= 0 && in < (int32_t)HAL_EDGE_GAP - since) in = (int32_t)HAL_EDGE_GAP - since;
    stepgen.now += (uint32_t)in;
    return true;
}

void stepgen_isr(void) {
    uint32_t actual = hal_now();
    if (!stepgen.running || stepgen.parked) return; /* halted, or only woken */
    if ((int32_t)(actual - stepgen.now) > (int32_t)stepgen.slack) slip(actual - stepgen.now);
    if ((int32_t)(stepgen.now - actual) > EARLY_TICKS) {
        if (stepgen.stretched) { /* it would have come soon enough, and the plan has been put off up to then */
            hal_timer_arm(stepgen.now);
            return;
        }
        stepgen.now = actual;
    }
    stepgen.ahead = hal_edges();
    stepgen.made = 0;
    bool more;
    do {
        if (actual != stepgen.now || !stepgen_short_way(true)) {
            serve(actual);
            stepgen_take_due();
            (void)stepgen_short_way(false);
        }
        more = stepgen_next_pulse() || next_deadline();
        actual = stepgen.now;
    } while (more && stepgen.made + 1 < stepgen.ahead.room && hal_before(stepgen.now, stepgen.ahead.until));
    if (stepgen.made) hal_edges_put(stepgen.made, stepgen.first, stepgen.edge);
    if (more) hal_timer_arm(stepgen.now);
}
