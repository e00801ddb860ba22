/* data_reader.h - a data file or inline rows, character by character, into grids.
 *
 * gnuplot's text formats: isolines as blocks of rows `x y z` separated by a blank line, data sets by two; rows of
 * one column, whose x and y are then the numbers of the point and of the block; `matrix`, whose columns count x and
 * rows count y; `nonuniform matrix`, whose first row holds (after one ignored field) the x and whose first column the
 * y. Every data set that is wanted becomes a grid of its own. For `plot` rows are `x y` or `y`, and all data sets
 * are one curve.
 *
 * A data set whose points turn out to lie on no grid becomes, with all sets behind it, isolines, where the caller has
 * lent a place for them (rows only). */
#ifndef DATA_READER_H
#define DATA_READER_H

#include "config.h"
#include "scene/data_curve.h"
#include "scene/data_grid.h"
#include "scene/field.h"
#include "scene/isolines.h"
#include "scene/scattered.h"

enum data_format { DATA_ROWS, DATA_MATRIX, DATA_NONUNIFORM };

#define USING_EXPR 10000 /* a part that is computed */
#define USING_POINT 0    /* pseudo column 0: number of the point within its data set */
#define USING_BLOCK (-1) /* number of the block */
#define USING_SET (-2)   /* number of the data set */

/* Where the first three (curves: two) columns are: set mapping, set polar. */
enum data_mapping {
    DATA_CARTESIAN,
    DATA_POLAR,       /* angle, radius */
    DATA_CYLINDRICAL, /* angle, z, radius (1) */
    DATA_SPHERICAL,   /* longitude, latitude, radius (1) */
};

/* What `using`, `index`, `every` and `matrix` say. */
typedef struct data_spec {
    enum data_format format;
    bool flat;       /* points of a curve, not of a surface */
    char separator;  /* 0: blanks or a comma */
    int32_t skip;    /* lines at the start that are not looked at */
    int32_t parts;   /* of using: 0 (not given), 1 (z, or y of a curve), 2 (x, y of a curve) or 3 */
    int32_t part[3]; /* column 1.., USING_... */
    uint64_t wanted; /* bit c: column c is a part: a row without it is an error */
    bool all;        /* expressions may look at any column */
#if CONFIG_64BIT
    /* looks[] is known: bit c says that computed part k looks at column c, and it depends on nothing else that changes.
     */
    bool known;
    uint64_t looks[3];
#endif
    int32_t first_set, last_set, set_step;                                            /* index: 0, INT32_MAX, 1 */
    int32_t point_step, block_step, first_point, first_block, last_point, last_block; /* every: 1,1,0,0,MAX,MAX */
#if CONFIG_SAMPLED
    enum data_mapping mapping;
    bool degrees; /* its angles */
#endif
#if CONFIG_SCATTERED
    const scattered_spec_t *scattered; /* points become a grid, or NULL */
#endif
#if CONFIG_LOGSCALE
    const num_t *log_base; /* [3], as log_scale() has it: x, y and z are logarithms; or NULL */
#endif
    /* Computes part number `part` (0..2); reader->column[] holds the row. */
    num_t (*compute)(void *ctx, int32_t part);
    void *ctx;
} data_spec_t;
void data_spec_default(data_spec_t *spec);

typedef struct data_reader {
    const data_spec_t *spec;
    field_t field;
    data_pool_t *pool;
    data_grid_t *grid;   /* [grids_max], of the caller */
    data_curve_t *curve; /* of the caller, where spec->flat */
#if CONFIG_PARAMETRIC
    isolines_t *isolines; /* of the caller, with its limits; or NULL */
    bool in_isolines;     /* sets go there now */
    int32_t left_grid_at; /* the line where what had begun as a grid proved to be none, trouble says why; or 0 */
#endif
#if CONFIG_SCATTERED
    scattered_t scattered;
#endif
#if CONFIG_BINARY
    const num_t
        *implied; /* [3], of the caller: x and y where using does not say them, and what is added to z; or NULL */
#endif
    int32_t grids, grids_max;
    num_t column[CONFIG_DATA_COLUMNS + 1];      /* of the row being read: [1] is the first; [0] the point's number */
    int32_t column_at[CONFIG_DATA_COLUMNS + 1]; /* where it stands in the line */
    uint64_t is_text;                           /* bit c: column c is not a number */
    int32_t parts;                              /* of using, or what the first row made of it */
    int32_t skip;                               /* lines still to be skipped */
    int32_t set, block, point;                  /* numbers, before every and index */
    int32_t kept_point, kept_block, set_points; /* after every; for columns 0 and -1 and implied x, y */
    int32_t blanks;                             /* blank lines in a row */
    int32_t axis_n;                             /* nonuniform matrix: its x, in the pool, downwards from axis */
    packed_t *axis;
    num_t row_y;
    bool row_known; /* a row has been seen in this set */
    bool set_open;  /* grid[grids - 1] is being filled */
    bool stopped;   /* inline data: the line `e` was seen */
    /* After an error: why, and where (line and character from 1; character 0: the whole line). */
    enum data_grid_trouble trouble;
    int32_t line, at;
} data_reader_t;

/* Begins reading. grid[grids_max] (or, for a flat spec, curve[0]), pool and spec are used until the end. stop_at_e:
 * inline data. first_line: number of the line before the first, for messages. */
void data_reader_start(data_reader_t *r, const data_spec_t *spec, data_pool_t *pool, data_grid_t *grid,
                       data_curve_t *curve, int32_t grids_max, bool stop_at_e, int32_t first_line);
/* Takes n characters. Returns 0, or ERR_DATA or ERR_FULL: trouble, line and at say why and where. Once stopped is set
 * the rest is not looked at. */
int data_reader_feed(data_reader_t *r, const char *text, size_t n);
#if CONFIG_SAMPLED
/* In place of text: a row of n numbers; a blank line. */
int data_reader_row(data_reader_t *r, const num_t *v, int32_t n);
int data_reader_break(data_reader_t *r);
#endif
/* The end of the data. Returns the number of grids (1 for a curve; with in_isolines there may be none), or an error;
 * ERR_EMPTY when there was no point at all. */
int data_reader_finish(data_reader_t *r);

#endif
