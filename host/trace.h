/* trace.h - `ridgeline trace`: reads step traces (VCD), judges them, compares two, draws the ink of one. */
#ifndef TRACE_H
#define TRACE_H

#include "motion/machine.h"
#include "view/page.h"
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
    uint64_t unit_ps;  /* the file's timescale (1 when it is below a picosecond) */
    machine_t machine; /* from the file's $comment, otherwise the defaults */
    bool has_machine;
    bool has_pen, has_enable; /* the file has such a signal; otherwise it stays 0 */
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
    uint64_t min_pulse_ps, max_pulse_ps; /* 0 when there was none */
    uint64_t min_setup_ps;               /* from a change of DIR to the next pulse; 0 when there was none */
    uint64_t min_interval_ps;            /* between the beginnings of two pulses; 0 when there was none */
    double max_jump_mm_s;                /* speed change from one step to the next in the same direction */
    unsigned long misplaced;             /* places where steps are not where their neighbours say (trace_place.h) */
    double misplaced_at_s, misplaced_s;  /* the first of them: when, and by how long */
} trace_axis_judgement_t;

typedef struct trace_judgement {
    trace_axis_judgement_t axis[2];
    double duration_s;     /* first to last change of a pin */
    double down_s;         /* of that, with the pen down */
    double down_mm, up_mm; /* along the steps' smoothed path */
    unsigned long lifts;
    double max_speed_down, max_speed_up; /* mm/s over TRACE_WINDOW_S */
    double max_accel;                    /* mm/s^2, second difference of the position over TRACE_WINDOW_S */
    double max_accel_at_s;
    double accel_limit;
    double settle_lift_s, settle_lower_s; /* shortest time from the pen's change to the next step; 0: none */
    unsigned long unsettled;              /* steps while the pen was settling */
    unsigned long disabled;               /* steps with the motors off */
    unsigned long short_pulses, short_setups;
    unsigned long turned_high; /* changes of DIR during a pulse */
    unsigned long unchanged;   /* pairs of stops as long as those for the pen, in which it did not change */
    double unchanged_at_s;     /* the first */
    bool has_pen, has_enable;
    bool ends_home, ends_up, ends_disabled;
    bool speed_ok, accel_ok;
    bool legal; /* nothing of it is against the machine's numbers */
} trace_judgement_t;

#define TRACE_SPEED_FACTOR 1.02
#define TRACE_WINDOW_S 0.02
/* Times are compared with this much grace, for traces in units coarser than a tick. */
#define TRACE_GRACE_PS 100000

/* Is nothing of it against the machine's numbers? */
bool trace_is_legal(const trace_judgement_t *j);
/* Judges t by m (which need not be t->machine). Returns 0, ERR_FULL (no memory). */
int trace_judge(const trace_t *t, const machine_t *m, trace_judgement_t *out);
/* Prints a judgement for people: one line per finding, illegal ones begin with `! `. */
void trace_print(const trace_judgement_t *j, const machine_t *m, FILE *out);

typedef struct trace_difference {
    bool same_sequence;
    size_t compared;        /* pin changes found equal in sequence */
    double max_us, mean_us; /* time differences over them */
    size_t worst;           /* the change with the largest difference */
    size_t rests;           /* of another length in b than in a, if that is allowed */
    double rest_us;         /* by so much in all */
    /* The first change that differs, or else the worst: its number in both, and where in the events to look. */
    size_t at, event_a, event_b;
} trace_difference_t;

/* Compares the sequences of pin changes and their times (each trace's from its own first change). Changes that one
 * trace has in another order than the other are the same as long as they lie within tolerance_us of each other; those
 * of one pin never change their order. rests: when the pen has been lifted b may stand longer or shorter than a, where
 * one of them had still to compute; times count from there. Returns 0, ERR_FULL (no memory). */
int trace_compare(const trace_t *a, const trace_t *b, double tolerance_us, bool rests, trace_difference_t *out);
void trace_print_difference(const trace_t *a, const trace_t *b, const trace_difference_t *d, FILE *out);

/* The ink of a trace, as strokes in page coordinates: every point lies within TRACE_INK_STEPS steps of where the
 * steps put the pen, and points that a straight line explains are left out. Returns 0 or the sink's error. */
#define TRACE_INK_STEPS 1.0
int trace_ink(const trace_t *t, const machine_t *m, pen_sink_t sink);
/* Writes the ink to a file whose suffix says the format (host/writer.h); the paper is the box around it, and A4 at
 * least. Returns 0, ERR_FILE, ERR_VALUE (unknown suffix). */
int trace_draw(const trace_t *t, const machine_t *m, const char *name);

/* The command: argv[0] is "trace". Returns the exit status: 0 legal or equal, 1 illegal or different, 2 bad input. */
int trace_main(int argc, char **argv);

#endif
