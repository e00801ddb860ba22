/* test_plain.c - data are the same whether lines of plain numbers are read at once or one character at a time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "scene/data_reader.h"
#include "scene/decimal_scan.h"
#define DICE_SEED 20261129
#include "tests/unit/dice.h"

enum { POOL = 4096, GRIDS = 3, TEXT = 4000 };

static size_t put_digits(char *out, int n) {
    for (int k = 0; k < n; k++) out[k] = (char)('0' + below(10));
    return (size_t)n;
}

/* A number as programs write them, and as people should not. */
static size_t put_number(char *out) {
    static const char *const ODD[] = {
        "1e",
        ".",
        "+-1",
        "nan",
        "inf",
        "1.e5",
        "0x10",
        "-",
        "?",
        "1e+",
        "e5",
        ".e5",
        "00012",
        "-0",
        "+.5",
        "5.",
        "1d3",
        "1D-3",
        "1x",
        "0x",
        "1e400",
        "1e-400",
        "1e99",
        "--1",
        "1..2",
        "1.2.",
        "\"1\"",
        "NA",
        "-inf",
        "1e5.",
        "~",
        "4.9406564584124654e-324",
        "0",
        "0.0",
        "1E308",
        "1e12345",
        "2e-308",
        "1e20000",
        "\xef\xbb\xbf",
        "18446744073709551615",
        "9007199254740993",
        "9007199254740993e-3",
        "9223372036854775809",
        "0.000000000000000000001",
        "4503599627370496.5",
        "4503599627370497.5",
        "12345678",
        "123456789",
        "1234567.8",
        "12345678.",
        ".12345678",
        "9999999999999999999",
    };
    size_t n = 0;
    switch (below(12)) {
    case 0:
        return (size_t)sprintf(out, "%s", ODD[below((int32_t)(sizeof ODD / sizeof ODD[0]))]);
    case 1:
        return (size_t)sprintf(out, "%.17g", (uniform() - .5) * 1000);
    case 2:
        return (size_t)sprintf(out, "%.*e", below(20), (uniform() - .5) * 1e10);
    case 3:
        return (size_t)sprintf(out, "%d", below(3000) - 1500);
    default:
        if (below(2)) out[n++] = below(3) ? '-' : '+';
        n += put_digits(out + n, below(4) ? 1 + below(3) : below(22));
        if (below(6)) {
            out[n++] = '.';
            n += put_digits(out + n, below(4) ? below(8) : below(22));
        }
        if (!below(8)) n += (size_t)sprintf(out + n, "%c%d", "eEdD"[below(4)], below(700) - 350);
        return n;
    }
}

#if CONFIG_64BIT
/* Digits, points and exponents, against the scanner and the arithmetic that boards have. */
static void numbers_are_the_same_bits(void **state) {
    (void)state;
    int plain = 0;
    enum { N = 400000 };
    for (int k = 0; k < N; k++) {
        char text[160] = "";
        size_t n = put_number(text);
        memset(text + n, "\n 5#"[below(4)], sizeof text - n);
        text[n] = "\n \t,"[below(4)];
        field_t f;
        field_start(&f, 0, false, 0);
        const char *p = text;
        enum field_event event = FIELD_MORE;
        while (event == FIELD_MORE && p <= text + n) event = field_next(&f, &p, p + 1); /* slowly */
        decimal_t d;
        const char *end = decimal_scan(text, &d);
        if (!end || end != text + n) continue; /* not plain: never looked at */
        plain++;
        assert_int_equal(event, FIELD_VALUE);
        assert_int_equal(f.kind, FIELD_NUMBER);
        if (d.mantissa != f.mantissa || d.exp10 != f.exp10 || d.negative != f.negative) {
            printf("%.*s\n", (int)n, text);
            fail();
        }
        assert_int_equal(decimal_packed(d), packed_from_num(field_num(&f)));
    }
    printf("# %d of %d numbers are plain\n", plain, N);
    assert_true(plain > N / 2);
}

/* Mantissas beside those that are halfway between two words, where 53 bits are not decided by one product. */
static void halves_are_decided(void **state) {
    (void)state;
    int rare = 0;
    enum { N = 400000 };
    for (int k = 0; k < N; k++) {
        decimal_t d = {.exp10 = below(60) - 35, .negative = below(2)};
        d.mantissa = dice() >> below(64);
        if (below(2)) { /* to a tie of its own: m = (2 q + 1) 2^k / 10^exp10, as nearly as there is one */
            uint64_t odd = (dice() >> 10 | (uint64_t)1 << 53) | 1;
            num_t m = num_mul(num_from_i64((int64_t)odd), num_from_decimal(1, -d.exp10));
            m.e = -below(3);
            d.mantissa = (uint64_t)num_to_fixed(m, 0, NULL);
        }
        const packed_t slow = packed_from_num(decimal_num(d)), word = decimal_packed(d);
        assert_int_equal(word, slow);
        const int zeros = d.mantissa ? ints_clz64(d.mantissa) : 0;
        uint64_t h = wide_mulhi_u64(d.mantissa << zeros, decimal_power5[d.exp10 - DECIMAL_POWER_MIN]);
        h <<= ~h >> 63;
        rare += (h & 0x7ff) - 0x3fa < 9;
    }
    printf("# %d of %d mantissas in doubt\n", rare, N);
    assert_true(rare > N / 1000);
}
#endif

typedef struct result {
    packed_t pool[POOL];
    data_pool_t end;
    data_grid_t grid[GRIDS];
    data_curve_t curve;
    data_reader_t reader;
    int err;
} result_t;

static num_t compute(void *ctx, int32_t part) {
    const data_reader_t *r = ctx;
    if (r->spec->format == DATA_ROWS && r->field.count < 2) return num_from_i64(r->field.count);
    return num_mul(r->column[1 + part], r->column[2]);
}

static void read_text(result_t *r, data_spec_t spec, const char *text, size_t n, size_t piece, bool inline_data) {
    memset(r, 0, sizeof *r);
    r->end = (data_pool_t){r->pool, 0, POOL};
    spec.compute = compute;
    spec.ctx = &r->reader;
    data_reader_start(&r->reader, &spec, &r->end, r->grid, &r->curve, GRIDS, inline_data, 3);
    for (size_t at = 0; !r->err && at < n; at += piece)
        r->err = data_reader_feed(&r->reader, text + at, n - at < piece ? n - at : piece);
    if (!r->err) r->err = data_reader_finish(&r->reader);
}

static void equal(const result_t *a, const result_t *b, const char *text, size_t n) {
    const bool same = a->err == b->err && a->reader.trouble == b->reader.trouble && a->reader.line == b->reader.line &&
                      a->reader.at == b->reader.at && a->end.low == b->end.low && a->end.high == b->end.high &&
                      a->reader.stopped == b->reader.stopped && memcmp(a->pool, b->pool, sizeof a->pool) == 0 &&
                      a->reader.grids == b->reader.grids;
    if (!same) {
        printf("%.*s\n[%d %d %d:%d] [%d %d %d:%d]\n", (int)n, text, a->err, a->reader.trouble, a->reader.line,
               a->reader.at, b->err, b->reader.trouble, b->reader.line, b->reader.at);
        fail();
    }
    for (int k = 0; !a->reader.spec->flat && a->err > 0 && k < a->reader.grids; k++) {
        assert_int_equal(a->grid[k].inner_n, b->grid[k].inner_n);
        assert_int_equal(a->grid[k].outer_n, b->grid[k].outer_n);
        assert_int_equal(a->grid[k].inner_is_x, b->grid[k].inner_is_x);
        assert_int_equal(a->grid[k].z - a->pool, b->grid[k].z - b->pool);
    }
}

/* Rows on a grid, or a matrix, mostly without a fault. */
static size_t put_data(char *out, bool matrix, char separator) {
    static const char *const AFTER[] = {"\n", "\r\n", " \n", "\t\n", " # more\n", " word\n", " 7 8 x9\n"};
    const int nx = 2 + below(8), ny = 2 + below(6), faults = below(3), style = below(7), digits = 1 + below(9);
    char between[3] = {separator ? separator : " \t,"[below(3)], below(3) && separator != ' ' ? '\0' : ' ', '\0'};
    size_t n = 0;
    for (int j = 0; j < ny; j++) {
        for (int i = 0; i < nx; i++) {
            if (faults && !below(40)) n += (size_t)sprintf(out + n, "# a comment\n");
            if (!matrix) n += (size_t)sprintf(out + n, "%.*f%s%.6f%s", digits, i * 0.25 - 1, between, j / 3., between);
            if (faults && !below(12))
                n += put_number(out + n);
            else
                n += (size_t)sprintf(out + n, "%.*f", digits, (uniform() - .5) * 10);
            if (!matrix)
                n += (size_t)sprintf(out + n, "%s", AFTER[faults == 2 ? below(7) : style]);
            else if (i < nx - 1)
                n += (size_t)sprintf(out + n, "%s", between);
            if (faults == 2 && !below(60)) n -= (size_t)below(3);
        }
        n += (size_t)sprintf(out + n, "%s", AFTER[faults == 2 ? below(4) : style < 4 ? style : 0]);
    }
    return n;
}

static void pieces_do_not_matter(void **state) {
    (void)state;
    enum { N = 12000 };
    static result_t whole, slow;
    int good = 0;
    for (int k = 0; k < N; k++) {
        char *text = malloc(TEXT); /* its end is known to the sanitizers */
        data_spec_t spec;
        data_spec_default(&spec);
        spec.format = (enum data_format)(below(6) % 4 % 3);
        spec.separator = below(3) ? '\0' : ";,\t .e-5"[below(8)];
        if (below(2)) {
            spec.parts = below(2) ? 3 : 1;
            for (int c = 0; c < spec.parts; c++) {
                spec.part[c] = spec.parts == 1 ? 3 : c + 1;
                if (!below(10)) spec.part[c] = below(6) - 2;
                if (spec.part[c] > 0) spec.wanted |= (uint64_t)1 << spec.part[c];
            }
            if (!below(3)) {
                spec.part[spec.parts - 1] = USING_EXPR;
                spec.all = true;
#if CONFIG_64BIT
                spec.known = below(4);
                spec.looks[spec.parts - 1] = (uint64_t)2 << (spec.parts - 1) | 4;
                if (spec.parts == 3 && below(2)) { /* the y */
                    spec.part[1] = USING_EXPR;
                    spec.looks[1] = 4;
                }
#endif
            }
        }
        if (!below(5)) spec.point_step = 1 + below(2);
        if (!below(8)) spec.last_block = below(3);
        spec.skip = below(20) ? 0 : below(4);
        spec.flat = spec.format == DATA_ROWS && spec.parts != 3 && !below(4);
        size_t n = 0;
        do {
            n += put_data(text + n, spec.format != DATA_ROWS, spec.separator);
            if (below(2)) n += (size_t)sprintf(text + n, "\n\n");
        } while (n < TEXT / 4 && below(2));
        if (below(4) == 0) n += (size_t)sprintf(text + n, "e\n1 2 3\n");
        if (below(8) == 0) n--;
        assert_true(n < TEXT);
        text = realloc(text, n);
        const bool inline_data = below(2);
        read_text(&slow, spec, text, n, 1, inline_data);
        read_text(&whole, spec, text, n, n, inline_data);
        whole.reader.spec = slow.reader.spec = &spec;
        equal(&whole, &slow, text, n);
        good += whole.err > 0;
        read_text(&whole, spec, text, n, 1 + (size_t)below(300), inline_data);
        whole.reader.spec = slow.reader.spec = &spec;
        equal(&whole, &slow, text, n);
        free(text);
    }
    printf("# %d of %d data are without fault\n", good, N);
    assert_true(good > N / 5);
}

int main(void) {
    const struct CMUnitTest tests[] = {
#if CONFIG_64BIT
        cmocka_unit_test(numbers_are_the_same_bits),
        cmocka_unit_test(halves_are_decided),
#endif
        cmocka_unit_test(pieces_do_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
