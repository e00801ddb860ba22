/* test_plotter.c - a drawing on the simulated plotter: the trace file, and the estimate that does without stepping. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "error.h"
#include "hal/hal.h"
#include "host/plotter.h"
#include "sim/sim.h"

static void draw_square(drawing_t *d, int32_t mm) {
    pen_sink_t s = drawing_sink(d);
    int32_t a = 10 * LAT_PER_MM, b = (10 + mm) * LAT_PER_MM;
    s.move(s.ctx, (page_point_t){a, a});
    s.draw(s.ctx, (page_point_t){b, a});
    s.draw(s.ctx, (page_point_t){b, b});
    s.draw(s.ctx, (page_point_t){a, b});
    s.draw(s.ctx, (page_point_t){a, a});
    s.move(s.ctx, (page_point_t){a, 2 * a});
    s.draw(s.ctx, (page_point_t){b, 2 * a});
}

static void estimate_is_the_time_of_the_trace(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    draw_square(&d, 30);
    machine_t m;
    machine_default(&m);
    motion_stats_t stats;
    assert_int_equal(plotter_estimate(&d, &m, &stats), 0);
    assert_int_equal(stats.lifts, 2);
    char path[64];
    snprintf(path, sizeof path, "/tmp/ridgeline-test-%d.vcd", (int)getpid());
    assert_int_equal(plotter_write_vcd(&d, &m, path), 0);
    double simulated = (double)sim_now() / HAL_TICK_HZ, estimated = (double)stats.ticks / HAL_TICK_HZ;
    assert_true(fabs(simulated / estimated - 1) < 0.01);
    drawing_length_t len = drawing_measure(&d);
    assert_true(fabs((double)stats.down_lat / LAT_PER_MM - len.down_mm) < 0.01);

    FILE *f = fopen(path, "r");
    assert_non_null(f);
    char text[4096];
    size_t n = fread(text, 1, sizeof text - 1, f);
    text[n] = 0;
    fclose(f);
    remove(path);
    assert_non_null(strstr(text, "x_step"));
    assert_non_null(strstr(text, "$enddefinitions"));
    drawing_free(&d);
}

static void what_cannot_be_drawn_is_an_error(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    draw_square(&d, 30);
    machine_t m;
    machine_default(&m);
    motion_stats_t stats;
    m.width_um = 20000; /* the square needs 40 mm */
    m.height_um = 20000;
    assert_int_equal(plotter_estimate(&d, &m, &stats), ERR_MACHINE);
    assert_int_equal(plotter_write_vcd(&d, &m, "/dev/null"), ERR_MACHINE);
    assert_int_equal(access("/dev/null", W_OK), 0); /* a device is never removed */
    machine_default(&m);
    m.accel_um_s2 = 0;
    assert_int_equal(plotter_estimate(&d, &m, &stats), ERR_MACHINE);
    machine_default(&m);
    assert_int_equal(plotter_write_vcd(&d, &m, "/nonexistent/a.vcd"), ERR_FILE);
    drawing_free(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(estimate_is_the_time_of_the_trace),
        cmocka_unit_test(what_cannot_be_drawn_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
