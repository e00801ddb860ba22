/* job.h - from a plot command to files: draws the picture into memory, then writes every output, then reports. Or it
 * writes the only output while it draws.
 *
 * The picture's working memory is lent from the heap: as much as picture_bytes asks for, and when that was too little,
 * twice that, until JOB_LENT_MAX. */
#ifndef JOB_H
#define JOB_H

#include <stdio.h>

#include "host/drawing.h"
#include "host/gpio.h"
#include "host/report.h"

#if SIZE_MAX > UINT32_MAX
#define JOB_LENT_MAX ((size_t)4 << 30)
#else
#define JOB_LENT_MAX ((size_t)1 << 30)
#endif
#define JOB_OUTPUTS_MAX 16

typedef struct job {
    /* The caller's, before the first page: */
    const char *name; /* of the scene, in the table */
    const char *output[JOB_OUTPUTS_MAX];
    int outputs;
    bool overwrite;    /* every page into the same files instead of a.svg, a-2.svg, ... */
    FILE *table;       /* rows go here, or NULL */
    FILE *stats;       /* JSON goes here, or NULL: report_json_begin has been called */
    FILE *announce;    /* says which files were written, or NULL */
    gpio_t gpio;       /* where pages are drawn with a pen, after their files are written */
    size_t data_bytes; /* held for data files while this page is drawn */
    /* Its own: */
    int pages;   /* drawn so far */
    int trouble; /* an error that is not the input's and has been said: a file that cannot be written, no memory */
    int status;  /* what the machine on gpio lines ended with, if not 0: the exit status */
    drawing_t drawing;
    void *lent;
    size_t lent_bytes;
} job_t;

/* Clears its own part; the caller fills in the rest. */
void job_init(job_t *job);
void job_free(job_t *job);
/* Draws one page. Returns 0 or a negative error; what concerns files and memory has been said on stderr, the rest is
 * for the caller to say. */
int job_draw(job_t *job, const plot_t *plot);
/* For a signal handler: the page that is being drawn is given up before anything of it is written, and job_draw returns
 * ERR_STOPPED. False if none is, or it has been asked for already. */
bool job_stop(void);

#endif
