/* small_session.c - a session with every capacity of the language at its smallest (test_small.sh builds it): each is
 * filled, and running out is an ordinary error after which the session goes on. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "../unit/session_fixture.h"

static void every_capacity_runs_out_politely(void **state) {
    (void)state;
    fixture_t *f = fixture_new();
    fixture_file(f, 0, "d", "0 0 1 5 6\n0 1 2 7 8\n\n1 0 3 9 10\n1 1 4 11 12\n");
    fixture_file(f, 1, "s", "print 3\n");
    char line[8 * CONFIG_LINE_MAX] = "a=1";
    /* what is left when each is nearly used up */
    assert_int_equal(fixture_feed(f, "splot 'd' using 1:2:3"), 0);
    assert_true(f->z[3] == 4);
    assert_int_equal(fixture_feed(f, "splot 'd' using 1:2:4"), ERR_VALUE);    /* CONFIG_DATA_COLUMNS 3 */
    assert_int_equal(fixture_feed(f, "splot x, y"), ERR_FULL);                /* CONFIG_PLOT_ITEMS 1 */
    assert_int_equal(fixture_feed(f, "load 's'"), ERR_FULL);                  /* CONFIG_LOAD_DEPTH 0 */
    assert_int_equal(fixture_feed(f, "splot '01234567890123456'"), ERR_FULL); /* CONFIG_NAME_MAX 16 */
    assert_int_equal(fixture_feed(f, "pause 0 '01234567890123456'"), ERR_FULL);
    assert_int_equal(fixture_feed(f, "print 1,\\\n2,\\\n3,\\\n4"), 0); /* CONFIG_JOINS 1 is for messages only */
    assert_string_equal(f->out, "1 2 3 4\n");
    assert_int_equal(fixture_feed(f, "print 1,\\\n2,\\\n3,\\\nfoo"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "splot sin(x+1.1)*2.2+sin(y+3.3)*4.4+sin(x+5.5)*6.6"),
                     ERR_FULL); /* CONFIG_PLOT_CODE */
    assert_int_equal(fixture_feed(f, "splot sin(x+1.1)*2.2"), 0);
    assert_int_equal(fixture_feed(f, "f(n)=n<1?0:f(n-1)+1\nprint f(4)"), 0);
    assert_int_equal(fixture_feed(f, "print f(40)"), ERR_FULL); /* CONFIG_CALLS or CONFIG_STACK */
    memset(line, ' ', CONFIG_LINE_MAX + 1);
    line[CONFIG_LINE_MAX + 1] = '\0';
    assert_int_equal(session_line(&f->session, line), ERR_FULL); /* CONFIG_LINE_MAX */
    int err = 0;
    for (int k = 0; k < 100 && !err; k++) { /* CONFIG_SYMBOLS and CONFIG_POOL */
        snprintf(line, sizeof line, "a_long_name_%d = %d", k, k);
        err = fixture_feed(f, line);
    }
    assert_int_equal(err, ERR_FULL);
    assert_non_null(strstr(f->err, "("));
    /* After all that, whole again. */
    assert_int_equal(fixture_feed(f, "reset session\nsplot x*y\nshow view\nhelp"), 0);
    assert_int_equal(f->item[0].nx, 10);
    free(f);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_capacity_runs_out_politely)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
