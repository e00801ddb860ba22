/* value.c - numbers as gnuplot prints them: %.15g, and ".0" where a real would look like an integer. */
#include "lang/value.h"
#include "num/num_double.h"

_Static_assert(VALUE_UNDEF == true, "value_real stores the flag of an undefined number as its kind");

num_t value_from_integer(int64_t i) {
    return num_double(num_from_i64(i));
}

enum { DIGITS = 15 };

/* Writes v in decimal; returns the byte behind it. */
static char *put_decimal(char *at, uint64_t v) {
    char digits[20];
    int n = 0;
    do {
        digits[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v);
    while (n) *at++ = digits[--n];
    return at;
}

static char *put_zeros(char *at, int n) {
    while (n-- > 0) *at++ = '0';
    return at;
}

static char *put_real(char *at, num_t a) {
    if (a.m == 0) return put_zeros(at, 1);
    int32_t exp10;
    int64_t decimal = num_to_decimal(num_abs(a), DIGITS, &exp10);
    if (num_sign(a) < 0) *at++ = '-';
    while (decimal % 10 == 0) { /* decimal > 0: a is not zero */
        decimal /= 10;
        exp10++;
    }
    char digit[20];
    int n = (int)(put_decimal(digit, (uint64_t)decimal) - digit);
    int point = exp10 + n; /* digits before the decimal point; the exponent of d.ddd is one less */
    if (point - 1 < -4 || point - 1 >= DIGITS) {
        *at++ = digit[0];
        if (n > 1) {
            *at++ = '.';
            memcpy(at, digit + 1, (size_t)(n - 1));
            at += n - 1;
        }
        int e = point - 1;
        *at++ = 'e';
        *at++ = e < 0 ? '-' : '+';
        if (e < 0) e = -e;
        if (e < 10) *at++ = '0';
        return put_decimal(at, (uint64_t)e);
    }
    if (point <= 0) {
        *at++ = '0';
        *at++ = '.';
        at = put_zeros(at, -point);
        memcpy(at, digit, (size_t)n);
        return at + n;
    }
    int whole = n < point ? n : point;
    memcpy(at, digit, (size_t)whole);
    at = put_zeros(at + whole, point - whole);
    if (n > whole) {
        *at++ = '.';
        memcpy(at, digit + whole, (size_t)(n - whole));
        at += n - whole;
    }
    return at;
}

size_t value_format(value_t v, char buf[VALUE_TEXT_MAX]) {
    char *at = buf;
    if (v.kind == VALUE_UNDEF) {
        memcpy(at, "NaN", 3);
        at += 3;
    } else if (v.kind == VALUE_INT) {
        if (v.m < 0) *at++ = '-';
        at = put_decimal(at, v.m < 0 ? 0u - (uint64_t)v.m : (uint64_t)v.m);
    } else {
        at = put_real(at, value_num(v));
        size_t len = (size_t)(at - buf);
        if (!memchr(buf, '.', len) && !memchr(buf, 'e', len)) {
            *at++ = '.';
            *at++ = '0';
        }
    }
    *at = 0;
    return (size_t)(at - buf);
}
