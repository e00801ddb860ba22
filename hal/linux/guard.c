/* guard.c - see guard.h. */
#define _GNU_SOURCE /* prctl */
#include "hal/linux/guard.h"
#include "hal/linux/port.h"

#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define PRIORITY 60 /* above the child's */

static volatile sig_atomic_t signals;

static void on_signal(int signal) {
    (void)signal;
    signals++;
}

int guard_signals(void) {
    return signals;
}

/* A group of its own: Ctrl-C reaches the parent alone, so it is counted once. */
static int be_child(pid_t parent, const sigset_t *watched, int (*step)(void *ctx), void *ctx) {
    struct sigaction action = {.sa_handler = on_signal};
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
    sigprocmask(SIG_UNBLOCK, watched, NULL);
    if (getppid() != parent) return 1;
    int status = step(ctx);
    fflush(NULL);
    return status;
}

/* Until the child has ended. Returns the signal that asked for the end, or 0. */
static int watch(pid_t child, const sigset_t *watched, int *status) {
    int asked = 0;
    for (;;) {
        struct timespec grace = {.tv_sec = GUARD_GRACE_S};
        int signal = asked ? sigtimedwait(watched, NULL, &grace) : sigwaitinfo(watched, NULL);
        if (signal < 0 && errno == EAGAIN) kill(child, SIGKILL);
        if (signal > 0 && signal != SIGCHLD) {
            asked = signal;
            kill(child, signal);
        }
        if (waitpid(child, status, WNOHANG) == child) return asked;
    }
}

int guard_run(int (*step)(void *ctx), void *ctx, int *killed) {
    sigset_t watched;
    sigemptyset(&watched);
    sigaddset(&watched, SIGINT);
    sigaddset(&watched, SIGTERM);
    sigaddset(&watched, SIGHUP);
    sigaddset(&watched, SIGCHLD);
    sigprocmask(SIG_BLOCK, &watched, NULL);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    signal(SIGPIPE, SIG_IGN);
    *killed = 0;
    pid_t parent = getpid();
    fflush(NULL);
    pid_t child = fork();
    if (child < 0) {
        fprintf(stderr, "ridgeline: %s\n", strerror(errno));
        return 1;
    }
    if (child == 0) _exit(be_child(parent, &watched, step, ctx));

    /* Where it is permitted, as the child has said: to be awake before anybody else when it dies. */
    struct sched_param priority = {.sched_priority = PRIORITY};
    sched_setscheduler(0, SCHED_FIFO, &priority);
    mlockall(MCL_CURRENT);
    int status = 0, asked = watch(child, &watched, &status);
    int err = port_safe();
    if (err) fprintf(stderr, "ridgeline: the lines cannot be set (%s): cut the motors' power\n", strerror(-err));
    if (WIFSIGNALED(status)) {
        *killed = WTERMSIG(status);
        return 128 + *killed;
    }
    return asked && WEXITSTATUS(status) != 0 ? 128 + asked : err ? 1 : WEXITSTATUS(status);
}
