/* field.h - the characters of a data file cut into fields, however the file is cut into chunks.
 *
 * A push scanner: characters go in as they come, events come out; a field, a line or a number may be spread over
 * any number of chunks, and a line may be of any length. Fields are separated by blanks or by a comma (or by what
 * `set datafile separator` says); `#` begins a comment; lines that hold only a comment do not exist. Numbers are
 * decimals with the exponent letters e E d D, or 0x hexadecimal integers.
 * Cost: one switch per character, no look-ahead, no conversion: a number stays a decimal until it is wanted. */
#ifndef FIELD_H
#define FIELD_H

#include "config.h"
#include "num/num.h"
#include <stdbool.h>
#include <stdint.h>

enum field_event {
    FIELD_MORE,  /* the chunk is used up */
    FIELD_VALUE, /* one field is complete: kind, number */
    FIELD_LINE,  /* a line is complete: count fields; 0 = blank line */
    FIELD_STOP,  /* inline data only: the line `e` */
};

enum field_kind {
    FIELD_NUMBER,
    FIELD_MISSING, /* empty between two separators, ?, nan, inf: a hole */
    FIELD_TEXT,    /* anything else */
};

typedef struct field {
    enum field_kind kind; /* of the field of FIELD_VALUE */
    bool negative;
    uint64_t mantissa; /* |value| = mantissa * 10^exp10 */
    int32_t exp10;
    int32_t count;  /* fields of this line so far; FIELD_VALUE has just counted itself */
    int32_t line;   /* number of the line of the last event, from 1 */
    int32_t column; /* character the field began at, from 1 */
    /* scanner state */
    uint8_t state;
    bool stop_at_e;    /* inline data */
    bool exp_negative; /* sign of the exponent being read */
    bool comment_only;
    bool trailing;     /* blanks after a field that only another separator ends */
    bool at_separator; /* the last thing on the line was a separator: an empty field may follow */
    char separator;    /* 0: blanks or a comma */
    char quote;        /* of quoted text */
    char text[9];      /* the beginning of a field that is no number */
    uint8_t text_len;
    int32_t exponent; /* digits of the exponent */
    int32_t lines;    /* complete lines */
    int32_t at;       /* characters of this line */
} field_t;

/* separator: 0 for blanks or a comma. stop_at_e: a line whose first character is e or E ends the data. line: number of
 * lines before the first, for messages. */
void field_start(field_t *f, char separator, bool stop_at_e, int32_t line);
/* Consumes characters from *p up to end until something happens. */
enum field_event field_next(field_t *f, const char **p, const char *end);
/* At the end of the file: call until FIELD_MORE, as if a last newline were there if it was not. */
enum field_event field_finish(field_t *f);
/* The value of a FIELD_NUMBER; undefined for the other kinds. */
num_t field_num(const field_t *f);
#if CONFIG_64BIT
/* Is the next character the first of a line? */
bool field_begins_line(field_t *f);
/* The same as field_next(), sooner, where *p to end begin with a field that is a plain number, and with what shows
 * where it ends: true for FIELD_VALUE. False: nothing has happened. Up to limit, behind the end, memory can be read. */
bool field_plain(field_t *f, const char **p, const char *end, const char *limit);
#endif

#endif
