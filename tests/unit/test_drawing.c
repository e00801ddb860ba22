/* test_drawing.c - strokes as they were drawn, and the files of every format read back against them. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "error.h"
#include "host/drawing.h"
#include "host/writer.h"

static uint32_t seed = 1;
static uint32_t random_below(uint32_t n) {
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)(((uint64_t)seed * n) >> 32);
}

static page_point_t random_point(void) {
    return (page_point_t){(int32_t)random_below(297 * LAT_PER_MM), (int32_t)random_below(210 * LAT_PER_MM)};
}

static void fill(drawing_t *d, size_t strokes, uint32_t longest) {
    pen_sink_t sink = drawing_sink(d);
    for (size_t s = 0; s < strokes; s++) {
        sink.move(sink.ctx, random_point());
        for (uint32_t n = random_below(longest) + 1; n; n--) sink.draw(sink.ctx, random_point());
    }
}

static char name[64];
static const char *temporary(const char *suffix) {
    snprintf(name, sizeof name, "/tmp/ridgeline-test-%d%s", (int)getpid(), suffix);
    return name;
}

static char *slurp(const char *path) {
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    assert_int_equal(fseek(f, 0, SEEK_END), 0);
    long size = ftell(f);
    rewind(f);
    char *text = malloc((size_t)size + 1);
    assert_non_null(text);
    assert_int_equal(fread(text, 1, (size_t)size, f), size);
    text[size] = 0;
    fclose(f);
    remove(path);
    return text;
}

static double mm(int32_t lat) {
    return (double)lat / LAT_PER_MM;
}

static void strokes_are_kept(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    pen_sink_t s = drawing_sink(&d);
    page_point_t a = {1, 2}, b = {3, 4}, c = {-5, 6};
    s.move(s.ctx, c);
    s.move(s.ctx, a); /* the first move led to nothing */
    s.draw(s.ctx, b);
    s.draw(s.ctx, b);
    s.move(s.ctx, c);
    s.draw(s.ctx, c); /* a dot */
    s.move(s.ctx, a); /* and nothing after the last */
    assert_int_equal(d.strokes, 2);
    size_t n;
    const page_point_t *p = drawing_stroke(&d, 0, &n);
    assert_int_equal(n, 3);
    assert_memory_equal(&p[0], &a, sizeof a);
    assert_memory_equal(&p[2], &b, sizeof b);
    p = drawing_stroke(&d, 1, &n);
    assert_int_equal(n, 2);
    assert_memory_equal(&p[1], &c, sizeof c);
    drawing_clear(&d);
    assert_int_equal(d.strokes, 0);
    fill(&d, 3000, 5);
    assert_int_equal(d.strokes, 3000);
    drawing_free(&d);
}

static void take_stroke(void *ctx, const page_point_t *point, size_t n) {
    pen_sink_t sink = drawing_sink(ctx);
    sink.move(sink.ctx, point[0]);
    for (size_t i = 1; i < n; i++) sink.draw(sink.ctx, point[i]);
}

static void strokes_are_handed_on(void **state) {
    (void)state;
    drawing_t kept, passing, got;
    drawing_init(&kept);
    drawing_init(&passing);
    drawing_init(&got);
    drawing_hand_on(&passing, take_stroke, &got);
    seed = 7;
    fill(&kept, 300, 30);
    seed = 7;
    fill(&passing, 300, 30);
    drawing_hand_on(&passing, NULL, NULL); /* the last */
    assert_int_equal(passing.strokes, 300);
    assert_int_equal(passing.points, 0);
    assert_int_equal(got.points, kept.points);
    assert_memory_equal(got.point, kept.point, kept.points * sizeof *kept.point);
    assert_memory_equal(got.first, kept.first, kept.strokes * sizeof *kept.first);
    drawing_free(&kept);
    drawing_free(&passing);
    drawing_free(&got);
}

static void length_counts_travel_from_and_to_the_origin(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    pen_sink_t s = drawing_sink(&d);
    s.move(s.ctx, (page_point_t){3 * LAT_PER_MM, 4 * LAT_PER_MM});
    s.draw(s.ctx, (page_point_t){3 * LAT_PER_MM, 16 * LAT_PER_MM});
    s.move(s.ctx, (page_point_t){0, 16 * LAT_PER_MM});
    s.draw(s.ctx, (page_point_t){0, 10 * LAT_PER_MM});
    drawing_length_t len = drawing_measure(&d);
    assert_true(fabs(len.down_mm - 18) < 1e-12);
    assert_true(fabs(len.up_mm - (5 + 3 + 10)) < 1e-12);
    drawing_free(&d);
}

static void camera_is_kept_in_mm(void **state) {
    (void)state;
    camera_t c = {.m = {{{.m = (int64_t)3 << 61, .e = -61 + 15}}}};
    c.m[2][3] = (num_t){.m = (int64_t)1 << 62, .e = -62};
    drawing_t d;
    drawing_init(&d);
    drawing_set_camera(&d, &c);
    assert_true(d.camera_mm[0][0] == 3 && d.camera_mm[2][3] == 1 && d.camera_mm[1][1] == 0);
}

static void seg_reads_back_to_the_lat(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    for (int i = 0; i < 12; i++) d.camera_mm[i / 4][i % 4] = sin(i + 1) * pow(10, i - 6);
    fill(&d, 500, 20);
    assert_int_equal(writer_write(&d, NULL, temporary(".seg")), 0);
    char *text = slurp(name), *p = text;
    assert_memory_equal(p, "# camera ", 9);
    p += 9;
    for (int i = 0; i < 12; i++) assert_true(strtod(p, &p) == d.camera_mm[i / 4][i % 4]);
    for (size_t s = 0; s < d.strokes; s++) {
        size_t n;
        const page_point_t *q = drawing_stroke(&d, s, &n);
        for (size_t i = 1; i < n; i++) {
            assert_int_equal(*p++, '\n');
            const int32_t want[4] = {q[i - 1].x_lat, q[i - 1].y_lat, q[i].x_lat, q[i].y_lat};
            for (int k = 0; k < 4; k++) {
                char *point = strchr(p, '.');
                assert_int_equal(lround(strtod(p, &p) * LAT_PER_MM), want[k]);
                assert_int_equal(p - point, 7); /* 6 decimals */
            }
        }
    }
    assert_string_equal(p, "\n");
    free(text);
    drawing_free(&d);
}

static void svg_reads_back(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    drawing_set_title(&d, "a < b & \"c\"");
    fill(&d, 200, 10);
    assert_int_equal(writer_write(&d, NULL, temporary(".svg")), 0);
    char *text = slurp(name), *p = text;
    assert_non_null(strstr(text, "width=\"297mm\" height=\"210mm\" viewBox=\"0 0 297 210\""));
    assert_non_null(strstr(text, "<title>a &lt; b &amp; \"c\"</title>"));
    assert_non_null(strstr(text, "stroke-width=\"0.3\" stroke-linecap=\"round\""));
    for (size_t s = 0; s < d.strokes; s++) {
        size_t n;
        const page_point_t *q = drawing_stroke(&d, s, &n);
        p = strstr(p, "d=\"");
        assert_non_null(p);
        p += 3;
        for (size_t i = 0; i < n; i++) {
            assert_int_equal(*p++, i == 0 ? 'M' : i == 1 ? 'L' : ' ');
            assert_true(fabs(strtod(p, &p) - mm(q[i].x_lat)) <= 0.00051);
            assert_int_equal(*p++, ',');
            assert_true(fabs(strtod(p, &p) - (210 - mm(q[i].y_lat))) <= 0.00051);
        }
        assert_memory_equal(p, "\"/>", 3);
    }
    assert_null(strstr(p, "d=\""));
    free(text);
    drawing_free(&d);
}

static void titles_are_utf8(void **state) {
    static const char *const CASES[][2] = {
        {"H\xc3\xbcgel \xe2\x82\xac \xf0\x9f\x98\x80", "H\xc3\xbcgel \xe2\x82\xac \xf0\x9f\x98\x80"},
        {"H\xfcgel\x01\ta\x7f", "H?gel  a "},
        {"\xc3", "?"},                       /* cut short */
        {"\xc0\xaf\xed\xa0\x80", "?????"},   /* overlong; a surrogate */
        {"\xf4\x90\x80\x80 \xff", "???? ?"}, /* beyond Unicode */
    };
    (void)state;
    drawing_t d;
    drawing_init(&d);
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        drawing_set_title(&d, CASES[k][0]);
        assert_string_equal(d.title, CASES[k][1]);
    }
    char many[2 * DRAWING_TITLE_MAX + 1] = "x";
    for (int k = 1; k + 2 < (int)sizeof many; k += 2) memcpy(many + k, "\xc3\xbc", 3);
    drawing_set_title(&d, many);
    assert_int_equal(strlen(d.title), (DRAWING_TITLE_MAX - 1) | 1); /* not half a character */
    assert_memory_equal(d.title, many, strlen(d.title));
    drawing_free(&d);
}

static void hpgl_reads_back(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    fill(&d, 200, 90);
    pen_sink_t sink = drawing_sink(&d);
    sink.move(sink.ctx, (page_point_t){LAT_PER_MM, LAT_PER_MM}); /* shorter than a plotter unit */
    sink.draw(sink.ctx, (page_point_t){LAT_PER_MM + 1, LAT_PER_MM});
    assert_int_equal(writer_write(&d, NULL, temporary(".PLT")), 0);
    char *text = slurp(name), *p = text;
    assert_memory_equal(p, "IN;SP1;", 7);
    p += 7;
    for (size_t s = 0; s < d.strokes; s++) {
        size_t n;
        const page_point_t *q = drawing_stroke(&d, s, &n);
        for (size_t i = 0; i < n; i++) {
            p += strcspn(p, "PU,D");
            while (strchr("PUD,", *p)) p++;
            assert_true(fabs((double)strtol(p, &p, 10) - 40 * mm(q[i].x_lat)) <= 0.5);
            assert_int_equal(*p++, ',');
            assert_true(fabs((double)strtol(p, &p, 10) - 40 * mm(q[i].y_lat)) <= 0.5);
        }
    }
    assert_string_equal(p, ";\nPU0,0;SP0;\n");
    assert_non_null(strstr(text, "PU40,40;\nPD40,40;"));
    free(text);
    drawing_free(&d);
}

static void gcode_says_what_a_plotter_does(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    pen_sink_t s = drawing_sink(&d);
    s.move(s.ctx, (page_point_t){LAT_PER_MM, 2 * LAT_PER_MM});
    s.draw(s.ctx, (page_point_t){3 * LAT_PER_MM / 2, 10 * LAT_PER_MM + 33}); /* 10.001 mm */
    s.draw(s.ctx, (page_point_t){0, 0});
    machine_t m = {.draw_speed_um_s = 100000, .lift_us = 100000, .lower_us = 1250000};
    assert_int_equal(writer_write(&d, &m, temporary(".gcode")), 0);
    char *text = slurp(name);
    assert_non_null(strstr(text, "\nG21\nG90\nM5\nG4 P0.100\n"
                                 "G0 X1 Y2\nM3 S1000\nG4 P1.250\nG1 F6000 X1.5 Y10.001\nX0 Y0\nM5\nG4 P0.100\n"
                                 "G0 X0 Y0\nM2\n"));
    free(text);
    drawing_free(&d);
}

static void pictures_are_what_they_say(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    drawing_set_title(&d, "hill");
    fill(&d, 5, 1000);
    assert_int_equal(writer_write(&d, NULL, temporary(".png")), 0);
    char *text = slurp(name);
    assert_memory_equal(text, "\x89PNG\r\n", 6);
    assert_memory_equal(text + 16, "\x00\x00\x09\x23\x00\x00\x06\x76", 8); /* 2339 x 1654 */
    free(text);
    assert_int_equal(writer_write(&d, NULL, temporary(".pdf")), 0);
    text = slurp(name);
    assert_memory_equal(text, "%PDF-", 5);
    free(text);
    drawing_free(&d);
}

static void names_and_failures(void **state) {
    (void)state;
    char page[20];
    assert_true(writer_page_name(page, sizeof page, "a.b/c.svg", 1));
    assert_string_equal(page, "a.b/c.svg");
    assert_true(writer_page_name(page, sizeof page, "a.b/c.svg", 12));
    assert_string_equal(page, "a.b/c-12.svg");
    assert_true(writer_page_name(page, sizeof page, "a.b/c", 2));
    assert_string_equal(page, "a.b/c-2");
    assert_false(writer_page_name(page, sizeof page, "a-long-long-long-name.svg", 1));
    assert_true(writer_knows("x.SVG") && writer_knows("./x.gcode") && writer_knows("x.plt"));
    assert_false(writer_knows("svg") || writer_knows("x.svg/y") || writer_knows("x.") || writer_knows(".svg"));
    drawing_t d;
    drawing_init(&d);
    fill(&d, 2, 2);
    static const char *const suffix[] = {"svg", "png", "pdf", "seg", "hpgl"};
    for (size_t i = 0; i < sizeof suffix / sizeof suffix[0]; i++) {
        char path[64];
        snprintf(path, sizeof path, "/nonexistent/x.%s", suffix[i]);
        assert_int_equal(writer_write(&d, NULL, path), ERR_FILE);
    }
    assert_int_equal(writer_write(&d, NULL, "x.doc"), ERR_VALUE);
    assert_int_equal(writer_write(&d, NULL, "/dev/full/x.svg"), ERR_FILE);
    drawing_free(&d);
}

/* The file of a large drawing becomes that of a small one, and the other way round. */
static void a_file_is_written_over(void **state) {
    drawing_t small, large;
    (void)state;
    drawing_init(&small);
    drawing_init(&large);
    fill(&small, 3, 4);
    fill(&large, 4000, 20);
    const drawing_t *const in_turn[] = {&small, &large, &small};
    for (int k = 0; k < 3; k++) {
        assert_int_equal(writer_write(in_turn[k], NULL, temporary(".once.seg")), 0);
        char *fresh = slurp(name);
        for (int j = 0; j <= k; j++) assert_int_equal(writer_write(in_turn[j], NULL, temporary(".seg")), 0);
        char *again = slurp(name);
        assert_string_equal(again, fresh);
        free(fresh);
        free(again);
    }
    drawing_free(&small);
    drawing_free(&large);
}

static void large_drawings_are_written_fast(void **state) {
    (void)state;
    drawing_t d;
    drawing_init(&d);
    fill(&d, 4000, 200);
    double segments = (double)(d.points - d.strokes);
    static const char *const suffix[] = {".seg", ".svg", ".hpgl"};
    for (size_t i = 0; i < 3; i++) {
        clock_t start = clock();
        assert_int_equal(writer_write(&d, NULL, temporary(suffix[i])), 0);
        double ns = (double)(clock() - start) / CLOCKS_PER_SEC * 1e9 / segments;
        remove(name);
        printf("# %s: %.0f ns a segment, %.1f million segments\n", suffix[i] + 1, ns, segments / 1e6);
    }
    drawing_free(&d);
}

static int count(const char *text, const char *word) {
    int n = 0;
    for (const char *p = text; (p = strstr(p, word)) != NULL; p++) n++;
    return n;
}

/* Three strokes of pen 2, then four of pen 5: every format says so, in that order, and forgets nothing. */
static void pens_are_told_apart(void **state) {
    (void)state;
    static const struct {
        const char *suffix, *two, *five, *stroke;
    } format[] = {{".svg", "inkscape:label=\"pen 2\"", "inkscape:label=\"pen 5\"", "<path"},
                  {".hpgl", "SP2;", "SP5;", "PU"},
                  {".seg", "# pen 2\n", "# pen 5\n", NULL},
                  {".gcode", "T2\nM0", "T5\nM0", "M3 S"}};
    machine_t machine;
    machine_default(&machine);
    drawing_t d;
    drawing_init(&d);
    assert_false(drawing_has_pens(&d));
    assert_int_equal(drawing_take_pen(&d, 2), 0);
    fill(&d, 3, 5);
    assert_int_equal(drawing_take_pen(&d, 2), 0);
    assert_int_equal(drawing_take_pen(&d, 5), 0);
    fill(&d, 4, 5);
    assert_true(drawing_has_pens(&d));
    for (size_t s = 0; s < 7; s++) assert_int_equal(drawing_pen(&d, s), s < 3 ? 2 : 5);
    for (size_t k = 0; k < sizeof format / sizeof format[0]; k++) {
        const char *path = temporary(format[k].suffix);
        assert_int_equal(writer_write(&d, &machine, path), 0);
        char *text = slurp(path);
        assert_int_equal(count(text, format[k].two), 1);
        assert_int_equal(count(text, format[k].five), 1);
        const char *five = strstr(text, format[k].five);
        assert_true(strstr(text, format[k].two) < five);
        if (format[k].stroke) assert_int_equal(count(text, format[k].stroke), 7 + (k == 1));
        if (format[k].stroke) assert_int_equal(count(five, format[k].stroke), 4 + (k == 1));
        free(text);
    }
    drawing_clear(&d);
    fill(&d, 1, 5);
    assert_false(drawing_has_pens(&d));
    drawing_free(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strokes_are_kept),
        cmocka_unit_test(strokes_are_handed_on),
        cmocka_unit_test(length_counts_travel_from_and_to_the_origin),
        cmocka_unit_test(camera_is_kept_in_mm),
        cmocka_unit_test(seg_reads_back_to_the_lat),
        cmocka_unit_test(svg_reads_back),
        cmocka_unit_test(titles_are_utf8),
        cmocka_unit_test(hpgl_reads_back),
        cmocka_unit_test(gcode_says_what_a_plotter_does),
        cmocka_unit_test(pens_are_told_apart),
        cmocka_unit_test(pictures_are_what_they_say),
        cmocka_unit_test(names_and_failures),
        cmocka_unit_test(a_file_is_written_over),
        cmocka_unit_test(large_drawings_are_written_fast),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
