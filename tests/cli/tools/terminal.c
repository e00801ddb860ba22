/* terminal.c - a person at a terminal: runs a program on a pseudo-terminal, waits for what it prints, and types.
 *
 *     terminal PROGRAM ARGUMENT... <DIALOGUE >TRANSCRIPT
 *
 * A line of the dialogue is `wait TEXT` (until that has been printed, after what the last `wait` found), `type TEXT`,
 * or `keys`: wait until the program reads single keys, which a line editor does only some time after its prompt (Ctrl-D
 * means something else before). In texts \n is the end of a line and \003 a character by its octal number. At the end
 * of the dialogue it waits for the program's end, and ends with its status (128 and the signal's number when it was
 * killed).
 *
 * Nothing is timed, so a loaded machine gives the same transcript. A program that says no more while something is
 * waited for hangs; after HANGS_S seconds of silence that is said, with status 3. If it ends instead: status 4. No
 * terminal to be had: 5. */
#define _GNU_SOURCE
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

#define HANGS_S 120

static struct {
    char text[1 << 20]; /* all that was printed */
    size_t printed, seen;
    int fd;
} t;

/* More of what is printed: 1, 0 at its end, or -1 when nothing comes for so long. */
static int more(int ms) {
    struct pollfd p = {.fd = t.fd, .events = POLLIN};
    if (poll(&p, 1, ms) == 0) return -1;
    ssize_t n = read(t.fd, t.text + t.printed, sizeof t.text - 1 - t.printed);
    if (n <= 0) return 0;
    fwrite(t.text + t.printed, 1, (size_t)n, stdout);
    t.printed += (size_t)n;
    return 1;
}

static size_t unescape(const char *from, char *to) {
    size_t n = 0;
    while (*from) {
        char c = *from++;
        if (c == '\\' && *from == 'n')
            c = '\n', from++;
        else if (c == '\\') {
            char octal[4] = {0};
            size_t k = 0;
            while (k < 3 && *from >= '0' && *from <= '7') octal[k++] = *from++;
            if (k) c = (char)strtol(octal, NULL, 8);
        }
        to[n++] = c;
    }
    to[n] = 0;
    return n;
}

static int wait_for(const char *text, size_t length) {
    for (;;) {
        const char *found = memmem(t.text + t.seen, t.printed - t.seen, text, length);
        if (found) {
            t.seen = (size_t)(found - t.text) + length;
            return 0;
        }
        int n = more(HANGS_S * 1000);
        if (n > 0) continue;
        fflush(stdout);
        fprintf(stderr, "terminal: %s instead of printing: %s\n", n ? "silent" : "it ended", text);
        return n ? 3 : 4;
    }
}

/* The mode of the terminal can only be asked for, not waited for. */
static int wait_for_keys(void) {
    struct termios mode;
    for (int tries = 0; tries < HANGS_S * 1000; tries++) {
        if (tcgetattr(t.fd, &mode) == 0 && !(mode.c_lflag & ICANON)) return 0;
        if (more(1) == 0) return 4;
    }
    return 3;
}

static int start(char **argv) {
    t.fd = posix_openpt(O_RDWR | O_NOCTTY);
    if (t.fd < 0 || grantpt(t.fd) || unlockpt(t.fd)) return -1;
    int inner = open(ptsname(t.fd), O_RDWR | O_NOCTTY);
    struct winsize size = {.ws_row = 24, .ws_col = 80};
    if (inner < 0 || ioctl(inner, TIOCSWINSZ, &size)) return -1;
    pid_t pid = fork();
    if (pid == 0) {
        setsid();
        ioctl(inner, TIOCSCTTY, 0);
        for (int i = 0; i < 3; i++) dup2(inner, i);
        close(inner);
        close(t.fd);
        signal(SIGINT, SIG_DFL); /* ignored where a shell started the tests with & */
        execvp(argv[0], argv);
        perror(argv[0]);
        _exit(127);
    }
    close(inner);
    return pid;
}

int main(int argc, char **argv) {
    char line[4096], text[4096];
    int status = 0;
    if (argc < 2) return 2;
    int pid = start(argv + 1);
    if (pid < 0) {
        perror("terminal");
        return 5;
    }
    while (status == 0 && fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\n")] = 0;
        size_t length = strlen(line) > 5 ? unescape(line + 5, text) : 0;
        if (strncmp(line, "wait ", 5) == 0)
            status = wait_for(text, length);
        else if (strcmp(line, "keys") == 0)
            status = wait_for_keys();
        else if (strncmp(line, "type ", 5) == 0)
            status = write(t.fd, text, length) == (ssize_t)length ? 0 : 2;
        else
            status = 2;
        if (status == 2) fprintf(stderr, "terminal: cannot do: %s\n", line);
    }
    int n = 1;
    while (status == 0 && (n = more(HANGS_S * 1000)) > 0) {
    }
    if (n < 0) {
        fprintf(stderr, "terminal: silent, but it does not end\n");
        status = 3;
    }
    close(t.fd); /* hangs up */
    int ended = 0;
    waitpid(pid, &ended, 0);
    if (status) return status;
    return WIFSIGNALED(ended) ? 128 + WTERMSIG(ended) : WEXITSTATUS(ended);
}
