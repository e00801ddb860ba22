/* sim.c - see sim.h. */
#include "sim/sim.h"
#include <stdbool.h>
#include <stddef.h>

static struct {
    uint64_t tick;   /* since reset */
    uint32_t offset; /* hal_now() = tick + offset */
    uint32_t pins;
    bool armed;
    uint64_t deadline; /* in ticks since reset */
    sim_recorder_t recorder;
    void *ctx;
    const char *fault;
    uint32_t late_period, late_by;
    sim_counts_t counts;
} s;

void sim_reset(void) {
    s.tick = 0;
    s.offset = 0;
    s.pins = 0;
    s.armed = false;
    s.recorder = NULL;
    s.fault = NULL;
    s.late_period = 0;
    s.counts = (sim_counts_t){0};
}

void sim_record(sim_recorder_t recorder, void *ctx) {
    s.recorder = recorder;
    s.ctx = ctx;
}

uint64_t sim_now(void) {
    return s.tick;
}
uint32_t sim_pins(void) {
    return s.pins;
}
const char *sim_fault(void) {
    return s.fault;
}
sim_counts_t sim_counts(void) {
    return s.counts;
}
void sim_set_clock(uint32_t now) {
    s.offset = now - (uint32_t)s.tick;
}

void sim_inject_late(uint32_t period, uint32_t late) {
    s.late_period = period;
    s.late_by = late;
}

void hal_pins_write(uint32_t mask, uint32_t value) {
    uint32_t pins = (s.pins & ~mask) | (value & mask);
    uint32_t changed = pins ^ s.pins;
    if (!changed) return;
    s.pins = pins;
    s.counts.edges += (unsigned)__builtin_popcount(changed);
    if (s.recorder) s.recorder(s.ctx, s.tick, pins, changed);
}

uint32_t hal_now(void) {
    return (uint32_t)s.tick + s.offset;
}

void hal_timer_arm(uint32_t at) {
    int32_t in = (int32_t)(at - hal_now());
    if (in < 0) {
        s.counts.past++;
        in = 0;
    }
    s.deadline = s.tick + (uint32_t)in;
    s.armed = true;
}

void hal_timer_cancel(void) {
    s.armed = false;
}

static void serve(void) {
    s.armed = false;
    if (s.deadline > s.tick) s.tick = s.deadline;
    s.counts.deadlines++;
    if (s.late_period && s.counts.deadlines % s.late_period == 0) s.tick += s.late_by;
    stepgen_isr();
}

void hal_idle(void) {
    if (s.armed)
        serve();
    else
        s.tick += SIM_IDLE_TICKS;
}

void sim_run(uint64_t ticks) {
    uint64_t until = s.tick + ticks;
    while (s.armed && s.deadline <= until) serve();
    if (s.tick < until) s.tick = until;
}

void hal_fault(const char *what, int32_t a, int32_t b) {
    (void)a, (void)b;
    s.fault = what;
    s.armed = false;
    hal_pins_write(HAL_PEN | HAL_ENABLE | HAL_X_STEP | HAL_Y_STEP, 0);
}
