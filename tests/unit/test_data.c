/* test_data.c - data files: what gnuplot reads from them, grids in every direction, errors with their line, speed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "data_points.h"

static const char THREE[] = "# comment\n0 0 1 # more\n0 1 2\n0 2.5 3\n\n# between\n1 0 4\n1 1 5\n1 2.5 6\n";
static const char TWO_SETS[] =
    "\n\n\n1 10 1\n1 20 2\n1 30 3\n1 40 4\n\n2 10 5\n2 20 6\n2 30 7\n2 40 8\n\n3 10 9\n3 20 10\n3 30 11\n3 40 12"
    "\n\n\n\n5 1 1\n5 2 2\n\n6 1 3\n6 2 4\n";
static const char MATRIX[] = "1 2 3.5 4\n5 -6 7 8\n9 10 11 1e2\n";
static const char NONUNIFORM[] = "4 10 20 30 45\n1 1 2 3 4\n2.5 5 6 7 8\n7 9 10 11 12\n";
static const char ODD_NUMBERS[] =
    "0x10 1e1 1.5E2\n0x10 +2e1 -.5\n0x10 30. .25e+1\n\n1.7E1 10 7\n17 20 NaN\n17 30 1e-3\n";

static void points_are_gnuplots(void **state) {
    static const struct {
        const char *data, *command;
    } cases[] = {
        {THREE, ""},
        {THREE, "using 1:2:3"},
        {THREE, "using 1:(\\$2*2):(\\$3*2+column(1))"},
        {THREE, "using 3"},
        {THREE, "using 2-1:1+1:6/2"},
        {THREE, "using 1:2:(\\$3+1)/2"},
        {TWO_SETS, "skip 8 index 0 using 1:2:3:(\\$1)"},
        {TWO_SETS, "skip 8 index 1 volatile"},
        {THREE, "using 2:1:3"},
        {THREE, "using 1:(-\\$2):3"},
        {THREE, "u 2:(-\\$1):(\\$3**2)"},
        {THREE, "using -1:2:3"},
        {THREE, "using (\\$1):2:(\\$3>4?1/0:\\$3)"},
        {TWO_SETS, "index 0"},
        {TWO_SETS, "index 1"},
        {TWO_SETS, "index (0)"},
        {TWO_SETS, "index 1-1"},
        {TWO_SETS, "index 0:1-1"},
        {TWO_SETS, "index 0 using 3 every 2"},
        {TWO_SETS, "index 0 every :2"},
        {TWO_SETS, "index 0 every 2::1"},
        {TWO_SETS, "index 0 every ::1:1:2:2"},
        {MATRIX, "matrix"},
        {MATRIX, "matrix using 2:1:3"},
        {MATRIX, "matrix using (\\$1*0.5):(\\$2-3):(\\$3*2)"},
        {MATRIX, "matrix using 1:2:(\\$1+\\$2)"},
        {MATRIX, "matrix every 2"},
        {NONUNIFORM, "nonuniform matrix"},
        {NONUNIFORM, "nonuniform matrix using 1:2:(-\\$3)"},
        {ODD_NUMBERS, ""},
    };
    fixture_t *f = *state;
    static point_t theirs[4096], ours[4096];
    int checked = 0;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        int n = gnuplot_points(cases[i].command, cases[i].data, strlen(cases[i].data), theirs, 4096);
        if (n < 0) skip();
        char line[256] = "splot 'f' ";
        for (const char *p = cases[i].command; *p; p++)
            if (*p != '\\') snprintf(line + strlen(line), sizeof line - strlen(line), "%c", *p);
        fixture_file(f, 0, "f", cases[i].data);
        assert_int_equal(fixture_feed(f, line), 0);
        int m = our_points(f, ours);
        assert_points(line, ours, m, theirs, n);
        checked += n;
    }
    printf("# %d points of %d data commands equal gnuplot's\n", checked, (int)(sizeof cases / sizeof cases[0]));
}

/* The same grid written in the eight orders a file may have: the surface must be the same. */
static void every_direction_gives_the_same_surface(void **state) {
    fixture_t *f = *state;
    enum { NX = 4, NY = 3 };
    static const double x[NX] = {-1, 0.25, 1, 7}, y[NY] = {2, 3.5, 100};
    for (int order = 0; order < 8; order++) {
        for (int blanks = 0; blanks < 2; blanks++) {
            char text[1024] = "";
            bool y_inner = order & 1, x_down = order & 2, y_down = order & 4;
            int outer_n = y_inner ? NX : NY, inner_n = y_inner ? NY : NX;
            for (int o = 0; o < outer_n; o++) {
                for (int k = 0; k < inner_n; k++) {
                    int i = y_inner ? o : k, j = y_inner ? k : o;
                    if (x_down) i = NX - 1 - i;
                    if (y_down) j = NY - 1 - j;
                    snprintf(text + strlen(text), sizeof text - strlen(text), "%g, %g, %d\n", x[i], y[j], i + 10 * j);
                }
                if (blanks) strcat(text, "\n");
            }
            fixture_file(f, 0, "f", text);
            assert_int_equal(fixture_feed(f, "splot 'f' w l"), 0);
            assert_int_equal(f->item[0].nx, NX);
            assert_int_equal(f->item[0].ny, NY);
            for (int j = 0, p = 0; j < NY; j++)
                for (int i = 0; i < NX; i++, p++)
                    assert_true(f->x[p] == x[i] && f->y[p] == y[j] && f->z[p] == i + 10 * j);
            assert_int_equal(fixture_feed(f, "splot [0:1] [*:50] 'f' w l"), 0); /* cut to the ranges */
            assert_int_equal(f->item[0].nx, 2);
            assert_int_equal(f->item[0].ny, 2);
            assert_true(f->x[0] == 0.25 && f->x[1] == 1 && f->y[3] == 3.5 && f->z[0] == 1 && f->z[3] == 12);
            assert_int_equal(fixture_feed(f, "splot [0:0.5] 'f'"), ERR_EMPTY);
        }
    }
}

static void wrong_data_name_their_line(void **state) {
    static const struct {
        const char *options, *data;
        int code, line, column;
        const char *message;
    } cases[] = {
        {"", "0 0 1\n0 1 2\n\n1 0 3\n1 1 4\n1 2 5\n", ERR_DATA, 6, 0, "another number of points"},
        {"", "0 0 1\n0 1 2\n\n1 0 3\n\n2 0 1\n2 1 1\n", ERR_DATA, 5, 0, "another number of points"},
        {"", "0 0 1\n1 1 2\n\n1 0 3\n1 1 4\n", ERR_DATA, 2, 0, "neither"},
        {"", "0 0 1\n0 1 2\n0 2 3\n\n1 0 3\n1 1.1 4\n1 2 3\n", ERR_DATA, 6, 0, "another coordinate"},
        {"", "0 0 1\n0 1 2\n0 0.5 3\n", ERR_DATA, 3, 0, "keep increasing"},
        {"", "0 0 1\n0 1 2\n\n0 0 1\n0 1 2\n", ERR_DATA, 4, 0, "keep increasing"},
        {"", "0 0 1\n0 1 2\n\n1 0 1\n1 1 2\n\n0.5 0 1\n", ERR_DATA, 7, 0, "keep increasing"},
        {"", "0 0 1\n0 1 2\n\n1 0 1\n1.5 1 2\n", ERR_DATA, 5, 0, "neither"},
        {"", "0 0 1\n0 1 2\n", ERR_DATA, 2, 0, "2 x 2"},
        {"", "0 0 1\n\n1 0 1\n", ERR_DATA, 2, 0, "2 x 2"},
        {"", "1 2\n3 4\n", ERR_DATA, 1, 0, "not two"},
        {"", "0 0 1\n0 1 x\n", ERR_DATA, 2, 5, "not a number"},
        {"", "0 0 1\n0 1e 2\n", ERR_DATA, 2, 3, "not a number"},
        {"", "0 0 1\n0 1\n", ERR_DATA, 2, 0, "lacks a number"},
        {"", "0 0 1\n0 ? 1\n", ERR_DATA, 2, 0, "x or y"},
        {"using 1:2:4", "0 0 1\n0 1 2\n", ERR_DATA, 1, 0, "lacks a number"},
        {"matrix", "1 2 3\n4 5\n7 8 9\n", ERR_DATA, 2, 0, "another number of points"},
        {"matrix", "1 2 3\n4 5 6 7\n7 8 9\n", ERR_DATA, 2, 0, "another number of points"},
        {"matrix", "1 2\n3 z\n", ERR_DATA, 2, 3, "not a number"},
        {"nonuniform matrix", "2 1 2\n1 3 4\n2 5 6 7\n", ERR_DATA, 3, 7, "another number of points"},
        {"nonuniform matrix", "2 1 2\n? 3 4\n2 5 6\n", ERR_DATA, 2, 0, "x or y"},
        {"", "", ERR_EMPTY, 2, 7, "no data"},
        {"index 3", "0 0 1\n0 1 2\n\n1 0 1\n1 1 2\n", ERR_EMPTY, 2, 7, "no data"},
        {"using 1:2:(nobody)", "0 0 1\n0 1 2\n\n1 0 1\n1 1 2\n", ERR_NAME, 2, 22, "nobody"},
    };
    fixture_t *f = *state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char line[128];
        session_init(&f->session, &f->port, f->pool, sizeof f->pool);
        fixture_file(f, 0, "f", cases[i].data);
        assert_int_equal(fixture_feed(f, "set hidden3d horizon"), 0); /* which takes nothing but grids */
        snprintf(line, sizeof line, "splot 'f' %s", cases[i].options);
        int err = fixture_feed(f, line);
        const lang_error_t *e = &f->session.error;
        if (err != cases[i].code || e->line != cases[i].line || e->column != cases[i].column ||
            !strstr(e->message, cases[i].message))
            fail_msg("%s of\n%s\n gave %d line %d column %d: %s", line, cases[i].data, err, e->line, e->column,
                     e->message);
        if (err == ERR_DATA) assert_non_null(strstr(f->err, "\"f\", line "));
        assert_int_equal(f->plots, 0);
    }
}

static void holes_and_headings(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "f", "x y height\n0 0 1\n0 1 NaN\n0 2 ?\n\n1 0 nan\n1 1 -inf\n1 2 2\n");
    assert_int_equal(fixture_feed(f, "splot 'f'"), 0);
    assert_true(f->z[0] == 1 && f->z[5] == 2);
    for (int k = 1; k < 5; k++) assert_true(isnan(f->z[k]));
    fixture_file(f, 0, "f", "0,0,\n0,1,2\n\n1,0,3\n1,1,4\n");
    assert_int_equal(fixture_feed(f, "splot 'f'"), 0);
    assert_true(isnan(f->z[0]) && f->z[3] == 4);
    fixture_file(f, 0, "f", "0;0; 1 \n0;1;2\n\n1;0;3\n1;1;\n");
    assert_int_equal(fixture_feed(f, "set datafile separator ';'; splot 'f'"), 0);
    assert_true(f->z[0] == 1 && isnan(f->z[3]));
    /* What a number is made of separates all the same. */
    for (const char *c = ".e-5+d"; *c; c++) {
        char text[64], line[64];
        snprintf(text, sizeof text, "10%c0%c1\n10%c1%c2\n\n11%c0%c3\n11%c1%c4\n", *c, *c, *c, *c, *c, *c, *c, *c);
        snprintf(line, sizeof line, "set datafile separator '%c'; splot 'f'", *c);
        fixture_file(f, 0, "f", text);
        assert_int_equal(fixture_feed(f, line), 0);
        assert_true(f->z[0] == 1 && f->z[1] == 3 && f->z[2] == 2 && f->z[3] == 4);
    }
    /* Files are rounded: a millionth of a step is not another place. */
    fixture_file(f, 0, "f",
                 "0 0.333333 1\n0 0.666667 2\n0 1 2d0\n\n1 0.333334 3\n1.000000001 0.666666 4\n1 1.000001 1\n");
    assert_int_equal(fixture_feed(f, "unset datafile; splot 'f'"), 0);
    assert_true(f->y[2] == 0.666667 && f->z[4] == 2);
}

static void inline_data(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "splot '-' w l, x*y, '-' matrix; print 'done'\n0 0 1\n0 1 2"), 0);
    assert_int_equal(session_state(&f->session), SESSION_DATA);
    assert_int_equal(f->plots, 0);
    assert_int_equal(fixture_feed(f, "\n3 0 5\n3 1 6\n  e\n1 2 3\n4 5 6\ne"), 0);
    assert_int_equal(session_state(&f->session), SESSION_READY);
    assert_string_equal(f->out, "done\n");
    assert_int_equal(f->items, 3);
    assert_true(f->z[0] == 1 && f->z[1] == 5 && f->z[3] == 6);
    /* Beside data, functions are drawn over the extent of the data, as gnuplot does. */
    assert_true(f->x[f->item[1].first] == 0 && f->x[f->item[1].first + 9] == 3 && f->y[f->item[1].first + 99] == 1);
    /* replot has the rows still, and may add. */
    assert_int_equal(fixture_feed(f, "set view 10,10; replot x+y"), 0);
    assert_int_equal(f->items, 4);
    assert_true(f->z[1] == 5 && f->z[f->item[2].first + 5] == 6);
    assert_int_equal(fixture_feed(f, "replot '-'\n0 0 1\n1 0 2\n\n0 1 3\n1 1 4\ne\nprint 1"), 0);
    assert_int_equal(f->items, 5);
    assert_true(f->z[f->item[4].first + 2] == 3 && f->z[1] == 5);
    /* What fails in between does not cost the rows. */
    assert_int_equal(fixture_feed(f, "splot x, y, nobody(x)"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "replot '-'\n1 x"), ERR_DATA);
    assert_int_equal(fixture_feed(f, "replot"), 0);
    assert_int_equal(f->items, 5);
    assert_true(f->z[f->item[4].first + 2] == 3 && f->z[1] == 5);
    /* An error names the line of the text. */
    session_source(&f->session, "t.gp");
    assert_int_equal(fixture_feed(f, "# first\nsplot '-'\n0 0 1\n0 1 z"), ERR_DATA);
    assert_int_equal(f->session.error.line, 4);
    assert_int_equal(f->session.error.column, 5);
    assert_non_null(strstr(f->err, "\"t.gp\", line 4, column 5"));
    /* The end of the text ends the data. */
    assert_int_equal(fixture_feed(f, "splot '-'\n0 0 1\n0 1 2\n\n1 0 3\n1 1 4.5"), 0);
    assert_int_equal(session_end(&f->session), 0);
    assert_true(f->z[3] == 4.5);
    /* In a loaded file, in small pieces, and what follows is executed. */
    fixture_file(
        f, 0, "a.gp",
        "splot '-'; print 'a'\n0 0 1\n0 1 2\n\n1 0 3\n1 1 4\ne this is left out\nprint 'b'\nsplot '-'\n1\n2\n\n5\n7\n");
    assert_int_equal(fixture_feed(f, "load 'a.gp'; print 'c'"), 0);
    assert_string_equal(f->out, "a\nb\nc\n");
    assert_true(f->z[3] == 7 && f->x[3] == 1 && f->y[3] == 1);
}

static void several_sets_are_several_surfaces(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "f", TWO_SETS);
    assert_int_equal(fixture_feed(f, "splot 'f', '' index 1 using 1:2:(-$3) t 'down'"), 0);
    assert_int_equal(f->items, 3);
    assert_int_equal(f->item[0].nx, 3);
    assert_int_equal(f->item[0].ny, 4);
    assert_int_equal(f->item[1].nx, 2);
    assert_true(f->z[f->item[2].first] == -1);
    assert_string_equal(f->item[2].title, "down");
    char many[1024] = "";
    for (int k = 0; k < CONFIG_PLOT_ITEMS + 1; k++) strcat(many, "0 0 1\n0 1 2\n\n1 0 3\n1 1 4\n\n\n");
    fixture_file(f, 0, "f", many);
    assert_int_equal(fixture_feed(f, "splot 'f'"), ERR_FULL);
    assert_int_equal(fixture_feed(f, "splot 'f' index 2:3"), 0);
    assert_int_equal(f->items, 2);
    assert_int_equal(fixture_feed(f, "splot 'f' index 5:"), 0);
    assert_int_equal(f->items, CONFIG_PLOT_ITEMS + 1 - 5);
}

static void a_full_pool_is_an_ordinary_error(void **state) {
    fixture_t *f = *state;
    static const char rows[] = "0 0 1\n0 1 2\n\n1 0 3\n1 1 4\n";
    fixture_file(f, 0, "f", rows);
    fixture_file(f, 1, "n", "2 0 1\n0 1 2\n1 3 4\n");
    for (size_t size = 0; size <= 12; size++) {
        session_init(&f->session, &f->port, f->pool, size * 8);
        assert_int_equal(fixture_feed(f, "splot 'f'"), size < 8 ? ERR_FULL : 0); /* 4 heights, 2 + 2 coordinates */
        assert_int_equal(fixture_feed(f, "splot 'n' nonuniform matrix"), size < 10 ? ERR_FULL : 0);
    }
    session_init(&f->session, &f->port, NULL, 0);
    assert_int_equal(fixture_feed(f, "splot 'f'"), ERR_FULL);
    assert_non_null(strstr(f->err, "memory"));
    assert_int_equal(fixture_feed(f, "splot x*y"), 0);
}

static void curves_of_data(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "f", "# x y\n0 1 9\n2 NaN 9\n1 3 9\n\n5 4 9\n\n\n-1 7 8\n");
    assert_int_equal(fixture_feed(f, "set samples 5; plot 'f' using 1:($2*2) with lines, x**2, 'f' u 2"), 0);
    assert_int_equal(f->kind, PLOT_CURVES);
    assert_int_equal(f->items, 3);
    static const double x[] = {0, 0, 1, 1, 5, 5, -1}, y[] = {2, NAN, 6, NAN, 8, NAN, 14};
    assert_int_equal(f->item[0].nx, 7);
    for (int i = 0; i < 7; i++) assert_true(f->x[i] == x[i] && (f->z[i] == y[i] || (isnan(f->z[i]) && isnan(y[i]))));
    int p = f->item[1].first; /* beside data, over their extent */
    assert_true(f->x[p] == -1 && f->x[p + 4] == 5 && f->z[p + 4] == 25);
    p = f->item[2].first; /* counted within each block */
    assert_true(f->x[p] == 0 && f->z[p] == 1 && f->x[p + 2] == 2 && f->z[p + 2] == 3);
    assert_int_equal(fixture_feed(f, "plot '-', '-'\n1\n4\ne\n3 3\n4 5\n"), 0);
    assert_int_equal(session_end(&f->session), 0);
    assert_true(f->x[1] == 1 && f->z[1] == 4 && f->x[3] == 4 && f->z[3] == 5);
    assert_int_equal(fixture_feed(f, "plot '-'\n1 x\n"), ERR_DATA);
    assert_int_equal(f->session.error.column, 3);
    session_init(&f->session, &f->port, f->pool, 3 * 16);
    assert_int_equal(fixture_feed(f, "plot 'f'"), ERR_FULL);
}

static void terrains_are_meshes(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "t.obj",
                 "# a roof\nmtllib x\\y.mtl\no roof\nv 0 0 1.5\nv 1 0 2 # with a weight\r\nv 1 1 -3e0 1.0\nv 0 1 4\nvn "
                 "0 0 1\nvt 0 0\n"
                 "f 1/1/1 2//1 3/2\nf -4 \\\n -2 -1\nf 1 1 2\nv 2 0 7\nv 2 1 8\nf 1 2 3 4\nf 2 5 6 3");
    assert_int_equal(fixture_feed(f, "splot 't.obj' with lines"), 0);
    assert_int_equal(f->kind, PLOT_SOLIDS);
    assert_int_equal(f->mesh.nv, 6);
    assert_int_equal(f->mesh.faces, 5);
    assert_int_equal(f->mesh.corners, 17);
    int32_t sum = 0, triangles = 0;
    mesh_walk_t walk = mesh_walk(&f->mesh);
    for (int32_t v[3]; mesh_triangle(&walk, v); triangles++)
        for (int c = 0; c < 3; c++) sum += v[c];
    assert_int_equal(triangles, 6);
    assert_int_equal(sum, 3 + 5 + 3 + 5 + 10 + 8);
    assert_true(fixture_double(packed_num(f->mesh.vertex[2][2])) == -3);
    assert_true(fixture_double(packed_num(f->mesh.vertex[5][0])) == 2);
    static const struct {
        const char *text;
        int code, line, column;
    } bad[] = {
        {"v 1 2\n", ERR_DATA, 1, 6},          {"v 1 2 z\n", ERR_DATA, 1, 7},
        {"v 0 0 0\nf 1 2 3", ERR_DATA, 2, 5}, {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", ERR_DATA, 4, 6},
        {"v 0 0 0\nf x", ERR_DATA, 2, 3},     {"v 0 0 0\n", ERR_EMPTY, 1, 7},
        {"v 0 0 nan\n", ERR_DATA, 1, 7},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        session_init(&f->session, &f->port, f->pool, sizeof f->pool);
        fixture_file(f, 0, "t.obj", bad[i].text);
        assert_int_equal(fixture_feed(f, "splot 't.obj'"), bad[i].code);
        assert_int_equal(f->session.error.line, bad[i].line);
        assert_int_equal(f->session.error.column, bad[i].column);
    }
    fixture_file(f, 0, "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3");
    for (size_t units = 0; units < 13; units++) {
        session_init(&f->session, &f->port, f->pool, units * 8);
        assert_int_equal(fixture_feed(f, "splot 't.obj'"), units < 11 ? ERR_FULL : 0); /* 9 for vertices, 2 */
    }
    assert_int_equal(fixture_feed(f, "splot 't.obj', x*y"), 0); /* among surfaces */
    assert_int_equal(f->kind, PLOT_SOLIDS);
    assert_int_equal(f->items, 2);
}

/* Whole megabytes through the reader alone. */
static void reading_is_fast(void **state) {
    (void)state;
    enum { N = 300 };
    size_t size = (size_t)N * N * 40, n = 0;
    char *text = malloc(size);
    data_pool_t pool = {malloc((N * N + 2 * N) * sizeof(packed_t)), 0, N * N + 2 * N};
    for (int j = 0; j < N; j++) {
        for (int i = 0; i < N; i++)
            n +=
                (size_t)snprintf(text + n, size - n, "%.6f %.6f %.9f\n", i / 7.0, j / 3.0, sin(i * 0.1) * cos(j * 0.1));
        text[n++] = '\n';
    }
    data_spec_t spec;
    data_grid_t grid;
    data_reader_t reader;
    data_spec_default(&spec);
    clock_t start = clock();
    data_reader_start(&reader, &spec, &pool, &grid, NULL, 1, false, 0);
    for (size_t at = 0; at < n; at += CONFIG_READ_CHUNK) {
        size_t left = n - at;
        assert_int_equal(data_reader_feed(&reader, text + at, left < CONFIG_READ_CHUNK ? left : CONFIG_READ_CHUNK), 0);
    }
    assert_int_equal(data_reader_finish(&reader), 1);
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("# rows x y z: %.0f MB/s, %.0f ns per point\n", (double)n / 1e6 / seconds, seconds * 1e9 / (N * N));
    data_view_t v;
    surface_t s;
    assert_int_equal(data_grid_surface(&grid, NULL, NULL, &v, &s), 0);
    assert_int_equal(s.nx, N);
    assert_int_equal(s.ny, N);
    double worst = 0;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            double z = fixture_double(s.z_of(s.ctx, i, j));
            worst = fmax(worst, fabs(z - sin(i * 0.1) * cos(j * 0.1)));
        }
    assert_true(worst < 0.6e-9);
    free(text);
    free(pool.base);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(points_are_gnuplots, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(every_direction_gives_the_same_surface, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(wrong_data_name_their_line, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(holes_and_headings, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(inline_data, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(several_sets_are_several_surfaces, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(a_full_pool_is_an_ordinary_error, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(curves_of_data, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(terrains_are_meshes, fixture_setup, fixture_teardown),
        cmocka_unit_test(reading_is_fast),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
