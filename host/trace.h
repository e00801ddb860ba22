/* trace.h - `ridgeline trace`: reads step traces (VCD), judges them, compares two, draws the ink of one. */
#ifndef TRACE_H
#define TRACE_H

#include "motion/machine.h"
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* One pin change. */
typedef struct trace_event {
    uint64_t time_ps;
    uint8_t pins;    /* all pins after it (enum hal_pin bits) */
    uint8_t changed; /* which of them changed: more than one when they changed at the same time */
} trace_event_t;

typedef struct trace {
    trace_event_t *events; /* malloc'ed; trace_free */
    size_t count;
    uint8_t initial;   /* pins before the first event */
    uint64_t end_ps;   /* last time in the file */
    uint64_t unit_ps;  /* the file's timescale (fs are rounded up to 1 ps) */
    machine_t machine; /* from the file's $comment, otherwise the defaults */
    bool has_machine;
} trace_t;

typedef struct trace_error {
    unsigned long line; /* 1-based; 0 when the file could not be read at all */
    char text[120];
} trace_error_t;

/* Reads a VCD file: any tool's, as long as it has signals named x_step x_dir y_step y_dir pen enable (in any scope, of
 * width 1; other signals are skipped; x and z count as 0). pen and enable may be missing.
 * Returns 0, ERR_FILE, ERR_DATA (error filled), ERR_FULL (no memory). The trace is empty on error. */
int trace_read(FILE *file, trace_t *out, trace_error_t *error);
/* The same from memory. */
int trace_read_text(const char *text, size_t bytes, trace_t *out, trace_error_t *error);
void trace_free(trace_t *t);

typedef struct trace_axis_judgement {
    uint64_t steps;
    int64_t end_steps, min_steps, max_steps;
    uint64_t min_pulse_ps, max_pulse_ps, min_setup_ps, min_interval_ps; /* UINT64_MAX when there was none */
} trace_axis_judgement_t;

typedef struct trace_judgement {
    trace_axis_judgement_t axis[2];
    double duration_s, down_s; /* whole; pen down */
    double down_mm, up_mm;
    unsigned long lifts;
    double max_speed_down, max_speed_up; /* mm/s along the path */
    double max_accel;                    /* mm/s^2, see docs/TRACE.md for how it is estimated */
    double max_jump;                     /* mm/s between successive steps of one axis in one direction */
    double shortest_settle_lift_s, shortest_settle_lower_s;
    unsigned long moved_unsettled; /* steps while the pen was settling */
    unsigned long moved_disabled;  /* steps with the motors off */
    unsigned long short_pulses, short_setups, short_intervals;
    bool ends_home, ends_pen_up, ends_disabled;
    bool legal; /* all of the above within the machine's numbers */
} trace_judgement_t;

/* Judges t by m (which need not be t->machine). */
void trace_judge(const trace_t *t, const machine_t *m, trace_judgement_t *out);
/* Prints a judgement for people: one line per finding, illegal ones begin with `! `. */
void trace_print(const trace_judgement_t *j, const machine_t *m, FILE *out);

typedef struct trace_difference {
    bool same_sequence;
    size_t compared;        /* events found equal in sequence */
    double max_us, mean_us; /* time differences over them */
    size_t first;           /* index of the first event that differs (sequence) or of the largest difference */
} trace_difference_t;

/* Compares the sequences of pin changes and their times (each from its first change of a pin). Two pins that change at
 * one time in a and one after the other in b are the same when no more than tolerance_us lies between. */
void trace_compare(const trace_t *a, const trace_t *b, double tolerance_us, trace_difference_t *out);

/* Draws the ink (pen down) as SVG, or PNG when the name ends in .png. Returns 0, ERR_FILE. */
int trace_draw(const trace_t *t, const machine_t *m, const char *name);

/* The command: argv[0] is "trace". Returns the exit status: 0 legal or equal, 1 illegal or different, 2 bad input. */
int trace_main(int argc, char **argv);

#endif
