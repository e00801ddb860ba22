/* prompt.c - libedit through its readline interface. */
#include "host/prompt.h"

#include <editline/readline.h>
#include <limits.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/complete.h"
#include "host/library.h"
#include "host/script.h"

/* clang-format off */
#define EDIT(F) \
    F(using_history) F(stifle_history) F(read_history) F(write_history) F(add_history) F(readline) \
    F(rl_completion_matches) F(rl_attempted_completion_function) F(rl_line_buffer)
/* clang-format on */
static struct { EDIT(LIBRARY_POINTER) } edit;
static bool has_edit;

static bool history_path(char *path, size_t room) {
    const char *home = getenv("HOME");
    if (!home || !home[0]) return false;
    int n = snprintf(path, room, "%s/.ridgeline_history", home);
    return n > 0 && (size_t)n < room;
}

/* Blank lines and repetitions are not worth remembering; rows of inline data neither. */
static void remember(const char *line, char *last, size_t room) {
    if (!line[strspn(line, " \t")] || script_state() == SESSION_DATA || strcmp(line, last) == 0) return;
    if (has_edit) edit.add_history(line);
    snprintf(last, room, "%s", line);
}

/* The tab key: commands and options are ours, names of files are left to libedit. */
static const char *table;
static char *next_word(const char *text, int state) {
    static const char *at;
    if (state == 0) at = NULL;
    return complete_next(table, text, &at);
}
static char **complete(const char *text, int start, int end) {
    (void)end;
    table = complete_table(*edit.rl_line_buffer, (size_t)start);
    return table ? edit.rl_completion_matches(text, next_word) : NULL;
}

static sigjmp_buf to_prompt;
static volatile sig_atomic_t is_reading;

/* Ctrl-C takes back the line that is being typed, as in a shell, and stops a drawing that takes too long, a pause, or
 * data being read. What cannot be stopped, such as writing a file, is gone through with; a second time ends the
 * program. libedit begins anew with its next line, so leaving it half-way costs no more than that line's memory. */
static void on_interrupt(int sig) {
    if (is_reading) siglongjmp(to_prompt, 1);
    if (script_stop()) return; /* NOLINT(bugprone-signal-handler): it reads and writes sig_atomic_t only */
    signal(sig, SIG_DFL);
    raise(sig);
}

/* Without libedit: a line as the terminal itself lets it be typed. */
static char *plain_line(const char *prompt) {
    char *line = NULL;
    size_t room = 0;
    fputs(prompt, stdout);
    fflush(stdout);
    ssize_t n = getline(&line, &room, stdin);
    if (n > 0 && line[n - 1] == '\n') line[n - 1] = 0;
    if (n >= 0) return line;
    free(line);
    return NULL;
}

/* The next line, to be freed; NULL at the end of the input. */
static char *read_line(void) {
    if (sigsetjmp(to_prompt, 1)) {
        putchar('\n');
        script_cancel();
    }
    is_reading = 1;
    const char *prompt = script_state() == SESSION_READY ? "ridgeline> " : "> ";
    char *line = has_edit ? edit.readline(prompt) : plain_line(prompt);
    is_reading = 0;
    return line;
}

void prompt_run(void) {
    char path[PATH_MAX], last[1024] = "";
    static const char *const NAMES[] = {EDIT(LIBRARY_NAME)};
    has_edit = library_load("libedit.so.2", NAMES, sizeof NAMES / sizeof *NAMES, &edit);
    bool keep = has_edit && history_path(path, sizeof path);
    if (has_edit) {
        edit.using_history();
        edit.stifle_history(PROMPT_HISTORY);
        *edit.rl_attempted_completion_function = complete;
    }
    if (keep) edit.read_history(path);
    signal(SIGINT, on_interrupt);
    puts("Ridgeline: type `splot exp(-x**2-y**2)`, `help` or `quit`.");
    script_source(NULL);
    while (script_state() != SESSION_QUIT) {
        char *line = read_line();
        if (!line) {
            putchar('\n');
            break;
        }
        remember(line, last, sizeof last);
        script_line(line);
        free(line);
        /* Every time, so that nothing is lost when the window is closed. */
        if (keep) edit.write_history(path);
    }
}
