/* The reference drawings through planner, step generator and simulator: is the motion legal, as fast as infinite
 * look-ahead, on the path, and what it was (golden hashes)? */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "error.h"
#include "sim/sim.h"
#include "sim/vcd.h"
#include "tests/oracle/motion_rig.h"

#define PI 3.14159265358979323846
#define GOLDEN "tests/golden/motion.txt"

static uint32_t seed;
static double uniform(void) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) / 16777216.0;
}

static machine_t default_machine(void) {
    machine_t m;
    machine_default(&m);
    return m;
}

static rig_drawing_t line_at(double degrees) {
    rig_drawing_t d = {0};
    rig_move(&d, 10, 10);
    rig_draw(&d, 10 + 100 * cos(degrees * PI / 180), 10 + 100 * sin(degrees * PI / 180));
    return d;
}

/* {12/5}: 1,307 mm */
static rig_drawing_t star(void) {
    rig_drawing_t d = {0};
    double radius = 1307.0 / 12 / (2 * sin(5 * PI / 12));
    rig_move(&d, 80 + radius, 80);
    for (int i = 1; i <= 12; i++) rig_draw(&d, 80 + radius * cos(i * 5 * PI / 6), 80 + radius * sin(i * 5 * PI / 6));
    return d;
}

/* 6,480 mm in lines of about 0.8 mm */
static rig_drawing_t spiral(void) {
    rig_drawing_t d = {0};
    double a = 0;
    rig_move(&d, 100, 100);
    for (double length = 0; length < 6480; length += 0.8) {
        double r = 1.5 * a / (2 * PI);
        a += 0.8 / fmax(r, 1);
        r = 1.5 * a / (2 * PI);
        rig_draw(&d, 100 + r * cos(a), 100 + r * sin(a));
    }
    return d;
}

/* 2,000 lines of uniform lengths lo..hi whose direction wanders */
static rig_drawing_t curved(double lo, double hi) {
    rig_drawing_t d = {0};
    double x = 100, y = 100, heading = 0, bend = 0;
    seed = 7;
    rig_move(&d, x, y);
    for (int i = 0; i < 2000; i++) {
        bend = 0.95 * bend + 0.06 * (uniform() - 0.5);
        heading += bend + 0.03;
        double length = lo + (hi - lo) * uniform();
        rig_draw(&d, x += length * cos(heading), y += length * sin(heading));
    }
    return d;
}

/* 40 x 40 sinc, every grid line a stroke */
static rig_drawing_t sinc(void) {
    rig_drawing_t d = {0};
    for (int family = 0; family < 2; family++)
        for (int i = 0; i < 40; i++)
            for (int k = 0; k < 40; k++) {
                int j = i % 2 ? 39 - k : k;
                double u = (family ? i : j) * 20.0 / 39 - 10, v = (family ? j : i) * 20.0 / 39 - 10, r = hypot(u, v);
                double x = 130 + (u - v) * 6.2, y = 70 + (u + v) * 3.1 + 60 * (r > 0 ? sin(r) / r : 1);
                if (k == 0)
                    rig_move(&d, x, y);
                else
                    rig_draw(&d, x, y);
            }
    return d;
}

/* What every trace must be. */
static void assert_legal(const char *name, const rig_drawing_t *d, const machine_t *m, const rig_run_t *r) {
    assert_int_equal(r->error, 0);
    assert_int_equal(r->stats.position_steps[0], 0);
    assert_int_equal(r->stats.position_steps[1], 0);
    assert_int_equal(r->stats.starved, 0);
    if (!r->prepared) assert_int_equal(r->stats.late, 0); /* no step was planned for a time gone by */
    trace_judgement_t j;
    assert_int_equal(trace_judge(&r->trace, m, &j), 0);
    double deviation = rig_deviation_steps(d, m, &r->trace);
    if (!j.legal || deviation > 1) {
        print_message("%s: %.3f steps off the path\n", name, deviation);
        trace_print(&j, m, stdout);
    }
    assert_true(j.legal);
    assert_true(deviation <= 1);
    for (int k = 0; k < 2; k++) assert_true(j.axis[k].steps == r->stats.steps[k]);
    assert_true(j.lifts == r->stats.lifts && j.lifts == d->strokes);
}

typedef struct reference {
    const char *name;
    rig_drawing_t drawing;
    double grbl; /* Grbl 1.1h on such a drawing: its time over its ideal (cycle-exact simulation) */
} reference_t;

static void test_reference_drawings(void **state) {
    (void)state;
    reference_t list[] = {
        {"line 100 mm", line_at(0), 1.71 / 1.541},
        {"line 30 degrees", line_at(30), 1.71 / 1.541},
        {"star 1307 mm", star(), 16.17 / 16.33},
        {"spiral 6480 mm", spiral(), 80.34 / 80.74},
        {"2000 of 0.5-1 mm", curved(0.5, 1), 16.99 / 17.14},
        {"2000 of 0.05-0.15", curved(0.05, 0.15), 7.70 / 5.17},
        {"sinc 40x40", sinc(), 183.6 / 185.5},
    };
    machine_t m = default_machine();
    printf("# %-18s %9s %9s %8s %8s %8s %7s %8s %8s %8s\n", "drawing", "ideal s", "ours s", "ratio", "32 block", "Grbl",
           "accel", "jump", "off path", "in time");
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        rig_drawing_t *d = &list[i].drawing;
        double ideal = rig_ideal_s(d, &m);
        rig_run_t r = rig_run(d, &m, MOTION_BYTES_HOST, NULL);
        assert_legal(list[i].name, d, &m, &r);
        double ours = (double)r.stats.ticks / HAL_TICK_HZ, ratio = ours / ideal;
        double small = rig_estimate_s(d, &m, 32 * sizeof(planner_block_t)) / ideal;
        trace_judgement_t j;
        trace_judge(&r.trace, &m, &j);
        printf("# %-18s %9.4f %9.4f %8.5f %8.5f %8.3f %7.0f %8.2f %8.3f %8.3f\n", list[i].name, ideal, ours, ratio,
               small, list[i].grbl, j.max_accel, fmax(j.axis[0].max_jump_mm_s, j.axis[1].max_jump_mm_s),
               rig_deviation_steps(d, &m, &r.trace), rig_timed_deviation_steps(d, &m, &r.trace));
        assert_true(ratio < 1.0005 && ratio > 0.9995);
        assert_true(fabs(rig_estimate_s(d, &m, MOTION_BYTES_HOST) - ours) < 1e-4);
        trace_free(&r.trace);
        rig_free(d);
    }
}

/* Every single step of a line at the moment when the ideal pen passes the half between two steps. */
static void test_every_step_on_time(void **state) {
    (void)state;
    static const double angle[] = {0, 0.1, 1, 17, 30, 44.9, 45, 60, 89.95, 90, 135, 170, 200, 333};
    machine_t m = default_machine();
    double worst_us = 0, worst_jump = 0;
    for (size_t i = 0; i < sizeof angle / sizeof angle[0]; i++) {
        rig_drawing_t d = {0};
        motion_ref_point_t p[2];
        rig_move(&d, 150, 120);
        rig_draw(&d, 150 + 100 * cos(angle[i] * PI / 180), 120 + 100 * sin(angle[i] * PI / 180));
        p[0] = d.point[0], p[1] = d.point[1];
        motion_ref_limits_t limits = {100, 1000, 0.01};
        motion_ref_line_t line;
        motion_ref_run(p, 2, &limits, &line);
        rig_run_t r = rig_run(&d, &m, MOTION_BYTES_HOST, NULL);
        assert_legal("line", &d, &m, &r);
        double from[2] = {p[0].x, p[0].y}, to[2] = {p[1].x, p[1].y}, start = 0, last_speed[2] = {0}, last_time[2] = {0};
        int64_t pos[2] = {0, 0};
        bool down = false;
        for (size_t e = 0; e < r.trace.count; e++) {
            const trace_event_t *ev = &r.trace.events[e];
            double now = (double)ev->time_ps * 1e-12;
            if (ev->changed & HAL_PEN) {
                down = ev->pins & HAL_PEN;
                start = now + m.lower_us * 1e-6;
            }
            for (int k = 0; k < 2; k++) {
                if (!(ev->changed & ev->pins & (k ? HAL_Y_STEP : HAL_X_STEP))) continue;
                int way = ev->pins & (k ? HAL_Y_DIR : HAL_X_DIR) ? 1 : -1;
                double passed = ((double)pos[k] + 0.5 * way) / 80;
                pos[k] += way;
                if (!down) continue;
                double s = (passed - from[k]) / (to[k] - from[k]) * line.length;
                double error_us = fabs(now - start - motion_ref_when(&line, limits.accel, s)) * 1e6;
                worst_us = fmax(worst_us, error_us);
                double speed = last_time[k] > start ? 1 / 80.0 / (now - last_time[k]) : 0;
                if (last_speed[k] > 0 && speed > 0) worst_jump = fmax(worst_jump, fabs(speed - last_speed[k]));
                last_speed[k] = speed;
                last_time[k] = now;
            }
        }
        trace_free(&r.trace);
        rig_free(&d);
    }
    printf("# lines at 14 angles: steps within %.2f us of the exact time; speed jump per step at most %.2f mm/s (ideal "
           "3.1, "
           "Grbl 23)\n",
           worst_us, worst_jump);
    assert_true(worst_us < 3);
    assert_true(worst_jump < 3.1);
}

/* The same drawing on other machines: the path is the same, the motors differ. */
static void test_kinds_of_machine(void **state) {
    (void)state;
    rig_drawing_t d = curved(0.5, 1);
    for (int kind = 0; kind < 16; kind++) {
        machine_t m = default_machine();
        m.kinematics = kind & 1 ? MACHINE_COREXY : MACHINE_CARTESIAN;
        m.swap_xy = kind & 2;
        m.invert[0] = kind & 4;
        m.invert[1] = kind & 8;
        if (kind == 0) m.steps_per_mm_q16[1] = 100u << 16;
        m.pulse_ns = 3000;
        m.dir_setup_ns = 5000;
        rig_run_t r = rig_run(&d, &m, MOTION_BYTES_HOST, NULL);
        assert_legal("kind of machine", &d, &m, &r);
        trace_free(&r.trace);
    }
    rig_free(&d);
}

/* Fast, slow, coarse and fine machines; delays of zero. */
static void test_range_of_machines(void **state) {
    (void)state;
    static const struct {
        uint32_t steps_q16, draw, travel, accel, junction, pulse, setup, delay;
    } list[] = {
        {5u << 16, 100000, 200000, 1000000, 10, 2000, 1000, 0},
        {400u << 16, 100000, 200000, 5000000, 20, 1000, 500, 1000},
        {80u << 16, 500000, 500000, 10000000, 50, 2000, 1000, 5000},
        {80u << 16, 5000, 10000, 50000, 0, 10000, 20000, 100000},
        {(80u << 16) + 21845, 30000, 1000, 100000, 1000, 1000, 0, 300000},
        {80u << 16, 100000, 2000000, 1000, 10, 2000, 1000, 1000}, /* 1 mm/s^2: limits of speed are never reached */
        {80u << 16, 1000, 1000, 100000000, 10, 2000, 1000, 1000}, /* 1 mm/s */
    };
    rig_drawing_t d = curved(0.2, 1);
    rig_move(&d, 20, 20); /* a dot */
    rig_draw(&d, 20, 20);
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        machine_t m = default_machine();
        m.steps_per_mm_q16[0] = m.steps_per_mm_q16[1] = list[i].steps_q16;
        m.draw_speed_um_s = list[i].draw;
        m.travel_speed_um_s = list[i].travel;
        m.accel_um_s2 = list[i].accel;
        m.junction_um = list[i].junction;
        m.pulse_ns = list[i].pulse;
        m.dir_setup_ns = list[i].setup;
        m.lift_us = m.lower_us = list[i].delay;
        rig_run_t r = rig_run(&d, &m, MOTION_BYTES(4096, 64), NULL);
        assert_legal("range of machines", &d, &m, &r);
        double ratio = (double)r.stats.ticks / HAL_TICK_HZ / rig_ideal_s(&d, &m);
        if (!(ratio > 0.999 && ratio < 1.001)) print_message("machine %zu: %.5f of the ideal\n", i, ratio);
        assert_true(ratio > 0.999 && ratio < 1.001);
        trace_free(&r.trace);
    }
    rig_free(&d);
}

static void late(void) {
    sim_inject_late(7, 100);
}
static void wrapping(void) {
    sim_set_clock(0xfffff000u);
}

/* A late interrupt costs time, not steps, and nothing becomes too short. */
static void test_late_interrupts(void **state) {
    (void)state;
    machine_t m = default_machine();
    rig_drawing_t d = curved(0.5, 1);
    rig_run_t on_time = rig_run(&d, &m, MOTION_BYTES_HOST, NULL), r = rig_run(&d, &m, MOTION_BYTES_HOST, late);
    assert_legal("late", &d, &m, &r);
    assert_true(r.stats.late > 1000);
    assert_true(r.stats.steps[0] == on_time.stats.steps[0] && r.stats.steps[1] == on_time.stats.steps[1]);
    trace_free(&r.trace);
    r = rig_run(&d, &m, MOTION_BYTES_HOST, wrapping);
    trace_difference_t difference;
    assert_int_equal(trace_compare(&r.trace, &on_time.trace, 0, false, &difference), 0);
    assert_true(difference.same_sequence && difference.max_us == 0);
    trace_free(&r.trace);
    trace_free(&on_time.trace);
    rig_free(&d);
}

/* Sharp turns back and forth at every phase of a step: the worst case of rounding. */
static void test_turns_between_steps(void **state) {
    (void)state;
    static const double size[] = {0.006, 0.03, 0.2, 3};
    machine_t m = default_machine();
    rig_drawing_t d = {0};
    seed = 99;
    for (int stroke = 0; stroke < 40; stroke++) {
        double x = 50 + uniform(), y = 50 + uniform(), s = size[stroke % 4];
        rig_move(&d, x, y);
        for (int i = 0; i < 60; i++) {
            double dx = uniform() - 0.5, dy = uniform() - 0.5;
            rig_draw(&d, x + s * dx, y + s * dy);
        }
    }
    rig_run_t r = rig_run(&d, &m, MOTION_BYTES_HOST, NULL);
    trace_judgement_t j;
    trace_judge(&r.trace, &m, &j);
    printf("# turns at every phase of a step: shortest interval %.1f us, %.3f steps off the path\n",
           fmin((double)j.axis[0].min_interval_ps, (double)j.axis[1].min_interval_ps) * 1e-6,
           rig_deviation_steps(&d, &m, &r.trace));
    assert_legal("turns", &d, &m, &r);
    trace_free(&r.trace);
    rig_free(&d);
}

/* A motor that turns round, goes back by less than a step, and goes on: steps that were left out at the first turn are
 * due at once in the next line, and the others of that line when the plan has the pen there. */
static void test_trembling(void **state) {
    (void)state;
    machine_t m = default_machine();
    rig_drawing_t d = {0};
    seed = 3;
    for (int stroke = 0; stroke < 100; stroke++) {
        double x = 20 + 10 * uniform(), y = 20 + 10 * uniform(), size = 0.05 * (1 << stroke % 5);
        rig_move(&d, x, y);
        for (int i = 0; i < 100; i++) {
            double along = size * (0.1 + uniform()), across = size * uniform(), back = -0.004 * uniform();
            bool on = i % 3;
            x += stroke % 2 ? along : on ? across : back;
            y += stroke % 2 ? on ? across : back : along;
            rig_draw(&d, x, y);
        }
    }
    rig_run_t r = rig_run(&d, &m, MOTION_BYTES_HOST, NULL);
    double in_time = rig_timed_deviation_steps(&d, &m, &r.trace);
    printf("# trembling motors: pen within %.3f steps of the ideal one at any moment\n", in_time);
    assert_legal("trembling", &d, &m, &r);
    assert_true(in_time < 1);
    trace_free(&r.trace);
    rig_free(&d);
}

/* The smallest memory still draws everything, only slower. */
static void test_smallest_memory(void **state) {
    (void)state;
    machine_t m = default_machine();
    rig_drawing_t d = curved(0.05, 0.15);
    double ideal = rig_ideal_s(&d, &m);
    static const size_t blocks[] = {8, 16, 32, 64, 128};
    printf("# look-ahead of 2000 lines of 0.05-0.15 mm, time over ideal:");
    for (size_t i = 0; i < 5; i++) {
        rig_run_t r = rig_run(&d, &m, MOTION_BYTES(blocks[i], 8), NULL);
        assert_legal("small", &d, &m, &r);
        printf(" %zu blocks (%u bytes) %.3f", blocks[i], r.stats.memory_bytes,
               (double)r.stats.ticks / HAL_TICK_HZ / ideal);
        trace_free(&r.trace);
    }
    printf("\n");
    motion_t motion;
    uint64_t memory[8];
    assert_int_equal(motion_init(&motion, &m, memory, sizeof memory), ERR_FULL);
    rig_free(&d);
}

/* Outside the machine's reach: nothing of the move is stepped, the pen goes home. */
static void test_soft_limits(void **state) {
    (void)state;
    machine_t m = default_machine();
    m.width_um = 200000;
    m.height_um = 100000;
    static const double outside[][2] = {{200.1, 50}, {50, 100.1}, {-0.1, 50}, {50, -0.1}};
    for (int i = 0; i < 8; i++) {
        rig_drawing_t d = {0};
        rig_move(&d, 10, 10);
        rig_draw(&d, 200, 100);
        if (i < 4)
            rig_draw(&d, outside[i][0], outside[i][1]);
        else
            rig_move(&d, outside[i - 4][0], outside[i - 4][1]);
        rig_run_t r = rig_run(&d, &m, MOTION_BYTES_HOST, NULL);
        assert_int_equal(r.error, ERR_MACHINE);
        trace_judgement_t j;
        trace_judge(&r.trace, &m, &j);
        assert_true(j.legal);
        assert_true(j.axis[0].min_steps == 0 && j.axis[0].max_steps == 200 * 80);
        assert_true(j.axis[1].min_steps == 0 && j.axis[1].max_steps == 100 * 80);
        trace_free(&r.trace);
        rig_free(&d);
    }
}

static void test_impossible_machines(void **state) {
    (void)state;
    static uint64_t memory[MOTION_BYTES_HOST / 8];
    motion_t motion;
    machine_t m = default_machine();
    m.steps_per_mm_q16[1] = 2000u << 16; /* 200,000 steps/s with pulses of 2 us */
    assert_int_equal(motion_init(&motion, &m, memory, sizeof memory), ERR_MACHINE);
    m = default_machine();
    m.steps_per_mm_q16[0] = 0;
    assert_int_equal(motion_init(&motion, &m, memory, sizeof memory), ERR_MACHINE);
    m = default_machine();
    m.accel_um_s2 = 0;
    assert_int_equal(motion_init(&motion, &m, memory, sizeof memory), ERR_MACHINE);
    assert_int_equal(motion_init_estimate(&motion, &m, memory, sizeof memory), ERR_MACHINE);
    motion_stats_t stats;
    assert_int_equal(motion_finish(&motion, &stats), ERR_MACHINE);
}

/* An empty drawing does not even switch the motors on. */
static void test_nothing_to_draw(void **state) {
    (void)state;
    machine_t m = default_machine();
    rig_drawing_t d = {0};
    rig_move(&d, 10, 10);
    rig_run_t r = rig_run(&d, &m, MOTION_BYTES_HOST, NULL);
    assert_int_equal(r.error, 0);
    assert_int_equal(r.trace.count, 0);
    assert_true(r.stats.ticks == 0);
    rig_free(&d);
}

/* Drawings made of integers alone, so that no libm can change them. */
static rig_drawing_t golden_drawing(int which) {
    rig_drawing_t d = {0};
    seed = (uint32_t)which;
    if (which == 0) {
        rig_move(&d, 10, 10);
        rig_draw(&d, 110, 10);
    } else if (which == 1) {
        for (int i = 0; i < 200; i++) {
            double x = uniform() * 200, y = uniform() * 150;
            if (i % 10 == 0)
                rig_move(&d, x, y);
            else
                rig_draw(&d, x, y);
        }
    } else { /* a circle of 3,000 lines by x += y/512, y -= x/512 */
        double x = 40, y = 0;
        rig_move(&d, 100 + x, 100 + y);
        for (int i = 0; i < 3000; i++) {
            x += y / 512;
            y -= x / 512;
            rig_draw(&d, 100 + x, 100 + y);
        }
    }
    return d;
}

static int to_nowhere(void *ctx, const char *text, size_t bytes) {
    (void)text;
    *(size_t *)ctx += bytes;
    return 0;
}

/* Not judged, since machines differ: what simulating and estimating cost. */
static void test_speed(void **state) {
    (void)state;
    static vcd_t vcd;
    static uint64_t memory[MOTION_BYTES_HOST / 8];
    rig_drawing_t d = golden_drawing(1), fine = curved(0.05, 0.15);
    machine_t m = default_machine();
    motion_t motion;
    motion_stats_t stats;
    size_t bytes = 0;
    clock_t start = clock();
    sim_reset();
    assert_int_equal(motion_init(&motion, &m, memory, sizeof memory), 0);
    vcd_begin(&vcd, to_nowhere, &bytes, &m, NULL, 0);
    sim_record(vcd_record, &vcd);
    rig_feed(&d, &motion);
    assert_int_equal(motion_finish(&motion, &stats), 0);
    vcd_end(&vcd, sim_now());
    double simulated = (double)(clock() - start) / CLOCKS_PER_SEC;
    start = clock();
    for (int i = 0; i < 100; i++) rig_estimate_s(&fine, &m, MOTION_BYTES_HOST);
    double estimated = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("# simulator: %.1f M steps/s, VCD of %.0f MB written on the way; estimate: %.0f ns per segment\n",
           (double)(stats.steps[0] + stats.steps[1]) / simulated * 1e-6, (double)bytes * 1e-6,
           estimated / 100 / 2000 * 1e9);
    rig_free(&d);
    rig_free(&fine);
}

static void test_golden(void **state) {
    (void)state;
    static const char *const name[] = {"line", "polygons", "circle"};
    FILE *f = fopen(GOLDEN, "r");
    char have[3][160] = {"", "", ""};
    for (int i = 0; f && i < 3; i++)
        if (!fgets(have[i], sizeof have[i], f)) have[i][0] = 0;
    if (f) fclose(f);
    bool same = true;
    machine_t m = default_machine();
    for (int i = 0; i < 3; i++) {
        rig_drawing_t d = golden_drawing(i);
        rig_run_t r = rig_run(&d, &m, MOTION_BYTES_HOST, NULL);
        char now[160];
        snprintf(now, sizeof now, "%s: %llu x steps, %llu y steps, %u strokes, %llu ticks, trace %016llx\n", name[i],
                 (unsigned long long)r.stats.steps[0], (unsigned long long)r.stats.steps[1], r.stats.strokes,
                 (unsigned long long)r.stats.ticks, (unsigned long long)r.hash);
        if (strcmp(now, have[i]) != 0) {
            print_message("%s should be\n%sbut is\n%s", GOLDEN, have[i], now);
            same = false;
        }
        trace_free(&r.trace);
        rig_free(&d);
    }
    assert_true(same);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reference_drawings),
        cmocka_unit_test(test_every_step_on_time),
        cmocka_unit_test(test_kinds_of_machine),
        cmocka_unit_test(test_range_of_machines),
        cmocka_unit_test(test_late_interrupts),
        cmocka_unit_test(test_turns_between_steps),
        cmocka_unit_test(test_trembling),
        cmocka_unit_test(test_smallest_memory),
        cmocka_unit_test(test_soft_limits),
        cmocka_unit_test(test_impossible_machines),
        cmocka_unit_test(test_nothing_to_draw),
        cmocka_unit_test(test_golden),
        cmocka_unit_test(test_speed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
