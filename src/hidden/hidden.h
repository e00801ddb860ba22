/* hidden.h - what the hidden-line kernels share: lent memory, a sink for the ink, and an account of the work.
 *
 * perimeter.h draws grid surfaces, horizon.h draws profiles. Both decide in pencil coordinates (view/chart.h)
 * against an upper and a lower horizon (hidden/surface/envelope.h) and emit pieces of lines of the scene
 * (hidden/ink.h). */
#ifndef HIDDEN_H
#define HIDDEN_H

#include "config.h"
#include "hidden/ink.h"
#include <stdbool.h>
#include <stddef.h>

/* A kernel pauses between facets (segments of a profile), where little of the stack is in use, if the sink wants it to:
 * what has come is then drawn. Only with CONFIG_WAITING. */
typedef struct hidden_pause {
    const bool *wanted;
    int (*pause)(void *ctx); /* an error ends the kernel */
    void *ctx;
} hidden_pause_t;

static inline int hidden_pause(const hidden_pause_t *p) {
    return CONFIG_WAITING > 0 && p != NULL && *p->wanted ? p->pause(p->ctx) : 0;
}

/* One surface without holes may be hidden in strips of the abscissa, one after the other (strip.h): the same ink in
 * another order, ended where it passes from one into the next. The horizons then take a part of their memory, and what
 * lies across a border is done in both. Strips are told in HIDDEN_STRIPS-ths of the whole. */
#define HIDDEN_STRIPS 16
typedef struct hidden_strips {
    uint16_t ends; /* bit k: one ends at k + 1; the last bit is always set */
    bool divide;   /* one that is ERR_FULL is halved and tried again; what it has drawn comes again, too */
} hidden_strips_t;
#define HIDDEN_TWO_STRIPS ((uint16_t)(1u << (HIDDEN_STRIPS - 1) | 1u << (HIDDEN_STRIPS / 2 - 1)))

/* The job's surroundings. All of it must stay valid until the kernel returns; nothing is kept afterwards. */
typedef struct hidden_job {
    void *mem;              /* working memory, aligned to 8 bytes; contents need not be cleared */
    size_t bytes;           /* its size: rows first, the rest holds the horizons */
    const ink_sink_t *sink; /* takes the visible pieces; an error it returns ends the kernel */
    void (*tick)(void *ctx, int32_t done, int32_t of); /* once a row (profile), for progress; may be NULL */
    void *tick_ctx;
    hidden_strips_t *strips;     /* perimeter; NULL: as a whole */
    const hidden_pause_t *pause; /* perimeter, horizon; may be NULL */
} hidden_job_t;

/* A part of the job's memory, from its front: what a kernel would have on the stack, where that is small
 * (CONFIG_WAITING). NULL if there is not so much. */
static inline void *hidden_lend(hidden_job_t *job, size_t bytes) {
    void *at = job->mem;
    bytes = (bytes + 7) / 8 * 8;
    if (at == NULL || job->bytes < bytes) return NULL;
    job->mem = (uint8_t *)at + bytes;
    job->bytes -= bytes;
    return at;
}

/* `type *name`: lent by `rest`, a copy of the job, where the stack is small, and may be NULL; else on the stack. */
#if CONFIG_WAITING > 0
#define HIDDEN_STATE(type, name, rest) type *name = hidden_lend(&(rest), sizeof *name)
#else
#define HIDDEN_STATE(type, name, rest) type name##_own, *name = &name##_own
#endif
#define HIDDEN_LENT(type) (CONFIG_WAITING > 0 ? (sizeof(type) + 7) / 8 * 8 : 0)

/* What a drawing took. Filled in also when the kernel ends with an error. */
typedef struct hidden_stats {
    int64_t facets;                 /* facets (horizon: profile segments) that took part: those at holes do not */
    int64_t edges;                  /* edges clipped, each once */
    int64_t tests;                  /* orientation tests, two 32x32->64 products each */
    int64_t crossings;              /* crossings found: the only places that divide */
    int64_t pieces;                 /* pieces given to the sink */
    int64_t evaluated;              /* points evaluated while drawing */
    int32_t peak_upper, peak_lower; /* most vertices each horizon had */
    int32_t strips;                 /* one after the other, 1 if there were none */
    int32_t windows;                /* most windows between them (windows.h) */
    size_t bytes;                   /* lent memory that was used, at its peak */
    size_t needs; /* after ERR_FULL: about what would have been enough, going on as it went until then; 0: not known */
} hidden_stats_t;

#endif
