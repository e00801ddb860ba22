/* format.c - numbers as sprintf writes them, from 17 decimal digits and an exponent. */
#include "lang/format.h"
#include "config.h"

#if CONFIG_CONTROL
enum { DIGITS = 17 };

size_t format_read(const char *spec, format_t *f) {
    const char *p = spec;
    *f = (format_t){.precision = -1};
    for (; *p && strchr("-+ 0#", *p); p++) {
        f->left |= *p == '-';
        f->plus |= *p == '+';
        f->blank |= *p == ' ';
        f->zero |= *p == '0';
        f->sharp |= *p == '#';
    }
    for (; *p >= '0' && *p <= '9'; p++)
        if (f->width < FORMAT_WIDTH_MAX) f->width = f->width * 10 + (*p - '0');
    if (f->width > FORMAT_WIDTH_MAX) f->width = FORMAT_WIDTH_MAX;
    if (*p == '.') {
        f->precision = 0;
        for (p++; *p >= '0' && *p <= '9'; p++)
            if (f->precision < FORMAT_PRECISION_MAX) f->precision = f->precision * 10 + (*p - '0');
        if (f->precision > FORMAT_PRECISION_MAX) f->precision = FORMAT_PRECISION_MAX;
    }
    while (*p == 'l' || *p == 'h') p++;
    if (!*p || !strchr("diuxXoceEfFgGs%", *p)) return 0;
    f->type = *p++;
    return (size_t)(p - spec);
}

/* sign and digits, filled up to the width. */
static void pad(text_t *t, const format_t *f, const char *sign, const char *body, size_t n, bool zeros) {
    int32_t fill = f->width - (int32_t)(strlen(sign) + n);
    const bool zero = zeros && f->zero && !f->left;
    for (int32_t k = fill; !f->left && !zero && k > 0; k--) text_add(t, " ");
    text_add(t, sign);
    for (int32_t k = fill; zero && k > 0; k--) text_add(t, "0");
    text_add_bytes(t, body, n);
    for (int32_t k = fill; f->left && k > 0; k--) text_add(t, " ");
}

static const char *sign_of(const format_t *f, bool negative) {
    return negative ? "-" : f->plus ? "+" : f->blank ? " " : "";
}

static void integer(text_t *t, const format_t *f, int64_t v) {
    const unsigned base = f->type == 'x' || f->type == 'X' ? 16 : f->type == 'o' ? 8 : 10;
    const bool is_signed = f->type == 'd' || f->type == 'i';
    const bool negative = is_signed && v < 0;
    uint64_t mag = negative ? 0 - (uint64_t)v : (uint64_t)v;
    if (!is_signed && v < 0 && v >= INT32_MIN) mag &= UINT32_MAX; /* as gnuplot, which hands over an int */
    char digits[64];
    size_t n = sizeof digits;
    while (mag > 0 || (n == sizeof digits && f->precision != 0) || (int32_t)(sizeof digits - n) < f->precision) {
        digits[--n] = (f->type == 'X' ? "0123456789ABCDEF" : "0123456789abcdef")[mag % base];
        mag /= base;
    }
    const char *prefix = f->sharp && base == 16 && v ? (f->type == 'X' ? "0X" : "0x") : "";
    pad(t, f, is_signed ? sign_of(f, negative) : prefix, digits + n, sizeof digits - n, f->precision < 0);
}

/* The value's first n decimal digits (1 to DIGITS; later ones are 0): digit[0] is not 0, and counts 10^*exp. */
static void decimal(num_t a, int32_t n, char digit[DIGITS], int32_t *exp) {
    memset(digit, '0', DIGITS);
    *exp = 0;
    if (num_sign(a) == 0) return;
    int32_t exp10, cut = n < DIGITS ? DIGITS + 1 - n : 0;
    int64_t d = num_to_decimal(num_abs(a), cut ? DIGITS + 1 : DIGITS, &exp10), unit = 1;
    for (int32_t k = 0; k < cut; k++) unit *= 10;
    const int64_t rest = d % unit;
    d /= unit;
    if (cut && (rest > unit / 2 || (rest == unit / 2 && d % 2))) d++; /* ties to even: 0.25 is 0.2 */
    exp10 += cut;
    char all[20];
    int32_t k = sizeof all;
    for (; d > 0; d /= 10) all[--k] = (char)('0' + d % 10);
    const int32_t have = (int32_t)sizeof all - k;
    memcpy(digit, all + k, (size_t)(have < DIGITS ? have : DIGITS));
    *exp = exp10 + have - 1;
}

static void exponent(text_t *e, int32_t exp, bool upper) {
    text_add(e, upper ? "E" : "e");
    text_add(e, exp < 0 ? "-" : "+");
    if (exp < 0) exp = -exp;
    if (exp < 10) text_add(e, "0");
    text_add_int(e, exp);
}

/* digit k, counted from the first one at 10^exp; zeros before and behind those there are. */
static void put_digit(text_t *b, const char *digit, int32_t k) {
    text_add_bytes(b, k < 0 || k >= DIGITS ? "0" : digit + k, 1);
}

static void fixed(text_t *b, const char *digit, int32_t exp, int32_t decimals, bool point) {
    for (int32_t p = exp > 0 ? exp : 0; p >= -decimals; p--) {
        if (p == -1) text_add(b, ".");
        put_digit(b, digit, exp - p);
    }
    if (decimals <= 0 && point) text_add(b, ".");
}

static void scientific(text_t *b, const char *digit, int32_t exp, int32_t decimals, bool point, bool upper) {
    put_digit(b, digit, 0);
    if (decimals > 0 || point) text_add(b, ".");
    for (int32_t k = 1; k <= decimals; k++) put_digit(b, digit, k);
    exponent(b, exp, upper);
}

static void real(text_t *t, const format_t *f, num_t a) {
    char digit[DIGITS], body[FORMAT_PRECISION_MAX + 330];
    text_t b = text_start(body, sizeof body);
    const char type = (char)(f->type | 32);
    const bool upper = f->type != type;
    int32_t precision = f->precision < 0 ? 6 : f->precision, exp;
    if (type == 'e') {
        decimal(a, precision + 1, digit, &exp);
        scientific(&b, digit, exp, precision, f->sharp, upper);
    } else if (type == 'f') {
        decimal(a, DIGITS, digit, &exp);
        const int32_t wanted = exp + 1 + precision; /* digits before the one that decides */
        if (wanted <= 0) {                          /* less than half of the last place, or more */
            const bool up = wanted == 0 && digit[0] >= '5' && num_sign(a) != 0;
            memset(digit, '0', sizeof digit);
            digit[0] = up ? '1' : '0';
            exp = up ? -precision : 0;
        } else if (wanted < DIGITS) {
            decimal(a, wanted, digit, &exp);
        }
        fixed(&b, digit, exp, precision, f->sharp);
    } else {
        if (precision == 0) precision = 1;
        decimal(a, precision, digit, &exp);
        int32_t last = (precision < DIGITS ? precision : DIGITS) - 1;
        while (!f->sharp && last > 0 && digit[last] == '0') last--;
        if (exp < -4 || exp >= precision)
            scientific(&b, digit, exp, last, f->sharp, upper);
        else
            fixed(&b, digit, exp, last > exp ? last - exp : 0, f->sharp);
    }
    pad(t, f, sign_of(f, num_sign(a) < 0), b.buf, b.len, true);
}

void format_text(text_t *t, const format_t *f, const char *text, size_t n) {
    if (f->precision >= 0 && n > (size_t)f->precision) n = (size_t)f->precision;
    pad(t, f, "", text, n, false);
}

void format_number(text_t *t, const format_t *f, value_t v) {
    const num_t a = value_num(v);
    if (v.kind == VALUE_UNDEF || a.undef) {
        format_text(t, &(format_t){.width = f->width, .left = f->left, .precision = -1}, "nan", 3);
    } else if (f->type == 'c') {
        const char c = (char)num_to_fixed(num_trunc(a), 0, NULL);
        format_text(t, f, &c, 1);
    } else if (strchr("diuxXo", f->type)) {
        integer(t, f, num_to_fixed(num_trunc(a), 0, NULL));
    } else {
        real(t, f, a);
    }
}
#endif
