/* script.h - a session of the command language on the desktop: where its lines come from, its files, its messages.
 *
 * print goes to stdout, warnings and errors to stderr. A data file or script is looked for where its name says, and
 * then beside the scene that names it. `pause` waits only when `waits` is set. There is one script per program. */
#ifndef SCRIPT_H
#define SCRIPT_H

#include <stdbool.h>
#include <stdio.h>

#include "host/job.h"
#include "lang/session.h"

/* Exit statuses. */
enum { SCRIPT_DONE = 0, SCRIPT_TROUBLE = 1, SCRIPT_BAD_INPUT = 2 };

/* Starts the session; job draws what it plots and must outlive it. */
void script_begin(job_t *job, bool waits);
/* Names the source of the lines that follow, for messages; NULL for a terminal. */
void script_source(const char *name);
/* One line without its end. 0 or the session's error, which has been reported. */
int script_line(const char *text);
/* Forgets a line to be continued, and inline data. */
void script_cancel(void);
/* For a signal handler: the drawing, pause or reading of data that is under way ends, as does the line that asked for
 * it. False if no line is being executed, or it has been asked for already. */
bool script_stop(void);
enum session_state script_state(void);
/* What `set` has set so far. */
const settings_t *script_settings(void);
/* All lines of f, called `name`. Stops at the first error or at `quit`. 0 or the error. */
int script_file(FILE *f, const char *name);
/* The exit status that an error of the above means: the input's fault unless the job ran into trouble. */
int script_status(int err);

#endif
