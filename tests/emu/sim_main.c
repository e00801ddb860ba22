/* sim_main.c - the program of a board on the simulator: firmware/main.c itself, with the board's capacities, on the
 * simulated machine. Its recorded trace is what the board's pins are compared with.
 *
 *     sim-BOARD STIM OUT.vcd OUT.txt DRAWINGS [STORE]
 *
 * STORE keeps the saved settings and scene from one run to the next, as the chip's flash does. The run ends when
 * everything has been played and no pin has moved for STILL_S: a scene that is refused does not wait for its drawing.
 */
#include <stdio.h>
#include <stdlib.h>

#include "hal/hal.h"
#include "sim/sim.h"
#include "sim/sim_console.h"
#include "sim/vcd.h"
#include "tests/emu/stim.h"

#define STILL_S 30

int firmware_main(void); /* main() of firmware/main.c, compiled under this name */

static struct {
    vcd_t vcd;
    FILE *trace, *console;
    stim_t *stim;
    int stims;
    int drawings, to_draw;
    bool started;
    uint64_t moved; /* tick of the last pin change, or of the last thing to be played */
    const char *store;
} g;

static void load_store(void) {
    static uint32_t slot[HAL_STORE_BYTES / 4];
    FILE *f = fopen(g.store, "rb");
    for (int i = 0; f && i < HAL_STORE_SLOTS; i++)
        if (fread(slot, sizeof slot, 1, f) == 1) hal_store_write(i, slot, sizeof slot);
    if (f) fclose(f);
}

static int save_store(void) {
    static uint32_t slot[HAL_STORE_BYTES / 4];
    FILE *f = fopen(g.store, "wb");
    int err = f ? 0 : -1;
    for (int i = 0; f && i < HAL_STORE_SLOTS; i++) {
        hal_store_read(i, slot, sizeof slot);
        if (fwrite(slot, sizeof slot, 1, f) != 1) err = -1;
    }
    return f && fclose(f) ? -1 : err;
}

static void finish(void *ctx) {
    (void)ctx;
    int err = vcd_end(&g.vcd, sim_now());
    if (fclose(g.trace) || fclose(g.console)) err = -1;
    if (g.store && save_store()) err = -1;
    if (sim_fault()) fprintf(stderr, "fault: %s\n", sim_fault());
    exit(err || sim_fault() ? 1 : 0);
}

static uint64_t ticks_of(int64_t ns) {
    return (uint64_t)(ns * 2 / 125);
}

/* Looks once a second. */
static void look(void *ctx) {
    if (sim_now() > g.moved + (uint64_t)STILL_S * HAL_TICK_HZ) finish(ctx);
    sim_at(sim_now() + HAL_TICK_HZ, look, ctx);
}

static void play(bool relative) {
    uint64_t origin = relative ? sim_now() : 0;
    for (int i = 0; i < g.stims; i++) {
        const stim_t *s = &g.stim[i];
        if (s->relative != relative) continue;
        uint64_t at = origin + ticks_of(s->ns);
        if (s->kind == STIM_TYPE) sim_console_type(at, s->text, (size_t)s->bytes);
        if (s->kind == STIM_INPUT) sim_inputs_set(at, 1u << s->input, s->level ? 1u << s->input : 0);
        if (s->kind == STIM_QUIT) sim_at(at, finish, NULL);
        if (at > g.moved) g.moved = at;
    }
}

static void record(void *ctx, uint64_t tick, uint32_t pins, uint32_t changed) {
    vcd_record(ctx, tick, pins, changed);
    if (tick > g.moved) g.moved = tick;
    if (!g.started) {
        g.started = true;
        play(true);
    }
    if (changed & HAL_ENABLE && !(pins & HAL_ENABLE) && ++g.drawings == g.to_draw)
        sim_at(tick + HAL_TICK_HZ / 50, finish, NULL);
}

static void listen(void *ctx, const char *text, size_t bytes) {
    (void)ctx;
    fwrite(text, 1, bytes, g.console);
}

int main(int argc, char **argv) {
    if (argc != 5 && argc != 6) return 2;
    g.store = argc == 6 ? argv[5] : NULL;
    g.stims = stim_read(argv[1], &g.stim);
    g.trace = fopen(argv[2], "wb");
    g.console = fopen(argv[3], "wb");
    g.to_draw = atoi(argv[4]);
    if (g.stims < 0 || !g.trace || !g.console) return 2;
    sim_reset();
    sim_console_reset();
    sim_console_listen(listen, NULL);
    if (g.store) load_store();
    vcd_begin(&g.vcd, vcd_write_file, g.trace, NULL, argv[1], 0);
    sim_record(record, &g.vcd);
    play(false);
    sim_at(HAL_TICK_HZ, look, NULL);
    return firmware_main();
}
