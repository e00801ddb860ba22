/* sim_console.c - see sim_console.h. */
#include "sim/sim_console.h"

#include <string.h>

#include "error.h"
#include "sim/sim.h"

#define STOPPING (HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y | HAL_IN_ESTOP)
#define NO_CUT UINT32_MAX

typedef struct press {
    uint32_t mask, value;
} press_t;

static struct {
    sim_listener_t listener;
    void *ctx;
    struct {
        uint64_t tick;
        uint8_t byte;
    } typed[SIM_TYPED_BYTES]; /* a ring: bytes on their way */
    uint32_t typed_head, typed_tail;
    uint64_t typed_last; /* tick of the newest */
    uint8_t received[SIM_RECEIVE_BYTES];
    uint32_t received_head, received_tail;
    uint32_t errors;
    press_t press[SIM_EVENTS];
    uint32_t press_head, press_tail;
    uint32_t inputs; /* levels: 1 is active with the board's own wiring */
    uint32_t inverted;
    uint32_t cut;
    bool dead, held;
    uint64_t watchdog, fed, longest; /* ticks; watchdog 0: off */
} c;

static struct {
    bool used;
    uint8_t slot[HAL_STORE_SLOTS][HAL_STORE_BYTES];
} store;

void sim_console_reset(void) {
    memset(&c, 0, sizeof c);
    c.cut = NO_CUT;
    if (!store.used) sim_store_erase();
}

void sim_console_listen(sim_listener_t listener, void *ctx) {
    c.listener = listener;
    c.ctx = ctx;
}

/* One event at a time stands for all that is typed. */
static void byte_arrives(void *ctx) {
    (void)ctx;
    if (c.received_head - c.received_tail == SIM_RECEIVE_BYTES)
        c.errors++;
    else
        c.received[c.received_head++ % SIM_RECEIVE_BYTES] = c.typed[c.typed_tail % SIM_TYPED_BYTES].byte;
    c.typed_tail++;
    if (c.typed_tail != c.typed_head) sim_at(c.typed[c.typed_tail % SIM_TYPED_BYTES].tick, byte_arrives, NULL);
}

uint64_t sim_console_type(uint64_t tick, const char *bytes, size_t count) {
    if (count > SIM_TYPED_BYTES - (c.typed_head - c.typed_tail)) {
        hal_fault("sim: too much typed", (int32_t)count, 0);
        return c.typed_last;
    }
    bool under_way = c.typed_head != c.typed_tail;
    for (size_t i = 0; i < count; i++) {
        if (tick < c.typed_last + SIM_BYTE_TICKS) tick = c.typed_last + SIM_BYTE_TICKS;
        c.typed_last = tick;
        c.typed[c.typed_head % SIM_TYPED_BYTES].tick = tick;
        c.typed[c.typed_head++ % SIM_TYPED_BYTES].byte = (uint8_t)bytes[i];
    }
    if (!under_way && count) sim_at(c.typed[c.typed_tail % SIM_TYPED_BYTES].tick, byte_arrives, NULL);
    return c.typed_last;
}

int hal_console_read(void) {
    return c.received_tail == c.received_head ? -1 : c.received[c.received_tail++ % SIM_RECEIVE_BYTES];
}

void hal_console_write(const char *text, size_t bytes) {
    if (c.listener) c.listener(c.ctx, text, bytes);
}

void hal_console_hold(bool hold) {
    if (hold != c.held) hal_console_write(hold ? "\023" : "\021", 1);
    c.held = hold;
}

uint32_t hal_console_errors(void) {
    uint32_t n = c.errors;
    c.errors = 0;
    return n;
}

static void inputs_change(void *ctx) {
    (void)ctx;
    press_t p = c.press[c.press_tail++ % SIM_EVENTS];
    uint32_t before = c.inputs;
    c.inputs = (before & ~p.mask) | (p.value & p.mask);
    if ((c.inputs ^ c.inverted) & ~(before ^ c.inverted) & STOPPING) console_input_isr(hal_inputs());
}

void sim_inputs_set(uint64_t tick, uint32_t mask, uint32_t value) {
    c.press[c.press_head++ % SIM_EVENTS] = (press_t){mask, value};
    sim_at(tick, inputs_change, NULL);
}

uint32_t hal_inputs(void) {
    return c.inputs ^ c.inverted;
}

/* Pins are recorded as the program means them. */
void hal_wire(const hal_wiring_t *wiring) {
    c.inverted = wiring->invert_inputs;
}

void hal_trip(uint32_t limits) {
    (void)limits; /* console_input_isr takes no time here */
}

void sim_store_erase(void) {
    memset(store.slot, 0xff, sizeof store.slot);
    store.used = true;
}

void sim_store_cut(uint32_t bytes) {
    c.cut = bytes;
}

int hal_store_read(int slot, void *buf, size_t bytes) {
    if (slot < 0 || slot >= HAL_STORE_SLOTS || bytes > HAL_STORE_BYTES) return ERR_FILE;
    memcpy(buf, store.slot[slot], bytes);
    return 0;
}

int hal_store_write(int slot, const void *buf, size_t bytes) {
    if (slot < 0 || slot >= HAL_STORE_SLOTS || bytes > HAL_STORE_BYTES || c.dead) return ERR_FILE;
    memset(store.slot[slot], 0xff, HAL_STORE_BYTES);
    if (bytes > c.cut) {
        memcpy(store.slot[slot], buf, c.cut);
        c.dead = true;
        return ERR_FILE;
    }
    memcpy(store.slot[slot], buf, bytes);
    if (c.cut != NO_CUT) c.cut -= (uint32_t)bytes;
    return 0;
}

static void note_feeding(void) {
    uint64_t since = sim_now() - c.fed;
    if (c.watchdog && since > c.longest) c.longest = since;
}

void hal_watchdog_start(uint32_t ms) {
    c.watchdog = (uint64_t)ms * (HAL_TICK_HZ / 1000);
    c.fed = sim_now();
}

void hal_watchdog_feed(void) {
    note_feeding();
    c.fed = sim_now();
}

uint64_t sim_watchdog_longest(void) {
    note_feeding();
    return c.longest;
}

bool sim_watchdog_bitten(void) {
    return c.watchdog && sim_watchdog_longest() > c.watchdog;
}

void hal_start(void) {}

uint32_t hal_stack_used(uint32_t *room) {
    return *room = 0;
}

bool hal_stack_ok(void) {
    return true;
}

const char *hal_board_name(void) {
    return "sim";
}
