/* VCD there and back: sim/vcd.h writes, host/trace.h reads; files of other tools, and files that are none. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "hal/hal.h"
#include "host/trace.h"
#include "sim/vcd.h"

#define DECLARE                                                                                                        \
    "$timescale 1 us $end $var wire 1 a x_step $end $var wire 1 b x_dir $end $var wire 1 c y_step $end "               \
    "$var wire 1 d y_dir $end $var wire 1 e pen $end $var wire 1 f enable $end $enddefinitions $end\n"

typedef struct text {
    char *text;
    size_t used, room;
    int fail_after;
} text_t;

static int append(void *ctx, const char *s, size_t bytes) {
    text_t *t = ctx;
    if (t->fail_after && --t->fail_after == 0) return ERR_FILE;
    if (t->used + bytes > t->room) t->text = realloc(t->text, t->room = 2 * (t->used + bytes));
    memcpy(t->text + t->used, s, bytes);
    t->used += bytes;
    return 0;
}

static trace_t read_ok(const char *text) {
    trace_t t;
    trace_error_t e;
    int err = trace_read_text(text, strlen(text), &t, &e);
    if (err) print_message("line %lu: %s\n", e.line, e.text);
    assert_int_equal(err, 0);
    return t;
}

static void test_there_and_back(void **state) {
    (void)state;
    enum { N = 200000 };
    static uint64_t tick[N];
    static uint8_t pins[N];
    static vcd_t v;
    text_t text = {0};
    machine_t m;
    machine_default(&m);
    m.kinematics = MACHINE_COREXY;
    m.invert[1] = true;
    m.steps_per_mm_q16[0] = 123456;
    m.lift_us = 77;
    vcd_begin(&v, append, &text, &m, "a title $end is not let through", 0x2a);
    uint32_t seed = 5;
    uint64_t now = 0;
    uint8_t p = 0x2a;
    for (int i = 0; i < N; i++) {
        seed = seed * 1664525u + 1013904223u;
        now += 1 + (seed >> 12) % (i % 1000 ? 3000 : 4000000000u);
        uint8_t changed = (uint8_t)(1 + (seed >> 5) % 63);
        p ^= changed;
        tick[i] = now;
        pins[i] = p;
        vcd_record(&v, now, p, changed);
    }
    assert_int_equal(vcd_end(&v, now + 9), 0);
    trace_t t;
    trace_error_t e;
    assert_int_equal(trace_read_text(text.text, text.used, &t, &e), 0);
    assert_int_equal(t.count, N);
    assert_int_equal(t.initial, 0x2a);
    for (int i = 0; i < N; i++) {
        assert_true((t.events[i].time_ps + 31250) / 62500 == tick[i]);
        assert_int_equal(t.events[i].pins, pins[i]);
    }
    assert_true(t.end_ps / 1000 == (now + 9) * 125 / 2);
    assert_true(t.has_machine && t.has_pen && t.has_enable);
    assert_true(t.machine.kinematics == MACHINE_COREXY && t.machine.invert[1] && !t.machine.invert[0]);
    assert_true(t.machine.steps_per_mm_q16[0] == 123456 && t.machine.lift_us == 77 && t.machine.pulse_ns == 2000);
    trace_free(&t);

    FILE *f = tmpfile(); /* the same through a file: chunks end anywhere */
    fwrite(text.text, 1, text.used, f);
    rewind(f);
    assert_int_equal(trace_read(f, &t, &e), 0);
    assert_int_equal(t.count, N);
    fclose(f);
    trace_free(&t);
    free(text.text);
}

static void test_write_errors_are_kept(void **state) {
    (void)state;
    static vcd_t v;
    text_t text = {.fail_after = 2};
    vcd_begin(&v, append, &text, NULL, NULL, 0);
    for (uint64_t i = 1; i < 100000; i++) vcd_record(&v, i, i & 1, 1);
    assert_int_equal(vcd_end(&v, 100000), ERR_FILE);
    free(text.text);
}

/* Long identifiers, one for two names, vectors of one bit, reals, x and z, scopes, sections among the changes. */
static void test_other_tools(void **state) {
    (void)state;
    trace_t t = read_ok("$date today $end $version some tool 1.2 $end\n"
                        "$comment $var is not a declaration in here $end\n"
                        "$timescale\n  10 ns\n$end\n$scope module top $end $scope module pins $end\n"
                        "$var reg 1 !# x_step $end\n$var wire 1 (k x_dir [0] $end $var wire 8 %% bus [7:0] $end\n"
                        "$var wire 1 \"long! y_step $end $var wire 1 s y_dir $end $var real 64 r volts $end\n"
                        "$upscope $end $upscope $end $enddefinitions $end\n"
                        "#100 $dumpvars x!# 0(k bxxxxxxxx %% z\"long! 1s r0.5 r $end\n"
                        "#110\n1!#\n#111 0!# b00000001 %%\n#120 $comment 1!# $end b1 !#\n#121\nb0 !#\n#130 1\"long! "
                        "1(k\n#135 x\"long! U(k\n"
                        "$dumpoff x!# x(k $end #140 $dumpon 0!# $end\n#200\n");
    assert_int_equal(t.initial, HAL_Y_DIR);
    assert_int_equal(t.count, 6);
    assert_true(t.unit_ps == 10000 && t.end_ps == 2000000);
    assert_true(!t.has_pen && !t.has_enable && !t.has_machine);
    assert_true(t.events[0].time_ps == 1100000 && t.events[0].changed == HAL_X_STEP);
    assert_true(t.events[4].time_ps == 1300000 && t.events[4].changed == (HAL_Y_STEP | HAL_X_DIR));
    assert_true(t.events[5].pins == HAL_Y_DIR);
    trace_free(&t);

    /* A pulse of no width is two events. */
    t = read_ok(DECLARE "#0 0a #5 1a 0a #6");
    assert_int_equal(t.count, 2);
    trace_free(&t);

    /* Changes without a time are the beginning; the first time after them is not. */
    t = read_ok(DECLARE "1f #7 1a");
    assert_true(t.initial == HAL_ENABLE && t.count == 1 && t.events[0].time_ps == 7000000);
    trace_free(&t);

    t = read_ok(DECLARE); /* no change at all */
    assert_true(t.count == 0 && t.end_ps == 0);
    trace_free(&t);

    static const struct {
        const char *scale;
        uint64_t ps;
    } scale[] = {{"1s", 1000000000000}, {"100 ms", 100000000000}, {"1 ps", 1}, {"100 fs", 1}};
    for (size_t i = 0; i < 4; i++) {
        char text[512];
        snprintf(text, sizeof text, "$timescale %s $end %s", scale[i].scale, strchr(DECLARE, 'd') + 1);
        t = read_ok(text);
        assert_true(t.unit_ps == scale[i].ps);
        trace_free(&t);
    }
}

static void test_malformed(void **state) {
    (void)state;
    static const struct {
        const char *text;
        unsigned long line;
    } bad[] = {
        {"", 1},
        {"hello", 1},
        {"\n\nP6 640 480", 3},
        {"$timescale 2 ns $end", 1},
        {"$timescale 1 hour $end", 1},
        {"$timescale 1000 ns $end", 1},
        {"$timescale ns $end", 1},
        {"$timescale 1 ns", 1},
        {"$var wire 1 a x_step", 1},
        {"$var wire 1 $end", 1},
        {"$var wire one a x_step $end", 1},
        {"$var wire 2 a x_step $end", 1},
        {"$var wire 1 abcdefghijklmnopqrstuvwxyz x_step $end", 1},
        {"$comment never ends\n\n", 3},
        {"$comment ridgeline machine draw_um_s fast $end", 1},
        {"$comment ridgeline machine steps_per_mm_q16 0 5 $end", 1},
        {"$comment ridgeline machine draw_um_s", 1},
        {"$var wire 1 a x_step $end $enddefinitions $end", 1},
        {"$timescale 1 ns $end\n$var wire 1 a x_step $end\n$enddefinitions $end", 3},
        {"$timescale 1 ns $end", 1},
        {DECLARE "#1\n1a\n#0\n", 4},
        {DECLARE "#x\n", 2},
        {DECLARE "#\n", 2},
        {DECLARE "#99999999999999999999\n", 2},
        {DECLARE "#18446744073709551615\n", 2},
        {DECLARE "#1 1\n", 2},
        {DECLARE "#1 q\n", 2},
        {DECLARE "#1 b a\n", 2},
        {DECLARE "#1\n\nb1", 4},
        {DECLARE "#1 $what $end", 2},
        {DECLARE "#1 $comment", 2},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        trace_t t;
        trace_error_t e;
        int err = trace_read_text(bad[i].text, strlen(bad[i].text), &t, &e);
        if (err != ERR_DATA || e.line != bad[i].line)
            print_message("%s: %d, line %lu: %s\n", bad[i].text, err, e.line, e.text);
        assert_int_equal(err, ERR_DATA);
        assert_int_equal(e.line, bad[i].line);
        assert_true(e.text[0] && t.count == 0 && !t.events);
    }
    trace_t t;
    trace_error_t e;
    assert_int_equal(trace_read_text(DECLARE "\0\1\0", sizeof DECLARE + 2, &t, &e), ERR_DATA);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_there_and_back),
        cmocka_unit_test(test_write_errors_are_kept),
        cmocka_unit_test(test_other_tools),
        cmocka_unit_test(test_malformed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
