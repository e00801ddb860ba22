/* test_report.c - what a page took is valid JSON whatever the scene is called, and one row of a table. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "host/report.h"

/* A JSON reader that only says yes or no: returns what follows a value, or NULL. */
static const char *value(const char *p);

static const char *blanks(const char *p) {
    return p + strspn(p, " \t\r\n");
}

static const char *string(const char *p) {
    if (*p++ != '"') return NULL;
    while (*p != '"') {
        if ((unsigned char)*p < 0x20) return NULL;
        if (*p == '\\') {
            p++;
            if (*p == 'u') {
                if (strspn(p + 1, "0123456789abcdefABCDEF") < 4) return NULL;
                p += 4;
            } else if (!*p || !strchr("\"\\/bfnrt", *p)) {
                return NULL;
            }
        }
        p++;
    }
    return p + 1;
}

static const char *members(const char *p, char close, int named) {
    p = blanks(p + 1);
    if (*p == close) return p + 1;
    for (;;) {
        if (named) {
            p = string(blanks(p));
            if (!p) return NULL;
            p = blanks(p);
            if (*p++ != ':') return NULL;
        }
        p = value(p);
        if (!p) return NULL;
        p = blanks(p);
        if (*p == close) return p + 1;
        if (*p++ != ',') return NULL;
    }
}

static const char *value(const char *p) {
    p = blanks(p);
    if (*p == '{') return members(p, '}', 1);
    if (*p == '[') return members(p, ']', 0);
    if (*p == '"') return string(p);
    if (strncmp(p, "null", 4) == 0) return p + 4;
    char *end;
    strtod(p, &end);
    return end == p || *p == '+' || *p == '.' ? NULL : end;
}

static char *report_text(const char *scene, const char *title, int pages, int machine_error) {
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    assert_non_null(f);
    const char *const files[] = {"a.svg", "b \"c\".seg", NULL};
    report_json_begin(f, scene);
    for (int i = 1; i <= pages; i++) {
        report_t r = {
            .page = i, .title = title, .file = files, .machine_error = machine_error, .points = 7, .strokes = 2};
        r.picture.facets = 3481;
        r.motion.ticks = 24000000;
        report_json_page(f, &r);
    }
    report_json_end(f);
    fclose(f);
    return text;
}

static void json_is_valid(void **state) {
    (void)state;
    static const char *const names[] = {"hill.gp", "a\"b\\c\n\t\x01", "", "gr\xc3\xbc\xc3\x9f"};
    for (size_t i = 0; i < 4; i++)
        for (int pages = 0; pages < 3; pages++) {
            char *text = report_text(names[i], names[i], pages, i == 1 ? ERR_MACHINE : 0);
            const char *end = value(text);
            assert_non_null(end);
            assert_string_equal(blanks(end), "");
            free(text);
        }
}

static void json_says_what_it_was_told(void **state) {
    (void)state;
    char *text = report_text("x", "y", 1, 0);
    assert_non_null(strstr(text, "\"facets\": 3481"));
    assert_non_null(strstr(text, "\"segments\": 5"));
    assert_non_null(strstr(text, "\"plotting_s\": 1.500000"));
    free(text);
    text = report_text("x", "y", 1, ERR_MACHINE);
    assert_non_null(strstr(text, "\"plotting_s\": null"));
    free(text);
}

static void table_rows_fit_their_head(void **state) {
    (void)state;
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    report_t r = {.page = 2, .name = "hill"};
    r.picture.facets = 4000000;
    r.length.down_mm = 1234567;
    report_table_head(f);
    report_table_row(f, &r);
    fclose(f);
    char *row = strchr(text, '\n') + 1;
    assert_int_equal(row - text, strlen(row));
    assert_memory_equal(row, "hill, page 2 ", 13);
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(json_is_valid),
        cmocka_unit_test(json_says_what_it_was_told),
        cmocka_unit_test(table_rows_fit_their_head),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
