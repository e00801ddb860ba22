/* script.c - the session's port, in stdio. */
#define _GNU_SOURCE /* ppoll */
#include "host/script.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#include "error.h"
#include "host/huge_pages.h"
#include "host/progress.h"
#include "host/scene_files.h"

/* Address space for data, of which only the pages that are written to become memory. */
#if SIZE_MAX > UINT32_MAX
#define DATA_BYTES_MAX ((size_t)8 << 30)
#else
#define DATA_BYTES_MAX ((size_t)512 << 20)
#endif
#define DATA_BYTES_MIN ((size_t)1 << 20)
_Static_assert(DATA_BYTES_MAX >= DATA_BYTES_MIN, "for a size_t of 32 bits, too");

#define LARGE_FILE ((off_t)4 << 20)
#define BYTES_PER_CHARACTER 4 /* of data, at the most: a number has a digit and a blank */

static struct {
    session_t session;
    job_t *job;
    bool waits;
    char *data; /* the session's memory for data */
    size_t data_bytes;
} script;

static void port_print(void *ctx, const char *text) {
    (void)ctx;
    fputs(text, stdout);
    fflush(stdout);
}

static void port_warn(void *ctx, const char *text) {
    (void)ctx;
    if (script.job->trouble) return; /* the job has said it already, and better */
    progress_wipe();
    fputs(text, stderr);
}

static volatile sig_atomic_t is_running, is_to_stop;

bool script_stop(void) {
    if (job_stop()) return true;
    if (!is_running || is_to_stop) return false;
    is_to_stop = 1;
    return true;
}

/* The user knows what was stopped: nothing more is said. */
static int stopped(void) {
    progress_wipe();
    fputc('\n', stderr);
    return script.job->trouble = ERR_STOPPED;
}

/* What is read from a large file takes huge pages: to touch it by small ones takes a fortieth of a plot's time. */
static void expect_data(off_t file_bytes) {
    const session_t *s = &script.session;
    const size_t from = (s->pool.low * sizeof(packed_t) + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE;
    if (file_bytes < LARGE_FILE || from >= script.data_bytes) return;
    const size_t left = script.data_bytes - from;
    const size_t most =
        (uintmax_t)file_bytes < left / BYTES_PER_CHARACTER ? (size_t)file_bytes * BYTES_PER_CHARACTER : left;
    huge_pages_ask(script.data + from, most);
}

static int open_file(const char *name, bool binary) {
    const int handle = scene_files_open(name, binary);
    if (handle >= 0) expect_data(scene_files_size(handle));
    return handle;
}

static int port_open(void *ctx, const char *name) {
    (void)ctx;
    return open_file(name, false);
}

static int port_open_binary(void *ctx, const char *name) {
    (void)ctx;
    return open_file(name, true);
}

static int port_read(void *ctx, int handle, char *buf, int size) {
    (void)ctx;
    return is_to_stop ? stopped() : scene_files_read(handle, buf, size);
}

static void port_close(void *ctx, int handle) {
    (void)ctx;
    scene_files_close(handle);
}

static int port_keep(void *ctx, const char *name, const char *text, size_t n) {
    (void)ctx;
    return scene_files_keep(name, text, n);
}

static int64_t now_ns(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * INT64_C(1000000000) + t.tv_nsec;
}

/* Until so many ms have passed or, with less than 0, there is something to read; or until Ctrl-C, which comes through
 * only while it waits: else it could come between the look at is_to_stop and the waiting, and be lost. */
static void wait_for_input(int32_t ms) {
    struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
    const int64_t end = now_ns() + ms * INT64_C(1000000);
    sigset_t interrupt, usual;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    sigprocmask(SIG_BLOCK, &interrupt, &usual);
    for (int ready = -1; ready < 0 && !is_to_stop;) {
        const int64_t left = ms < 0 ? 0 : end - now_ns();
        if (left < 0) break;
        const struct timespec t = {.tv_sec = (time_t)(left / 1000000000), .tv_nsec = (long)(left % 1000000000)};
        ready = ppoll(&in, ms < 0, ms < 0 ? NULL : &t, &usual);
        if (ready < 0 && errno != EINTR) break;
    }
    sigprocmask(SIG_SETMASK, &usual, NULL);
}

static int port_pause(void *ctx, const char *prompt, int32_t ms) {
    (void)ctx;
    if (!script.waits) return 0;
    if (prompt[0]) {
        fprintf(stderr, "%s", prompt);
        if (ms >= 0) fputc('\n', stderr);
        fflush(stderr);
    }
    wait_for_input(ms);
    if (is_to_stop) return stopped();
    if (ms >= 0) return 0;
    int c;
    while ((c = getchar()) != EOF && c != '\n') continue;
    return 0;
}

static int port_turn(void *ctx) {
    (void)ctx;
    return is_to_stop ? stopped() : 0;
}

static int port_plot(void *ctx, const plot_t *plot) {
    (void)ctx;
    const session_t *s = &script.session;
    if (is_to_stop) return stopped();
    script.job->data_bytes = (s->pool.low + s->pool_size - s->pool.high) * sizeof(packed_t);
    return job_draw(script.job, plot);
}

/* The largest area that the system lets us reserve; nothing when it is strict about memory. */
static void *reserve(size_t *bytes) {
    for (*bytes = DATA_BYTES_MAX; *bytes >= DATA_BYTES_MIN; *bytes /= 2) {
        void *p = mmap(NULL, *bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (p != MAP_FAILED) return p;
    }
    *bytes = 0;
    return NULL;
}

void script_begin(job_t *job, bool waits) {
    static const session_port_t PORT = {
        .print = port_print,
        .warn = port_warn,
        .open = port_open,
        .open_binary = port_open_binary,
        .read = port_read,
        .close = port_close,
        .keep = port_keep,
        .pause = port_pause,
        .turn = port_turn,
        .plot = port_plot,
    };
    script.job = job;
    script.waits = waits;
    script.data = reserve(&script.data_bytes);
    session_start(&script.session, &PORT, script.data, script.data_bytes);
}

void script_source(const char *name) {
    session_source(&script.session, name);
}
int script_line(const char *text) {
    script.job->trouble = 0;
    is_to_stop = 0;
    is_running = 1;
    const int err = session_line(&script.session, text);
    is_running = 0;
    return err;
}
void script_cancel(void) {
    session_cancel(&script.session);
}
const settings_t *script_settings(void) {
    return session_settings(&script.session);
}
enum session_state script_state(void) {
    return session_state(&script.session);
}

int script_file(FILE *f, const char *name) {
    scene_files_are_beside(name);
    script_source(name);
    char *line = NULL;
    size_t room = 0;
    ssize_t n;
    int err = 0;
    while (!err && script_state() != SESSION_QUIT && (n = getline(&line, &room, f)) >= 0) {
        while (n > 0 && (line[n - 1] == '\n' || line[n - 1] == '\r')) line[--n] = 0;
        err = script_line(line);
    }
    free(line);
    if (!err && ferror(f)) { /* a folder, for example */
        fprintf(stderr, "ridgeline: %s: %s\n", name, strerror(errno));
        return ERR_FILE;
    }
    if (!err && script_state() != SESSION_QUIT) err = session_end(&script.session);
    return err;
}

int script_status(int err) {
    if (!err) return SCRIPT_DONE;
    if (script.job->status) return script.job->status;
    if (script.job->trouble) return SCRIPT_TROUBLE;
    return err == ERR_MACHINE || err == ERR_STOPPED ? SCRIPT_TROUBLE : SCRIPT_BAD_INPUT;
}
