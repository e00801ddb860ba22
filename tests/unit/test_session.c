/* test_session.c - commands, abbreviations, lines and files of lines, errors with their place. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "session_fixture.h"

/* Every line by itself: code, line, column, and a piece of the message. Nothing may be drawn. */
static void errors_have_a_place(void **state) {
    static const struct {
        const char *text;
        int code, line, column;
        const char *message;
    } cases[] = {
        {"foo 3", ERR_NAME, 1, 1, "unknown command: foo"},
        {"set foo", ERR_NAME, 1, 5, "unknown option: foo"},
        {"unset foo", ERR_NAME, 1, 7, "unknown option: foo"},
        {"show foo", ERR_NAME, 1, 6, "unknown option: foo"},
        {"splot x*y foo", ERR_SYNTAX, 1, 11, "end of the command"},
        {"splot x*y w", ERR_SYNTAX, 1, 12, "lines"},
        {"splot x*y w foo", ERR_NAME, 1, 13, "foo"},
        {"splot x*y with points foo", ERR_SYNTAX, 1, 23, "end of the command"},
        {"splot x*y w l w l", ERR_SYNTAX, 1, 15, "twice"},
        {"splot x*y title", ERR_SYNTAX, 1, 16, "quotes"},
        {"splot foo(x)", ERR_NAME, 1, 7, "foo"},
        {"splot x*a", ERR_NAME, 1, 9, "a"},
        {"splot", ERR_SYNTAX, 1, 6, "expected"},
        {"replot", ERR_EMPTY, 1, 7, "nothing"},
        {"splot x*y, 'no.dat'", ERR_FILE, 1, 12, "no.dat"},
        {"splot '-' using 1:2", ERR_SYNTAX, 1, 17, "one column"},
        {"splot '-' using 1:2:", ERR_SYNTAX, 1, 21, "column"},
        {"splot '-' using 99", ERR_VALUE, 1, 17, "columns"},
        {"splot '-' every 0", ERR_VALUE, 1, 17, "range"},
        {"splot [1:1+1e-14] x", ERR_VALUE, 1, 19, "narrow"},
        {"splot a=1, a*x, a=2, a*y", ERR_UNSUPPORTED, 1, 17, "first element"},
        {"splot $x matrix", ERR_FILE, 1, 7, "$x"},
        {"$x << EOD", ERR_UNSUPPORTED, 1, 1, "data blocks"},
        {"$x EOD", ERR_SYNTAX, 1, 4, "<<"},
        {"splot ''", ERR_VALUE, 1, 7, "no file"},
        {"plot '-' matrix", ERR_UNSUPPORTED, 1, 6, "matrix"},
        {"plot '-' using 1:2:foo", ERR_NAME, 1, 20, "foo"},
        {"plot '-' using 1:2:=", ERR_SYNTAX, 1, 20, "column"},
        {"plot 'a.obj'", ERR_UNSUPPORTED, 1, 6, "solids"},
        {"splot [0:1", ERR_SYNTAX, 1, 11, "']'"},
        {"splot [1:1] x", ERR_VALUE, 1, 7, "empty"},
        {"set xrange 5", ERR_SYNTAX, 1, 12, "range"},
        {"set xrange [0:10:2]", ERR_SYNTAX, 1, 17, "']'"},
        {"set samples 1", ERR_VALUE, 1, 13, "samples"},
        {"set isosamples 3,1", ERR_VALUE, 1, 18, "isosamples"},
        {"set view 400", ERR_VALUE, 1, 10, "rot_x"},
        {"set view 60,30,0", ERR_VALUE, 1, 16, "scale"},
        {"set view from 1,2", ERR_SYNTAX, 1, 18, "X,Y,Z"},
        {"set view from 1,2,3 to 1,2,3", ERR_VALUE, 1, 15, "same point"},
        {"set hidden3d foo", ERR_SYNTAX, 1, 14, "perimeter"},
        {"set paper a9", ERR_SYNTAX, 1, 11, "a3"},
        {"set paper 5,100", ERR_VALUE, 1, 11, "10 and 5000"},
        {"set paper a4 margin 104", ERR_VALUE, 1, 21, "margin"},
        {"set machine steps 80 speed 99999", ERR_VALUE, 1, 28, "speed"},
        {"set machine steps 80,0", ERR_VALUE, 1, 22, "between 1 and 10000"},
        {"set machine foo 3", ERR_NAME, 1, 13, "foo"},
        {"set title 3", ERR_SYNTAX, 1, 11, "quotes"},
        {"a=3 b=4", ERR_SYNTAX, 1, 5, "end of the command"},
        {"print", ERR_SYNTAX, 1, 6, ""},
        {"print 1,", ERR_SYNTAX, 1, 9, ""},
        {"print xyz", ERR_NAME, 1, 7, "xyz"},
        {"load 'nofile'", ERR_FILE, 1, 6, "nofile"},
        {"call 'x' 1", ERR_UNSUPPORTED, 1, 1, "call"},
        {"help foobar", ERR_NAME, 1, 6, "foobar"},
        {"3+4", ERR_SYNTAX, 1, 1, "command"},
        {"splot x*y; set foo", ERR_NAME, 1, 16, "foo"},
    };
    fixture_t *f = *state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        session_init(&f->session, &f->port, f->pool, sizeof f->pool);
        f->plots = 0;
        int err = fixture_feed(f, cases[i].text);
        const lang_error_t *e = &f->session.error;
        if (err != cases[i].code || e->line != cases[i].line || e->column != cases[i].column ||
            !strstr(e->message, cases[i].message))
            fail_msg("%s\n gave %d line %d column %d: %s", cases[i].text, err, e->line, e->column, e->message);
        assert_int_equal(f->plots, strncmp(cases[i].text, "splot x*y;", 10) == 0);
        assert_int_equal(session_state(&f->session), SESSION_READY);
        assert_int_equal(fixture_feed(f, "print 1"), 0); /* it goes on */
        assert_string_equal(f->out, "1\n");
    }
}

static void a_report_shows_the_place(void **state) {
    fixture_t *f = *state;
    session_source(&f->session, "hill.gp");
    assert_int_equal(fixture_feed(f, "a = 1\nsplot sin(x"), ERR_SYNTAX);
    assert_string_equal(f->err, "splot sin(x\n           ^\n\"hill.gp\", line 2, column 12: ')' expected\n");
}

static void continued_lines_keep_their_places(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "splot x*y, \\\n  x+y, \\"), 0);
    assert_int_equal(session_state(&f->session), SESSION_MORE);
    assert_int_equal(fixture_feed(f, "  x+nobody"), ERR_NAME);
    assert_int_equal(f->session.error.line, 3);
    assert_int_equal(f->session.error.column, 5);
    assert_int_equal(f->plots, 0);
    assert_int_equal(fixture_feed(f, "print 1,\\\r\n2"), 0);
    assert_string_equal(f->out, "1 2\n");
    assert_int_equal(fixture_feed(f, "print 1,\\"), 0);
    assert_int_equal(session_end(&f->session), ERR_SYNTAX);
    assert_int_equal(session_state(&f->session), SESSION_READY);
}

static void abbreviations_are_gnuplots(void **state) {
    fixture_t *f = *state;
    assert_int_equal(
        fixture_feed(f, "se is 5,6; se xr [0:1];se yr[2:3]\nsp x*y w l t 'a', x+y wit line noti, x w li not"), 0);
    assert_int_equal(f->items, 3);
    assert_int_equal(f->item[0].nx, 5);
    assert_int_equal(f->item[0].ny, 6);
    assert_string_equal(f->item[0].title, "a");
    assert_string_equal(f->item[1].title, "");
    assert_int_equal(fixture_feed(f, "rep"), 0);
    assert_int_equal(f->plots, 2);
    assert_int_equal(fixture_feed(f, "uns hid; sho hid; res; pr 3; pa 0.5; p x"), 0);
    assert_string_equal(f->out, "unset hidden3d\n3\n");
    assert_int_equal(f->pause_ms, 500);
    assert_int_equal(f->kind, PLOT_CURVES);
    assert_int_equal(fixture_feed(f, "u x"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "s x"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "q"), 0);
    assert_int_equal(session_state(&f->session), SESSION_QUIT);
    assert_int_equal(fixture_feed(f, "print 3"), 0);
    assert_string_equal(f->out, "");
}

static size_t kept_room;
static int keep_little(void *ctx, const char *name, const char *text, size_t n) {
    (void)ctx, (void)name;
    if (!text) return 0;
    if (n > kept_room) return ERR_FULL;
    kept_room -= n;
    return 0;
}

/* A data block that finds no memory for what is printed. */
static void print_tells_what_is_not_kept(void **state) {
    fixture_t *f = *state;
    f->port.keep = keep_little;
    kept_room = 100;
    assert_int_equal(fixture_feed(f, "array A = [1, 'b', 3]; set print $d"), 0);
    const size_t line = strlen("10 [1,\"b\",3] 20\n");
    for (size_t room = 0; room <= line; room++) {
        kept_room = room;
        f->err[0] = '\0';
        assert_int_equal(fixture_feed(f, "print 10, A, 20"), room < line ? ERR_FULL : 0);
        assert_int_equal(strlen(f->err) > 0, room < line);
    }
    assert_int_equal(fixture_feed(f, "set print; print 4"), 0);
    assert_string_equal(f->out, "4\n");
}

static int turns_left;
static int one_turn(void *ctx) {
    (void)ctx;
    return turns_left-- > 0 ? 0 : ERR_STOPPED;
}

static void loops_can_be_stopped(void **state) {
    fixture_t *f = *state;
    f->port.turn = one_turn;
    turns_left = 5;
    assert_int_equal(fixture_feed(f, "i = 0; while (1) { i = i + 1 }; print 1"), ERR_STOPPED);
    turns_left = 7;
    assert_int_equal(fixture_feed(f, "do for [k=1:9] for [l=1:2] { i = i + 1 }"), ERR_STOPPED);
    turns_left = 2;
    assert_int_equal(fixture_feed(f, "print i; do for [k=1:2] { i = k }"), 0);
    assert_string_equal(f->out, "11\n");
}

static void print_is_gnuplots(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "print 'a', 3, 1.5, 1/3.,1e10,1e-10,100000.0*1e10, 7/2, -2**2"), 0);
    assert_string_equal(f->out, "a 3 1.5 0.333333333333333 10000000000.0 1e-10 1e+15 3 -4\n");
    assert_int_equal(fixture_feed(f, "f(x,y)=x+y;a=2;print f(a,1) # f\n;;print a;"), 0);
    assert_string_equal(f->out, "3\n2\n");
}

static void known_options_warn_once(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set key at 3,4 'a;b'; print 1"), 0);
    assert_string_equal(f->out, "1\n");
    assert_string_equal(f->err, "line 1: warning: set key is ignored\n");
    assert_int_equal(fixture_feed(f, "unset key\nset key off\nreset\nset k"), 0);
    assert_string_equal(f->err, "");
    assert_int_equal(fixture_feed(f, "unset border; set bord 31; set term png; clear"), 0);
    assert_string_equal(f->err, "line 6: warning: unset border is ignored\nline 6: warning: set term is ignored\n"
                                "line 6: warning: clear is ignored\n");
    assert_int_equal(fixture_feed(f, "set style data lines"), 0);
    assert_string_equal(f->err, "");
}

static void functions_are_sampled_as_gnuplot_does(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set isosamples 4,5; set samples 30,40; splot x+10*y"), 0);
    assert_int_equal(f->item[0].nx, 4);
    assert_int_equal(f->item[0].ny, 5);
    assert_int_equal(f->rows_nx, 30);
    assert_int_equal(f->rows_ny, 5);
    assert_int_equal(f->cols_nx, 4);
    assert_int_equal(f->cols_ny, 40);
    for (int j = 0, k = 0; j < 5; j++) {
        for (int i = 0; i < 4; i++, k++) {
            double x = -10 + i * (20.0 / 3), y = -10 + j * 5.0;
            assert_true(fabs(f->x[k] - x) < 1e-14 && fabs(f->y[k] - y) < 1e-14 && fabs(f->z[k] - (x + 10 * y)) < 1e-12);
        }
    }
    assert_int_equal(fixture_feed(f, "splot [u=0:1][v=1:3][*:7] u*v"), 0);
    assert_true(f->x[0] == 0 && f->x[3] == 1 && f->y[0] == 1 && f->y[19] == 3 && f->z[19] == 3);
    assert_true(f->settings.z.auto_lo && !f->settings.z.auto_hi && fixture_double(f->settings.z.hi) == 7);
    assert_true(session_settings(&f->session)->z.auto_hi); /* the command's ranges are its own */
    assert_int_equal(fixture_feed(f, "set dummy a,b; splot a-b; plot [2:3] a**2"), 0);
    assert_int_equal(f->item[0].nx, 30);
    assert_true(f->x[0] == 2 && f->x[29] == 3 && f->z[29] == 9);
    assert_int_equal(fixture_feed(f, "set xrange [3:1]; reset; set xrange [3:1]; splot x"), 0);
    assert_true(f->settings.x.reverse && f->x[0] == 1 && f->x[9] == 3);
}

static void noise_is_a_function_of_the_place(void **state) {
    fixture_t *f = *state;
    static double first[100];
    assert_int_equal(fixture_feed(f, "splot rand(0)+rand(0)*10"), 0);
    memcpy(first, f->z, sizeof first);
    assert_int_equal(fixture_feed(f, "print rand(0)\nreplot"), 0);
    int same_as_before = 0;
    for (int k = 1; k < 100; k++) same_as_before += first[k] == first[k - 1];
    assert_int_equal(same_as_before, 0);
    session_init(&f->session, &f->port, f->pool, sizeof f->pool);
    assert_int_equal(fixture_feed(f, "splot rand(0)+rand(0)*10; replot"), 0);
    assert_memory_equal(first, f->z, sizeof first);
    double sum = 0;
    assert_int_equal(fixture_feed(f, "set isosamples 100; splot rand(0)"), 0);
    for (int k = 0; k < 10000; k++) {
        assert_true(f->z[k] >= 0 && f->z[k] < 1);
        sum += f->z[k];
    }
    assert_true(fabs(sum / 10000 - 0.5) < 0.015);
}

static void files_are_loaded_inside_lines(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "a.gp", "print 'a1'; load 'b.gp'; print 'a2'\nprint \\\n 'a3'");
    fixture_file(f, 1, "b.gp", "print 'b1'\r\n# nothing\n\nprint 'b2'\n");
    fixture_file(f, 2, "loop.gp", "load 'loop.gp'\n");
    fixture_file(f, 3, "bad.gp", "print 1\nprint 2;\\\n  y = foo(3) bar\nprint 3\n");
    fixture_file(f, 4, "quit.gp", "print 1; quit; print 2\nprint 3");
    assert_int_equal(fixture_feed(f, "load 'a.gp'; print 'end'"), 0);
    assert_string_equal(f->out, "a1\nb1\nb2\na2\na3\nend\n");
    assert_int_equal(fixture_feed(f, "load 'loop.gp'"), ERR_FULL);
    assert_int_equal(fixture_feed(f, "foo(x)=x; load 'bad.gp'; print 9"), ERR_SYNTAX);
    assert_string_equal(f->out, "1\n2\n");
    assert_int_equal(f->session.error.line, 3);
    assert_int_equal(f->session.error.column, 14);
    assert_non_null(strstr(f->err, "\"bad.gp\", line 3, column 14"));
    assert_int_equal(fixture_feed(f, "load 'quit.gp'; print 4"), 0);
    assert_string_equal(f->out, "1\n");
    assert_int_equal(session_state(&f->session), SESSION_QUIT);
}

/* As gnuplot: what could not be drawn is not drawn again; what was before it is. */
static void replot_forgets_what_failed(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "splot x*y"), 0);
    assert_int_equal(fixture_feed(f, "splot '-'\n1 2 zero"), ERR_DATA);
    assert_int_equal(fixture_feed(f, "show plot"), 0);
    assert_non_null(strstr(f->out, "splot x*y"));
    assert_int_equal(fixture_feed(f, "splot 1/0"), 0); /* what the port draws counts */
    f->plot_result = ERR_FULL;
    assert_int_equal(fixture_feed(f, "splot x"), ERR_FULL);
    f->plot_result = 0;
    assert_int_equal(fixture_feed(f, "show plot"), 0);
    assert_non_null(strstr(f->out, "splot 1/0"));
    assert_int_equal(fixture_feed(f, "replot"), 0);
    f->plot_result = ERR_STOPPED; /* a drawing that was stopped is drawn again */
    assert_int_equal(fixture_feed(f, "splot y"), ERR_STOPPED);
    f->plot_result = 0;
    assert_int_equal(fixture_feed(f, "show plot"), 0);
    assert_non_null(strstr(f->out, "splot y"));
}

static void replot_repeats_and_adds(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "a=1; splot a*x"), 0);
    assert_int_equal(fixture_feed(f, "a=2; replot x+y w l"), 0);
    assert_int_equal(f->items, 2);
    assert_true(f->z[0] == -20);
    assert_int_equal(fixture_feed(f, "replot nobody(x)"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "replot"), 0);
    assert_int_equal(f->items, 2);
    assert_int_equal(fixture_feed(f, "show plot"), 0);
    assert_string_equal(f->out, "splot a*x, x+y w l\n");
}

static void hidden_dem_runs_to_its_end(void **state) {
    fixture_t *f = *state;
    const char *folder = "/usr/share/doc/gnuplot/examples/";
    static char text[2][65536];
    static const char *const name[2] = {"hidden.dem", "glass.dat"};
    for (int i = 0; i < 2; i++) {
        char path[128];
        snprintf(path, sizeof path, "%s%s", folder, name[i]);
        FILE *file = fopen(path, "r");
        if (!file) skip();
        text[i][fread(text[i], 1, sizeof text[i] - 1, file)] = '\0';
        fclose(file);
        fixture_file(f, i, name[i], text[i]);
    }
    assert_int_equal(fixture_feed(f, "load 'hidden.dem'"), 0);
    assert_int_equal(f->plots, 7);
    assert_int_equal(f->pauses, 7);
    assert_int_equal(f->item[0].nx, 16);
    assert_int_equal(f->item[0].ny, 16);
    assert_true(f->x[15] == 15 && f->y[255] == 15 && f->z[0] == 0.568);
    assert_true(fixture_double(f->settings.view.rot_x) == 50 && fixture_double(f->settings.view.rot_z) == 30);
}

static void long_lines_are_refused(void **state) {
    fixture_t *f = *state;
    static char line[CONFIG_LINE_MAX + 100];
    memset(line, ' ', sizeof line - 1);
    memcpy(line, "print 1", 7);
    assert_int_equal(session_line(&f->session, line), ERR_FULL);
    line[CONFIG_LINE_MAX] = '\0';
    f->out[0] = '\0';
    assert_int_equal(session_line(&f->session, line), 0);
    assert_string_equal(f->out, "1\n");
    /* A plot command as long as a line can be repeated. */
    memcpy(line, "splot x", 7);
    assert_int_equal(session_line(&f->session, line), 0);
    assert_int_equal(fixture_feed(f, "replot"), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(errors_have_a_place, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(a_report_shows_the_place, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(continued_lines_keep_their_places, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(loops_can_be_stopped, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(print_tells_what_is_not_kept, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(abbreviations_are_gnuplots, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(print_is_gnuplots, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(known_options_warn_once, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(functions_are_sampled_as_gnuplot_does, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(noise_is_a_function_of_the_place, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(files_are_loaded_inside_lines, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(replot_repeats_and_adds, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(replot_forgets_what_failed, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(hidden_dem_runs_to_its_end, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(long_lines_are_refused, fixture_setup, fixture_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
