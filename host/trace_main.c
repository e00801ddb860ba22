/* trace_main.c - `ridgeline trace a.vcd [b.vcd]`. */
#include "error.h"
#include "host/trace.h"
#include "host/writer.h"
#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define TOLERANCE_US 0.1 /* a tick is 0.0625: the same ticks written in different units are equal */

static const char USAGE[] =
    "usage: ridgeline trace A.vcd [options]          judge a step trace; exit 0 legal, 1 not legal, 2 bad input\n"
    "       ridgeline trace A.vcd B.vcd [options]    compare two; exit 0 equal, 1 different, 2 bad input\n"
    "  -o FILE              draw the ink of A (" WRITER_SUFFIXES ")\n"
    "  --tolerance US       times this close are equal (0.1)\n"
    "  --rests              B may stand longer where the pen was lifted: one of them had to compute\n"
    "The machine is the one named in the file, or the default one, changed by:\n"
    "  --steps N[,M]        steps per mm of the motors      --corexy --swap --invert-x --invert-y\n"
    "  --speed MM/S         pen down                        --travel MM/S    pen up\n"
    "  --accel MM/S2        acceleration                    --pulse US       least pulse width\n"
    "  --setup US           least DIR set-up time           --lift S  --lower S   pen delays\n"
    "'-' reads standard input.\n";

typedef struct options {
    const char *file[2];
    int files;
    const char *ink;
    double tolerance_us;
    bool rests;
    const char *machine[32]; /* options that change the machine, and their values */
    const char *value[32];
    int changes;
} options_t;

/* Options with a number, and what one unit of it is in the machine's unit. */
static const struct {
    const char *name;
    size_t offset;
    double unit;
} NUMBER[] = {
    {"--speed", offsetof(machine_t, draw_speed_um_s), 1e3}, {"--travel", offsetof(machine_t, travel_speed_um_s), 1e3},
    {"--accel", offsetof(machine_t, accel_um_s2), 1e3},     {"--pulse", offsetof(machine_t, pulse_ns), 1e3},
    {"--setup", offsetof(machine_t, dir_setup_ns), 1e3},    {"--lift", offsetof(machine_t, lift_us), 1e6},
    {"--lower", offsetof(machine_t, lower_us), 1e6},
};
static const struct {
    const char *name;
    size_t offset;
} FLAG[] = {
    {"--swap", offsetof(machine_t, swap_xy)},
    {"--invert-x", offsetof(machine_t, invert[0])},
    {"--invert-y", offsetof(machine_t, invert[1])},
};

static bool parse_number(const char **text, double *out) {
    char *end;
    *out = strtod(*text, &end);
    bool ok = end != *text && isfinite(*out) && *out >= 0;
    *text = end;
    return ok;
}

/* Does one change; false: no such option or a bad value. */
static bool change(machine_t *m, const char *option, const char *value) {
    double v;
    for (size_t i = 0; i < sizeof FLAG / sizeof FLAG[0]; i++)
        if (strcmp(option, FLAG[i].name) == 0) {
            *(bool *)((char *)m + FLAG[i].offset) = true;
            return true;
        }
    if (strcmp(option, "--corexy") == 0) {
        m->kinematics = MACHINE_COREXY;
        return true;
    }
    if (!value) return false;
    if (strcmp(option, "--steps") == 0) {
        for (int i = 0; i < 2; i++) {
            if (!parse_number(&value, &v) || v < 1e-3 || v > 65535) return false;
            m->steps_per_mm_q16[i] = (uint32_t)(v * 65536 + 0.5);
            if (i == 0) m->steps_per_mm_q16[1] = m->steps_per_mm_q16[0];
            if (*value != ',') break;
            value++;
        }
        return *value == 0;
    }
    for (size_t i = 0; i < sizeof NUMBER / sizeof NUMBER[0]; i++)
        if (strcmp(option, NUMBER[i].name) == 0) {
            if (!parse_number(&value, &v) || *value || v * NUMBER[i].unit > 4e9) return false;
            *(uint32_t *)(void *)((char *)m + NUMBER[i].offset) = (uint32_t)(v * NUMBER[i].unit + 0.5);
            return true;
        }
    return false;
}

static bool takes_value(const char *option) {
    for (size_t i = 0; i < sizeof NUMBER / sizeof NUMBER[0]; i++)
        if (strcmp(option, NUMBER[i].name) == 0) return true;
    return strcmp(option, "--steps") == 0;
}

static bool parse(int argc, char **argv, options_t *o) {
    *o = (options_t){.tolerance_us = TOLERANCE_US};
    machine_t scratch;
    machine_default(&scratch);
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i], *next = i + 1 < argc ? argv[i + 1] : NULL;
        bool ok = true;
        if (strcmp(a, "-o") == 0 && next) {
            o->ink = argv[++i];
            ok = writer_knows(o->ink);
            if (!ok) a = o->ink;
        } else if (strcmp(a, "--tolerance") == 0 && next) {
            const char *text = argv[++i];
            ok = parse_number(&text, &o->tolerance_us) && !*text;
        } else if (strcmp(a, "--rests") == 0) {
            o->rests = true;
        } else if (a[0] == '-' && a[1]) {
            bool valued = takes_value(a);
            ok = o->changes < 32 && change(&scratch, a, valued ? next : NULL);
            if (ok) {
                o->machine[o->changes] = a;
                o->value[o->changes++] = valued ? argv[++i] : NULL;
            }
        } else if (o->files < 2) {
            o->file[o->files++] = a;
        } else {
            ok = false;
        }
        if (!ok) {
            fprintf(stderr, "ridgeline trace: bad argument: %s\n%s", a, USAGE);
            return false;
        }
    }
    if (o->files == 0) fputs(USAGE, stderr);
    return o->files > 0;
}

static int read_file(const char *name, trace_t *t) {
    FILE *f = strcmp(name, "-") == 0 ? stdin : fopen(name, "rb");
    if (!f) {
        fprintf(stderr, "ridgeline trace: %s: %s\n", name, strerror(errno));
        return ERR_FILE;
    }
    trace_error_t error;
    int e = trace_read(f, t, &error);
    if (f != stdin) fclose(f);
    if (e && error.line)
        fprintf(stderr, "%s:%lu: %s\n", name, error.line, error.text);
    else if (e)
        fprintf(stderr, "%s: %s\n", name, error_text(e));
    return e;
}

static int judge(const trace_t *t, const options_t *o, const machine_t *m) {
    trace_judgement_t j;
    if (trace_judge(t, m, &j)) {
        fprintf(stderr, "ridgeline trace: out of memory\n");
        return 2;
    }
    printf("%s: %zu events, %s\n", o->file[0], t->count, t->has_machine ? "machine from the file" : "default machine");
    trace_print(&j, m, stdout);
    return j.legal ? 0 : 1;
}

static int compare(const trace_t *a, const trace_t *b, const options_t *o) {
    trace_difference_t d;
    if (trace_compare(a, b, o->tolerance_us, o->rests, &d)) {
        fprintf(stderr, "ridgeline trace: out of memory\n");
        return 2;
    }
    trace_print_difference(a, b, &d, stdout);
    return d.same_sequence && d.max_us <= o->tolerance_us ? 0 : 1;
}

int trace_main(int argc, char **argv) {
    options_t o;
    if (!parse(argc, argv, &o)) return 2;
    trace_t t[2] = {{0}, {0}};
    int status = 0;
    for (int i = 0; i < o.files && !status; i++)
        if (read_file(o.file[i], &t[i])) status = 2;
    if (!status) {
        machine_t m = t[0].machine;
        for (int i = 0; i < o.changes; i++) change(&m, o.machine[i], o.value[i]);
        status = o.files == 2 ? compare(&t[0], &t[1], &o) : judge(&t[0], &o, &m);
        int e = o.ink ? trace_draw(&t[0], &m, o.ink) : 0;
        if (e) {
            fprintf(stderr, "ridgeline trace: %s: %s\n", o.ink, error_text(e));
            status = 2;
        }
    }
    trace_free(&t[0]);
    trace_free(&t[1]);
    return status;
}
