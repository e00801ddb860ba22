/* data_binary.h - numbers of a binary file, byte by byte, into the rows of data_reader.h.
 *
 * gnuplot's two kinds. A matrix of 32-bit floats whose first row and column are coordinates, which are there before the
 * heights, so that a matrix needs no more memory than what is drawn of it:
 *
 *     N  x1 x2 .. xN
 *     y1 z11 z12 ..
 *     y2 z21 ..
 *
 * And points of several fields each, of any types: an array, whose x and y are counted, or records, which have their
 * own. Bytes come as they come, cut anywhere. Only where there are files. */
#ifndef DATA_BINARY_H
#define DATA_BINARY_H

#include "scene/data_reader.h"

#if CONFIG_BINARY
enum binary_kind { BINARY_FLOAT, BINARY_SIGNED, BINARY_UNSIGNED };

typedef struct binary_field {
    uint8_t bytes; /* 1, 2, 4, 8; floats 4, 8 */
    uint8_t kind;
    bool dropped; /* it is no column */
} binary_field_t;

enum binary_layout { BINARY_MATRIX, BINARY_ARRAY, BINARY_RECORD };

typedef struct binary_spec {
    enum binary_layout layout;
    int32_t n[2];             /* points of a row, rows; -1: up to the end of the file. Of a matrix the file says it. */
    bool transposed, down[2]; /* array: rows run along y; x, y decrease */
    num_t first[3], step[2];  /* array: x, y of the first point, what is added to z */
    bool big_endian;
    int32_t skip;   /* bytes at the start */
    int32_t fields; /* of a point */
    binary_field_t field[CONFIG_DATA_COLUMNS];
} binary_spec_t;

typedef struct data_binary {
    const binary_spec_t *spec;
    data_reader_t *reader;
    int32_t skip;     /* bytes still to be skipped */
    int32_t at, row;  /* points of the row (a matrix: numbers), rows that are complete */
    int32_t field;    /* of the point */
    int32_t columns;  /* of the point so far; of a matrix: its x */
    packed_t *axis;   /* its x, downwards */
    num_t implied[3]; /* reader->implied */
    num_t value[CONFIG_DATA_COLUMNS];
    uint8_t part[8]; /* the beginning of a number */
    int32_t part_n;
} data_binary_t;

/* An array or records from 0 on, in steps of 1, without fields; the machine's order of bytes. */
void binary_spec_default(binary_spec_t *spec);
/* reader has been started; its spec's format is DATA_ROWS. */
void data_binary_start(data_binary_t *b, const binary_spec_t *spec, data_reader_t *reader);
/* Takes n bytes, or fewer when no more are wanted. Errors are the reader's. */
int data_binary_feed(data_binary_t *b, const char *bytes, size_t n);
/* Is all there that was asked for? The rest of the file may be of any length. */
bool data_binary_is_complete(const data_binary_t *b);
/* The end of the file: 0, or ERR_DATA when it came too soon. data_reader_finish() is next. */
int data_binary_finish(data_binary_t *b);
#endif

#endif
