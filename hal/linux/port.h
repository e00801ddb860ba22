/* port.h - the Linux port's outer side: takes the lines, says what went wrong, what it counted. hal.h's functions for
 * the step generator (pins, clock, timer, waiting, inputs, fault) are in port.c; console, store and watchdog of hal.h
 * belong to boards and are not here.
 *
 * There is no interrupt: hal_idle() sleeps until shortly before the armed deadline, spins the rest, and calls
 * stepgen_isr(). So everything runs in one thread and the planner works between two deadlines.
 *
 * Time base. hal_now() is CLOCK_MONOTONIC less what was lost: a deadline that is served late by more than
 * PORT_SLACK_NS moves the base by as much, and everything still to come with it. So two edges are never closer together
 * than planned (by more than the slack and a usual write), whatever stopped the process in between: a stall makes the
 * drawing take longer and nothing else.
 *
 * Real-time throttling. A SCHED_FIFO process that never sleeps is stopped by the kernel 50 ms in every second. At step
 * rates that leave no gap for a real sleep the port takes PORT_REST_PERCENT of the time in short ones by itself. */
#ifndef PORT_H
#define PORT_H

#include "hal/hal.h"
#include "hal/linux/pins.h"

#define PORT_SLACK_NS 500     /* late by less than this moves an edge, not the plan: a quarter of a default pulse */
#define PORT_WRITE_NS 3000    /* a write that takes longer moves the plan too: nobody knows when the pins changed */
#define PORT_LATE_NS 10000    /* late by more is counted and reported */
#define PORT_TAIL_NS 60000    /* spun before a deadline: longer than a wake-up usually takes */
#define PORT_SLICE_NS 1000000 /* longest sleep without a look at the switches */
#define PORT_REST_PERCENT 7   /* the kernel wants 5 */
#define PORT_REST_NS 20000

/* Written by the stepping process, in memory that its guardian sees too. */
typedef struct port_counts {
    int32_t steps[2];       /* pulses that were written, with the sign of DIR */
    uint64_t writes;        /* that changed a pin */
    uint64_t served;        /* deadlines */
    uint64_t late;          /* of these, by more than PORT_LATE_NS */
    uint64_t rests;         /* sleeps taken for the sake of throttling, in which a deadline may have passed */
    int64_t worst_ns;       /* the latest of all */
    int64_t shifted_ns;     /* how far the time base moved in all */
    int64_t worst_write_ns; /* longest from a deadline to the end of its write */
    uint32_t pins;          /* pin word as last written */
} port_counts_t;

enum port_trouble { PORT_FINE, PORT_SWITCH, PORT_WRITE, PORT_READ };

/* Takes the lines of a checked pin file: outputs first, at their safe levels in the order of enum pins_name, then
 * inputs. Returns 0, or -errno after a message to `complaints`. */
int port_open(const pins_t *pins, FILE *complaints);
void port_close(void);
/* Pen up and steps low, then motors off. Of the process that steps or of its guardian, at any time. 0 or -errno of the
 * last write: then nobody knows the levels. */
int port_safe(void);
/* The clock starts, real-time scheduling and locked memory are asked for; warns in plain words where they are refused.
 */
void port_start(FILE *warnings);

/* What has happened since port_open. After anything but PORT_FINE no deadline is served any more. */
enum port_trouble port_trouble(void);
/* The errno of PORT_WRITE or PORT_READ. */
int port_error(void);
/* The inputs (enum hal_input) that became active since the last call; those of `expected` (port_expect) stop stepping
 * without being trouble. */
uint32_t port_hits(void);
void port_expect(uint32_t expected);
const port_counts_t *port_counts(void);

#endif
