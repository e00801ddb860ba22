/* progress.h - one line on the terminal that says how far a long job is.
 *
 * Nothing appears unless stderr is a terminal and the job has taken a second; the line is wiped before anything
 * else is printed, and when the job ends. There is one terminal, so there is one progress line. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdint.h>

/* Seconds of a clock that only goes forward. */
double progress_now(void);

void progress_begin(void);
/* what: a few words. Cheap enough to be called once a row or stroke: it asks the clock, and writes at most ten times a
 * second. */
void progress_update(const char *what, int64_t done, int64_t of);
void progress_wipe(void);

#endif
