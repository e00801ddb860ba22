/* trace.h: each kind of illegal motion is found, comparing, and the ink. Traces are written by hand, in us. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "hal/hal.h"
#include "host/trace.h"

#define HEAD                                                                                                           \
    "$timescale 1 us $end $var wire 1 a x_step $end $var wire 1 b x_dir $end $var wire 1 c y_step $end "               \
    "$var wire 1 d y_dir $end $var wire 1 e pen $end $var wire 1 f enable $end $enddefinitions $end\n"                 \
    "#0 0a 0b 0c 0d 0e 0f\n"
#define FORTH "#1000 1f #2000 1b #10000 1a #10002 0a "
#define BACK "#400000 0b #410000 1a #410002 0a "

static trace_t read_text(const char *text) {
    trace_t t;
    trace_error_t e;
    assert_int_equal(trace_read_text(text, strlen(text), &t, &e), 0);
    return t;
}

static trace_judgement_t judged(const char *text) {
    trace_t t = read_text(text);
    trace_judgement_t j;
    assert_int_equal(trace_judge(&t, &t.machine, &j), 0);
    FILE *null = fopen("/dev/null", "w");
    trace_print(&j, &t.machine, null);
    fclose(null);
    trace_free(&t);
    return j;
}

static void test_legal(void **state) {
    (void)state;
    trace_judgement_t j =
        judged(HEAD FORTH "#20000 1e #120000 1c #120002 0c #121000 1d #130000 1c #130002 0c #140000 0e "
                          "#250000 0d #260000 1c #260002 0c #261000 1d #270000 1c #270002 0c #280000 0d "
                          "#290000 1c #290002 0c #300000 1c #300002 0c #310000 1d #320000 1c #320002 0c "
                          "#330000 1c #330002 0c " BACK "#500000 0f");
    assert_true(j.legal);
    assert_true(j.axis[0].steps == 2 && j.axis[1].steps == 8 && j.axis[1].min_steps == -2 && j.axis[1].max_steps == 0);
    assert_true(fabs(j.duration_s - 0.499) < 1e-9 && fabs(j.down_s - 0.12) < 1e-9 && j.lifts == 1);
    assert_true(j.axis[0].min_pulse_ps == 2000000 && j.axis[0].min_setup_ps == 8000000000);
    assert_true(fabs(j.settle_lower_s - 0.1) < 1e-9 && fabs(j.settle_lift_s - 0.12) < 1e-9);
}

static void test_each_fault(void **state) {
    (void)state;
    assert_true(judged(HEAD FORTH BACK "#500000 0f").legal);
    trace_judgement_t j = judged(HEAD FORTH "#500000 0f");
    assert_true(!j.legal && !j.ends_home && j.axis[0].end_steps == 1);
    j = judged(HEAD FORTH BACK "#500000 1e #600000 0f");
    assert_true(!j.legal && !j.ends_up && j.ends_home);
    j = judged(HEAD FORTH BACK);
    assert_true(!j.legal && !j.ends_disabled);
    j = judged(HEAD FORTH BACK "#500000 0f #600000 1a #600002 0a #700000 1b #710000 1a #710002 0a");
    assert_true(!j.legal && j.disabled == 2);
    j = judged(HEAD FORTH "#12000 1a #12001 0a #20000 0b #30000 1a #30003 0a " BACK "#500000 0f");
    assert_true(!j.legal && j.short_pulses == 1 && j.axis[0].max_pulse_ps == 3000000);
    j = judged(HEAD "#1000 1f #2000 1b 1a #2002 0a " BACK "#500000 0f");
    assert_true(!j.legal && j.short_setups == 1);
    j = judged(HEAD "#1000 1f #2000 1b #10000 1a #10001 0b #10002 0a #20000 1a #20002 0a #500000 0f");
    assert_true(!j.legal && j.turned_high == 1);
    j = judged(HEAD "#500 1f #600 1e #2000 1b #10000 1a #10002 0a #20000 0e " BACK "#500000 0f");
    assert_true(!j.legal && j.unsettled == 1);
    assert_true(judged(HEAD).legal);
}

/* When the n-th of 1000 steps of 0.0125 mm is made, s after the start: up to 100 mm/s at 1000 mm/s^2 and down again. */
static double step_time(int n) {
    double s = (n + 0.5) * 0.0125, most = 12.5, ramp = 5;
    if (s < ramp) return sqrt(2 * s / 1000);
    if (s > most - ramp) return 0.1 + (most - 2 * ramp) / 100 + 0.1 - sqrt(2 * (most - s) / 1000);
    return 0.1 + (s - ramp) / 100;
}

static int by_time(const void *a, const void *b) {
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* 1000 steps to the right and back; of those to the right one comes late by so much (or early). */
static trace_judgement_t there_and_back(int displaced, double late_s) {
    static char text[100000];
    double at[1000];
    int used = snprintf(text, sizeof text, HEAD "#1000 1f #2000 1b ");
    for (int way = 0; way < 2; way++) {
        for (int n = 0; n < 1000; n++) at[n] = step_time(n) + (way == 0 && n == displaced ? late_s : 0);
        qsort(at, 1000, sizeof *at, by_time);
        for (int n = 1; n < 1000; n++) at[n] = fmax(at[n], at[n - 1] + 4e-6); /* pulses do not overlap */
        if (way == 1) used += snprintf(text + used, sizeof text - (size_t)used, "#400000 0b ");
        for (int n = 0; n < 1000; n++) {
            long us = lrint(at[n] * 1e6) + (way ? 500000 : 10000);
            used += snprintf(text + used, sizeof text - (size_t)used, "#%ld 1a #%ld 0a ", us, us + 2);
        }
    }
    snprintf(text + used, sizeof text - (size_t)used, "#900000 0f");
    return judged(text);
}

static void test_steps_out_of_place(void **state) {
    (void)state;
    assert_true(there_and_back(-1, 0).legal);
    int tried = 0, found = 0;
    for (int n = 20; n < 980; n += 7) {
        for (int late = -600; late <= 600; late += 100) {
            if (abs(late) < 300) continue;
            trace_judgement_t j = there_and_back(n, late * 1e-6);
            double at = step_time(n) + 0.01;
            tried++;
            found += !j.legal && j.axis[0].misplaced && fabs(j.axis[0].misplaced_at_s - at) < 0.003;
        }
    }
    printf("# %d of %d single steps displaced by 0.3 to 0.6 ms are found\n", found, tried);
    assert_true(found == tried);
}

static void test_pen_changes_that_are_missing(void **state) {
    (void)state;
    assert_true(judged(HEAD FORTH "#20000 1e #125000 1a #125002 0a #130000 0e #235000 0b #240000 1a #240002 0a "
                                  "#250000 1a #250002 0a #500000 0f")
                    .legal);
    /* forth, lifted with nothing to see, back, lowered, forth */
    trace_judgement_t j = judged(HEAD FORTH "#15000 1e #120000 1a #120002 0a #225000 0b #230000 1a #230002 0a "
                                            "#335000 1a #335002 0a #336000 0e #500000 0f");
    assert_true(!j.legal && j.unchanged == 1 && fabs(j.unchanged_at_s - 0.12) < 1e-9);
}

/* Steps at a steady 200 mm/s from the first on: too fast, and no acceleration is enough. */
static void test_speed_and_acceleration(void **state) {
    (void)state;
    size_t room = 200000, used = 0;
    char *text = malloc(room);
    used += (size_t)snprintf(text, room, HEAD "#10 1f #20 1b ");
    int time = 1000;
    for (int i = 0; i < 4000; i++) {
        if (i == 2000) used += (size_t)snprintf(text + used, room - used, "#%d 0b\n", time += 100000);
        time += i % 2 ? 63 : 62;
        used += (size_t)snprintf(text + used, room - used, "#%d 1a #%d 0a\n", time, time + 2);
    }
    snprintf(text + used, room - used, "#%d 0f", time + 1000);
    trace_judgement_t j = judged(text);
    assert_true(!j.legal && !j.speed_ok && !j.accel_ok && j.ends_home);
    assert_true(fabs(j.max_speed_up - 200) < 1 && j.max_speed_down == 0);
    assert_true(j.max_accel > 5000 && fabs(j.up_mm - 50) < 0.1);
    free(text);
}

static trace_difference_t compared_at(const char *a, const char *b, double tolerance_us, bool rests) {
    trace_t ta = read_text(a), tb = read_text(b);
    trace_difference_t d;
    assert_int_equal(trace_compare(&ta, &tb, tolerance_us, rests, &d), 0);
    FILE *null = fopen("/dev/null", "w");
    trace_print_difference(&ta, &tb, &d, null);
    fclose(null);
    trace_free(&ta);
    trace_free(&tb);
    return d;
}

static trace_difference_t compared(const char *a, const char *b, double tolerance_us) {
    return compared_at(a, b, tolerance_us, false);
}

static void test_compare(void **state) {
    (void)state;
    trace_difference_t d = compared(HEAD FORTH BACK, HEAD FORTH BACK, 0);
    assert_true(d.same_sequence && d.max_us == 0 && d.compared == 7);
    /* all later: the same */
    d = compared(HEAD "#10 1f #20 1b #30 1a #32 0a", HEAD "#110 1f #120 1b #130 1a #132 0a", 0);
    assert_true(d.same_sequence && d.max_us == 0);
    d = compared(HEAD "#10 1f #20 1b #30 1a #32 0a", HEAD "#10 1f #20 1b #37 1a #39 0a", 0);
    assert_true(d.same_sequence && fabs(d.max_us - 7) < 1e-9 && fabs(d.mean_us - 3.5) < 1e-9 && d.at == 2);
    /* another order within the tolerance, and beyond it */
    d = compared(HEAD "#10 1f #20 1b 1d #30 1a", HEAD "#10 1f #20 1d #21 1b #30 1a", 1);
    assert_true(d.same_sequence && fabs(d.max_us - 1) < 1e-9);
    d = compared(HEAD "#10 1f #20 1b #25 1d #30 1a", HEAD "#10 1f #20 1d #25 1b #30 1a", 1);
    assert_true(!d.same_sequence && d.compared == 1 && d.at == 1 && d.event_a == 1 && d.event_b == 1);
    /* the edges of one pin keep their order however near they are */
    d = compared(HEAD "#10 1a #11 0a", HEAD "#10 1a #11 0a #12 1a #13 0a", 100);
    assert_true(!d.same_sequence && d.compared == 2 && d.event_a == 2 && d.event_b == 2);
    d = compared(HEAD, HEAD, 0);
    assert_true(d.same_sequence && d.compared == 0);
    d = compared(HEAD, HEAD "#5 1a", 0);
    assert_true(!d.same_sequence);
}

/* Longer with the pen up, but not where it was not lifted just before. */
static void test_compare_rests(void **state) {
    (void)state;
    const char *a = HEAD "#10 1e #20 0e #30 1a #32 0a #40 1a #42 0a";
    trace_difference_t d = compared_at(a, HEAD "#10 1e #20 0e #530 1a #532 0a #540 1a #542 0a", 1, true);
    assert_true(d.same_sequence && d.max_us == 0 && d.rests == 1 && fabs(d.rest_us - 500) < 1e-9);
    d = compared(a, HEAD "#10 1e #20 0e #530 1a #532 0a #540 1a #542 0a", 1);
    assert_true(d.same_sequence && fabs(d.max_us - 500) < 1e-9 && d.rests == 0);
    d = compared_at(a, HEAD "#10 1e #20 0e #30 1a #32 0a #540 1a #542 0a", 1, true);
    assert_true(d.same_sequence && fabs(d.max_us - 500) < 1e-9 && d.rests == 0);
}

typedef struct ink {
    double x[64], y[64];
    int strokes, points;
} ink_t;

static int ink_draw(void *ctx, page_point_t to) {
    ink_t *k = ctx;
    assert_true(k->points < 64);
    k->x[k->points] = to.x_lat / (double)LAT_PER_MM;
    k->y[k->points++] = to.y_lat / (double)LAT_PER_MM;
    return 0;
}

static int ink_move(void *ctx, page_point_t to) {
    ((ink_t *)ctx)->strokes++;
    return ink_draw(ctx, to);
}

/* A staircase of 1000 x 300 steps and back along x: three points. */
static void test_ink(void **state) {
    (void)state;
    size_t room = 400000, used = 0;
    char *text = malloc(room);
    used += (size_t)snprintf(text, room, HEAD "#10 1f #20 1b 1d #100000 1e #300000\n");
    int time = 300000, up = 0;
    for (int i = 0; i < 1000; i++) {
        time += 200;
        used += (size_t)snprintf(text + used, room - used, "#%d 1a #%d 0a\n", time, time + 2);
        if ((i * 300 + 500) / 1000 > up)
            up++, used += (size_t)snprintf(text + used, room - used, "#%d 1c #%d 0c\n", time + 50, time + 52);
    }
    used += (size_t)snprintf(text + used, room - used, "#%d 0b\n", time += 200);
    for (int i = 0; i < 400; i++) {
        time += 200;
        used += (size_t)snprintf(text + used, room - used, "#%d 1a #%d 0a\n", time, time + 2);
    }
    snprintf(text + used, room - used, "#%d 0e", time + 200);
    trace_t t = read_text(text);
    ink_t ink = {.strokes = 0};
    assert_int_equal(trace_ink(&t, &t.machine, (pen_sink_t){&ink, ink_move, ink_draw}), 0);
    assert_int_equal(ink.strokes, 1);
    assert_true(ink.points >= 3 && ink.points <= 4);
    assert_true(ink.x[0] == 0 && ink.y[0] == 0);
    assert_true(fabs(ink.x[1] - 12.5) < 0.02 && fabs(ink.y[1] - 3.75) < 0.02);
    assert_true(fabs(ink.x[ink.points - 1] - 7.5) < 1e-4 && fabs(ink.y[ink.points - 1] - 3.75) < 1e-4);
    t.machine.kinematics = MACHINE_COREXY; /* the same pins on another machine draw something else */
    ink = (ink_t){.strokes = 0};
    assert_int_equal(trace_ink(&t, &t.machine, (pen_sink_t){&ink, ink_move, ink_draw}), 0);
    assert_true(fabs(ink.x[1] - 16.25 / 2) < 0.02 && fabs(ink.y[1] - 8.75 / 2) < 0.02);
    trace_free(&t);
    free(text);
}

/* The command itself: exit statuses. */
static int command(const char *a, const char *b, const char *c, const char *d) {
    char *argv[] = {"trace", (char *)(uintptr_t)a, (char *)(uintptr_t)b, (char *)(uintptr_t)c, (char *)(uintptr_t)d,
                    NULL};
    int argc = 1;
    while (argc < 5 && argv[argc]) argc++;
    return trace_main(argc, argv);
}

static void write_file(const char *name, const char *text) {
    FILE *f = fopen(name, "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static void test_command(void **state) {
    (void)state;
    char dir[] = "/tmp/test_trace_XXXXXX", a[64], b[64], ink[64];
    assert_non_null(mkdtemp(dir));
    snprintf(a, sizeof a, "%s/a.vcd", dir);
    snprintf(b, sizeof b, "%s/b.vcd", dir);
    snprintf(ink, sizeof ink, "%s/ink.svg", dir);
    write_file(a, HEAD FORTH BACK "#500000 0f");
    write_file(b, HEAD FORTH BACK "#500001 0f");
    assert_int_equal(command(a, NULL, NULL, NULL), 0);
    assert_int_equal(command(a, a, NULL, NULL), 0);
    assert_int_equal(command(a, b, NULL, NULL), 1);
    assert_int_equal(command(a, b, "--tolerance", "2"), 0);
    assert_int_equal(command(a, "--pulse", "3", NULL), 1);
    assert_int_equal(command(a, "--steps", "40,80", NULL), 0);
    assert_int_equal(command(a, "-o", ink, NULL), 0);
    assert_int_equal(remove(ink), 0);
    assert_int_equal(command(a, "-o", "ink.nothing", NULL), 2);
    assert_int_equal(command(a, "--steps", "0", NULL), 2);
    assert_int_equal(command(a, "--what", NULL, NULL), 2);
    assert_int_equal(command(a, b, a, NULL), 2);
    assert_int_equal(command("/nowhere/a.vcd", NULL, NULL, NULL), 2);
    assert_int_equal(command(NULL, NULL, NULL, NULL), 2);
    write_file(b, HEAD "#5 nonsense");
    assert_int_equal(command(b, NULL, NULL, NULL), 2);
    assert_int_equal(command(a, b, NULL, NULL), 2);
    remove(a);
    remove(b);
    remove(dir);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_legal),
        cmocka_unit_test(test_each_fault),
        cmocka_unit_test(test_steps_out_of_place),
        cmocka_unit_test(test_pen_changes_that_are_missing),
        cmocka_unit_test(test_speed_and_acceleration),
        cmocka_unit_test(test_compare),
        cmocka_unit_test(test_compare_rests),
        cmocka_unit_test(test_ink),
        cmocka_unit_test(test_command),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
