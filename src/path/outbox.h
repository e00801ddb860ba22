/* outbox.h - runs of strokes that are settled, in the order in which the pen will go along them.
 *
 * Strokes leave the pool for this ring, so that ordering can go on with the pool while they are drawn: as many vertices
 * at a time as the machine takes without waiting, between the rows of the surface that are still being computed. When a
 * vertex is drawn depends on time; which, and after which, does not. */
#ifndef OUTBOX_H
#define OUTBOX_H

#include "path/pool.h"
#include "path/simplify.h"

typedef struct outbox_run {
    run_t run;  /* with OUTBOX_ flags in to_hi */
    int32_t us; /* the pen has so much to do with it */
} outbox_run_t;

#define OUTBOX_BYTES(runs) ((size_t)(runs) * sizeof(outbox_run_t))

typedef struct outbox {
    outbox_run_t *run; /* cap of them, a ring */
    int32_t cap, first, n;
    bool filled;     /* as many have been added */
    int64_t us;      /* of the cap added last: the pen never has more to do */
    int64_t t, last; /* in the first run: the vertex drawn last, and where it ends */
    bool started;    /* it has been */
    bool begun;      /* and the stroke has a point */
} outbox_t;

/* Flags in run_t.to_hi. */
#define OUTBOX_BACK (1u << 31) /* from `to` to `from` */
#define OUTBOX_ENDS (1u << 30) /* the stroke ends here */

void outbox_init(outbox_t *o, outbox_run_t *run, int32_t cap);
/* Adds a run that is entered at `side`; there must be room. */
void outbox_put(outbox_t *o, const run_t *run, int side, bool ends, int32_t us);
static inline bool outbox_full(const outbox_t *o) {
    return o->n == o->cap;
}
/* Hands the next vertex to out, of one at least; *vertices grows by one. *over: the stroke ends here. Returns 0
 * or the error of the sink. */
int outbox_draw(outbox_t *o, const ink_map_t *map, simplify_t *out, int64_t *vertices, bool *over);

#endif
