/* pool.h - the memory shared by the stages that see many runs at once.
 *
 * An end is 2 * run + side (side 0: from, 1: to). `mate` links ends: an end >= 0 is the end it continues into
 * without lifting the pen; a free end holds ~(the free end at the other end of its stroke). The stages run
 * one after another, so their work arrays share one piece of memory. */
#ifndef POOL_H
#define POOL_H

#include "path/run.h"
#include "view/page.h"

#define POOL_RUNS_MIN 4
#define POOL_WORK_PER_RUN 32
#define POOL_BYTES_PER_RUN (20 + 8 + POOL_WORK_PER_RUN)
#define POOL_BYTES(runs) ((size_t)(runs)*POOL_BYTES_PER_RUN)

typedef struct pool {
    int32_t n, cap;
    run_t *run;    /* cap */
    int32_t *mate; /* 2 * cap */
    void *work;    /* POOL_WORK_PER_RUN * cap bytes */
} pool_t;

#endif
