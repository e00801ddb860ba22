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
    uint32_t at;    /* when it leaves */
    uint32_t level; /* what it is */
#ifdef AHEAD_PAIR
    uint32_t second_at; /* the one behind it, if that is close; else the same */
    uint32_t second;
#endif
    uint32_t due;  /* when the last that is ready is due */
    uint32_t next; /* index of what comes behind it in the ring */
} p;

uint32_t player_begin(uint32_t at) {
    p.due = at - HAL_EDGE_GAP;
    return p.due;
}

void player_look(void) {
    irq_pend(PORT_IRQ_TIMER);
}

void player_refresh(void) {}

void player_cut(void) {
    p.ready = false;
}

static __attribute__((noinline)) void left_late(uint32_t late) {
    ahead.late++;
    if (late > ahead.latest) ahead.latest = late;
    p.due += late;
    p.at += late;
#ifdef AHEAD_PAIR
    p.second_at += late;
#endif
    ahead.skew += late;
}

/* Makes the edge behind the one that is ready, ready too. */
static inline void pair(void) {
#ifdef AHEAD_PAIR
    const uint32_t tail = p.next, second = ahead.ring[SLOT(tail)];
    if (second >= hal_edge(0, AHEAD_PAIR) || tail == ahead.head) return;
    p.second_at = p.due += hal_edge_ticks(second);
    p.second = port_level(second & HAL_EDGE_PINS);
    p.next = tail + 1;
#endif
}

static inline bool is_pair(void) {
#ifdef AHEAD_PAIR
    return p.second_at != p.at;
#else
    return true;
#endif
}

/* False: there is none. */
static inline bool make_ready(uint32_t tail) {
    p.ready = tail != ahead.head;
    if (!p.ready) return false;
    const uint32_t word = ahead.ring[SLOT(tail)];
    p.at = p.due += hal_edge_ticks(word);
    p.level = port_level(word & HAL_EDGE_PINS);
    p.next = tail + 1;
#ifdef AHEAD_PAIR
    p.second_at = p.at;
#endif
    pair();
    return true;
}

static inline uint32_t play(void) {
    uint32_t at = p.at;
    port_until(port_raw(at));
    port_put(p.level);
#ifdef AHEAD_PAIR
    if (is_pair()) {
        at = p.second_at;
        port_until(port_raw(at));
        port_put(p.second);
    }
#endif
    return at;
}

void player_isr(void) {
    uint32_t now = port_now();
    bool any = p.ready || make_ready(ahead.tail);
    while (any && (int32_t)(p.at - now) <= AHEAD_SOON) {
        const uint32_t at = play(), tail = p.next;
        ahead.tail = tail;
        any = make_ready(tail);
        now = port_now();
        if ((int32_t)(now - at) > AHEAD_AFTER + AHEAD_SLACK) left_late(now - at - AHEAD_AFTER);
    }
    if (any && !is_pair()) pair(); /* it may have come meanwhile */
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
