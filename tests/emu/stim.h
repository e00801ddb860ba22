/* stim.h - what happens to a board from outside, read from a file of lines
 *
 *     TIME type TEXT        bytes on the console from then on, 115200 baud; \r \n \\ \xHH
 *     TIME input NAME 0|1   a switch: limit_x limit_y button estop; 1 is active
 *     TIME poke ADDRESS VALUE    16 bits of the board's memory, from outside: lib.sh puts addresses for @NAMES. Not on
 *                                the simulator
 *     TIME fault WORD      a byte with the error bits of the PL011's data register: 0x100 framing, 0x800 overrun. Only
 *                                rp2040.mjs
 *     TIME heal                  what was poked is again what it was
 *     TIME quit             the end of the run
 *     # comment
 *
 * TIME is in microseconds since power-on, or +TIME since the first change of a pin. Lines are in order of time,
 * absolute ones first. The simulator and the QEMU plugin read it with this, rp2040.mjs has the same in its language. */
#ifndef STIM_H
#define STIM_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum stim_kind { STIM_TYPE, STIM_INPUT, STIM_POKE, STIM_HEAL, STIM_QUIT };

typedef struct stim {
    int64_t ns;
    bool relative;
    enum stim_kind kind;
    char text[1024];
    int bytes; /* of text */
    int input; /* number: bit of enum hal_input */
    int level;
    unsigned at, value; /* of a poke */
} stim_t;

static int stim_input(const char *name) {
    static const char *const NAME[] = {"limit_x", "limit_y", "button", "estop"};
    for (int i = 0; i < 4; i++)
        if (strcmp(NAME[i], name) == 0) return i;
    return -1;
}

static int stim_unescape(char *out, const char *in) {
    char *begin = out;
    while (*in && *in != '\n') {
        if (*in != '\\') {
            *out++ = *in++;
        } else if (in[1] == 'x') {
            char hex[3] = {in[2], in[2] ? in[3] : 0, 0};
            *out++ = (char)strtol(hex, NULL, 16);
            in += 4;
        } else {
            *out++ = in[1] == 'r' ? '\r' : in[1] == 'n' ? '\n' : in[1];
            in += 2;
        }
    }
    return (int)(out - begin);
}

/* Reads a whole file: how many entries there are in *out (malloc'ed), or -1 after saying why. */
static int stim_read(const char *name, stim_t **out) {
    FILE *f = fopen(name, "r");
    char line[1200], verb[16], rest[1100];
    int n = 0, number = 0;
    *out = NULL;
    if (!f) {
        perror(name);
        return -1;
    }
    while (fgets(line, sizeof line, f)) {
        number++;
        if (line[0] == '#' || line[0] == '\n') continue;
        *out = realloc(*out, (size_t)(n + 1) * sizeof **out);
        stim_t *s = &(*out)[n];
        memset(s, 0, sizeof *s);
        double us;
        rest[0] = 0;
        if (sscanf(line, "%lf %15s %1099[^\n]", &us, verb, rest) < 2) goto wrong;
        s->relative = line[0] == '+';
        s->ns = (int64_t)(us * 1000);
        char which[16];
        if (strcmp(verb, "type") == 0) {
            s->kind = STIM_TYPE;
            s->bytes = stim_unescape(s->text, rest);
        } else if (strcmp(verb, "input") == 0 && sscanf(rest, "%15s %d", which, &s->level) == 2) {
            s->kind = STIM_INPUT;
            s->input = stim_input(which);
            if (s->input < 0) goto wrong;
        } else if (strcmp(verb, "poke") == 0 && sscanf(rest, "%i %i", (int *)&s->at, (int *)&s->value) == 2) {
            s->kind = STIM_POKE;
        } else if (strcmp(verb, "heal") == 0) {
            s->kind = STIM_HEAL;
        } else if (strcmp(verb, "quit") == 0) {
            s->kind = STIM_QUIT;
        } else {
            goto wrong;
        }
        n++;
    }
    fclose(f);
    return n;
wrong:
    fprintf(stderr, "%s:%d: not understood: %s", name, number, line);
    fclose(f);
    return -1;
}

#endif
