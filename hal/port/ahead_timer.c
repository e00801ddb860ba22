/* ahead_timer.c - the player of ahead.h that is an interrupt of a timer, the most urgent of all.
 *
 *     alarm      AHEAD_ENTRY     edge      AHEAD_SOON
 *       |-------------------------|------------------ - - -> the next one: waited for, or an alarm of its own
 *        entered, waits for its tick
 *
 * An edge that is late by more than AHEAD_SLACK takes all that follows with it, so no pulse gets shorter than planned
 * by more than that.
 *
 * The port defines in its port.h, for use in this interrupt:
 *     uint32_t port_raw(uint32_t at)       a tick near the last port_now, as whatever the port compares fastest
 *     void port_until(uint32_t raw)        waits for it
 *     void port_alarm(uint32_t at)         lets its interrupt call player_isr at or shortly before that tick, which is
 *                                          AHEAD_SOON - AHEAD_ENTRY or more after the last port_now; replaces an
 *                                          earlier alarm
 *     uint32_t port_level(uint32_t pins)   what to write to all pins, polarity applied
 *     void port_put(uint32_t level)
 *     AHEAD_ENTRY   ticks from an alarm to where its edge is waited for, at most, other code having interrupts off
 *     AHEAD_SOON    ticks to an edge that leaving the interrupt is not worth for: leaving and entering
 *     AHEAD_AFTER   ticks from an edge until the clock has been read with the next one ready
 */
#include "hal/port/ahead.h"

#ifdef AHEAD_ENTRY
#include "hal/hal.h"
#include "hal/port/cortex.h"
#include "port.h"

#define SLOT(i) ((i) % AHEAD_EDGES)
#define NEVER (1u << 28) /* ticks: looks again, without need */

/* The next edge is made ready before the interrupt is left, so that little is to be done when it is entered again. */
static struct {
    bool ready;
    uint32_t at;    /* when it leaves, or the last one has left */
    uint32_t level; /* what it is */
} p;

uint32_t player_begin(uint32_t at) {
    p.at = at - HAL_EDGE_GAP;
    return p.at;
}

void player_fed(void) {
    irq_pend(PORT_IRQ_TIMER);
}

void player_wake(void) {
    irq_pend(PORT_IRQ_TIMER);
}

void player_refresh(void) {}

void player_cut(void) {
    p.ready = false;
}

static __attribute__((noinline)) void left_late(uint32_t late) {
    ahead.late++;
    if (late > ahead.latest) ahead.latest = late;
    p.at += late;
    ahead.skew += late;
}

/* False: there is none. */
static inline bool make_ready(uint32_t tail) {
    p.ready = tail != ahead.head;
    if (!p.ready) return false;
    const uint32_t word = ahead.ring[SLOT(tail)];
    p.at += hal_edge_ticks(word);
    p.level = port_level(word & HAL_EDGE_PINS);
    return true;
}

void player_isr(void) {
    uint32_t now = port_now();
    bool any = p.ready || make_ready(ahead.tail);
    while (any && (int32_t)(p.at - now) <= AHEAD_SOON) {
        const uint32_t at = p.at, tail = ahead.tail + 1;
        port_until(port_raw(at));
        port_put(p.level);
        ahead.tail = tail;
        any = make_ready(tail);
        now = port_now();
        if ((int32_t)(now - at) > AHEAD_AFTER + AHEAD_SLACK) left_late(now - at - AHEAD_AFTER);
    }
    uint32_t at = any ? p.at : now + NEVER;
    at -= AHEAD_ENTRY;
    const uint32_t wake = ahead.wake;
    if ((int32_t)(wake - now) < AHEAD_SOON - AHEAD_ENTRY) {
        ahead.wake = now + NEVER;
        pendsv_pend();
    } else if (hal_before(wake, at)) {
        at = wake;
    }
    port_alarm(at);
}
#endif
