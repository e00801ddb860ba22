/* fuzz_console.c - any bytes from a wire, at any pace, and switches that close when they like: a board on the
 * simulator.
 *
 * Bytes 0xf0..0xff are not typed: they let time pass, turn switches, cut the store's power, lose bytes, or switch the
 * board off and on. */
#include <stdlib.h>
#include <string.h>

#include "app/console.h"
#include "sim/sim.h"
#include "sim/sim_console.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MEMORY = 24 * 1024 };
#define MS (HAL_TICK_HZ / 1000)

static console_t console;
static uint64_t memory[MEMORY / 8];
static volatile size_t seen;
static uint64_t drawn;

static void listen(void *ctx, const char *text, size_t bytes) {
    (void)ctx;
    for (size_t i = 0; i < bytes; i++) seen += (uint8_t)text[i];
}

/* Whatever is typed, the motors step only when they are on, and never for hours: then Ctrl-X comes. */
static void record(void *ctx, uint64_t tick, uint32_t pins, uint32_t changed) {
    (void)ctx;
    if ((changed & pins & (HAL_X_STEP | HAL_Y_STEP)) && !(pins & HAL_ENABLE)) abort();
    if (++drawn % 20000 == 0) sim_console_type(tick + 1, "\x18", 1);
}

/* Somebody always comes and presses Ctrl-X: a hold or a `pause -1` may last for ever. */
static void give_up(void *ctx) {
    sim_console_type(sim_now() + 1, "\x18", 1);
    sim_at(sim_now() + 10 * HAL_TICK_HZ, give_up, ctx);
}

static void power_on(void) {
    sim_reset();
    sim_console_reset();
    sim_console_listen(listen, NULL);
    sim_record(record, NULL);
    sim_at(10 * HAL_TICK_HZ, give_up, NULL);
    console_begin(&console, &(console_config_t){memory, sizeof memory, MOTION_BYTES_SMALL});
}

static void run(uint64_t ticks) {
    uint64_t until = sim_now() + ticks;
    while (sim_now() < until) console_step(&console);
}

static void happen(uint8_t what) {
    static const uint32_t SWITCH[] = {HAL_IN_LIMIT_X, HAL_IN_LIMIT_Y, HAL_IN_BUTTON, HAL_IN_ESTOP};
    switch (what) {
    case 0:
        run(MS);
        break;
    case 1:
        run(100 * MS);
        break;
    case 2:
        run(3000 * (uint64_t)MS);
        break;
    case 3:
        sim_run(100 * MS); /* the main loop is busy */
        break;
    case 4:
        sim_store_cut((uint32_t)(drawn % 50));
        break;
    case 5:
        power_on();
        break;
    case 6:
        run(30 * MS);
        break;
    case 7:
        sim_console_type(sim_now(), "splot x*y\r", 10);
        break;
    default:
        sim_inputs_set(sim_now(), SWITCH[(what - 8) / 2], what & 1 ? 0 : SWITCH[(what - 8) / 2]);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 2000) return 0;
    drawn = 0;
    sim_store_erase();
    power_on();
    sim_console_type(0, "set machine steps 2;set isosamples 4,4\r", 39);
    for (size_t i = 0; i < size; i++) {
        if (data[i] >= 0xf0)
            happen(data[i] & 15);
        else
            sim_console_type(sim_now(), (const char *)&data[i], 1);
    }
    run(500 * MS);
    if (sim_fault()) abort();
    return 0;
}
