/* test_isolines.c - data that lie on no grid: which facets and lines they become, and when memory ends. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "session_fixture.h"

static double coordinate(const mesh_t *m, int32_t v, int k) {
    double d;
    memcpy(&d, &m->vertex[v][k], sizeof d);
    return d;
}

/* `3 1:4 ...`: the elements of a mesh, faces and lines by their vertices, in few characters. */
static const char *elements(const mesh_t *m) {
    static char text[1024];
    int n = 0;
    text[0] = '\0';
    mesh_walk_t w = mesh_walk(m);
    while (mesh_next(&w)) {
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%c", n ? " " : "", w.kind == MESH_FACE ? 'f' : 'l');
        for (int32_t k = 0; k < w.count; k++)
            n += snprintf(text + n, sizeof text - (size_t)n, "%s%d", k ? "," : "", (int)mesh_at(&w, k));
    }
    return text;
}

/* After each of these data files are the elements known, and whether anybody is warned. */
static void facets_where_all_lines_are_equally_long(void **state) {
    static const struct {
        const char *data, *elements;
        bool warns;
    } cases[] = {
        /* a saddle over a rhombus; then with a corner that is none; with a third line */
        {"0 0 0\n1 1 1\n\n-1 1 1\n0 2 0\n", "f0,1,3,2", false},
        {"0 0 0\n1 1 1\n\n-1 1 1\n0 2 NaN\n", NULL, false},
        {"0 0 0\n1 1 1\n2 2 2\n\n-1 1 NaN\n0 2 3\n1 2 2\n\n-2 2 1\n-1 3 1\n0 4 1\n", "f1,2,5,4 f4,5,8,7", false},
        {"0 0 0\n1 1 1\n\n-1 1 1\n0 2 0\n\n-1 2 5\n0 3 0\n", "f0,1,3,2 f2,3,5,4", false},
        /* lines of different lengths; interrupted; a single one; scattered points */
        {"0 0 0\n1 1 1\n\n-1 1 1\n0 2 0\n2 0 0\n", "l0,1 l2,3,4", true},
        {"0 0 0\n1 1 1\nNaN 1 1\n3 4 5\n4 5 6\n\n-1 1 1\n0 2 0\n2 0 0\n", "l0,1 l3,4 l5,6,7", true},
        {"0 0 1\n0 1 2\n0 2 2\n", "l0,1,2", true},
        {"0 0 1\n4 1 2\n3 2 2\n5 1 0\n", "l0,1,2,3", true},
        /* a grid until its third point, its third line, its end; with a stray coordinate */
        {"0 0 1\n0 1 2\n0.5 2 3\n\n1 0 1\n1 1 2\n1 2 3\n", "f0,1,4,3 f1,2,5,4", false},
        {"0 0 1\n0 1 2\n\n1 0 1\n1 1 2\n\n2 0 1\n3 1 2\n", "f0,1,3,2 f2,3,5,4", true},
        {"0 0 1\n0 1 2\n\n1 0 1\n1 1 2\n\n2 0 1\n", "l0,1 l2,3", true},
        /* two sets, both no grids */
        {"0 0 0\n1 1 1\n\n-1 1 1\n0 2 0\n\n\n5 5 1\n6 6 2\n\n4 6 1\n5 7 2\n", "f0,1,3,2 f4,5,7,6", false},
    };
    fixture_t *f = *state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fixture_file(f, 0, "f", cases[i].data);
        f->mesh_items = 0;
        int err = fixture_feed(f, "splot 'f'");
        if (!cases[i].elements) {
            assert_int_equal(err, ERR_EMPTY);
            continue;
        }
        if (err) fail_msg("%s: %s", cases[i].data, f->err);
        assert_int_equal(f->kind, PLOT_SOLIDS);
        assert_int_equal(f->mesh_items, 1);
        if (strcmp(elements(&f->mesh), cases[i].elements) != 0)
            fail_msg("%s\nis %s instead of %s", cases[i].data, elements(&f->mesh), cases[i].elements);
        assert_int_equal(strstr(f->err, "warning") != NULL, cases[i].warns);
    }
}

/* What was read as a grid, and then as none, is where it was; the ranges cut; functions lie beside it. */
static void points_stay_where_they_are(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "f", "0.1 0.5 1\n0.1 1.25 2\n0.1 2 3\n\n1 0.5 4\n1 1.25 5\n1 2 6\n\n3 0.5 7\n3 1.5 8\n3 2 9\n");
    assert_int_equal(fixture_feed(f, "splot 'f'"), 0);
    static const double x[] = {0.1, 1, 3}, y[] = {0.5, 1.25, 2};
    for (int k = 0; k < 9; k++) {
        assert_true(coordinate(&f->mesh, k, 0) == x[k / 3] && coordinate(&f->mesh, k, 2) == k + 1);
        assert_true(coordinate(&f->mesh, k, 1) == (k == 7 ? 1.5 : y[k % 3]));
    }
    assert_non_null(strstr(f->err, "its line 10: not a grid: the corresponding point"));
    assert_int_equal(fixture_feed(f, "splot [:1] 'f'"), 0);
    assert_string_equal(elements(&f->mesh), "f0,1,4,3 f1,2,5,4");
    assert_int_equal(fixture_feed(f, "splot [] [] [2:] 'f'"), 0);
    assert_string_equal(elements(&f->mesh), "f1,2,5,4 f3,4,7,6 f4,5,8,7");
    assert_int_equal(fixture_feed(f, "splot 'f', x+y"), 0);
    assert_int_equal(f->mesh_items, 1);
    /* inline data stay for replot, and a grid behind them is one */
    assert_int_equal(fixture_feed(f, "splot '-'\n0 0 0\n1 1 1\n\n-1 1 1\n0 2 0\ne"), 0);
    assert_int_equal(fixture_feed(f, "replot x"), 0);
    assert_string_equal(elements(&f->mesh), "f0,1,3,2");
    /* which a command that is wrong leaves alone */
    assert_int_equal(fixture_feed(f, "splot x y"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "replot"), 0);
    assert_string_equal(elements(&f->mesh), "f0,1,3,2");
    assert_int_equal(fixture_feed(f, "splot x"), 0);
    assert_int_equal(f->kind, PLOT_SURFACES);
    assert_int_equal(f->mesh_items, 0);
}

/* However little memory there is, it is enough or too little; nothing is written behind it. */
static void memory_ends_anywhere(void **state) {
    static const char data[] =
        "0 0 1\n0 1 2\n0 2 3\n\n1 0 4\n1 1 5\n1 2 6\n\n2 0 1\n2.5 1 2\n2 2 0\n\n\n5 5 5\n6 6 6\n7 8 9\n";
    fixture_t *f = *state;
    static packed_t pool[128];
    bool enough = false;
    for (size_t n = 1; n < 100; n++) {
        memset(pool, 0xa5, sizeof pool);
        session_init(&f->session, &f->port, pool + 8, n * sizeof(packed_t));
        fixture_file(f, 0, "f", data);
        int err = fixture_feed(f, "splot 'f'");
        if (enough) assert_int_equal(err, 0);
        if (!enough && err == 0) print_message("# 12 points, 4 facets and a line take %d bytes\n", (int)(n * 8));
        enough = err == 0;
        if (err) assert_int_equal(err, ERR_FULL);
        if (!err) assert_string_equal(elements(&f->mesh), "f0,1,4,3 f1,2,5,4 f3,4,7,6 f4,5,8,7 l9,10,11");
        for (size_t k = 0; k < 128; k++)
            if (k < 8 || k >= 8 + n) assert_true(pool[k] == 0xa5a5a5a5a5a5a5a5u);
    }
    assert_true(enough);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(facets_where_all_lines_are_equally_long, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(points_stay_where_they_are, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(memory_ends_anywhere, fixture_setup, fixture_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
