/* gpio.c - see gpio.h. */
#include "host/gpio.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host/job.h"
#include "host/relay.h"
#include "host/script.h"

extern char **environ;

enum { ARGS_MAX = 12, SETS_MAX = 16 };

static bool find_program(char *path, size_t size) {
    const char *given = getenv("RIDGELINE_GPIO");
    if (given) {
        snprintf(path, size, "%s", given);
    } else {
        ssize_t n = readlink("/proc/self/exe", path, size - 1);
        if (n < 0) return false;
        path[n] = 0;
        char *slash = strrchr(path, '/');
        size_t room = size - (size_t)(slash + 1 - path);
        if ((size_t)snprintf(slash + 1, room, "ridgeline-gpio") >= room) return false;
    }
    if (access(path, X_OK) == 0) return true;
    fprintf(stderr, "ridgeline: %s is not there: build it with libgpiod's development files (`make gpio`)\n", path);
    return false;
}

/* Until the child has ended, passing on what asks for it. */
static int wait_for(pid_t child, const sigset_t *watched) {
    int status;
    for (;;) {
        int signal = sigwaitinfo(watched, NULL);
        if (signal > 0 && signal != SIGCHLD) kill(child, signal);
        if (waitpid(child, &status, WNOHANG) == child) break;
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/* In a process group of its own: Ctrl-C then reaches it once, through us. */
static int run_program(const char *path, char **args, FILE *input) {
    sigset_t watched, before;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_t files;
    pid_t child;
    sigemptyset(&watched);
    sigaddset(&watched, SIGINT);
    sigaddset(&watched, SIGTERM);
    sigaddset(&watched, SIGHUP);
    sigaddset(&watched, SIGCHLD);
    sigprocmask(SIG_BLOCK, &watched, &before);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigmask(&attributes, &before);
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, fileno(input), STDIN_FILENO);
    fflush(NULL);
    int err = posix_spawn(&child, path, &files, &attributes, args, environ), status = SCRIPT_TROUBLE;
    if (err)
        fprintf(stderr, "ridgeline: %s: %s\n", path, strerror(err));
    else
        status = wait_for(child, &watched);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    sigprocmask(SIG_SETMASK, &before, NULL);
    return status;
}

/* What was asked of the machine and these lines cannot do, or NULL. Switching off is always possible. */
static const char *unfit(const char *what, const machine_t *m) {
    if (strcmp(what, "off") == 0) return NULL;
    if (m->wiring.pen == HAL_PEN_SERVO)
        return "pen servo: this board's lines make no servo pulses; set machine pen level";
    if (m->wiring.pen == HAL_PEN_SOLENOID)
        return "pen solenoid: this board's lines hold it with all of the power; set machine pen level";
    if (m->wiring.invert_pins || m->wiring.invert_inputs)
        return "invert: levels are turned round by active_low and active_high in the pin file";
    if (m->home_far && strcmp(what, "home") == 0) return "home right, top: here the switches are at the low end";
    return NULL;
}

/* what: the word for ridgeline-gpio; extra: more of its arguments, ending with NULL. */
static int run(const gpio_t *gpio, const char *what, const char *const *extra, const machine_t *machine,
               const drawing_t *d) {
    char path[PATH_MAX];
    const char *args[ARGS_MAX] = {"ridgeline-gpio", what, "--pins", gpio->pins};
    int n = 4;
    if (gpio->dry_run) args[n++] = "--dry-run";
    while (extra && *extra && n < ARGS_MAX - 1) args[n++] = *extra++;
    const char *wrong = unfit(what, machine);
    if (wrong) {
        fprintf(stderr, "ridgeline: set machine %s; nothing was moved\n", wrong);
        return SCRIPT_BAD_INPUT;
    }
    if (!find_program(path, sizeof path)) return SCRIPT_TROUBLE;
    FILE *relay = tmpfile();
    if (!relay || relay_write(relay, machine, d) != 0 || fseek(relay, 0, SEEK_SET) != 0) {
        fprintf(stderr, "ridgeline: handing over the drawing: %s\n", strerror(errno));
        if (relay) fclose(relay);
        return SCRIPT_TROUBLE;
    }
    int status = run_program(path, (char **)(uintptr_t)args, relay);
    fclose(relay);
    return status;
}

/* The terminal is asked, whatever standard input is. */
static bool ask_for(const char *what, int number, const char *todo) {
    FILE *tty = fopen("/dev/tty", "r+");
    if (!tty) {
        fprintf(stderr, "ridgeline: %s %d: %s; there is no terminal to ask for it\n", what, number, todo);
        return false;
    }
    fprintf(tty, "%s %d: %s and press Return. ", what, number, todo);
    fflush(tty);
    int c;
    while ((c = fgetc(tty)) != EOF && c != '\n') continue;
    fclose(tty);
    return c == '\n';
}

/* The strokes that one pen draws, from `first` on; they stay d's. */
static drawing_t part_of(const drawing_t *d, size_t first) {
    drawing_t part = *d;
    size_t end = first;
    while (end < d->strokes && drawing_pen(d, end) == drawing_pen(d, first)) end++;
    part.first += first;
    part.strokes = end - first;
    if (end < d->strokes) part.points = d->first[end];
    part.changes = 0;
    return part;
}

int gpio_plot(const gpio_t *gpio, int page, const machine_t *machine, const drawing_t *d) {
    if (page > 1 && !gpio->dry_run && !ask_for("Page", page, "change the paper")) return SCRIPT_TROUBLE;
    static int in_holder = 1; /* across pages */
    size_t at = 0;
    do {
        const drawing_t part = part_of(d, at);
        int pen = drawing_pen(d, at);
        if (d->strokes && pen != in_holder) {
            if (!gpio->dry_run && !ask_for("Pen", pen, "put it in")) return SCRIPT_TROUBLE;
            in_holder = pen;
        }
        int status = run(gpio, "plot", NULL, machine, &part);
        if (status) return status;
        at += part.strokes;
    } while (at < d->strokes);
    return 0;
}

/* ---- the commands that set a machine up ---- */

bool gpio_is_command(const char *word) {
    return strcmp(word, "jog") == 0 || strcmp(word, "home") == 0 || strcmp(word, "pen") == 0 ||
           strcmp(word, "off") == 0;
}

static int usage(void) {
    fputs("Usage: ridgeline jog X Y --pins FILE    moves the lifted pen by so many mm\n"
          "       ridgeline home --pins FILE       looks for the limit switches and stops just off them\n"
          "       ridgeline pen up --pins FILE     lifts the pen, motors off\n"
          "       ridgeline pen down --pins FILE   lowers it until Ctrl-C, or for --for SECONDS\n"
          "       ridgeline off --pins FILE        the same as pen up\n"
          "All take --set 'COMMAND' (set machine ...) and --dry-run.\n",
          stderr);
    return SCRIPT_BAD_INPUT;
}

/* Millimetres as micrometres, or false. */
static bool read_mm(const char *text, long *um) {
    char *end;
    double mm = strtod(text, &end);
    if (end == text || *end || !(fabs(mm) <= 4000)) return false;
    *um = lround(mm * 1000);
    return true;
}

typedef struct line {
    gpio_t gpio;
    const char *set[SETS_MAX], *word[3], *hold;
    int sets, words;
} line_t;

/* By hand rather than by getopt: -5 is a distance. */
static bool parse(line_t *l, int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
        if (strcmp(a, "--dry-run") == 0) {
            l->gpio.dry_run = true;
        } else if (strncmp(a, "--", 2) == 0) {
            if (!value) return false;
            i++;
            if (strcmp(a, "--pins") == 0)
                l->gpio.pins = value;
            else if (strcmp(a, "--for") == 0)
                l->hold = value;
            else if (strcmp(a, "--set") == 0 && l->sets < SETS_MAX)
                l->set[l->sets++] = value;
            else
                return false;
        } else if (l->words < 2) {
            l->word[l->words++] = a;
        } else {
            return false;
        }
    }
    return true;
}

int gpio_main(int argc, char **argv) {
    static job_t job;
    line_t l = {0};
    const char *what = argv[0], *extra[3] = {NULL};
    char by[64];
    if (!parse(&l, argc, argv)) return usage();
    if (strcmp(what, "jog") == 0) {
        long x, y;
        if (l.words != 2 || !read_mm(l.word[0], &x) || !read_mm(l.word[1], &y)) return usage();
        snprintf(by, sizeof by, "%ld,%ld", x, y);
        extra[0] = "--by";
        extra[1] = by;
    } else if (strcmp(what, "pen") == 0) {
        bool down = l.words == 1 && strcmp(l.word[0], "down") == 0;
        if (!down && !(l.words == 1 && strcmp(l.word[0], "up") == 0)) return usage();
        what = down ? "pen-down" : "off";
        if (down && l.hold) {
            extra[0] = "--for";
            extra[1] = l.hold;
        }
    } else if (l.words) {
        return usage();
    }
    if (!l.gpio.pins) {
        fprintf(stderr, "ridgeline: --pins FILE is missing\n");
        return SCRIPT_BAD_INPUT;
    }
    job_init(&job);
    script_begin(&job, false);
    script_source("--set");
    for (int i = 0; i < l.sets; i++)
        if (script_line(l.set[i]) != 0) return SCRIPT_BAD_INPUT;
    int status = run(&l.gpio, what, extra, &script_settings()->machine, NULL);
    job_free(&job);
    return status;
}
