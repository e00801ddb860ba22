/* progress.c - a carriage return and blanks. */
#include "host/progress.h"

#include <stdbool.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

static struct {
    bool terminal, shown;
    double started, last;
} line;

double progress_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

void progress_begin(void) {
    line.terminal = isatty(STDERR_FILENO) != 0;
    line.shown = false;
    line.started = line.last = progress_now();
}

void progress_update(const char *what, int64_t done, int64_t of) {
    if (!line.terminal) return;
    double now = progress_now();
    if (now - line.started < 1 || now - line.last < 0.1) return;
    line.last = now;
    line.shown = true;
    int percent = of > 0 ? (int)(100 * (double)done / (double)of) : 0;
    fprintf(stderr, "\r%-28s %3d %%  %5.0f s", what, percent, now - line.started);
    fflush(stderr);
}

void progress_wipe(void) {
    if (!line.shown) return;
    fprintf(stderr, "\r%44s\r", "");
    fflush(stderr);
    line.shown = false;
}
