/* waiting.h - pieces of ink wait here for a pause of the kernel (hidden_pause_t).
 *
 * A kernel gives its pieces from the midst of a facet, where much of the stack is in use. Cutting, joining, ordering
 * and drawing them there would take as much again, since points are computed anew; so they wait until the facet is
 * done. 20 bytes a piece. */
#ifndef WAITING_H
#define WAITING_H

#include "hidden/ink.h"
#include "path/run.h"
#include <stdbool.h>

typedef struct waiting {
    run_t *run; /* cap, the caller's */
    int32_t cap, n;
    bool some; /* some wait */
    ink_sink_t next;
} waiting_t;

#define WAITING_BYTES(pieces) ((size_t)(pieces) * sizeof(run_t))

/* w must outlive the sink. A piece more than cap is ERR_FULL; one outside run.h's ranges ERR_VALUE. */
ink_sink_t waiting_sink(waiting_t *w);
/* Hands all of them on, in the order in which they came. Returns 0 or the error of w->next. */
int waiting_pause(waiting_t *w);

#endif
