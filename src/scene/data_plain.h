/* data_plain.h - rows and matrices of nothing but plain numbers, which most data are, sooner; internal to
 * data_reader.c.
 *
 * A line of plain numbers is read as a whole. Where its point continues a grid that is known from its first block, as
 * nearly all do, digits become words of the pool at once; everything else goes the way that data_reader.c knows.
 * Cost of a point: 30 ns with three numbers of 8 digits, 10 ns in a matrix, where characters one by one take 105
 * and 45. */
#ifndef DATA_PLAIN_H
#define DATA_PLAIN_H

#include "scene/data_reader.h"

static inline bool data_is_scattered(const data_reader_t *r) {
#if CONFIG_SCATTERED
    return r->spec->scattered && !r->spec->flat;
#else
    return (void)r, false;
#endif
}

/* Of data_reader.c. Does the data set belong to those that are wanted? */
bool data_set_is_wanted(const data_reader_t *r);
/* A complete row: field.count columns. */
int data_row(data_reader_t *r);
/* One field of a matrix, which is a point. */
int data_cell(data_reader_t *r);

/* Characters end at `end`; up to `limit`, which is there or behind, memory can be read. */
typedef struct data_text {
    const char *end, *limit;
} data_text_t;

#if CONFIG_64BIT
/* Takes what it can from *p on, or nothing. 0 or an error as data_reader_feed(). */
int data_plain(data_reader_t *r, const char **p, data_text_t text);
#endif

#endif
