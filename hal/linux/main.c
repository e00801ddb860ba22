/* main.c - ridgeline-gpio: the program that `ridgeline plot --hal gpio`, jog, home, pen and off start for a machine on
 * gpio lines.
 *
 *     ridgeline-gpio plot|jog|home|pen-down|off --pins FILE [--by X_UM,Y_UM] [--for S] [--dry-run] <relay
 *
 * A program of its own, because hal.h is chosen at link time: `ridgeline` is linked with the simulator and this with
 * hal/linux, and steps pay for no choice between them. It is also small, so that locking its memory is cheap, and
 * `ridgeline` needs no libgpiod. What to draw and the machine's numbers come on standard input (host/relay.h).
 *
 * First everything is checked, then the lines are taken, then a child steps (guard.h). Exit status: 0 done, 2 the pin
 * file or the command line is wrong, 1 anything else, 128 + signal after a signal. */
#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "hal/linux/guard.h"
#include "hal/linux/run.h"
#include "host/play.h"
#include "host/relay.h"

enum { DONE, TROUBLE, BAD_INPUT };

typedef struct command {
    const char *what, *pins;
    bool dry;
    run_t run;
} command_t;

static int complain(const char *what, const char *which) {
    fprintf(stderr, "ridgeline-gpio: %s%s\nThis program is started by `ridgeline`; see docs/LINUX.md.\n", what, which);
    return BAD_INPUT;
}

static int32_t lat_from_um(long um) {
    return (int32_t)((int64_t)um * LAT_PER_MM / 1000);
}

static bool parse_by(const char *text, page_point_t *by) {
    char *end;
    long x = strtol(text, &end, 10);
    if (*end != ',') return false;
    long y = strtol(end + 1, &end, 10);
    if (*end || x < -4000000 || x > 4000000 || y < -4000000 || y > 4000000) return false;
    *by = (page_point_t){lat_from_um(x), lat_from_um(y)};
    return true;
}

static int parse(command_t *c, int argc, char **argv) {
    static const struct option LONG[] = {
        {"pins", required_argument, NULL, 'p'},
        {"by", required_argument, NULL, 'b'},
        {"for", required_argument, NULL, 'f'},
        {"dry-run", no_argument, NULL, 'n'},
        {NULL, 0, NULL, 0},
    };
    int option;
    while ((option = getopt_long(argc, argv, "", LONG, NULL)) != -1) {
        switch (option) {
        case 'p':
            c->pins = optarg;
            break;
        case 'b':
            if (!parse_by(optarg, &c->run.by)) return complain("bad distance: ", optarg);
            break;
        case 'f':
            c->run.hold_s = atoi(optarg);
            if (c->run.hold_s < 1 || c->run.hold_s > RUN_HOLD_MAX_S) return complain("bad time: ", optarg);
            break;
        case 'n':
            c->dry = true;
            break;
        default:
            return complain("the command line cannot be understood", "");
        }
    }
    static const struct {
        const char *name;
        enum run_what what;
    } WHAT[] = {{"plot", RUN_PLOT}, {"jog", RUN_JOG}, {"home", RUN_HOME}, {"pen-down", RUN_PEN_DOWN}, {"off", RUN_OFF}};
    if (optind + 1 != argc) return complain("one command, please", "");
    c->what = argv[optind];
    for (size_t i = 0; i < sizeof WHAT / sizeof WHAT[0]; i++) {
        if (strcmp(c->what, WHAT[i].name) != 0) continue;
        c->run.what = WHAT[i].what;
        return c->pins ? DONE : complain("--pins FILE is missing", "");
    }
    return complain("unknown command ", c->what);
}

static int read_pins(const char *name, pins_t *pins) {
    FILE *f = fopen(name, "r");
    if (!f) {
        fprintf(stderr, "ridgeline: %s: %s\n", name, strerror(errno));
        return BAD_INPUT;
    }
    int mistakes = pins_read(pins, f, name, stderr);
    fclose(f);
    if (!mistakes) return DONE;
    fprintf(stderr, "ridgeline: %s: %d mistake%s; nothing was moved\n", name, mistakes, mistakes > 1 ? "s" : "");
    return BAD_INPUT;
}

/* How long it takes; also says whether the machine can do it at all. */
static int estimate(run_t *run, motion_stats_t *stats) {
    static uint64_t memory[(MOTION_BYTES_HOST + 7) / 8];
    static motion_t m;
    machine_t machine = run->machine;
    if (run->what != RUN_PLOT) machine.width_um = machine.height_um = 0;
    int err = motion_init_estimate(&m, &machine, memory, sizeof memory);
    if (!err && run->what == RUN_PLOT) return play(&run->drawing, &m, NULL, stats);
    if (!err) err = motion_travel(&m, run->by);
    int parked = motion_park(&m, stats);
    return err ? err : parked;
}

static void say_pins(const command_t *c, const pins_t *pins) {
    printf("%s: libgpiod %s\n", c->pins, lines_library());
    for (int i = 0; i < PINS_COUNT; i++) {
        char text[128];
        pins_describe(pins, (enum pins_name)i, text, sizeof text);
        printf("  %-8s %s\n", pins_name((enum pins_name)i), text);
    }
}

static void say_plan(const command_t *c, const motion_stats_t *stats) {
    const run_t *run = &c->run;
    unsigned long tenths = (unsigned long)(stats->ticks / (HAL_TICK_HZ / 10));
    switch (run->what) {
    case RUN_PLOT:
        printf("would draw %u strokes, %.1f mm, and travel %.1f mm with the pen up, in %lu:%02lu.%lu min;",
               (unsigned)stats->strokes, (double)stats->down_lat / LAT_PER_MM, (double)stats->up_lat / LAT_PER_MM,
               tenths / 600, tenths / 10 % 60, tenths % 10);
        break;
    case RUN_JOG:
        printf("would move the pen, lifted, by %.3f mm, %.3f mm in %lu.%lu s;", (double)run->by.x_lat / LAT_PER_MM,
               (double)run->by.y_lat / LAT_PER_MM, tenths / 10, tenths % 10);
        break;
    case RUN_HOME:
        printf("would look for%s%s at %d mm/s and stop %d mm off;", run->limit[0] ? " limit_x" : "",
               run->limit[1] ? " limit_y" : "", RUN_HOME_UM_S / 1000, RUN_HOME_BACK_UM / 1000);
        break;
    case RUN_PEN_DOWN:
        printf("would lower the pen;");
        break;
    case RUN_OFF:
        printf("would lift the pen and switch the motors off;");
        break;
    }
    printf(" nothing was moved\n");
}

static int carry_out(command_t *c, const pins_t *pins) {
    int killed = 0;
    int err = port_open(pins, stderr);
    int status = err ? TROUBLE : guard_run(run_step, &c->run, &killed);
    if (killed) {
        char where[96];
        run_position(&c->run.machine, port_counts(), where, sizeof where);
        fprintf(stderr, "ridgeline: the stepping process was killed (%s) at %s; pen up, motors off\n",
                strsignal(killed), where);
    }
    port_close();
    return status;
}

int main(int argc, char **argv) {
    static command_t c;
    static pins_t pins;
    motion_stats_t stats;
    int status = parse(&c, argc, argv);
    if (status) return status;
    drawing_init(&c.run.drawing);
    int err = relay_read(stdin, &c.run.machine, &c.run.drawing);
    if (err) return complain("nothing to draw on standard input: ", error_text(err));
    err = estimate(&c.run, &stats);
    if (err) {
        fprintf(stderr, "ridgeline: %s; nothing was moved\n", error_text(err));
        return TROUBLE;
    }
    status = read_pins(c.pins, &pins);
    for (int i = 0; i < 2; i++) c.run.limit[i] = pins.pin[PINS_LIMIT_X + i].given;
    if (!status && c.run.what == RUN_HOME && !c.run.limit[0] && !c.run.limit[1]) {
        fprintf(stderr, "ridgeline: %s: home needs limit_x or limit_y\n", c.pins);
        status = BAD_INPUT;
    }
    if (!status && c.dry) {
        say_pins(&c, &pins);
        say_plan(&c, &stats);
    } else if (!status) {
        status = carry_out(&c, &pins);
    }
    pins_close(&pins);
    drawing_free(&c.run.drawing);
    return status;
}
