/* talk.h - a program that is typed to as at a terminal, a line at a time, so that it goes on after an error.
 *
 * Its standard input is a pseudo-terminal; what it writes, on both of its outputs, is read through a pipe. */
#ifndef COMPARE_TALK_H
#define COMPARE_TALK_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

enum { TALK_TEXT = 1 << 16 };

typedef struct talk {
    const char *name;
    int terminal, output;
    pid_t pid;
    long asked;
    size_t read;
    char text[TALK_TEXT]; /* what it has written since it was asked */
} talk_t;

/* Starts argv[0], found by PATH. false: said why on standard error. */
bool talk_start(talk_t *t, char *const argv[]);
/* Types lines. */
bool talk_type(talk_t *t, const char *lines);
/* Waits until all has been carried out that was typed last. Returns what was written meanwhile, prompts and echoes too,
 * or NULL when the program ended or hangs, which is said. */
const char *talk_hear(talk_t *t);
void talk_end(talk_t *t);

#endif
