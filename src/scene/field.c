/* field.c - the scanner of field.h: one state per place inside a field, kept between chunks. */
#include "scene/field.h"
#include "scene/decimal_scan.h"

enum state {
    AT_START,   /* of a line: nothing but blanks so far */
    BETWEEN,    /* between fields */
    SIGNED,     /* after + or - */
    ZERO,       /* after a leading 0: perhaps hexadecimal */
    WHOLE,      /* digits before the point */
    POINT,      /* a point with no digit before it */
    FRACTION,   /* digits after the point */
    EXPONENT,   /* after the exponent's letter */
    EXP_SIGNED, /* after its sign */
    EXP_DIGITS,
    HEX,
    WORD, /* not a number */
    QUOTED,
    COMMENT,
};

/* Below this another digit fits into the mantissa. 19 digits always do. */
#define MANTISSA_ROOM ((UINT64_MAX - 9) / 10)
#define EXPONENT_LIMIT 100000 /* beyond, more digits change nothing: the value is 0 or undefined */

void field_start(field_t *f, char separator, bool stop_at_e, int32_t line) {
    *f = (field_t){.separator = separator, .stop_at_e = stop_at_e, .lines = line, .line = line};
}

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

static bool is_separator(const field_t *f, char c) {
    return f->separator ? c == f->separator : c == ',' || is_blank(c);
}

static int hex_digit(char c) {
    if (is_digit(c)) return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

static char lower(char c) {
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static void begin(field_t *f) {
    f->kind = FIELD_NUMBER;
    f->negative = f->exp_negative = false;
    f->mantissa = 0;
    f->exp10 = f->exponent = 0;
    f->text_len = 0;
    f->column = f->at;
    f->at_separator = f->trailing = false;
}

static void digit(field_t *f, char c, bool fraction) {
    if (f->mantissa <= MANTISSA_ROOM) {
        f->mantissa = f->mantissa * 10 + (uint64_t)(c - '0');
        if (fraction) f->exp10--;
    } else if (!fraction && f->exp10 < EXPONENT_LIMIT) {
        f->exp10++;
    }
}

/* The digits from p on of a number that is in its whole part or fraction, which are most of what there is to read:
 * as many as change the mantissa. Returns where they end. */
static const char *digits(field_t *f, const char *p, const char *end) {
    const char *start = p;
    uint64_t mantissa = f->mantissa;
    while (p < end && is_digit(*p) && mantissa <= MANTISSA_ROOM) mantissa = mantissa * 10 + (uint64_t)(*p++ - '0');
    f->mantissa = mantissa;
    f->at += (int32_t)(p - start);
    if (f->state == FRACTION) f->exp10 -= (int32_t)(p - start);
    return p;
}

static void word(field_t *f, char c) {
    bool after_number = f->state >= ZERO && f->state != WORD;
    f->kind = FIELD_TEXT;
    f->state = WORD;
    if (after_number || f->trailing)
        f->text_len = sizeof f->text; /* like no word we know */
    else if (f->text_len < sizeof f->text)
        f->text[f->text_len++] = lower(c);
}

static bool text_is(const field_t *f, const char *what) {
    uint8_t i = 0;
    while (what[i] && i < f->text_len && what[i] == f->text[i]) i++;
    return !what[i] && i == f->text_len;
}

/* What stands in the field now that it ends. */
static enum field_event complete(field_t *f) {
    switch (f->state) {
    case SIGNED:
    case POINT:
    case EXPONENT:
    case EXP_SIGNED:
        f->kind = FIELD_TEXT;
        break;
    case EXP_DIGITS:
        f->exp10 += f->exp_negative ? -f->exponent : f->exponent;
        break;
    case WORD:
        if (text_is(f, "nan") || text_is(f, "inf") || text_is(f, "infinity") || text_is(f, "?") || text_is(f, "na"))
            f->kind = FIELD_MISSING;
        break;
    case QUOTED:
        f->kind = FIELD_TEXT;
        break;
    default:
        break;
    }
    f->state = BETWEEN;
    f->count++;
    f->line = f->lines + 1;
    return FIELD_VALUE;
}

static enum field_event empty(field_t *f) {
    begin(f);
    f->kind = FIELD_MISSING;
    f->count++;
    f->line = f->lines + 1;
    return FIELD_VALUE;
}

/* A separator stands after a field, or between two: only a comma (or a configured character) can leave a field empty,
 * and blanks around it belong to it. */
static bool separates_nothing(field_t *f, char c) {
    if (!f->separator && is_blank(c)) return false;
    bool nothing = f->at_separator || f->count == 0;
    f->at_separator = true;
    return nothing;
}

static void first_character(field_t *f, char c) {
    begin(f);
    if (c == '-' || c == '+') {
        f->negative = c == '-';
        f->state = SIGNED;
    } else if (c == '0') {
        f->state = ZERO;
    } else if (is_digit(c)) {
        f->state = WHOLE;
        digit(f, c, false);
    } else if (c == '.') {
        f->state = POINT;
    } else if (c == '"' || c == '\'') {
        f->state = QUOTED;
        f->quote = c;
    } else {
        word(f, c);
    }
}

/* One more character of a number; whatever does not continue it makes the field text. */
static void next_character(field_t *f, char c) {
    char l = lower(c);
    switch (f->state) {
    case SIGNED:
        if (c == '0')
            f->state = ZERO;
        else if (is_digit(c))
            f->state = WHOLE, digit(f, c, false);
        else if (c == '.')
            f->state = POINT;
        else
            word(f, c); /* -inf */
        return;
    case ZERO:
    case WHOLE:
        if (is_digit(c))
            f->state = WHOLE, digit(f, c, false);
        else if (c == '.')
            f->state = FRACTION;
        else if (l == 'e' || l == 'd')
            f->state = EXPONENT;
        else if (l == 'x' && f->state == ZERO)
            f->state = HEX;
        else
            word(f, c);
        return;
    case POINT:
    case FRACTION:
        if (is_digit(c))
            f->state = FRACTION, digit(f, c, true);
        else if ((l == 'e' || l == 'd') && f->state == FRACTION)
            f->state = EXPONENT;
        else
            word(f, c);
        return;
    case EXPONENT:
        if (c == '-' || c == '+') {
            f->exp_negative = c == '-';
            f->state = EXP_SIGNED;
            return;
        } /* fall through */
    case EXP_SIGNED:
    case EXP_DIGITS:
        if (!is_digit(c)) {
            word(f, c);
            return;
        }
        f->state = EXP_DIGITS;
        if (f->exponent < EXPONENT_LIMIT) f->exponent = f->exponent * 10 + (c - '0');
        return;
    case HEX:
        if (hex_digit(c) < 0 || f->mantissa >> 60)
            word(f, c);
        else
            f->mantissa = f->mantissa << 4 | (uint64_t)hex_digit(c);
        return;
    default:
        word(f, c);
        return;
    }
}

/* The mark with which some programs begin a file of UTF-8. */
static bool is_byte_order_mark(const field_t *f, char c) {
    static const char MARK[] = "\xef\xbb\xbf";
    return f->lines == 0 && f->at <= 3 && c == MARK[f->at - 1];
}

static void new_line(field_t *f) {
    f->lines++;
    f->at = 0;
    f->count = 0;
    f->state = AT_START;
    f->comment_only = f->at_separator = false;
}

/* The end of a line: first the field it ends, if any, then the line itself. The newline stays unread in the first case.
 */
static enum field_event end_of_line(field_t *f, bool *again) {
    *again = false;
    if (f->state > BETWEEN && f->state != COMMENT) {
        *again = true;
        return complete(f);
    }
    if (f->at_separator) {
        f->at_separator = false;
        *again = true;
        return empty(f);
    }
    bool exists = !f->comment_only;
    f->line = f->lines + 1;
    f->state = AT_START;
    return exists ? FIELD_LINE : FIELD_MORE;
}

enum field_event field_next(field_t *f, const char **p, const char *end) {
    if (f->state == AT_START && f->at < 0) new_line(f); /* the line whose end was reported last time */
    while (*p < end) {
        if ((f->state == WHOLE || f->state == FRACTION) && !f->trailing && !is_digit(f->separator))
            *p = digits(f, *p, end);
        if (*p == end) break;
        char c = **p;
        if (c == '\n') {
            bool again;
            enum field_event event = end_of_line(f, &again);
            if (again) return event;
            (*p)++;
            if (event == FIELD_LINE) {
                f->at = -1;
                return event;
            }
            new_line(f);
            continue;
        }
        (*p)++;
        f->at++;
        if (f->state == COMMENT) continue;
        if (f->state == QUOTED) {
            if (c == f->quote) word(f, c); /* so it is text whatever it says */
            continue;
        }
        if (f->state > BETWEEN) {
            bool comment = c == '#';
            if (!comment && !is_separator(f, c)) {
                if (is_blank(c))
                    f->trailing = true; /* only where blanks separate nothing */
                else if (f->trailing)
                    word(f, c);
                else
                    next_character(f, c);
                continue;
            }
            enum field_event event = complete(f);
            if (comment)
                f->state = COMMENT;
            else
                separates_nothing(f, c);
            return event;
        }
        if (f->state == AT_START && is_byte_order_mark(f, c)) continue;
        if (c == '#') {
            f->comment_only = f->state == AT_START;
            f->state = COMMENT;
        } else if (f->stop_at_e && f->state == AT_START && (c == 'e' || c == 'E')) {
            f->line = f->lines + 1;
            return FIELD_STOP;
        } else if (is_separator(f, c)) {
            if (separates_nothing(f, c)) {
                f->state = BETWEEN;
                enum field_event event = empty(f);
                f->at_separator = true;
                return event;
            }
            if (!is_blank(c)) f->state = BETWEEN;
        } else if (!is_blank(c)) {
            first_character(f, c);
        }
    }
    return FIELD_MORE;
}

#if CONFIG_64BIT
bool field_begins_line(field_t *f) {
    if (f->state == AT_START && f->at < 0) new_line(f);
    return f->state == AT_START && f->at == 0;
}

bool field_plain(field_t *f, const char **p, const char *end, const char *limit) {
    if (f->state == AT_START && f->at < 0) new_line(f);
    if (f->state > BETWEEN) return false;
    const char *start = *p;
    if (!f->separator)
        while (start < end && is_blank(*start)) start++;
    decimal_t d;
    if (limit - start < DECIMAL_SCAN_MARGIN) return false;
    const char *behind = decimal_scan(start, &d);
    if (!behind || behind >= end || (*behind != '\n' && !is_separator(f, *behind))) return false;
    f->kind = FIELD_NUMBER;
    f->negative = d.negative;
    f->mantissa = d.mantissa;
    f->exp10 = d.exp10;
    f->count++;
    f->line = f->lines + 1;
    f->column = f->at + (int32_t)(start - *p) + 1;
    f->at_separator = f->trailing = false;
    f->state = BETWEEN;
    if (*behind != '\n') separates_nothing(f, *behind++);
    f->at += (int32_t)(behind - *p);
    *p = behind;
    return true;
}
#endif

enum field_event field_finish(field_t *f) {
    if (f->state == AT_START && f->at <= 0) return FIELD_MORE;
    const char newline = '\n', *p = &newline;
    return field_next(f, &p, p + 1);
}

num_t field_num(const field_t *f) {
    if (f->kind != FIELD_NUMBER) return num_undef();
    num_t a = num_from_decimal(f->mantissa, f->exp10);
    return f->negative ? num_neg(a) : a;
}
