/* console_fixture.h - a board on the simulator with somebody at its console: types at exact ticks, reads what it says.
 */
#ifndef CONSOLE_FIXTURE_H
#define CONSOLE_FIXTURE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/console.h"
#include "sim/sim.h"
#include "sim/sim_console.h"

#define MS (HAL_TICK_HZ / 1000)
#define SECOND ((uint64_t)HAL_TICK_HZ)

static struct {
    console_t console;
    uint64_t memory[1 << 16];
    console_config_t config;
    char said[1 << 18];
    size_t said_len; /* without flow control, which is here: */
    bool off;
    int offs;
    uint64_t steps[2], pen_downs, edges, last_step;
    int32_t at[2];
    uint32_t pins;
} fix;

static inline void fix_listen(void *ctx, const char *text, size_t bytes) {
    (void)ctx;
    if (bytes > sizeof fix.said - 1 - fix.said_len) return;
    for (size_t i = 0; i < bytes; i++) {
        if (text[i] == 17 || text[i] == 19) {
            fix.off = text[i] == 19;
            fix.offs += fix.off;
        } else {
            fix.said[fix.said_len++] = text[i];
        }
    }
    fix.said[fix.said_len] = '\0';
}

static inline void fix_record(void *ctx, uint64_t tick, uint32_t pins, uint32_t changed) {
    (void)ctx;
    static const uint32_t STEP[2] = {HAL_X_STEP, HAL_Y_STEP}, DIR[2] = {HAL_X_DIR, HAL_Y_DIR};
    for (int k = 0; k < 2; k++) {
        if (!(changed & pins & STEP[k])) continue;
        fix.steps[k]++;
        fix.at[k] += pins & DIR[k] ? 1 : -1;
        fix.last_step = tick;
    }
    if (changed & pins & HAL_PEN) fix.pen_downs++;
    fix.pins = pins;
    fix.edges++;
}

/* Nothing heard or seen so far. */
static inline void fix_forget(void) {
    fix.said_len = 0;
    fix.said[0] = '\0';
    fix.steps[0] = fix.steps[1] = fix.pen_downs = fix.edges = 0;
}

/* Power on; the store keeps what it has. */
static inline void fix_power_on(size_t bytes) {
    sim_reset();
    sim_console_reset();
    sim_console_listen(fix_listen, NULL);
    sim_record(fix_record, NULL);
    fix_forget();
    fix.at[0] = fix.at[1] = 0;
    fix.pins = 0;
    fix.config = (console_config_t){fix.memory, bytes, MOTION_BYTES_HOST};
    console_begin(&fix.console, &fix.config);
}

/* Lets the board work for so long, and on until it has come to an end of what it then does. */
static inline void fix_run(uint64_t ticks) {
    uint64_t until = sim_now() + ticks;
    while (sim_now() < until) console_step(&fix.console);
    while (fix.console.realtime.head != fix.console.realtime.tail) console_step(&fix.console);
    console_step(&fix.console);
}

static inline void fix_type(const char *text) {
    sim_console_type(sim_now() + MS, text, strlen(text));
}

/* Types, and lets the board work on for a while. */
static inline void fix_say(const char *text, uint64_t ticks) {
    fix_type(text);
    fix_run((uint64_t)strlen(text) * SIM_BYTE_TICKS + 2 * MS + ticks);
}

static inline int fix_heard(const char *text) {
    return strstr(fix.said, text) != NULL;
}

#endif
