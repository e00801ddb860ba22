/* test_undefine.c - undefine: names are as if nobody had said what they are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "session_fixture.h"

static void names_are_forgotten(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "a = 1; ab = 2; ac = 'x'; ad = 'y'; b = 3; f(x) = x+b; g(x) = f(x)*2"), 0);
    assert_int_equal(fixture_feed(f, "undefine ab ad; print a, ac, g(1)"), 0);
    assert_string_equal(f->out, "1 x 8\n");
    assert_int_equal(fixture_feed(f, "print ab"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "print ad"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "undefine f()"), 0);
    assert_int_equal(fixture_feed(f, "print g(1)"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "f(x) = 10*x; print g(2), f(3)"), 0);
    assert_string_equal(f->out, "40 30\n");
    assert_int_equal(fixture_feed(f, "undefine a*, nothing; print exists('a'), exists('ac'), exists('b')"), 0);
    assert_string_equal(f->out, "0 0 1\n");
    assert_int_equal(fixture_feed(f, "undefine"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "undefine 3"), ERR_SYNTAX);
    for (int k = 0; k < 5000; k++) /* nothing is left behind */
        assert_int_equal(fixture_feed(f, "h(x) = x*x*x+1/(x+7); t = 'text'; undefine h() t"), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(names_are_forgotten, fixture_setup, fixture_teardown)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
