/* test_binary.c - binary data: what gnuplot reads from them, and errors. */
#include "data_points.h"

enum { BYTES = 4000 };

typedef struct bytes {
    char at[BYTES];
    size_t n;
} bytes_t;

static void put(bytes_t *b, const void *from, size_t n) {
    assert_true(b->n + n <= BYTES);
    memcpy(b->at + b->n, from, n);
    b->n += n;
}
static void put_float(bytes_t *b, double v) {
    const float f = (float)v;
    put(b, &f, sizeof f);
}

/* 4 columns, 3 rows, not evenly spaced. */
static void matrix(bytes_t *b) {
    put_float(b, 4);
    for (int i = 0; i < 4; i++) put_float(b, i * i * .5 - 1);
    for (int j = 0; j < 3; j++) {
        put_float(b, 10 + 3 * j + j * j);
        for (int i = 0; i < 4; i++) put_float(b, (i * 7 + j * 3) % 11 * -1.25e-3 + 1e-39 * i);
    }
}

static void floats(bytes_t *b) {
    for (int k = 0; k < 24; k++) put_float(b, k * k % 17 / 3. - 2);
}

static void doubles(bytes_t *b) {
    for (int k = 0; k < 12; k++) put(b, &(double){k * k % 7 * 1e-5}, sizeof(double));
}

static void records(bytes_t *b) {
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 4; i++) {
            const int16_t label = (int16_t)(i - 2);
            put_float(b, i * 2);
            put(b, &label, sizeof label);
            put_float(b, j - .5);
            put_float(b, i * j);
        }
}

static void small(bytes_t *b) {
    for (int k = 0; k < 96; k++) put(b, &(uint8_t){(uint8_t)(k * 37)}, 1);
}

static void swapped(bytes_t *b) {
    floats(b);
    for (size_t k = 0; k < b->n; k += 4) {
        const char word[4] = {b->at[k + 3], b->at[k + 2], b->at[k + 1], b->at[k]};
        memcpy(b->at + k, word, 4);
    }
}

static void points_are_gnuplots(void **state) {
    static const struct {
        void (*data)(bytes_t *b);
        const char *command;
    } CASES[] = {
        {matrix, "binary"},
        {matrix, "binary matrix using 1:2:3"},
        {matrix, "binary using 2:1:3"},
        {matrix, "binary using 3"},
        {matrix, "binary using (\\$1*2):2:(\\$3+column(1)*\\$2)"},
        {matrix, "binary every 2:2"},
        {matrix, "binary every ::1:1"},
        {floats, "binary array=(4,3)"},
        {floats, "binary array=(4,6) using 1"},
        {floats, "binary array=(4,-1) using 1"},
        {floats, "binary array=(4,6) dx=2 dy=0.5 origin=(1,-1,5) using 1"},
        {floats, "binary array=(4,6) flipy using 1"},
        {floats, "binary array=(4,6) flip=x using 1"},
        {floats, "binary array=(4,6) flipx flipy dx=3 using 1"},
        {floats, "binary array=(4,6) transpose using 1"},
        {floats, "binary array=(4,6) transpose flipy dx=2 dy=1 using 1"},
        {floats, "binary array=(4,6) dy=2 using 1"},
        {floats, "binary array=(4,6) center=(0,10,0) dx=2 using 1"},
        {floats, "binary array=(4,5) skip=16 using 1"},
        {floats, "binary array=(4,3) format='%*float%float' using 1"},
        {floats, "binary array=(4,6) using 1 every 1:2"},
        {floats, "binary array=(4,2) format='%float' using 1"},
        {doubles, "binary array=(4,3) format='%double'"},
        {doubles, "binary array=(4,3) format='%float64' using 1"},
        {records, "binary record=(4,3) format='%float%*short%2float' using 1:2:3"},
        {records, "binary record=(4,3) format='%float%short%float%float' using 1:3:(\\$4+\\$2)"},
        {records, "binary format='%float%*int16%float' using 1:2:3"},
        {small, "binary array=(8,12) format='%uchar' using 1"},
        {small, "binary array=(8,12) format='%char' using 1"},
        {small, "binary array=(8,6) format='%short' using 1"},
        {small, "binary array=(8,6) format='%ushort' endian=big using 1"},
        {small, "binary array=(4,6) format='%int' using 1"},
        {small, "binary array=(4,6) format='%uint' using 1"},
        {small, "binary array=(3,4) format='%int64' using 1"},
        {small, "binary array=(3,4) format='%uint64' using 1"},
        {swapped, "binary array=(4,6) endian=swap using 1"},
        {swapped, "binary array=(4,6) endian=big using 1"},
    };
    fixture_t *f = *state;
    static point_t theirs[4096], ours[4096];
    int checked = 0;
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        bytes_t b = {.n = 0};
        CASES[i].data(&b);
        int n = gnuplot_points(CASES[i].command, b.at, b.n, theirs, 4096);
        if (n < 0) skip();
        char line[256] = "splot 'f' ";
        for (const char *p = CASES[i].command; *p; p++)
            if (*p != '\\') snprintf(line + strlen(line), sizeof line - strlen(line), "%c", *p);
        fixture_file(f, 0, "f", b.at);
        f->file[0].size = b.n;
        if (fixture_feed(f, line)) fail_msg("%s: %s", line, f->err);
        assert_true(n >= 4);
        assert_points(line, ours, our_points(f, ours), theirs, n);
        checked += n;
    }
    printf("# %d points of %d binary files equal gnuplot's\n", checked, (int)(sizeof CASES / sizeof CASES[0]));
}

/* gnuplot 5.4 draws the first column of an array whatever `using` says of lines; its manual knows better. */
static void columns_of_arrays(void **state) {
    static const struct {
        const char *command;
        double second, last;
    } CASES[] = {
        {"format='%float%float' using 2", 9 / 3. - 2, (23 * 23 % 17) / 3. - 2},
        {"format='%2float' using ($2*0+column(1))", 4 / 3. - 2, (22 * 22 % 17) / 3. - 2},
        {"using ($1+$2)", 4 / 3. + 9 / 3. - 4, (22 * 22 % 17 + 23 * 23 % 17) / 3. - 4},
    };
    fixture_t *f = *state;
    bytes_t b = {.n = 0};
    floats(&b);
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        char line[128];
        snprintf(line, sizeof line, "splot 'f' binary array=(4,3) %s", CASES[i].command);
        fixture_file(f, 0, "f", b.at);
        f->file[0].size = b.n;
        assert_int_equal(fixture_feed(f, line), 0);
        assert_int_equal(f->points, 12);
        assert_true(fabs(f->z[1] - CASES[i].second) < 1e-5);
        assert_true(fabs(f->z[11] - CASES[i].last) < 1e-5);
    }
}

static void mistakes(void **state) {
    static const struct {
        void (*data)(bytes_t *b);
        const char *command, *says;
    } CASES[] = {
        {matrix, "binary binary", "given twice"},
        {floats, "binary", "no binary matrix"},
        {floats, "binary array=(4,7)", "the file ends before its data are complete"},
        {floats, "binary array=(5,-1)", "the file ends before its data are complete"},
        {floats, "binary array=(4,6) skip=1", "the file ends before its data are complete"},
        {floats, "binary array=(4,6) skip=1000000", "the file ends before its data are complete"},
        {floats, "binary array=(4,6) using 1:2:3", "points of an array are where they stand"},
        {floats, "binary array=(4,-1) flipy", "an array without an end"},
        {floats, "binary array=(-1,4)", "only the number of rows may be -1"},
        {floats, "binary array=(0,4)", "a number of points is at least 1"},
        {floats, "binary array=(4,6", ") expected"},
        {floats, "binary array 4", "= expected"},
        {floats, "binary array=(2,3):(2,3)", "one record"},
        {floats, "binary array=(4,6) format='float'", "a type begins with %"},
        {floats, "binary array=(4,6) format='%flat'", "the types are"},
        {floats, "binary array=(4,6) format='%99float'", "too many fields"},
        {floats, "binary array=(4,6) format='%*float'", "the file ends"},
        {floats, "binary array=(4,6) endian=middle", "little, big"},
        {floats, "binary array=(4,6) flip=z", "x, y or xy"},
        {floats, "binary array=(4,6) using (column(\\$1))", "a format is needed"},
        {floats, "binary filetype=png", "not supported"},
        {floats, "binary array=(4,6) matrix", "no binary matrix"},
        {floats, "binary record=(4,2)", "not a grid"},
    };
    fixture_t *f = *state;
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        bytes_t b = {.n = 0};
        CASES[i].data(&b);
        char line[256] = "unset hidden3d; set hidden3d horizon; splot 'f' ";
        for (const char *p = CASES[i].command; *p; p++)
            if (*p != '\\') snprintf(line + strlen(line), sizeof line - strlen(line), "%c", *p);
        fixture_file(f, 0, "f", b.at);
        f->file[0].size = b.n;
        f->plots = 0;
        assert_true(fixture_feed(f, line) < 0);
        assert_int_equal(f->plots, 0);
        if (!strstr(f->err, CASES[i].says)) fail_msg("%s: %s", line, f->err);
    }
    assert_true(fixture_feed(f, "splot '-' binary") < 0);
    assert_true(fixture_feed(f, "plot 'f' binary matrix") < 0);
}

static void the_pool_may_be_full(void **state) {
    fixture_t *f = *state;
    bytes_t b = {.n = 0};
    matrix(&b);
    fixture_file(f, 0, "f", b.at);
    f->file[0].size = b.n;
    for (size_t units = 0; units < 28; units++) { /* 12 heights, 4 columns, 3 rows, the 4 columns as they were read */
        session_init(&f->session, &f->port, f->pool, units * 8);
        assert_int_equal(fixture_feed(f, "splot 'f' binary"), units < 23 ? ERR_FULL : 0);
    }
}

/* Curves, too. */
static void curves(void **state) {
    fixture_t *f = *state;
    bytes_t b = {.n = 0};
    floats(&b);
    fixture_file(f, 0, "f", b.at);
    f->file[0].size = b.n;
    assert_int_equal(fixture_feed(f, "plot 'f' binary format='%float%float' using 1:2"), 0);
    assert_int_equal(f->points, 12);
    assert_int_equal(fixture_feed(f, "plot 'f' binary array=24 dx=0.5 using 1"), 0);
    assert_int_equal(f->points, 24);
    assert_true(fabs(f->x[3] - 1.5) < 1e-12);
    assert_int_equal(fixture_feed(f, "plot 'f' binary array=-1 using 1"), 0);
    assert_int_equal(f->points, 24);
    assert_int_equal(fixture_feed(f, "plot 'f' binary record=-1 using 1:2"), 0);
    assert_int_equal(f->points, 12);
}

/* What follows what was asked for is not looked at: half a number, or a file without an end. */
static void the_rest_is_left(void **state) {
    fixture_t *f = *state;
    bytes_t b = {.n = 0};
    floats(&b);
    put(&b, "xyz", 3);
    fixture_file(f, 0, "f", b.at);
    f->file[0].size = b.n;
    assert_int_equal(fixture_feed(f, "splot 'f' binary array=(4,6) using 1"), 0);
    assert_int_equal(f->points, 24);
    assert_int_equal(fixture_feed(f, "plot 'f' binary record=12 using 1:2"), 0);
    assert_int_equal(f->points, 12);
    assert_int_equal(fixture_feed(f, "splot 'f' binary array=(4,-1) using 1"), ERR_DATA);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(points_are_gnuplots, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(columns_of_arrays, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(mistakes, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(the_pool_may_be_full, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(curves, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(the_rest_is_left, fixture_setup, fixture_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
