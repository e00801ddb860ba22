/* progress.h - one line on a terminal that says how far a long job is.
 *
 * Nothing appears unless stderr is a terminal and the job has taken a second; the line is wiped before anything
 * else is printed, and when the job ends. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

/* Seconds of a clock that only goes forward. */
double progress_now(void);

typedef struct progress {
    bool terminal, shown;
    double started, last;
} progress_t;

void progress_begin(progress_t *p);
/* what: a few words. Cheap enough to be called once a row: it asks the clock, and writes at most ten times a second. */
void progress_update(progress_t *p, const char *what, int64_t done, int64_t of);
void progress_wipe(progress_t *p);

#endif
