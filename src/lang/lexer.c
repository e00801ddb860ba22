/* lexer.c - cuts a line into tokens, one at a time, with no memory but the lexer itself.
 *
 * What a number is follows gnuplot's scanner: 08 is 0 and then 8, 0x is 0 and then x, 1..2 is 1. and then .2. */
#include "lang/lexer.h"
#include "config.h"
#include "num/num_double.h"

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (unsigned char)c >= 128;
}

/* The value of a digit in the given base, or -1. */
static int digit_of(char c, int base) {
    int d = -1;
    if (is_digit(c)) d = c - '0';
    if (c >= 'a' && c <= 'f') d = c - 'a' + 10;
    if (c >= 'A' && c <= 'F') d = c - 'A' + 10;
    return d < base ? d : -1;
}

/* Line feeds stand between the lines of a block, and end commands. */
#if CONFIG_CONTROL
#define BLANKS " \t\r\f\v"
#else
#define BLANKS " \t\r\f\v\n"
#endif

static char at(const lexer_t *lx, uint32_t i) {
    return i < lx->len ? lx->text[i] : 0;
}

/* Integer constant in base 8, 10 or 16 from i on; real when 63 bits are not enough. Returns its end. */
static uint32_t scan_integer(const lexer_t *lx, uint32_t i, int base, value_t *v) {
    uint64_t n = 0;
    num_t big = num_from_i64(0);
    bool fits = true;
    for (int d; (d = digit_of(at(lx, i), base)) >= 0; i++) {
        if (fits && n > ((uint64_t)INT64_MAX - (uint64_t)d) / (uint64_t)base) {
            fits = false;
            big = num_from_i64((int64_t)n);
        }
        if (fits)
            n = n * (uint64_t)base + (uint64_t)d;
        else
            big = num_add(num_mul(big, num_from_i64(base)), num_from_i64(d));
    }
    *v = fits ? value_int((int64_t)n) : value_real(num_double(big));
    return i;
}

/* Real constant from i on. The first 19 digits count, which is as many as 63 bits hold. Returns its end, or 0 when an
 * exponent lacks its digits. */
static uint32_t scan_real(const lexer_t *lx, uint32_t i, value_t *v) {
    uint64_t n = 0;
    int32_t exp10 = 0;
    bool point = false;
    for (;; i++) {
        char c = at(lx, i);
        if (c == '.' && !point) {
            point = true;
        } else if (is_digit(c)) {
            if (n < UINT64_MAX / 10 - 1) {
                n = n * 10 + (uint64_t)(c - '0');
                exp10 -= point;
            } else {
                exp10 += !point;
            }
        } else {
            break;
        }
    }
    if (at(lx, i) == 'e' || at(lx, i) == 'E') {
        i++;
        bool minus = at(lx, i) == '-';
        if (minus || at(lx, i) == '+') i++;
        if (!is_digit(at(lx, i))) return 0;
        int32_t e = 0;
        for (; is_digit(at(lx, i)); i++) {
            if (e < 100000) e = e * 10 + (at(lx, i) - '0');
        }
        exp10 += minus ? -e : e;
    }
    *v = value_real(num_double(num_from_decimal(n, exp10)));
    return i;
}

static void scan_number(lexer_t *lx) {
    token_t *t = &lx->tok;
    uint32_t start = t->start, end = start;
    t->kind = TOKEN_NUMBER;
    char x = at(lx, start + 1);
    if (at(lx, start) == '0' && (x == 'x' || x == 'X') && digit_of(at(lx, start + 2), 16) >= 0) {
        lx->pos = scan_integer(lx, start + 2, 16, &t->value);
        return;
    }
    while (is_digit(at(lx, end))) end++;
    char c = at(lx, end);
    if (c != '.' && c != 'e' && c != 'E') {
        lx->pos = scan_integer(lx, start, at(lx, start) == '0' ? 8 : 10, &t->value);
        return;
    }
    lx->pos = scan_real(lx, start, &t->value);
    if (lx->pos == 0) {
        t->kind = TOKEN_BAD;
        t->bad = SAID("expecting exponent");
        lx->pos = lx->len;
    }
}

static void scan_string(lexer_t *lx) {
    token_t *t = &lx->tok;
    char quote = at(lx, t->start);
    uint32_t i = t->start + 1;
    t->kind = TOKEN_STRING;
    for (; i < lx->len && (!CONFIG_CONTROL || lx->text[i] != '\n'); i++) {
        if (quote == '"' && lx->text[i] == '\\' && i + 1 < lx->len) {
            i++;
        } else if (lx->text[i] == quote) {
            if (quote == '"' || at(lx, i + 1) != quote) {
                lx->pos = i + 1;
                return;
            }
            i++;
        }
    }
    t->kind = TOKEN_BAD;
    t->bad = SAID("string without its closing quote");
    lx->pos = i;
}

/* The operators of two characters; anything else is one character. */
static int operator_at(const lexer_t *lx, uint32_t i) {
    static const struct {
        char first, second;
        int16_t kind;
    } pair[] = {
        {'*', '*', TOKEN_POWER}, {'<', '<', TOKEN_SHL}, {'>', '>', TOKEN_SHR},
        {'<', '=', TOKEN_LE},    {'>', '=', TOKEN_GE},  {'=', '=', TOKEN_EQ},
        {'!', '=', TOKEN_NE},    {'&', '&', TOKEN_AND}, {'|', '|', TOKEN_OR},
    };
    char c = at(lx, i), next = at(lx, i + 1);
    for (size_t k = 0; k < sizeof pair / sizeof pair[0]; k++) {
        if (pair[k].first == c && pair[k].second == next) return pair[k].kind;
    }
    return c;
}

void lexer_start(lexer_t *lx, const char *text, size_t len) {
    if (len > UINT16_MAX) len = UINT16_MAX;
    const char *zero = len ? memchr(text, 0, len) : NULL;
    lx->text = text;
    lx->len = zero ? (uint32_t)(zero - text) : (uint32_t)len;
    lx->pos = 0;
    lexer_next(lx);
}

void lexer_next(lexer_t *lx) {
    token_t *t = &lx->tok;
    *t = (token_t){.kind = TOKEN_END, .start = lx->pos}; /* the end is where the last token ended, not behind blanks */
    while (lx->pos < lx->len && memchr(BLANKS, lx->text[lx->pos], sizeof BLANKS - 1)) lx->pos++;
    char c = at(lx, lx->pos);
#if CONFIG_CONTROL
    if (c == '#')
        while ((c = at(lx, lx->pos)) != 0 && c != '\n') lx->pos++;
    if (c == '\n') {
        t->kind = ';';
        t->start = lx->pos++;
        t->len = 1;
        return;
    }
#endif
    if (c == 0 || c == '#') {
        lx->pos = t->start;
        return;
    }
    t->start = lx->pos;
    if (is_letter(c)) {
        t->kind = TOKEN_NAME;
        while (is_letter(at(lx, lx->pos)) || is_digit(at(lx, lx->pos))) lx->pos++;
    } else if (is_digit(c) || (c == '.' && is_digit(at(lx, lx->pos + 1)))) {
        scan_number(lx);
    } else if (c == '"' || c == '\'') {
        scan_string(lx);
    } else if (c < ' ' || c == 127) {
        t->kind = TOKEN_BAD;
        t->bad = SAID("a control character");
        lx->pos++;
    } else {
        t->kind = operator_at(lx, lx->pos);
        lx->pos += t->kind > 255 ? 2 : 1;
    }
    t->len = lx->pos - t->start;
}

bool lexer_accept(lexer_t *lx, int kind) {
    if (lx->tok.kind != kind) return false;
    lexer_next(lx);
    return true;
}

bool lexer_is_name(const lexer_t *lx, const char *name) {
    return lx->tok.kind == TOKEN_NAME && strlen(name) == lx->tok.len && memcmp(lexer_text(lx), name, lx->tok.len) == 0;
}

bool lexer_is_almost(const lexer_t *lx, const char *pattern) {
    if (lx->tok.kind != TOKEN_NAME) return false;
    const char *text = lexer_text(lx);
    bool enough = false; /* are we behind the $ */
    uint32_t i = 0;
    for (; *pattern; pattern++) {
        if (*pattern == '$') {
            enough = true;
        } else if (i == lx->tok.len) {
            return enough;
        } else if (text[i++] != *pattern) {
            return false;
        }
    }
    return i == lx->tok.len;
}

/* The character that a backslash escape at text[i] (behind the backslash) stands for; *used: bytes it takes. */
static char escape(const char *text, uint32_t left, uint32_t *used) {
    *used = 1;
    switch (text[0]) {
    case 'n':
        return '\n';
    case 't':
        return '\t';
    case 'r':
        return '\r';
    default:
        break;
    }
    int v = 0;
    uint32_t n = 0;
    while (n < 3 && n < left && digit_of(text[n], 8) >= 0) v = v * 8 + digit_of(text[n++], 8);
    if (n == 0) return text[0];
    *used = n;
    return (char)v;
}

int lexer_string(const lexer_t *lx, char *out, size_t size) {
    const char *text = lexer_text(lx) + 1;
    uint32_t len = lx->tok.len - 2;
    bool escapes = text[-1] == '"';
    size_t n = 0;
    for (uint32_t i = 0; i < len; i++) {
        char c = text[i];
        if (!escapes && c == '\'') {
            i++; /* '' */
        } else if (escapes && c == '\\' && i + 1 < len) {
            uint32_t used;
            c = escape(text + i + 1, len - i - 1, &used);
            i += used;
        }
        if (n + 1 >= size) return ERR_FULL;
        out[n++] = c;
    }
    if (size == 0) return ERR_FULL;
    out[n] = 0;
    return (int)n;
}

int lexer_unexpected(const lexer_t *lx, lang_error_t *err, const char *what) {
    int32_t column = lexer_column(lx);
    if (lx->tok.kind == TOKEN_BAD) return lang_error_set(err, ERR_SYNTAX, column, lx->tok.bad);
    if (CONFIG_CONTROL && lx->tok.kind == '\\') what = "nothing may stand behind a \\ that continues the line";
    if (what) return lang_error_set(err, ERR_SYNTAX, column, what);
    if (lx->tok.kind == TOKEN_END) return lang_error_set(err, ERR_SYNTAX, column, "more was expected");
    return lang_error_set_name(err, ERR_SYNTAX, column, "unexpected or unrecognized token", lexer_text(lx),
                               lx->tok.len);
}
