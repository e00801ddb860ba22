/* options.h - the command line of `plot` and of the prompt. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stdbool.h>

#include "host/job.h"

#define OPTIONS_SETS_MAX 64

typedef struct options {
    const char *scene; /* a file, "-", or NULL when none was given */
    const char *output[JOB_OUTPUTS_MAX];
    int outputs;
    const char *set[OPTIONS_SETS_MAX]; /* commands to run first */
    int sets;
    const char *stats; /* file for JSON or NULL */
    gpio_t gpio;
    bool verbose, help, version;
} options_t;

/* argv[0] is skipped. False after a message on stderr when the line cannot be understood. */
bool options_parse(options_t *o, int argc, char **argv);

/* `ridgeline --help`, on stdout. */
void options_help(void);

#endif
