/* vcd.h - writes what the recorder sees as a Value Change Dump (IEEE 1364-2001 section 18), fast: 64 KiB blocks,
 * numbers formatted by hand. Signals x_step x_dir y_step y_dir pen enable in module plotter.
 *
 * Times are in ns: a tick is 62.5 ns, so odd ticks are cut to the ns below; round(ns / 62.5) gives the tick
 * back exactly. docs/TRACE.md describes the format. */
#ifndef VCD_H
#define VCD_H

#include "motion/machine.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define VCD_BUFFER 65536

/* Takes finished text. Returns 0 or a negative error, after which nothing more is written. */
typedef int (*vcd_write_t)(void *ctx, const char *text, size_t bytes);

typedef struct vcd {
    vcd_write_t write;
    void *ctx;
    int error;
    uint64_t last_tick;
    uint64_t high_ns; /* the time without its last eight digits, and the others as text */
    unsigned high_length;
    char high_text[16];
    size_t used;
    char buffer[VCD_BUFFER + 128];
} vcd_t;

/* Writes the header. machine goes into a $comment, so that `ridgeline trace` knows what to judge by; may be NULL.
 * title: one line, may be NULL. pins: state at tick 0. */
void vcd_begin(vcd_t *v, vcd_write_t write, void *ctx, const machine_t *machine, const char *title, uint32_t pins);
/* A sim_recorder_t; ctx is the vcd_t. Ticks must not decrease. */
void vcd_record(void *vcd, uint64_t tick, uint32_t pins, uint32_t changed);
/* Writes what is left and the final time. Returns 0 or the first error of write. */
int vcd_end(vcd_t *v, uint64_t tick);
/* A vcd_write_t for stdio: ctx is a FILE *. Returns ERR_FILE when fwrite fails. */
int vcd_write_file(void *file, const char *text, size_t bytes);

#endif
