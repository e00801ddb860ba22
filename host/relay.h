/* relay.h - a drawing and its machine handed from `ridgeline` to the program that steps it, through a file.
 *
 * Both come from one build: the file holds numbers as they are in memory, and is refused when they do not fit. */
#ifndef RELAY_H
#define RELAY_H

#include <stdio.h>

#include "host/drawing.h"
#include "motion/machine.h"

/* d may be NULL: a machine and nothing to draw. Returns 0 or ERR_FILE. */
int relay_write(FILE *f, const machine_t *machine, const drawing_t *d);
/* Into an initialised drawing. Returns 0, ERR_FILE (not such a file), ERR_FULL (no memory). */
int relay_read(FILE *f, machine_t *machine, drawing_t *d);

#endif
