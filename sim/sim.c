/* sim.c - see sim.h. */
#include "sim/sim.h"
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#define EDGES 256
#define AHEAD_TICKS 8000 /* of the main loop, at most: as on the boards */

typedef struct event {
    uint64_t tick;
    void (*call)(void *ctx);
    void *ctx;
} event_t;

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
    uint64_t deadlines; /* interrupts served */
    bool one_by_one;
    uint64_t until; /* edges may be made ahead so far */
    uint32_t edge[EDGES], edges;
    uint64_t first;            /* when the first of them is due */
    event_t event[SIM_EVENTS]; /* by tick */
    int events;
} s;

void sim_reset(void) {
    s.tick = 0;
    s.offset = 0;
    s.pins = 0;
    s.armed = false;
    s.recorder = NULL;
    s.fault = NULL;
    s.late_period = 0;
    s.events = 0;
    s.deadlines = 0;
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
    if (s.recorder) s.recorder(s.ctx, s.tick, pins, changed);
}

hal_edges_t hal_edges(void) {
    if (s.one_by_one || s.late_period) return (hal_edges_t){0};
    return (hal_edges_t){s.edge, EDGES, (uint32_t)s.until + s.offset};
}

void hal_edges_put(uint32_t edges, uint32_t first_at, uint32_t last_at) {
    (void)last_at;
    s.edges = edges;
    s.first = s.tick + (first_at - hal_now());
}

bool hal_edges_left(void) {
    return true;
}

uint32_t hal_now(void) {
    return (uint32_t)s.tick + s.offset;
}

void hal_timer_arm(uint32_t at) {
    int32_t in = (int32_t)(at - hal_now());
    if (in < 0) in = 0; /* it had gone by already */
    s.deadline = s.tick + (uint32_t)in;
    s.armed = true;
}

void hal_timer_cancel(void) {
    s.armed = false;
}

static void play_edges(void) {
    if (s.edges) s.tick = s.first;
    for (uint32_t i = 0; i < s.edges; i++) {
        if (i) s.tick += hal_edge_ticks(s.edge[i]);
        hal_pins_write(HAL_EDGE_PINS, s.edge[i]);
    }
    s.edges = 0;
}

/* What comes from outside at its tick meets nothing made beyond it. */
static void serve(uint64_t until) {
    s.armed = false;
    if (s.deadline > s.tick) s.tick = s.deadline;
    s.deadlines++;
    if (s.late_period && s.deadlines % s.late_period == 0) s.tick += s.late_by;
    s.until = s.tick + AHEAD_TICKS < until ? s.tick + AHEAD_TICKS : until;
    if (s.events && s.event[0].tick < s.until) s.until = s.event[0].tick;
    stepgen_isr();
    play_edges();
}

void sim_play_ahead(bool ahead) {
    s.one_by_one = !ahead;
}

bool sim_at(uint64_t tick, void (*event)(void *ctx), void *ctx) {
    if (s.events == SIM_EVENTS) return false;
    int i = s.events++;
    for (; i > 0 && s.event[i - 1].tick > tick; i--) s.event[i] = s.event[i - 1];
    s.event[i] = (event_t){tick, event, ctx};
    return true;
}

/* The next event, deadline, or nothing, if it comes up to `until`. */
static bool step(uint64_t until) {
    if (s.events && s.event[0].tick <= until && !(s.armed && s.deadline < s.event[0].tick)) {
        event_t e = s.event[0];
        s.events--;
        memmove(s.event, s.event + 1, (size_t)s.events * sizeof s.event[0]);
        if (e.tick > s.tick) s.tick = e.tick;
        e.call(e.ctx);
        return true;
    }
    if (!s.armed || s.deadline > until) return false;
    serve(until);
    return true;
}

void hal_idle(void) {
    uint64_t until = s.tick + SIM_IDLE_TICKS;
    if (!step(s.armed ? UINT64_MAX : until)) s.tick = until;
}

void sim_run(uint64_t ticks) {
    uint64_t until = s.tick + ticks;
    while (step(until)) continue;
    if (s.tick < until) s.tick = until;
}

void hal_fault(const char *what, int32_t a, int32_t b) {
    (void)a, (void)b;
    s.fault = what;
    s.armed = false;
    hal_pins_write(HAL_PEN | HAL_ENABLE | HAL_X_STEP | HAL_Y_STEP, 0);
}
