/* main.c - the program of a board: all its memory, and the console that uses it. */
#include "app/console.h"
#include "config.h"
#include "hal/hal.h"

static console_t console;
static uint64_t memory[CONFIG_BOARD_BYTES / 8];

int main(void) {
    hal_start();
    console_run(&console,
                &(console_config_t){memory, sizeof memory, MOTION_BYTES(CONFIG_MOTION_BLOCKS, CONFIG_MOTION_PIECES)});
    return 0;
}
