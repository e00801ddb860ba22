/* progress.c - a carriage return and blanks. */
#include "host/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

double progress_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

void progress_begin(progress_t *p) {
    p->terminal = isatty(STDERR_FILENO) != 0;
    p->shown = false;
    p->started = p->last = progress_now();
}

void progress_update(progress_t *p, const char *what, int64_t done, int64_t of) {
    if (!p->terminal) return;
    double now = progress_now();
    if (now - p->started < 1 || now - p->last < 0.1) return;
    p->last = now;
    p->shown = true;
    int percent = of > 0 ? (int)(100 * (double)done / (double)of) : 0;
    fprintf(stderr, "\r%-28s %3d %%  %5.0f s", what, percent, now - p->started);
    fflush(stderr);
}

void progress_wipe(progress_t *p) {
    if (!p->shown) return;
    fprintf(stderr, "\r%44s\r", "");
    fflush(stderr);
    p->shown = false;
}
