/* stepgen.c - the main loop's side: the queue, start and halt, where the machine is; see stepgen.h. */
#include "motion/stepgen_parts.h"

#define STEPGEN_ENOUGH 64                  /* pieces to begin with; fewer begin when no more are to come */
#define SETUP_MORE (HAL_TICK_HZ / 1000000) /* DIR is written so much earlier than it has to be */

stepgen_state_t stepgen;

uint32_t stepgen_cut(bool motors_on) {
    stepgen.halted = true;
    stepgen.set_pins = stepgen.hold = stepgen.want_hold = stepgen.stop = stepgen.asked = stepgen.stretched =
        stepgen.parked = false;
    stepgen.pins = motors_on ? stepgen.pins & HAL_ENABLE : 0;
    stepgen.tail = stepgen.head;
    stepgen_stop_running();
    return stepgen.level & ~(uint32_t)(HAL_X_STEP | HAL_Y_STEP | HAL_PEN | (motors_on ? 0 : HAL_ENABLE));
}

void stepgen_init(stepgen_piece_t *queue, uint32_t slots, uint32_t pulse_ticks, uint32_t setup_ticks) {
    hal_timer_cancel();
    /* Of motors that are on, DIR is as it was: a halt may have come between deciding and writing. */
    stepgen.level = stepgen.pins & HAL_ENABLE ? stepgen.level & (HAL_X_DIR | HAL_Y_DIR | HAL_ENABLE) : 0;
    hal_pins_write(HAL_X_STEP | HAL_Y_STEP | HAL_X_DIR | HAL_Y_DIR | HAL_PEN, stepgen.level);
    if (!(stepgen.pins & HAL_ENABLE)) stepgen.begun = 0;
    for (int m = 0; m < 2; m++)
        stepgen.motor[m] = (stepgen_motor_t){.forward = stepgen.level & (m ? HAL_Y_DIR : HAL_X_DIR)};
    stepgen.queue = queue;
    stepgen.mask = slots - 1;
    stepgen.head = stepgen.tail = 0;
    stepgen.pulse = pulse_ticks + STEPGEN_NEAR_TICKS; /* it may end so much sooner */
    stepgen.setup = setup_ticks + SETUP_MORE;
    stepgen.slack = pulse_ticks / 2;
    stepgen.set_pins = stepgen.running = stepgen.halted = false;
    stepgen.hold = stepgen.want_hold = stepgen.stop = stepgen.asked = stepgen.stretched = stepgen.parked = false;
    stepgen.speed = 0;
    stepgen.slope = 0;
    stepgen.pins = 0;
    stepgen.rest = true;
    stepgen.starved = stepgen.late = 0;
}

stepgen_piece_t *stepgen_slot(void) {
    uint32_t head = stepgen.head;
    if (stepgen.halted) stepgen.tail = head; /* nobody else writes it then */
    if (head - __atomic_load_n(&stepgen.tail, __ATOMIC_ACQUIRE) > stepgen.mask) return 0;
    return &stepgen.queue[head & stepgen.mask];
}

void stepgen_push(void) {
    __atomic_store_n(&stepgen.head, stepgen.head + 1, __ATOMIC_RELEASE);
    if (stepgen.mask + 1 - stepgen_room() == STEPGEN_ENOUGH) stepgen_start();
}

void stepgen_start(void) {
    if (stepgen.halted || stepgen.want_hold || __atomic_load_n(&stepgen.running, __ATOMIC_ACQUIRE) ||
        stepgen.head == stepgen.tail)
        return;
    stepgen.running = true;
    stepgen.hold = stepgen.asked = false;
    uint32_t now = hal_now() + STEPGEN_LEAD_TICKS;
    if (stepgen.begun) now += (STEPGEN_GRID_TICKS - (now - stepgen.begun)) % STEPGEN_GRID_TICKS;
    stepgen.now = stepgen.end = stepgen.begun = now;
    stepgen.edge = now - HAL_EDGE_GAP;
    hal_timer_arm(stepgen.now);
}

void stepgen_wake(uint32_t ticks) {
    if (__atomic_load_n(&stepgen.running, __ATOMIC_ACQUIRE) && !__atomic_load_n(&stepgen.parked, __ATOMIC_ACQUIRE))
        return;
    hal_timer_arm(hal_now() + ticks);
}

uint32_t stepgen_room(void) {
    uint32_t used = stepgen.head - __atomic_load_n(&stepgen.tail, __ATOMIC_ACQUIRE);
    return stepgen.mask + 1 - (stepgen.halted ? 0 : used);
}

bool stepgen_idle(void) {
    return stepgen.halted ||
           (!__atomic_load_n(&stepgen.running, __ATOMIC_ACQUIRE) && stepgen.head == stepgen.tail && hal_edges_left());
}
/* The interrupt may take a piece in between: again, then. */
int32_t stepgen_position(int motor) {
    const stepgen_motor_t *a = &stepgen.motor[motor];
    for (;;) {
        const int32_t goal = __atomic_load_n(&a->goal, __ATOMIC_ACQUIRE);
        const int32_t left = (int32_t)__atomic_load_n(&a->left, __ATOMIC_ACQUIRE);
        const bool forward = __atomic_load_n(&a->forward, __ATOMIC_ACQUIRE);
        if (goal == __atomic_load_n(&a->goal, __ATOMIC_ACQUIRE)) return forward ? goal - left : goal + left;
    }
}
uint32_t stepgen_starved(void) {
    return stepgen.starved;
}
uint32_t stepgen_late(void) {
    return stepgen.late;
}

bool stepgen_pen_down(void) {
    return stepgen.pins & HAL_PEN;
}

void stepgen_set_pins(uint32_t mask, uint32_t value) {
    stepgen.level = (stepgen.level & ~mask) | (value & mask);
    stepgen.pins = (uint8_t)(stepgen.level & (HAL_PEN | HAL_ENABLE));
    hal_pins_write(mask, value);
}

void stepgen_set_position(int motor, int32_t steps) {
    stepgen.motor[motor].goal = steps;
}

void stepgen_halt(bool motors_on) {
    hal_timer_cancel();
    stepgen.level = stepgen_cut(motors_on);
    hal_pins_write(HAL_X_STEP | HAL_Y_STEP | HAL_PEN | HAL_ENABLE, stepgen.level);
}

bool stepgen_halted(void) {
    return stepgen.halted;
}
