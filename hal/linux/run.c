/* run.c - see run.h. */
#include "hal/linux/run.h"

#include <stdio.h>
#include <string.h>

#include "error.h"
#include "hal/linux/guard.h"
#include "host/play.h"

enum { DONE, TROUBLE };

static uint64_t memory[(MOTION_BYTES_HOST + 7) / 8];
static uint32_t hits; /* switches met while they were expected */

void run_position(const machine_t *machine, const port_counts_t *counts, char *text, size_t size) {
    kinematics_t kin;
    kinematics_init(&kin, machine);
    page_point_t p = kinematics_page(&kin, counts->steps);
    snprintf(text, size, "x %.3f mm, y %.3f mm (%d, %d steps)", (double)p.x_lat / LAT_PER_MM,
             (double)p.y_lat / LAT_PER_MM, (int)counts->steps[0], (int)counts->steps[1]);
}

static void switch_names(uint32_t inputs, char *text, size_t size) {
    snprintf(text, size, "%s%s%s", inputs & HAL_IN_ESTOP ? " emergency stop" : "",
             inputs & HAL_IN_LIMIT_X ? " limit_x" : "", inputs & HAL_IN_LIMIT_Y ? " limit_y" : "");
}

/* The main loop's waiting: the machine runs in it, and whatever ends a run is seen in it. */
static void on_wait(void *ctx) {
    (void)ctx;
    hal_idle();
    if (port_trouble()) {
        stepgen_halt(false);
        return;
    }
    uint32_t now = port_hits();
    hits |= now;
    if (now) stepgen_halt(true);
    if (guard_signals() > 1) stepgen_halt(false);
    if (guard_signals() == 1) {
        stepgen_hold();
        if (stepgen_held()) stepgen_halt(false);
    }
}

static void report_counts(void) {
    const port_counts_t *c = port_counts();
    fprintf(
        stderr,
        "ridgeline: %llu of %llu deadlines later than %d us, the latest by %.1f us; %llu rests; the time base moved by "
        "%.3f ms in all; slowest write %.1f us\n",
        (unsigned long long)c->late, (unsigned long long)c->served, PORT_LATE_NS / 1000, (double)c->worst_ns / 1e3,
        (unsigned long long)c->rests, (double)c->shifted_ns / 1e6, (double)c->worst_write_ns / 1e3);
}

/* Says how it ended; the exit status. err: of the motion stage. */
static int report(const run_t *run, int err) {
    char where[96], names[64];
    run_position(&run->machine, port_counts(), where, sizeof where);
    switch_names(port_hits() | hits, names, sizeof names);
    report_counts();
    if (port_trouble() == PORT_WRITE || port_trouble() == PORT_READ)
        fprintf(stderr, "ridgeline: the lines cannot be %s: %s; stopped at %s\n",
                port_trouble() == PORT_WRITE ? "written" : "read", strerror(port_error()), where);
    else if (port_trouble() == PORT_SWITCH)
        fprintf(stderr, "ridgeline:%s became active; stopped at %s\n", names, where);
    else if (guard_signals())
        fprintf(stderr, "ridgeline: stopped by a signal at %s\n", where);
    else if (err)
        fprintf(stderr, "ridgeline: %s; stopped at %s\n", error_text(err), where);
    else
        return DONE;
    return TROUBLE;
}

static int begin(motion_t *m, const machine_t *machine) {
    int err = motion_init(m, machine, memory, sizeof memory);
    if (!err) motion_on_wait(m, on_wait, NULL);
    return err;
}

static int plot(run_t *run) {
    static motion_t m;
    int err = begin(&m, &run->machine);
    return err ? err : play(&run->drawing, &m, NULL, NULL);
}

/* One straight way, pen up, beginning where the motors stand. */
static int travel(const machine_t *machine, page_point_t by) {
    static motion_t m;
    int err = begin(&m, machine);
    if (err) return err;
    err = motion_travel(&m, by);
    int parked = motion_park(&m, NULL);
    return err ? err : parked;
}

static page_point_t along(int axis, int64_t um) {
    int32_t lat = (int32_t)(um * LAT_PER_MM / 1000);
    return axis ? (page_point_t){0, lat} : (page_point_t){lat, 0};
}

static int home_axis(const run_t *run, const machine_t *machine, int axis) {
    uint32_t bit = axis ? HAL_IN_LIMIT_Y : HAL_IN_LIMIT_X;
    int32_t size_um = axis ? run->machine.height_um : run->machine.width_um;
    int64_t reach_um = size_um ? (int64_t)size_um + 2 * RUN_HOME_BACK_UM : RUN_HOME_REACH_UM;
    port_expect(bit);
    hits = 0;
    if (!(hal_inputs() & bit)) {
        int err = travel(machine, along(axis, -reach_um));
        if (port_trouble() || guard_signals()) return ERR_STOPPED;
        if (!(hits & bit)) {
            fprintf(stderr, "ridgeline: %s was not met within %lld mm: is it wired, and the axis not turned round?\n",
                    axis ? "limit_y" : "limit_x", (long long)reach_um / 1000);
            return err ? err : ERR_MACHINE;
        }
    }
    /* The switch may bounce while it opens: then the way off is begun again. */
    for (int tries = 0; tries < 20 && !port_trouble() && !guard_signals(); tries++) {
        port_hits();
        hits = 0;
        int err = travel(machine, along(axis, RUN_HOME_BACK_UM));
        if (port_trouble() || guard_signals()) break;
        if (!err && !(hal_inputs() & bit)) {
            port_expect(0);
            return 0;
        }
        if (!err) break;
    }
    if (!port_trouble() && !guard_signals())
        fprintf(stderr, "ridgeline: %s is still active %d mm off it: is its polarity right?\n",
                axis ? "limit_y" : "limit_x", RUN_HOME_BACK_UM / 1000);
    return ERR_MACHINE;
}

static int home(const run_t *run) {
    machine_t machine = run->machine;
    machine.width_um = machine.height_um = 0;
    if (machine.travel_speed_um_s > RUN_HOME_UM_S) machine.travel_speed_um_s = RUN_HOME_UM_S;
    int err = 0;
    for (int axis = 0; axis < 2 && !err; axis++)
        if (run->limit[axis]) err = home_axis(run, &machine, axis);
    return err;
}

static int jog(const run_t *run) {
    machine_t machine = run->machine;
    machine.width_um = machine.height_um = 0;
    return travel(&machine, run->by);
}

static int pen_down(const run_t *run) {
    uint32_t end = hal_now() + (uint32_t)run->hold_s * HAL_TICK_HZ;
    hal_pins_write(HAL_PEN, HAL_PEN);
    while (!port_trouble() && !guard_signals() && !(run->hold_s && !hal_before(hal_now(), end))) hal_idle();
    if (port_trouble()) return ERR_MACHINE;
    return 0;
}

static bool may_start(const run_t *run) {
    char names[64];
    uint32_t active = hal_inputs(), against = HAL_IN_ESTOP;
    if (run->what == RUN_PLOT) against |= HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y;
    if (port_trouble()) {
        fprintf(stderr, "ridgeline: the switches cannot be read: %s\n", strerror(port_error()));
        return false;
    }
    if (!(active & against)) return true;
    switch_names(active & against, names, sizeof names);
    fprintf(stderr, "ridgeline:%s active already: nothing was moved%s\n", names,
            active & HAL_IN_ESTOP ? "" : " (`ridgeline home` or `ridgeline jog` gets off a limit switch)");
    return false;
}

int run_step(void *ctx) {
    run_t *run = ctx;
    port_start(stderr);
    if (!may_start(run)) return TROUBLE;
    int err = 0;
    switch (run->what) {
    case RUN_PLOT:
        err = plot(run);
        break;
    case RUN_JOG:
        err = jog(run);
        break;
    case RUN_HOME:
        err = home(run);
        break;
    case RUN_PEN_DOWN:
        err = pen_down(run);
        break;
    case RUN_OFF:
        break;
    }
    int safe = port_safe(); /* the guardian tries again, and complains */
    if (run->what >= RUN_PEN_DOWN && !err && !safe) return DONE;
    return report(run, err) || safe ? TROUBLE : DONE;
}
