/* talk.c - see talk.h. */
#define _GNU_SOURCE
#include "tests/compare/talk.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

enum { HANGS_MS = 120000 };

bool talk_start(talk_t *t, char *const argv[]) {
    int out[2];
    *t = (talk_t){.name = argv[0], .terminal = posix_openpt(O_RDWR | O_NOCTTY)};
    if (t->terminal < 0 || grantpt(t->terminal) || unlockpt(t->terminal) || pipe(out)) {
        perror("compare: no terminal");
        return false;
    }
    const int inner = open(ptsname(t->terminal), O_RDWR | O_NOCTTY);
    struct termios mode;
    tcgetattr(inner, &mode);
    mode.c_lflag &= (tcflag_t)~ECHO;
    tcsetattr(inner, TCSANOW, &mode);
    t->pid = fork();
    if (t->pid == 0) {
        setsid();
        ioctl(inner, TIOCSCTTY, 0);
        dup2(inner, 0);
        dup2(out[1], 1);
        dup2(out[1], 2);
        close(inner);
        close(out[0]);
        close(out[1]);
        close(t->terminal);
        setenv("TERM", "dumb", 1);
        execvp(argv[0], argv);
        perror(argv[0]);
        _exit(127);
    }
    close(inner);
    close(out[1]);
    t->output = out[0];
    return true;
}

static bool type(talk_t *t, const char *text) {
    const size_t n = strlen(text);
    return write(t->terminal, text, n) == (ssize_t)n;
}

/* Reads until mark has been written. */
static bool wait_for(talk_t *t, const char *mark) {
    size_t from = 0;
    for (;;) {
        t->text[t->read] = 0;
        if (strstr(t->text + from, mark)) return true;
        from = t->read > 64 ? t->read - 64 : 0;
        struct pollfd p = {.fd = t->output, .events = POLLIN};
        const bool silent = poll(&p, 1, HANGS_MS) <= 0;
        const ssize_t n = silent ? 0 : read(t->output, t->text + t->read, sizeof t->text - 1 - t->read);
        if (n <= 0) {
            fprintf(stderr, "compare: %s %s; it wrote:\n%s\n", t->name, silent ? "hangs" : "ended", t->text);
            return false;
        }
        t->read += (size_t)n;
    }
}

bool talk_type(talk_t *t, const char *lines) {
    char line[64];
    snprintf(line, sizeof line, "\nprint 'done', %ld\n", ++t->asked); /* its echo is not what it prints */
    t->read = 0;
    return type(t, lines) && type(t, line);
}

const char *talk_hear(talk_t *t) {
    char mark[64];
    snprintf(mark, sizeof mark, "done %ld\n", t->asked);
    return wait_for(t, mark) ? t->text : NULL;
}

void talk_end(talk_t *t) {
    close(t->terminal);
    close(t->output);
    if (t->pid > 0) {
        kill(t->pid, SIGKILL);
        waitpid(t->pid, NULL, 0);
    }
}
