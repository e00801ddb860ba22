/* ahead.c - see ahead.h. */
#include "hal/port/ahead.h"

#include "hal/hal.h"
#include "hal/port/cortex.h"
#include "port.h"

#define CHAIN 8 /* edges made ready together */

typedef struct edge {
    uint32_t at; /* clock */
    uint8_t mask, value;
} edge_t;

typedef struct ready {
    uint32_t raw;
    port_word_t word;
} ready_t;

static struct {
    edge_t ring[AHEAD_EDGES];
    volatile uint32_t head; /* written by the planner */
    volatile uint32_t tail; /* written by the writer */
    bool armed;
    volatile bool planning; /* stepgen_isr is running */
    volatile bool dropped;  /* what it is planning came to nothing: it was interrupted by a halt */
    uint32_t plan;          /* the armed deadline, in planned time */
    uint32_t skew;          /* real time is planned time + skew */
    uint32_t newest;        /* when the newest edge leaves */
    uint32_t put_off[2];    /* X, Y: how much later than planned its pulse begins, and so ends */
    uint32_t late, latest;  /* edges that left late; by how much at most */
} a;

#define PENDSV 14

/* The planner itself, and not the switches' interrupt above it. */
static inline bool in_planner(void) {
    return a.planning && exception() == PENDSV;
}

static inline bool full(void) {
    return a.head - a.tail >= AHEAD_EDGES;
}

static inline uint32_t later(uint32_t t, uint32_t u) {
    return hal_before(t, u) ? u : t;
}

static uint32_t locked_now(void) {
    uint32_t state = irq_lock();
    uint32_t now = port_now();
    irq_unlock(state);
    return now;
}

uint32_t hal_now(void) {
    return in_planner() ? a.plan : locked_now();
}

/* The alarm for the next edge, or for the planner if that is earlier. Interrupts off, or in the writer. */
static void set_alarm(uint32_t now) {
    bool any = a.head != a.tail;
    uint32_t at = a.ring[a.tail % AHEAD_EDGES].at - AHEAD_ENTRY;
    if (a.armed && !full()) {
        uint32_t wake = a.plan + a.skew - AHEAD_WINDOW / 2;
        if (!hal_before(now, wake))
            pendsv_pend();
        else if (!any || hal_before(wake, at)) {
            any = true;
            at = wake;
        }
    }
    if (any) port_alarm(at);
}

/* When an edge leaves is settled here: its tick, but AHEAD_GAP after the one before it, and a pulse keeps its width. */
static __attribute__((noinline)) void plan_write(uint32_t mask, uint32_t value) {
    uint32_t state = irq_lock();
    if (a.dropped) {
        irq_unlock(state);
        return;
    }
    uint32_t tick = a.plan + a.skew, at = tick;
    const uint32_t falls = mask & ~value, rises = mask & value;
    if (falls & HAL_X_STEP) at = later(at, tick + a.put_off[0]);
    if (falls & HAL_Y_STEP) at = later(at, tick + a.put_off[1]);
    const bool first = a.head == a.tail;
    at = first && !hal_before(a.newest, at) ? at : later(at, a.newest + AHEAD_GAP);
    if (rises & HAL_X_STEP) a.put_off[0] = at - tick;
    if (rises & HAL_Y_STEP) a.put_off[1] = at - tick;
    a.newest = at;
    a.ring[a.head % AHEAD_EDGES] = (edge_t){at, (uint8_t)mask, (uint8_t)value};
    a.head = a.head + 1;
    if (first) port_alarm(at - AHEAD_ENTRY);
    irq_unlock(state);
}

/* The short way for those who stop the machine. */
void hal_pins_write(uint32_t mask, uint32_t value) {
    if (in_planner())
        plan_write(mask, value);
    else
        port_write(port_word(mask, value));
}

void hal_timer_arm(uint32_t at) {
    uint32_t state = irq_lock();
    if (in_planner()) {
        a.plan = at;
        a.armed = !a.dropped;
        irq_unlock(state);
        return;
    }
    if (a.head != a.tail && hal_before(at, a.newest)) at = a.newest;
    a.skew = 0;
    a.plan = at;
    a.armed = true;
    pendsv_pend();
    irq_unlock(state);
}

void hal_timer_cancel(void) {
    uint32_t state = irq_lock();
    a.armed = false;
    a.dropped = a.planning;
    a.tail = a.head;
    irq_unlock(state);
}

uint32_t ahead_late(void) {
    return a.late;
}
uint32_t ahead_latest(void) {
    return a.latest;
}

/* The edges from `from` to the tail left late. If that is more than the motors may notice, all that follows is put off;
 * else only the ends of the pulses that began, and what would then come too close. */
static void left_late(uint32_t from, uint32_t late) {
    a.late++;
    if (late > a.latest) a.latest = late;
    if (late > AHEAD_SLACK) {
        late -= AHEAD_GAP; /* which reading the clock has taken */
        a.skew += late;
        a.newest += late;
        for (uint32_t i = a.tail; i != a.head; i++) a.ring[i % AHEAD_EDGES].at += late;
        return;
    }
    uint32_t high = 0, before = 0;
    for (uint32_t i = from; i != a.head; i++) {
        edge_t *e = &a.ring[i % AHEAD_EDGES];
        const uint32_t ends = e->mask & ~(uint32_t)e->value & high;
        high = (high & ~ends) | (e->mask & e->value);
        if (ends || (int32_t)(i - a.tail) < 0) e->at += late;
        if (i != from) e->at = later(e->at, before + AHEAD_GAP);
        before = e->at;
    }
    if (high & HAL_X_STEP) a.put_off[0] += late;
    if (high & HAL_Y_STEP) a.put_off[1] += late;
    a.newest = before;
}

/* Edges, until leaving pays. Those that come close together are made
 * ready before the first is waited for, so that no more than AHEAD_GAP lies between two. */
void ahead_write_isr(void) {
    uint32_t now = port_now();
    while (a.head != a.tail) {
        ready_t ready[CHAIN];
        const uint32_t from = a.tail;
        const edge_t *e = &a.ring[from % AHEAD_EDGES];
        if ((int32_t)(e->at - now) > AHEAD_SOON) break;
        uint32_t n = 0, at;
        do {
            at = e->at;
            ready[n++] = (ready_t){port_raw(at), port_word(e->mask, e->value)};
            e = &a.ring[(from + n) % AHEAD_EDGES];
        } while (n < CHAIN && from + n != a.head && e->at - at < AHEAD_CHAIN);
        for (const ready_t *r = ready; r < ready + n; r++) {
            port_until(r->raw);
            port_write(r->word);
        }
        a.tail = from + n;
        now = port_now();
        if (now - at > 2 * AHEAD_GAP) left_late(from, now - at);
    }
    set_alarm(now);
}

void ahead_plan_isr(void) {
    uint32_t now = locked_now();
    while (a.armed && !full()) {
        if ((int32_t)(a.plan + a.skew - now) >= AHEAD_WINDOW) {
            now = locked_now();
            if ((int32_t)(a.plan + a.skew - now) >= AHEAD_WINDOW) break;
        }
        a.armed = false;
        a.planning = true;
        stepgen_isr();
        a.planning = false;
        a.dropped = false;
    }
    uint32_t state = irq_lock();
    set_alarm(port_now());
    irq_unlock(state);
}
