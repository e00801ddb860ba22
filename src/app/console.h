/* console.h - a board's application: the language on a serial line, drawing on the machine, the saved scene, switches.
 *
 * Usage (firmware/main.c, also on the desktop against sim/):
 *
 *     static console_t console;
 *     static uint64_t memory[BYTES / 8];
 *     int main(void) {
 *         hal_start();
 *         console_run(&console, &(console_config_t){memory, sizeof memory, MOTION_BYTES_SMALL});
 *     }
 *
 * All memory is console_t and the lent block: the machine's queue first, then the data of the last plot, and what they
 * leave is lent to the picture, or to `save`. There is one console per program. docs/BOARD.md is the manual for the
 * person at the other end of the line.
 *
 * Context: main loop; console_input_isr (hal.h) is here, too. */
#ifndef CONSOLE_H
#define CONSOLE_H

#include "app/carriage.h"
#include "app/keep.h"
#include "app/line_edit.h"
#include "app/picture.h"
#include "app/realtime.h"
#include "lang/session.h"

typedef struct console_config {
    void *memory; /* aligned to 8, the console's for good */
    size_t bytes;
    size_t motion_bytes; /* of it, for the machine's queue: at least MOTION_BYTES_MIN */
} console_config_t;

typedef struct console {
    session_t session;
    session_port_t port;
    picture_t picture;
    carriage_t carriage;
    realtime_t realtime;
    line_edit_t edit;
    keep_t keep;
    keep_capture_t capture;
    machine_t kept_machine; /* as in the store */
    int32_t own_symbols;    /* of a session with nothing defined */
    bool wired;             /* the port knows kept_machine's wiring */
    bool machine_line;      /* the line, maybe continued, sets the machine's numbers */
    bool loading;           /* what is being carried out comes from the store */
    bool autorun;
    bool button_down;
    uint8_t other_pen;    /* in the holder: its number less one */
    uint32_t button_at;   /* hal_now() when it last changed */
    motion_stats_t stats; /* of the last drawing */
    size_t picture_bytes; /* it was lent */
} console_t;

#define CONSOLE_WATCHDOG_MS 8000

/* Prints the banner, restores the machine's numbers, draws the saved scene with autorun. */
void console_begin(console_t *c, const console_config_t *config);
/* Takes one byte that was typed, or looks at the button and idles. */
void console_step(console_t *c);
/* console_begin, then console_step for ever. */
void console_run(console_t *c, const console_config_t *config);

#endif
