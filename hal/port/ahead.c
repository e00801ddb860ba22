/* ahead.c - see ahead.h. */
#include "hal/port/ahead.h"

#include "hal/hal.h"
#include "hal/port/cortex.h"
#include "port.h"

#define SLOT(i) ((i) % AHEAD_EDGES)
#define PENDSV 14
#define NEVER (1u << 30)

ahead_t ahead;

/* The planner itself, and not the switches' interrupt above it. */
static inline bool in_planner(void) {
    return ahead.planning && exception() == PENDSV;
}

/* There is no room for a batch. */
static inline bool is_full(void) {
    return ahead.head - ahead.tail > AHEAD_EDGES - AHEAD_BATCH;
}

/* Words that fit in one piece behind the newest, 2 at least. Not when it is full. */
static inline uint32_t room(void) {
    const uint32_t in_line = AHEAD_EDGES + 1 - SLOT(ahead.head);
    return AHEAD_BATCH < in_line ? AHEAD_BATCH : in_line;
}

static uint32_t locked_now(void) {
    uint32_t state = irq_lock();
    uint32_t now = port_now();
    irq_unlock(state);
    return now;
}

uint32_t hal_now(void) {
    return in_planner() ? ahead.plan : locked_now();
}

static uint32_t horizon; /* of the planner, in planned time */

hal_edges_t hal_edges(void) {
    return (hal_edges_t){&ahead.ring[SLOT(ahead.head)], room(), horizon};
}

/* The last may be under way although the ring is empty. */
bool hal_edges_left(void) {
    return ahead.head == ahead.tail && ahead.newest + ahead.skew - locked_now() - 1 > 2 * AHEAD_WINDOW;
}

/* Interrupts are off as shortly as can be: the player's may be due. */
void hal_edges_put(uint32_t edges, uint32_t first_at, uint32_t last_at) {
    const uint32_t head = ahead.head, slot = SLOT(head);
    uint32_t *first = &ahead.ring[slot];
    *first = hal_edge(*first & HAL_EDGE_PINS, first_at - ahead.newest);
    if (slot + edges > AHEAD_EDGES) ahead.ring[0] = ahead.ring[AHEAD_EDGES];
    uint32_t state = irq_lock();
    if (!ahead.dropped) {
        player_refresh();
        if (head == ahead.tail) {
            const uint32_t from = player_begin(first_at + ahead.skew) - ahead.skew;
            *first = hal_edge(*first & HAL_EDGE_PINS, first_at - from);
        }
        ahead.newest = last_at;
        ahead.head = head + edges;
    }
    irq_unlock(state);
    player_fed();
}

/* The short way for those who stop the machine, and for what is done by hand. */
void hal_pins_write(uint32_t mask, uint32_t value) {
    port_write(port_word(mask, value));
}

void hal_timer_arm(uint32_t at) {
    uint32_t state = irq_lock();
    if (in_planner()) {
        ahead.plan = at;
        ahead.armed = !ahead.dropped;
        irq_unlock(state);
        return;
    }
    ahead.newest += ahead.skew;
    ahead.skew = 0;
    if (ahead.head != ahead.tail && hal_before(at, ahead.newest)) at = ahead.newest;
    ahead.plan = at;
    ahead.armed = true;
    pendsv_pend();
    irq_unlock(state);
}

void hal_timer_cancel(void) {
    uint32_t state = irq_lock();
    ahead.armed = false;
    ahead.dropped = ahead.planning;
    ahead.tail = ahead.head;
    player_cut();
    irq_unlock(state);
}

uint32_t ahead_late(void) {
    return ahead.late;
}
uint32_t ahead_latest(void) {
    return ahead.latest;
}

/* When to go on: half a window before the deadline; with the ring full, when half of what it holds has left. */
static uint32_t wake_at(uint32_t now, bool full) {
    if (!ahead.armed) return now + NEVER;
    if (!full) return ahead.plan + ahead.skew - AHEAD_WINDOW / 2;
    const int32_t holds = (int32_t)(ahead.newest + ahead.skew - now);
    return holds > 0 ? now + (uint32_t)holds / 2 : now;
}

/* To the end of the window as it is at the beginning: following the clock, it would make edges one by one. */
void ahead_plan_isr(void) {
    const uint32_t now = locked_now();
    bool full = false;
    while (ahead.armed && (int32_t)(ahead.plan + ahead.skew - now) < AHEAD_WINDOW) {
        full = is_full();
        if (full) break;
        horizon = now + AHEAD_WINDOW - ahead.skew;
        ahead.armed = false;
        ahead.planning = true;
        stepgen_isr();
        ahead.planning = false;
        ahead.dropped = false;
    }
    ahead.wake = wake_at(now, full);
    player_wake();
}
