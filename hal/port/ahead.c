/* ahead.c - see ahead.h. All of it runs in the timer interrupt or with interrupts off. */
#include "hal/port/ahead.h"

#include "hal/hal.h"
#include "hal/port/cortex.h"
#include "port.h"

#define STEPS (uint32_t)(HAL_X_STEP | HAL_Y_STEP)

typedef struct edge {
    uint32_t tick;
    uint8_t mask, value;
} edge_t;

static struct {
    edge_t ring[AHEAD_EDGES];
    uint32_t head, tail;
    bool armed;
    bool planning;          /* stepgen_isr is running */
    uint32_t plan;          /* the armed deadline, in planned time */
    uint32_t skew;          /* real time is planned time + skew */
    uint32_t newest;        /* tick of the newest edge */
    uint32_t began_late[2]; /* X, Y: the pulse under way, or the last one (ticks) */
    uint32_t late, latest;
} a;

uint32_t hal_now(void) {
    if (a.planning) return a.plan;
    uint32_t state = irq_lock();
    uint32_t now = port_now();
    irq_unlock(state);
    return now;
}

void hal_pins_write(uint32_t mask, uint32_t value) {
    if (!a.planning) {
        port_pins(mask, value);
        return;
    }
    a.newest = a.plan + a.skew;
    a.ring[a.head++ % AHEAD_EDGES] = (edge_t){a.newest, (uint8_t)mask, (uint8_t)value};
}

void hal_timer_arm(uint32_t at) {
    if (a.planning) {
        a.plan = at;
        a.armed = true;
        return;
    }
    uint32_t state = irq_lock();
    if (a.head != a.tail && hal_before(at, a.newest)) at = a.newest;
    a.skew = 0;
    a.plan = at;
    a.armed = true;
    port_alarm(port_now());
    irq_unlock(state);
}

void hal_timer_cancel(void) {
    uint32_t state = irq_lock();
    a.armed = false;
    a.tail = a.head;
    irq_unlock(state);
}

uint32_t ahead_late(void) {
    return a.late;
}
uint32_t ahead_latest(void) {
    return a.latest;
}

/* The plan slips: what is in the ring and all that follows. */
static void slip(uint32_t by) {
    a.late++;
    if (by > a.latest) a.latest = by;
    a.skew += by;
    a.newest += by;
    for (uint32_t i = a.tail; i != a.head; i++) a.ring[i % AHEAD_EDGES].tick += by;
}

/* By how much a pulse that ends with these falls began late: so much later it ends, at least. */
static inline uint32_t began_late(uint32_t falls) {
    uint32_t late = falls & HAL_X_STEP ? a.began_late[0] : 0;
    if (falls & HAL_Y_STEP && a.began_late[1] > late) late = a.began_late[1];
    return late;
}

/* Writes the oldest edge at its tick, or as late as need be for full pulses, and goes on while the next one comes soon;
 * the way from one write to the next is kept short. A step of the other motor that comes within AHEAD_MERGE leaves
 * in the same write, at the later of the two ticks. Returns the tick of the last write. */
static uint32_t write_edges(void) {
    uint32_t tail = a.tail, now;
    const uint32_t head = a.head;
    do {
        const edge_t *e = &a.ring[tail++ % AHEAD_EDGES];
        uint32_t tick = e->tick, mask = e->mask, value = e->value;
        uint32_t due = tick + began_late(mask & ~value);
        if (tail != head) {
            const edge_t *next = &a.ring[tail % AHEAD_EDGES];
            if (next->tick - tick <= AHEAD_MERGE && !((mask | next->mask) & ~STEPS) && !(mask & next->mask)) {
                uint32_t due2 = next->tick + began_late(next->mask & ~(uint32_t)next->value);
                if (hal_before(due, due2)) due = due2;
                mask |= next->mask;
                value |= next->value;
                tail++;
            }
        }
        now = port_wait(due);
        port_pins(mask, value);
        uint32_t late = now - tick, rises = mask & value;
        if (rises & HAL_X_STEP) a.began_late[0] = late;
        if (rises & HAL_Y_STEP) a.began_late[1] = late;
        if (late > AHEAD_SLACK) {
            a.tail = tail;
            slip(late);
        }
    } while (tail != head && (int32_t)(a.ring[tail % AHEAD_EDGES].tick - now) < AHEAD_SOON);
    a.tail = tail;
    return now;
}

static void plan_edge(void) {
    a.planning = true;
    a.armed = false;
    stepgen_isr();
    a.planning = false;
}

void ahead_isr(void) {
    uint32_t now = port_now();
    for (;;) {
        int32_t to_edge = AHEAD_WINDOW;
        if (a.head != a.tail) {
            to_edge = (int32_t)(a.ring[a.tail % AHEAD_EDGES].tick - now);
            if (to_edge < AHEAD_SOON) {
                now = write_edges();
                continue;
            }
        }
        int32_t to_plan = (int32_t)(a.plan + a.skew - now);
        bool room = a.head - a.tail < AHEAD_EDGES;
        if (a.armed && room && to_plan < AHEAD_WINDOW && to_edge > AHEAD_COST + AHEAD_ENTRY) {
            plan_edge();
            now = port_now();
            continue;
        }
        /* Back for the edge, or half a window before the next deadline to plan it, whichever is earlier. */
        int32_t in = to_edge - AHEAD_ENTRY;
        if (a.armed && room && (a.head == a.tail || to_plan - AHEAD_WINDOW / 2 < in)) in = to_plan - AHEAD_WINDOW / 2;
        if (a.armed || a.head != a.tail) port_alarm(now + (uint32_t)in);
        return;
    }
}
