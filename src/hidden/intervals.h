/* intervals.h - parts of numbered lines, collected in any order and united: what is given twice counts once.
 *
 * Parameters are q30 along the line, 0 to INK_ONE. Lent memory, 12 bytes a part; when it is full, parts that overlap
 * are united to make room. */
#ifndef INTERVALS_H
#define INTERVALS_H

#include "hidden/ink.h"
#include <stddef.h>

typedef struct interval {
    int32_t line, from_q30, to_q30; /* from < to; INK_ONE fits */
} interval_t;

typedef struct intervals {
    interval_t *part;
    int32_t n, n_max;
    int32_t most; /* at once, once they are finished */
} intervals_t;

/* mem aligned to 4. */
void intervals_init(intervals_t *s, void *mem, size_t bytes);
/* Returns 0 or ERR_FULL. Nothing happens if from >= to. */
int intervals_add(intervals_t *s, int32_t line, int32_t from_q30, int32_t to_q30);

/* Takes out all parts of a line. */
void intervals_drop(intervals_t *s, int32_t line);

/* What intervals_finish does with a line. */
typedef struct interval_use {
    void *ctx;
    int32_t (*least)(void *ctx, int32_t line); /* gaps up to this are closed, parts no longer than it left out */
    int (*part)(void *ctx, const interval_t *part);
} interval_use_t;

/* Gives all parts to use, line by line, in order. Returns 0 or its error. */
int intervals_finish(intervals_t *s, const interval_use_t *use);

/* The same for what of a is in no part of b. */
int intervals_less(intervals_t *a, intervals_t *b, const interval_use_t *use);

#endif
