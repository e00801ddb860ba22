/* stepgen_hold.c - hold and resume: time is stretched, half a millisecond at a time; see stepgen.h.
 *
 * What comes from the main loop takes effect on a grid of STEPGEN_GRID_TICKS since the motion began, or since it was
 * parked; the next motion begins on it, too. What the pins do then depends on the plan alone, and not on when the main
 * loop got round to asking. */
#include "motion/stepgen_parts.h"

#define SLICE_TICKS (HAL_TICK_HZ / 2000) /* the speed is constant so long while time is stretched */
#define SLICE (SLICE_TICKS / STEPGEN_SPEED_TICKS)
#define ONE_Q16 (1u << 16)

/* How fast the plan is now. The taken piece may begin a little later: its law is then followed backwards. */
static uint32_t planned_speed(void) {
    int32_t left = (int32_t)(stepgen.end - stepgen.now) / STEPGEN_SPEED_TICKS;
    int32_t speed = (int32_t)stepgen.speed - stepgen.slope * left;
    return speed > 0 ? (uint32_t)speed : 0;
}

/* speed / planned, for speed < planned; both are cut to 16 bits first. */
static uint32_t ratio_q16(uint32_t speed, uint32_t planned) {
    while (planned >= ONE_Q16) {
        planned >>= 1;
        speed >>= 1;
    }
    uint32_t q16 = (speed << 16) / planned;
    return q16 ? q16 : 1;
}

/* The speed of the next slice: that of its middle. Ends stretching when the plan's speed has been reached; false when
 * it is standstill. */
static bool next_slice(void) {
    uint32_t planned = planned_speed();
    if (!stepgen.stretched || stepgen.pace > planned) stepgen.pace = planned;
    stepgen.stretched = true;
    stepgen.slice_end = stepgen.now + SLICE_TICKS;
    uint32_t middle = stepgen.pace + SLICE / 2;
    if (stepgen.hold) {
        if (stepgen.pace <= SLICE / 2) {
            stepgen.slice_end = stepgen.now; /* and look again when the last pulse has ended */
            return false;
        }
        middle = stepgen.pace - SLICE / 2;
        stepgen.pace = stepgen.pace > SLICE ? stepgen.pace - SLICE : 0;
    } else {
        stepgen.pace += SLICE;
        if (middle >= planned) stepgen.stretched = false;
    }
    if (stepgen.stretched) {
        stepgen.rate_q16 = ratio_q16(middle, planned);
        stepgen.stretch_q16 = UINT32_MAX / stepgen.rate_q16;
    }
    return true;
}

int32_t stepgen_follow_hold(void) {
    if (__atomic_load_n(&stepgen.want_hold, __ATOMIC_ACQUIRE) == stepgen.hold) {
        stepgen.asked = false;
        return STEPGEN_NEVER;
    }
    if (!stepgen.asked) {
        stepgen.asked = true;
        stepgen.asked_at = stepgen.now + (STEPGEN_GRID_TICKS - (stepgen.now - stepgen.begun)) % STEPGEN_GRID_TICKS;
    }
    int32_t in = (int32_t)(stepgen.asked_at - stepgen.now);
    if (in > 0) return in;
    stepgen.hold = !stepgen.hold;
    stepgen.asked = false;
    return STEPGEN_NEVER;
}

int32_t stepgen_stretch(int32_t fall, int32_t plan, int32_t ask) {
    if (!stepgen.stretched || !hal_before(stepgen.now, stepgen.slice_end)) {
        if (!next_slice()) return fall;
        if (!stepgen.stretched) return plan < fall ? plan : fall;
    }
    uint32_t in = stepgen.slice_end - stepgen.now;
    if (fall < (int32_t)in) in = fall < 0 ? 0 : (uint32_t)fall;
    if (ask < (int32_t)in) in = (uint32_t)ask;
    uint32_t planned = plan < 0 ? 0 : (uint32_t)plan;
    uint64_t then = ((uint64_t)planned * stepgen.stretch_q16) >> 16;
    if (plan != STEPGEN_NEVER && then <= in) {
        stepgen_put_off((uint32_t)then - planned);
        return (int32_t)then;
    }
    stepgen_put_off(in - (uint32_t)(((uint64_t)in * stepgen.rate_q16) >> 16));
    return (int32_t)in;
}

/* A point of the grid that began when the machine was parked. */
static void unpark(void) {
    uint32_t now = hal_now() + STEPGEN_LEAD_TICKS;
    now += (STEPGEN_GRID_TICKS - (now - stepgen.now)) % STEPGEN_GRID_TICKS;
    stepgen.parked = false;
    stepgen_put_off(now - stepgen.now);
    stepgen.now = stepgen.slice_end = stepgen.begun = now;
    stepgen.edge = now - HAL_EDGE_GAP;
    hal_timer_arm(now);
}

/* The interrupt sees what is wanted at its next deadline, and while time is stretched every half millisecond. A
 * deadline that is farther away than that is brought forward. */
static void want(bool hold) {
    if (stepgen.want_hold == hold) return;
    __atomic_store_n(&stepgen.want_hold, hold, __ATOMIC_SEQ_CST);
    uint32_t now = hal_now();
    if (__atomic_load_n(&stepgen.running, __ATOMIC_ACQUIRE) && hal_before(now + SLICE_TICKS, stepgen.now))
        hal_timer_arm(now);
}

void stepgen_hold(void) {
    want(true);
}

void stepgen_stop(void) {
    stepgen.stop = true;
    if (__atomic_load_n(&stepgen.parked, __ATOMIC_ACQUIRE))
        unpark();
    else
        want(true);
}

void stepgen_resume(void) {
    if (stepgen.stop) return;
    if (__atomic_load_n(&stepgen.parked, __ATOMIC_ACQUIRE)) {
        stepgen.hold = stepgen.want_hold = stepgen.asked = false;
        stepgen.pace = 0;
        unpark();
    } else {
        want(false);
        stepgen_start();
    }
}

bool stepgen_holding(void) {
    return stepgen.want_hold;
}
bool stepgen_held(void) {
    /* In this order: an interrupt in between that halts has taken the wish back before it says that it stands, or its
     * edge, which waits for its tick, would be cut and the pen lifted too soon. */
    const bool stands =
        __atomic_load_n(&stepgen.parked, __ATOMIC_ACQUIRE) || !__atomic_load_n(&stepgen.running, __ATOMIC_ACQUIRE);
    return stands && __atomic_load_n(&stepgen.want_hold, __ATOMIC_ACQUIRE);
}
