/* script.c - the session's port, in stdio. */
#define _GNU_SOURCE /* ppoll */
#include "host/script.h"

#include <errno.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "error.h"
#include "host/huge_pages.h"
#include "host/progress.h"
#include "host/solid_file.h"

enum { FILES_MAX = 16 };

/* Address space for data, of which only the pages that are written to become memory. */
#define DATA_BYTES_MAX ((size_t)8 << 30)
#define DATA_BYTES_MIN ((size_t)1 << 20)

#define LARGE_FILE ((off_t)4 << 20)
#define BYTES_PER_CHARACTER 4 /* of data, at the most: a number has a digit and a blank */

/* A data block. */
typedef struct block {
    struct block *next;
    char name[40];
    char *text;
    size_t len, room;
} block_t;

static struct {
    session_t session;
    job_t *job;
    bool waits;
    char folder[PATH_MAX]; /* of the scene, with its slash, or empty */
    FILE *file[FILES_MAX];
    off_t size[FILES_MAX], done[FILES_MAX]; /* of files: bytes; 0 if nobody knows */
    bool binary[FILES_MAX];                 /* nothing in it ends a line */
    block_t *block;                         /* all of them */
    char *data;                             /* the session's memory for data */
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

static block_t *find_block(const char *name) {
    block_t *b = script.block;
    while (b && strcmp(b->name, name) != 0) b = b->next;
    return b;
}

static void forget_blocks(const char *name, bool begins) {
    for (block_t **at = &script.block; *at;) {
        block_t *b = *at;
        if (begins ? strncmp(b->name, name, strlen(name)) != 0 : strcmp(b->name, name) != 0) {
            at = &b->next;
            continue;
        }
        *at = b->next;
        free(b->text);
        free(b);
    }
}

static int port_keep(void *ctx, const char *name, const char *text, size_t n) {
    (void)ctx;
    if (!text && n > 0) {
        forget_blocks(name, n == 2);
        return 0;
    }
    block_t *b = find_block(name);
    if (!b) {
        b = calloc(1, sizeof *b);
        if (!b) return ERR_FULL;
        snprintf(b->name, sizeof b->name, "%s", name);
        b->next = script.block;
        script.block = b;
    }
    if (!text) b->len = 0;
    if (b->len + n >= b->room) {
        const size_t room = 2 * (b->len + n) + 256;
        char *more = realloc(b->text, room);
        if (!more) return ERR_FULL;
        b->text = more;
        b->room = room;
    }
    if (text) memcpy(b->text + b->len, text, n);
    b->len += text ? n : 0;
    return 0;
}

static FILE *open_file(const char *name) {
    const block_t *b = name[0] == '$' ? find_block(name) : NULL;
    if (!b) return fopen(name, "rb");
    if (b->len == 0) return fopen("/dev/null", "rb");
    FILE *copy = fmemopen(NULL, b->len + 1, "w+"); /* the block may change while it is read */
    if (!copy) return NULL;
    if (fwrite(b->text, 1, b->len, copy) == b->len) rewind(copy);
    return copy;
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

static int open_as(const char *name, bool binary) {
    int handle = 0;
    while (handle < FILES_MAX && script.file[handle]) handle++;
    if (handle == FILES_MAX) return ERR_FULL;
    FILE *f = open_file(name);
    if (!f && name[0] != '/' && script.folder[0]) {
        char path[PATH_MAX];
        int n = snprintf(path, sizeof path, "%s%s", script.folder, name);
        if (n > 0 && (size_t)n < sizeof path) f = fopen(path, "rb");
    }
    if (!f) return ERR_FILE;
    if (solid_file_is(name) && !binary) f = solid_file_open(f, name);
    if (!f) return ERR_DATA;
    setvbuf(f, NULL, _IOFBF, CONFIG_READ_CHUNK / 8); /* larger pieces are read where they are wanted */
    struct stat about;
    script.file[handle] = f;
    script.binary[handle] = binary;
    script.size[handle] = fileno(f) >= 0 && fstat(fileno(f), &about) == 0 && S_ISREG(about.st_mode) ? about.st_size : 0;
    script.done[handle] = 0;
    expect_data(script.size[handle]);
    progress_begin();
    return handle;
}

static int port_open(void *ctx, const char *name) {
    (void)ctx;
    return open_as(name, false);
}

static int port_open_binary(void *ctx, const char *name) {
    (void)ctx;
    return open_as(name, true);
}

static int port_read(void *ctx, int handle, char *buf, int size) {
    (void)ctx;
    FILE *f = script.file[handle];
    if (is_to_stop) return stopped();
    size_t n = fread(buf, 1, (size_t)size, f);
    script.done[handle] += (off_t)n;
    if (script.size[handle]) progress_update("reading", script.done[handle], script.size[handle]);
    for (char *cr = buf, *end = buf + (script.binary[handle] ? 0 : n);
         (cr = memchr(cr, '\r', (size_t)(end - cr))) != NULL; cr++) {
        const int next = cr + 1 < end ? cr[1] : fgetc(f);
        if (cr + 1 == end && next != EOF) ungetc(next, f);
        if (next != '\n') *cr = '\n'; /* lines may end with CR alone */
    }
    return n == 0 && ferror(f) ? ERR_FILE : (int)n;
}

static void port_close(void *ctx, int handle) {
    (void)ctx;
    progress_wipe();
    fclose(script.file[handle]);
    script.file[handle] = NULL;
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
        const struct timespec t = {.tv_sec = left / 1000000000, .tv_nsec = left % 1000000000};
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

static int port_plot(void *ctx, const plot_t *plot) {
    (void)ctx;
    const session_t *s = &script.session;
    if (is_to_stop) return stopped();
    script.job->data_bytes = (s->pool.low + s->pool_size - s->pool.high) * sizeof(packed_t);
    return job_draw(script.job, plot);
}

/* The largest area that the system lets us reserve; nothing when it is strict about memory. */
static void *reserve(size_t *bytes) {
    for (*bytes = sizeof(void *) < 8 ? DATA_BYTES_MAX >> 4 : DATA_BYTES_MAX; *bytes >= DATA_BYTES_MIN; *bytes /= 2) {
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

static void remember_folder(const char *name) {
    const char *slash = strrchr(name, '/');
    size_t n = slash ? (size_t)(slash - name) + 1 : 0;
    if (n >= sizeof script.folder) n = 0;
    memcpy(script.folder, name, n);
    script.folder[n] = 0;
}

int script_file(FILE *f, const char *name) {
    remember_folder(name);
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
