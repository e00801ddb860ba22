/* console.h on the simulator: a person at the terminal. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/unit/console_fixture.h"

#define HEARD(text)                                                                                                    \
    do {                                                                                                               \
        if (!fix_heard(text)) print_message("not heard: %s\nbut:\n%s\n", text, fix.said);                              \
        assert_true(fix_heard(text));                                                                                  \
    } while (0)

#define SMALL "set paper 60,50 margin 5;set isosamples 8,8\r"

static int on(void **state) {
    (void)state;
    sim_store_erase();
    fix_power_on(sizeof fix.memory);
    return 0;
}

static void test_power_on(void **state) {
    (void)state;
    fix_run(SECOND);
    HEARD("Ridgeline 0.1.0 on sim");
    HEARD("> ");
    assert_int_equal(fix.pins, 0);
    assert_int_equal(fix.edges, 0);
    assert_false(sim_watchdog_bitten());
}

/* Rows that were on their way when one was refused are passed over, up to `e` or a command. */
static void test_refused_rows(void **state) {
    (void)state;
    fix_run(SECOND);
    fix_say("splot '-' solid\ro box\rv 0 0 0\rv 0 0 x\r", 50 * MS);
    HEARD("line 4, column 7: not a number");
    fix_forget();
    fix_say("v 0 1 0\rg side\rf 1 2 3\r\r# end\r E \rprint 2+3\r", 50 * MS);
    HEARD("\r\n5\r\n> ");
    assert_false(fix_heard("line "));
    fix_say("splot '-'\r0 0 z\r", 50 * MS);
    fix_forget();
    fix_say("0 1 2\r-1.5 1 1\rf(x)=x+1\rprint f(3)\r", 50 * MS);
    HEARD("\r\n4\r\n> ");
    assert_false(fix_heard("line "));
    fix_say("1 2 3\r", 50 * MS); /* a command again */
    HEARD("column 1");
    assert_int_equal(fix.edges, 0);
}

/* Commands of the board among those of the language. */
static void test_several_on_a_line(void **state) {
    (void)state;
    fix_run(SECOND);
    fix_say("a=3; pen down ;print a\r", SECOND);
    HEARD("\r\n3\r\n> ");
    assert_true(fix.pins & HAL_PEN);
    fix_forget();
    fix_say("pen\t up # lifts it\rprint '; pen down #', \"\\\"; pen down\"\rhome = 4; print home\r", SECOND);
    HEARD("; pen down # \"; pen down\r\n");
    HEARD("\r\n4\r\n> ");
    assert_false(fix.pins & HAL_PEN);
    fix_forget();
    fix_say("status; nonsense; pen down; print 5\r", SECOND); /* up to what is wrong */
    HEARD("<Idle");
    HEARD("column 9: ");
    assert_false(fix_heard("\r\n5\r\n"));
    assert_false(fix.pins & HAL_PEN);
    fix_forget();
    fix_say("splot '-'; pen down\r", SECOND);
    HEARD("rows come first");
    fix_say("0 0 x\r", SECOND);
    HEARD("not a number");
    assert_false(fix.pins & HAL_PEN);
    fix_forget();
    fix_say(SMALL "save\r", SECOND);
    HEARD("There is no plot to save yet."); /* what was refused is none */
    fix_say("splot '-'\r0 0 0\r1 0 1\r\r0 1 1\r1 1 0\re\r", 100 * SECOND);
    fix_say("save\rsplot x*y; save; print 6\r", 200 * SECOND);
    HEARD("A scene with inline data cannot be saved.");
    HEARD("saved\r\n6\r\n> ");
    fix_forget();
    fix_say("load; print 7\r", 200 * SECOND);
    HEARD("\r\n7\r\n> ");
    fix_forget();
    fix_say("status; print 8; status; pen down; pen up; print 9; status; home=1\r", SECOND);
    HEARD("Pen:up>\r\n8\r\n<Idle|MPos:0.000,0.000|Pen:up>\r\n9\r\n<Idle|MPos:0.000,0.000|Pen:up>\r\n> ");
}

static void test_editing(void **state) {
    (void)state;
    fix_say("prinx\b \bt 2\x7f 2+3\r", 50 * MS);
    HEARD("\r\n5\r\n> ");
    fix_forget();
    fix_say("garbage words\x15print 7*6\r", 50 * MS);
    HEARD("\r\n42\r\n> ");
    fix_forget();
    fix_say("\x1b[A\r", 50 * MS); /* Up */
    HEARD("print 7*6\r\n42\r\n> ");
    fix_forget();
    fix_say("xyz\x10\b7\r", 50 * MS); /* what was typed gives way, and is edited */
    HEARD("\r\n49\r\n> ");
    fix_forget();
    fix_say("print 1\r\nprint 2\nprint 3\r", 50 * MS); /* all ends of line */
    HEARD("print 1\r\n1\r\n> print 2\r\n2\r\n> print 3\r\n3\r\n> ");
    fix_forget();
    fix_say("\x1b[Dprint\x1b[3~ 8\x1bOB\r", 50 * MS); /* other keys do nothing */
    HEARD("\r\n8\r\n");
    fix_forget();
    fix_say("set title '\xc3\xa4\x7f\xc3\xb6'\rshow title\r", 50 * MS);
    HEARD("set title '\xc3\xb6'\r\n> ");
}

static void test_errors_lose_nothing(void **state) {
    (void)state;
    static char line[CONFIG_LINE_MAX + 100];
    fix_say("a = 17\r", 20 * MS);
    memset(line, '1', sizeof line - 2);
    line[sizeof line - 2] = '\r';
    line[sizeof line - 1] = '\0';
    fix_say(line, 300 * MS);
    HEARD("error: the line is too long and was not taken");
    fix_forget();
    fix_say("print \x01 5\rprint a\r", 50 * MS);
    HEARD("error: the line was damaged on its way and was not taken");
    HEARD("\r\n17\r\n");
    fix_forget();
    fix_say("a b c\rprint a\r", 50 * MS); /* an error of the language */
    HEARD("\r\n17\r\n");
}

/* Bytes that come while nobody reads: the port's queue runs over, and the line it happened to is refused. */
static void test_overrun(void **state) {
    (void)state;
    for (int i = 0; i < 60; i++) fix_type("print 123456\r");
    sim_run(SECOND); /* the main loop is busy elsewhere */
    fix_run(SECOND);
    fix_say("\rprint 55\r", 50 * MS);
    HEARD("\r\n123456\r\n");
    HEARD("error: the line was damaged");
    HEARD("\r\n55\r\n");
}

static void test_inline_data(void **state) {
    (void)state;
    fix_say(SMALL "splot '-'\r0 0 1\r0 1 ?\r0 2 1\r", 50 * MS);
    fix_say("1 0 \x02 1\r", 50 * MS); /* damaged: to be sent again */
    HEARD("the rows before it were");
    fix_say("1 0 1\r1 1 2\r1 2 1\r2 0 1\r2 1 1\r2 2 0\re\r", 60 * SECOND);
    assert_true(fix.steps[0] > 1000);
    assert_true(fix.pen_downs > 0);
    assert_int_equal(fix.at[0], 0);
    assert_int_equal(fix.at[1], 0);
    assert_null(strstr(fix.said, "<Idle")); /* ? at the beginning of a row is data */
    fix_forget();
    fix_say("replot\rprint 5\r", 60 * SECOND);
    assert_true(fix.steps[0] > 1000);
    HEARD("\r\n5\r\n");
    fix_say("save\r", SECOND);
    HEARD("inline data cannot be saved");
}

/* Sends a long script as a terminal with XON/XOFF does; nothing is lost although drawing takes long. */
static void test_flow_control(void **state) {
    (void)state;
    static char script[8000];
    size_t n = 0, sent = 0;
    for (int k = 0; k < 3; k++) {
        n += (size_t)sprintf(script + n, "set paper 40,30 margin 5\rset isosamples 4,4\rsplot x>0?y:%d\r", k);
        for (int i = 0; i < 30; i++) n += (size_t)sprintf(script + n, "print %d\r", 1000 * k + i);
    }
    fix.offs = 0;
    int slack = 20; /* bytes that are under way already when XOFF comes */
    while (sent < n) {
        if (!fix.off) slack = 20;
        for (int k = 0; k < 16 && sent < n && slack > 0; k++) {
            slack -= fix.off;
            sim_console_type(sim_now(), script + sent++, 1);
        }
        fix_run(5 * MS);
    }
    fix_run(SECOND);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 30; i++) {
            char number[24];
            sprintf(number, "\r\n%d\r\n", 1000 * k + i);
            HEARD(number);
        }
    assert_null(strstr(fix.said, "error"));
    printf("# script of %zu bytes with 3 drawings: stopped %d times, nothing lost\n", n, fix.offs);
}

static void test_save_and_load(void **state) {
    (void)state;
    fix_say(SMALL "f(u)=sin(u)/2; k=3  # a comment\rset view 50,40\rset zrange [*:5]; unset border\rset title "
                  "'It''s me'\rsplot f(k*x)*y\rsave\r",
            200 * SECOND);
    HEARD("saved\r\n");
    uint64_t steps[2] = {fix.steps[0], fix.steps[1]};
    assert_true(steps[0] > 1000);
    fix_power_on(sizeof fix.memory);
    fix_say("f(u)=7\rload\r", 200 * SECOND);
    assert_int_equal(fix.steps[0], steps[0]);
    assert_int_equal(fix.steps[1], steps[1]);
    fix_say("g(x)=x+1; h=5; nonsense; i=6\rh(x)=\rsave\rload\rprint g(h)\r", 200 * SECOND); /* up to what is wrong */
    HEARD("\r\n6\r\n");
    fix.steps[0] -= steps[0];
    fix_say("print f(0), k\rshow view\rshow title\rshow plot\rsave\rload\r", 200 * SECOND);
    HEARD("0.0 3\r\n");
    HEARD("set view 50,40,1,1");
    HEARD("set title 'It''s me'");
    HEARD("splot f(k*x)*y");
    assert_int_equal(fix.steps[0], 2 * steps[0]);
    fix_say("reset session; " SMALL "set polar; plot 1+cos(t)\rsave\r", 200 * SECOND); /* t is nobody but there */
    steps[0] = fix.steps[0] - 2 * steps[0];
    fix_power_on(sizeof fix.memory);
    fix_say("load\r", 200 * SECOND);
    assert_true(steps[0] > 1000);
    assert_int_equal(fix.steps[0], steps[0]);
}

static void test_button_and_autorun(void **state) {
    (void)state;
    fix_say(SMALL "splot x*y\rsave\r", 100 * SECOND);
    uint64_t steps = fix.steps[0];
    fix_power_on(sizeof fix.memory);
    fix_run(SECOND);
    assert_int_equal(fix.steps[0], 0);
    sim_inputs_set(sim_now() + 10 * MS, HAL_IN_BUTTON, HAL_IN_BUTTON); /* a bounce is no press */
    sim_inputs_set(sim_now() + 12 * MS, HAL_IN_BUTTON, 0);
    fix_run(SECOND);
    assert_int_equal(fix.steps[0], 0);
    sim_inputs_set(sim_now() + 10 * MS, HAL_IN_BUTTON, HAL_IN_BUTTON);
    sim_inputs_set(sim_now() + 200 * MS, HAL_IN_BUTTON, 0);
    fix_run(100 * SECOND);
    assert_int_equal(fix.steps[0], steps);
    fix_say("autorun on\r", SECOND);
    fix_power_on(sizeof fix.memory);
    fix_run(SECOND);
    HEARD("autorun\r\n");
    assert_int_equal(fix.steps[0], steps);
    fix_say("autorun off\r", SECOND);
    fix_power_on(sizeof fix.memory);
    fix_run(SECOND);
    assert_int_equal(fix.steps[0], 0);
    sim_store_erase();
    fix_say("load\r", SECOND);
    HEARD("There is no saved scene");
}

static void test_settings_are_kept(void **state) {
    (void)state;
    fix_say("set machine steps 100.5,200 speed 50 invert x corexy size 300,200\rset samples 50\r", SECOND);
    fix_power_on(sizeof fix.memory);
    fix_say("show machine\rreset\rshow machine\rshow samples\r", SECOND);
    const char *first = strstr(fix.said, "set machine steps 100.5,200 speed 50");
    assert_non_null(first);
    assert_non_null(strstr(first, "setup 1 noswap corexy size 300,200"));
    assert_non_null(strstr(first, "invert x"));
    assert_non_null(strstr(first + 1, "set machine steps 100.5,200 speed 50")); /* reset is about pictures */
    HEARD("set samples 100,100");
    fix_say("set mach \\\rspeed 40\rset machine travel 30; nonsense\rprint 1\r", SECOND); /* continued; half wrong */
    fix_power_on(sizeof fix.memory);
    fix_say("show machine\r", SECOND);
    HEARD("speed 40 travel 30");
    fix_say("set machine pen servo 900,1700,.3 limits homing home right pulloff 2 invert y,step,pen,estop\r", SECOND);
    fix_power_on(sizeof fix.memory);
    fix_say("show machine\r", SECOND);
    HEARD("set machine pen servo 900,1700,0.3 limits homing home right,bottom pulloff 2 invert y,step,pen,estop");
}

static void test_too_large(void **state) {
    (void)state;
    fix_power_on(MOTION_BYTES_HOST + 3000);
    fix_say("set isosamples 120,120\rsplot rand(0)\r", 10 * SECOND);
    HEARD("The scene does not fit: it may need ");
    HEARD("Nothing was drawn");
    assert_int_equal(fix.edges, 0);
    fix_say("set isosamples 10,10\rset paper 50,40 margin 5\rsplot x*y\r", 100 * SECOND);
    assert_true(fix.steps[0] > 1000);
}

/* A small chip's memory: the picture takes it as the scene needs it. */
static void test_small_memory(void **state) {
    (void)state;
    fix_power_on(MOTION_BYTES_HOST + 6200);
    fix_say("set isosamples 60,60;set xrange [-2:2];set yrange [-2:2]\rsplot exp(-x**2-y**2)\r", SECOND);
    assert_null(strstr(fix.said, "does not fit"));
    assert_true(fix.steps[0] > 10000);
    assert_int_equal(fix.console.stats.starved, 0);
    fix_say("memory\r", SECOND);
    HEARD("picture: hiding 4680 of 6200\r\n");
    HEARD("machine waited for the drawing: 0\r\n");
    printf("# 60 x 60 smooth surface in 6200 bytes: hiding took %zu, %lld strokes, pool full %lld times\n",
           fix.console.picture.stats.kernel_bytes, (long long)fix.console.picture.stats.path.strokes,
           (long long)fix.console.picture.stats.path.flushes);
}

/* What is not sure to fit for holes that it may have is measured, once, and then drawn, or tried first. */
static void test_measured_once(void **state) {
    (void)state;
    static const char *const SPLOT[] = {"splot exp(-x**2-y**2)\r", "splot sqrt(x+y)*exp(-x**2-y**2)\r",
                                        "splot rand(0)\r"};
    for (size_t k = 0; k < sizeof SPLOT / sizeof *SPLOT; k++) {
        hidden_stats_t found[2];
        for (int little = 0; little < 2; little++) {
            fix_power_on(little ? MOTION_BYTES_HOST + 50000 : sizeof fix.memory);
            fix_say("set isosamples 40;set xrange [-2:2];set yrange [-2:2];set paper 40,30 margin 2\r", SECOND);
            fix_say(SPLOT[k], 1000 * SECOND);
            found[little] = fix.console.picture.stats.hidden;
            assert_true(fix.console.picture.stats.path.strokes > 50);
            assert_int_equal(fix.console.picture.stats.evaluated, 40 * 40); /* and all came from the cache */
        }
        assert_int_equal(found[1].facets, found[0].facets);
        assert_int_equal(found[1].pieces, found[0].pieces);
    }
}

static void test_machine_size(void **state) {
    (void)state;
    fix_say("set machine size 200,150\rsplot x*y\r", 10 * SECOND);
    HEARD("The paper reaches beyond the machine");
    assert_int_equal(fix.edges, 0);
    fix_say("set paper 200,150;set isosamples 5,5;splot x*y\r", 100 * SECOND);
    assert_true(fix.steps[0] > 1000);
}

static void test_pen_and_motors(void **state) {
    (void)state;
    fix_say("pen down\r", SECOND);
    assert_int_equal(fix.pins, HAL_PEN);
    fix_say("  pen   up \r", SECOND);
    assert_int_equal(fix.pins, 0);
    fix_say("motors on\r", SECOND);
    assert_int_equal(fix.pins, HAL_ENABLE);
    fix_say("motors off\r", SECOND);
    assert_int_equal(fix.pins, 0);
    fix_say("pen = 5\rprint pen\r", SECOND); /* still a variable */
    HEARD("\r\n5\r\n");
    fix_say("pen sideways\r", SECOND);
    HEARD("unknown command");
    fix_say("help board\rhelp\r", SECOND);
    HEARD("autorun on|off");
    HEARD("Room for a scene: ");
    HEARD("struts with haloes");
    HEARD("replot");
}

static void test_pause(void **state) {
    (void)state;
    fix_say("pause 3 'wait'; print 11\r", 2 * SECOND);
    uint64_t now = sim_now();
    assert_true(now > 3 * SECOND);
    HEARD("wait\r\n11\r\n");
    fix_type("pause -1; print 12\r\n");
    sim_console_type(sim_now() + 5 * SECOND, "\r", 1);
    fix_run(SECOND);
    assert_true(sim_now() > now + 5 * SECOND);
    HEARD("\r\n12\r\n");
    fix_type("pause -1; print 13\r");
    sim_console_type(sim_now() + 5 * SECOND, "\x18", 1);
    fix_run(SECOND);
    assert_null(strstr(fix.said, "\r\n13\r\n"));
    fix_say("quit\rprint 14\r", SECOND);
    HEARD("\r\n14\r\n");
}

static int fives;
/* On a board time goes by while it computes. */
static void listen_for_long(void *ctx, const char *text, size_t bytes) {
    fix_listen(ctx, text, bytes);
    for (size_t i = 0; i < bytes; i++) fives += text[i] == '5';
    sim_run(MS);
}

/* Ctrl-X ends a loop that draws nothing; each turn feeds the watchdog. */
static void test_loop(void **state) {
    (void)state;
    fives = 0;
    sim_console_listen(listen_for_long, NULL);
    fix_type("while (1) { print 5 }; print 17\r");
    sim_console_type(sim_now() + 20 * SECOND, "\x18", 1);
    fix_run(30 * SECOND);
    assert_in_range(fives, 1000, 30000);
    assert_true(!sim_watchdog_bitten());
    assert_null(strstr(fix.said, "\r\n17\r\n"));
    fix_forget();
    fix_say("print 18\r", SECOND);
    HEARD("\r\n18\r\n");
}

/* A cube whose outline (six edges) and creases (three) are drawn with two pens, the first of which is not in the
 * holder. */
static void test_pens(void **state) {
    (void)state;
    const char *cube = "splot '-' solid\rv 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rv 0 0 1\rv 1 0 1\rv 1 1 1\rv 0 1 1\r"
                       "f 4 3 2 1\rf 5 6 7 8\rf 1 2 6 5\rf 2 3 7 6\rf 3 4 8 7\rf 4 1 5 8\re\r";
    fix_say("set pen crease 3 silhouette 2\r", SECOND);
    fix_forget();
    fix_type(cube);
    const uint64_t now = sim_now();
    sim_console_type(now + 20 * SECOND, "?", 1);
    sim_console_type(now + 30 * SECOND, "~", 1);
    sim_console_type(now + 100 * SECOND, "?", 1);
    sim_console_type(now + 110 * SECOND, "~", 1);
    fix_run(200 * SECOND);
    const char *two = strstr(fix.said, "Pen 2: put it in, then ~\r\n<Hold|MPos:0.000,0.000|Pen:up");
    const char *three = strstr(fix.said, "Pen 3: put it in, then ~\r\n<Hold|MPos:0.000,0.000|Pen:up");
    assert_true(two && three && two < three);
    assert_null(strstr(two + 1, "Pen 2"));
    assert_true(fix.pen_downs >= 2 && fix.at[0] == 0 && fix.at[1] == 0);
    assert_true(fix.last_step > now + 110 * SECOND);

    const uint64_t drawn = fix.pen_downs; /* pen 3 is in it, 2 is wanted, and nobody brings it */
    fix_forget();
    fix_type("replot; print 15\r");
    sim_console_type(sim_now() + 20 * SECOND, "\x18", 1);
    fix_run(40 * SECOND);
    HEARD("Pen 2");
    assert_true(fix.pen_downs == 0 && drawn > 0);
    fix_say("print 16\r", SECOND);
    HEARD("\r\n16\r\n");
    fix_forget();
    fix_say("set pen 3\rreplot\r", 100 * SECOND);
    assert_null(strstr(fix.said, "put it in"));
    assert_int_equal(fix.pen_downs > 0, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_power_on, on),
        cmocka_unit_test_setup(test_several_on_a_line, on),
        cmocka_unit_test_setup(test_editing, on),
        cmocka_unit_test_setup(test_refused_rows, on),
        cmocka_unit_test_setup(test_errors_lose_nothing, on),
        cmocka_unit_test_setup(test_overrun, on),
        cmocka_unit_test_setup(test_inline_data, on),
        cmocka_unit_test_setup(test_flow_control, on),
        cmocka_unit_test_setup(test_save_and_load, on),
        cmocka_unit_test_setup(test_button_and_autorun, on),
        cmocka_unit_test_setup(test_settings_are_kept, on),
        cmocka_unit_test_setup(test_too_large, on),
        cmocka_unit_test_setup(test_small_memory, on),
        cmocka_unit_test_setup(test_measured_once, on),
        cmocka_unit_test_setup(test_machine_size, on),
        cmocka_unit_test_setup(test_pen_and_motors, on),
        cmocka_unit_test_setup(test_pause, on),
        cmocka_unit_test_setup(test_loop, on),
        cmocka_unit_test_setup(test_pens, on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
