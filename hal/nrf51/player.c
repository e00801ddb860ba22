/* player.c - the player of ahead.h that is the interrupt of TIMER0, the most urgent of all (player_isr.S), cut down to
 * what an edge needs: 16 MHz leave 200 instructions for each of the four edges of two steps at 20,000 a second, and
 * most of those are the planner's.
 *
 *     alarm    ENTRY    edge      SOON
 *       |----------------|------------ - - -> the next: waited for, or an alarm of its own
 *        entered, waits
 *
 * After an edge the next word is fetched before anything else is looked at, so one that follows at once is 1.4 us late
 * at most. One that is late by more than SLACK takes all that follows with it, so no pulse gets shorter than planned by
 * more than that.
 *
 * TIMER1 wakes the planner: 16 bits of microseconds. */
#include "hal/nrf51/player.h"
#include "hal/hal.h"
#include "hal/port/ahead.h"
#include "hal/port/cortex.h"
#include "port.h"

#include <stddef.h>

#define NEVER (1u << 30)
#define FAR_US 50000

struct player {
    uint32_t at;     /* when the next edge leaves, or the last one has left */
    uint32_t level;  /* of the chip's port from then on; 0: there is none */
    uint32_t low;    /* tail at which the planner is called: there is room for a batch */
    uint32_t turned; /* levels that are turned round */
} player;

#define AT(type, member, offset) _Static_assert(offsetof(type, member) == (offset), "player_isr.S counts on it")
AT(ahead_t, ring, 0);
AT(ahead_t, head, AHEAD_HEAD);
AT(ahead_t, tail, AHEAD_HEAD + HEAD_TAIL);
AT(ahead_t, skew, AHEAD_HEAD + HEAD_SKEW);
AT(ahead_t, late, AHEAD_HEAD + HEAD_LATE);
AT(ahead_t, latest, AHEAD_HEAD + HEAD_LATEST);
AT(struct player, at, P_AT);
AT(struct player, level, P_LEVEL);
AT(struct player, low, P_LOW);
AT(struct player, turned, P_TURNED);
_Static_assert(AHEAD_EDGES == PLAYER_RING && HAL_EDGE_GAP == 3 && HAL_EDGE_PINS == 63, "player_isr.S counts on it");

uint32_t player_begin(uint32_t at) {
    player.at = at - HAL_EDGE_GAP;
    return player.at;
}

void player_refresh(void) {}

void player_cut(void) {
    player.level = 0;
}

void player_turn(uint32_t pins) {
    player.turned = port_spread[pins] ^ port_spread[0];
}

void player_fed(void) {
    if (!player.level) irq_pend(PORT_IRQ_TIMER);
}

/* The planner is called as soon as there is room for what it could not make; the clock has it look again, too. */
void player_wake(void) {
    const uint32_t state = irq_lock();
    const bool full = ahead.head - ahead.tail > AHEAD_EDGES - AHEAD_BATCH;
    player.low = full ? ahead.head - (AHEAD_EDGES - AHEAD_BATCH) : ahead.head + NEVER;
    const int32_t in = (int32_t)(ahead.wake - port_now());
    irq_unlock(state);
    if (in < 2 * 16 && !full)
        pendsv_pend();
    else if (!full)
        port_wake_in((uint32_t)in < FAR_US * 16 ? (uint32_t)in >> 4 : FAR_US);
}
