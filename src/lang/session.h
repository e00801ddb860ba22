/* session.h - a conversation in the command language: lines of text in, plots and messages out.
 *
 * The session owns settings, variables, functions and the last plot command, all inside session_t; the caller owns
 * session_t and the memory for data. Everything else it needs (files, a terminal, drawing) it asks of the port.
 * Nothing is drawn if any part of a plot command is wrong, and a line is executed command by command: what stands
 * before a wrong command has been done.
 *
 * Memory: sizeof(session_t) is 300 KB with the desktop's capacities, half of it pieces of files, which are touched as
 * they are needed, a quarter lang_t (names.h); and 6 KB with a small board's (config.h). Context: main loop only. No
 * recursion: `load` has its own small stack of files. */
#ifndef SESSION_H
#define SESSION_H

#include "config.h"
#include "error.h"
#include "lang/expr.h"
#include "lang/plot.h"
#include "lang/settings.h"
#include "lang/texts.h"
#include "lang/words.h"
#include "scene/data_binary.h"
#include "scene/data_crop.h"
#include "scene/data_reader.h"
#include "scene/expr_surface.h"
#include "scene/obj_reader.h"
#include <stddef.h>
#include <string.h>

/* What the host or board does for a session. Functions return 0 (or a count) or a negative error, which ends the
 * line and comes back from session_line(). None may be NULL but those that say so. */
typedef struct session_port {
    void *ctx;
    void (*print)(void *ctx, const char *text); /* what `print`, `show`, `help` say; contains its own newlines */
    void (*warn)(void *ctx, const char *text);  /* warnings and errors; contains its own newlines */
    /* Opens a data file or a script for reading: a handle >= 0, or ERR_FILE. */
    int (*open)(void *ctx, const char *name);
#if CONFIG_BINARY
    /* The same for a file of bytes that mean no characters. May be NULL. */
    int (*open_binary)(void *ctx, const char *name);
#endif
    /* Up to size bytes: how many, 0 at the end, or a negative error. */
    int (*read)(void *ctx, int handle, char *buf, int size);
    void (*close)(void *ctx, int handle);
#if CONFIG_LOAD_DEPTH
    /* Data blocks: opens `$name` as a file from then on. Adds n bytes to it; text NULL: empties it (n 0), forgets it
     * (1), or all whose names begin so (2). May be NULL. */
    int (*keep)(void *ctx, const char *name, const char *text, size_t n);
#endif
    /* pause: shows prompt (may be ""), waits ms milliseconds, or for Return when ms < 0. */
    int (*pause)(void *ctx, const char *prompt, int32_t ms);
#if CONFIG_CONTROL
    /* A loop goes round once more: 0, or ERR_STOPPED when the user wants no more of it. May be NULL. */
    int (*turn)(void *ctx);
#endif
    /* Draws. Called once for every splot, plot and replot. */
    int (*plot)(void *ctx, const plot_t *plot);
} session_port_t;

enum session_state {
    SESSION_READY, /* the next line is a command */
    SESSION_MORE,  /* the last line ended in `\`, or a block is open: the next one continues it */
    SESSION_DATA,  /* rows of inline data, up to a line `e`, or lines of a data block */
    SESSION_QUIT,  /* `quit` was executed: feed no more lines */
};

#if CONFIG_CONTROL
/* `[i=first:last:step]`, or `[w in "a b c"]`, on its way. */
typedef struct control_range {
    int symbol;
    bool was_defined; /* before; then */
    value_t before;
    int64_t first, now, last, step;
    const char *words; /* numbered from 1; NULL: numbers */
    bool open;         /* [i=first:*] */
} control_range_t;

/* A block being executed; places are those of the logical line. */
typedef struct session_block {
    enum { BLOCK_IF, BLOCK_ELSE, BLOCK_FOR, BLOCK_WHILE } kind;
    uint32_t body;         /* behind its { */
    uint32_t again;        /* of a while: its condition; of a for in front of another one: that, else 0 */
    control_range_t range; /* of a for */
} session_block_t;
#endif

/* Where lines come from: the caller, or a file being loaded. */
typedef struct session_frame {
    int handle;                  /* of the port; -1: session_line() */
    const char *name;            /* of the source, or NULL for a terminal */
    int32_t line;                /* physical lines so far */
    int32_t first_line;          /* where the logical line begins */
    uint16_t join[CONFIG_JOINS]; /* bytes of text at which its further physical lines begin */
    int32_t joins;
    bool more;  /* unfinished: ended in a backslash */
    lexer_t lx; /* how far text has been executed */
#if CONFIG_CONTROL
    session_block_t block[CONFIG_BLOCKS];
    int32_t blocks;
    int32_t braces; /* open in the text, as far as it is counted */
    uint32_t counted;
#endif
    uint32_t len;
    char text[CONFIG_LINE_MAX + 1];
} session_frame_t;

/* A file being read in pieces. */
typedef struct session_chunk {
    int at, len;
    char bytes[CONFIG_READ_CHUNK];
} session_chunk_t;

#define PLOT_NAMES_MAX 128 /* of `translucent`, with a zero behind each and another behind all */

#if CONFIG_SAMPLED
/* [t=0:10:2] in front of an element. */
typedef struct plot_sampling {
    bool given;
    range_t range;
    num_t step; /* 0: as many as `set samples` says */
} plot_sampling_t;
#endif

/* One element of a plot command, as it was typed. */
typedef struct session_source {
    enum { SOURCE_EXPR, SOURCE_FILE, SOURCE_INLINE } kind;
    bool solid;      /* a file or inline data of vertices and faces; a parametric surface */
    bool parametric; /* the latter */
    bool clear;      /* `translucent` */
    int32_t column;  /* of the element's first character, for messages */
    lexer_t name;    /* at the file's name, or at the expression */
    const char *title;
    int32_t title_len;
#if CONFIG_CONTROL
    bool iterated;         /* stands behind `for` */
    bool open_ended;       /* behind for [i=1:*]: data that are none end it */
    const char *file_name; /* in plot.texts; NULL: as `name` says */
#endif
    expr_t expr;    /* of the element */
    expr_t part[3]; /* of using; of a parametric surface */
    data_spec_t spec;
#if CONFIG_BINARY
    bool binary;
    binary_spec_t layout;
#endif
    int32_t first_grid, grids; /* of data */
    int32_t smooth_q30;        /* cosine of `crease` (mesh.h) */
#if CONFIG_PARAMETRIC
    num_t extent[2][2]; /* plot.h */
    bool empty;         /* nothing of it is to be drawn, which is no mistake */
    bool curved;        /* some of its data are no grid: behind its grids comes a mesh */
#endif
#if CONFIG_SAMPLED
    uint8_t sampled; /* its rows are computed: from one parameter, or two; 0 */
    plot_sampling_t sampling[2];
#endif
    uint32_t moves; /* where `translate` and the like begin in the line of `name`, or 0 */
} session_source_t;

/* What stands behind one surface or curve while it is drawn. */
typedef union session_work {
    struct {
        expr_source_t source;
        expr_grid_t grid, rows, cols;
    } expr;
    struct {
        data_view_t data;
#if CONFIG_CROP
        data_crop_t rows, cols;
#endif
    } data;
} session_work_t;

typedef struct session {
    const session_port_t *port;
    settings_t settings;
    lang_t lang;
    lang_error_t error;                                                           /* of the last line that failed */
    uint8_t warned_command[WORDS_COMMAND_MAX / 8], warned_set[WORDS_SET_MAX / 8]; /* bits */
#if CONFIG_LOAD_DEPTH
    bool in_block;                 /* lines are those of a data block */
    char block[32], block_end[32]; /* its name; the line that ends it */
    const char *row;               /* of inline data, as session_line() was given it; or NULL */
    char print_to[32];             /* set print: the block that gets what is printed, or "" */
#endif
    bool rows_left;     /* the inline data were refused, and rows of them are still coming */
    int32_t rows_bytes; /* of memory that they take all together, if that was why; or 0 */
    bool quit;
#if CONFIG_CONTROL
    int32_t turns; /* of loops, since the last line came in */
    /* What becomes of an `else` that comes next, and of a block behind `if (c)` or `else` at the end of a line. */
    enum {
        ALTERNATIVE_NONE, /* it has no `if` */
        ALTERNATIVE_PASSED,
        ALTERNATIVE_TAKEN,
        ALTERNATIVE_BODY,        /* the block is executed */
        ALTERNATIVE_BODY_LEFT,   /* it is not; its `else` is */
        ALTERNATIVE_BODY_PASSED, /* nor is that */
    } alternative;
    texts_t texts;
#endif
    bool nonlinear; /* set nonlinear; without CONFIG_LOGSCALE also set logscale */
#if CONFIG_LOGSCALE
    num_t log_base[3]; /* of x, y, z; 0: linear */
#endif
    enum { AXES_XY, AXES_PARAMETRIC, AXES_POLAR } axes; /* set parametric, polar: what expressions mean */
#if CONFIG_PARAMETRIC
    range_t uv[2]; /* set urange, vrange */
#endif
#if CONFIG_SCATTERED
    scattered_spec_t scattered; /* set dgrid3d */
#endif
#if CONFIG_SAMPLED
    range_t t; /* set trange */
    enum data_mapping mapping;
#endif
    bool in_last;                      /* the error is in `last` (replot), not in the frame's line */
    char dummy[2][LANG_ERROR_MAX / 4]; /* set dummy */
    char separator;                    /* set datafile separator; 0: blanks and commas */
    int32_t frames;                    /* sources of lines on the stack; at least 1 */
    session_frame_t frame[1 + CONFIG_LOAD_DEPTH];
    char frame_name[CONFIG_LOAD_DEPTH + 1][CONFIG_NAME_MAX + 1]; /* [0] is used for prompts and data files */
    session_chunk_t frame_chunk[CONFIG_LOAD_DEPTH + 1];          /* [0] is used for data files */
    /* The last plot command that was drawn, for replot; behind it the one that is being carried out, in its place if
     * there is no room. */
    char last[CONFIG_LINE_MAX + 1];
    size_t last_len; /* of it that is known to be right: replot may have added the rest */
    int32_t coming;  /* where the one being carried out begins, or -1 */
    /* The plot command being carried out. */
    struct {
        enum plot_kind kind;
        bool waiting; /* for inline data of source[next] */
        int32_t sources, next;
        int32_t kept;     /* replot: elements whose data are still in the pool */
        int32_t valid;    /* elements of the last plot whose data are in the pool */
        int data_error;   /* of an expression in using, or 0 */
        range_t range[3]; /* given in the command, or as set */
#if CONFIG_PARAMETRIC
        range_t uv[2]; /* so too */
#endif
#if CONFIG_SAMPLED
        range_t t;
        const expr_params_t *using_params; /* of the element being compiled, or NULL */
#endif
#if CONFIG_CONTROL
        char texts[CONFIG_NAME_MAX + 1]; /* titles and names of files that were put together, one behind the other */
        size_t texts_len;
        control_range_t iterated[CONFIG_BLOCKS]; /* by `for`: functions may change these until all is drawn */
        int32_t iterations;
#endif
        size_t code_len;
        session_source_t source[CONFIG_PLOT_ITEMS];
        data_grid_t grid[CONFIG_PLOT_ITEMS];
        int32_t grids;
        union { /* of `plot`; of a splot of solids, by element */
            data_curve_t curve[CONFIG_PLOT_ITEMS];
            mesh_t mesh[CONFIG_PLOT_ITEMS];
        };
        union { /* the data being read; when they are, what is drawn */
            struct {
                data_reader_t reader;
#if CONFIG_BINARY
                data_binary_t binary;
#endif
#if CONFIG_PARAMETRIC
                isolines_t isolines;
#endif
            };
            struct {
                obj_reader_t obj;
                affine_t affine;
#if CONFIG_AREA
                char clear_names[PLOT_NAMES_MAX]; /* obj.clear */
#endif
            };
            struct {
                session_work_t work[CONFIG_PLOT_ITEMS];
                plot_item_t item[CONFIG_PLOT_ITEMS];
            };
        };
        uint8_t code[CONFIG_PLOT_CODE];
    } plot;
    data_pool_t pool;
    size_t pool_size; /* units of 8 bytes */
} session_t;

/* Starts a session with default settings in memory that is zero, as static memory is: what is not used of it need not
 * be touched, and a desktop gets it page by page. pool: memory for data (8-byte aligned), 8 bytes a height, may be NULL
 * with pool_bytes 0. port and pool are used until the session's end. */
void session_start(session_t *s, const session_port_t *port, void *pool, size_t pool_bytes);
/* The same in any memory. */
static inline void session_init(session_t *s, const session_port_t *port, void *pool, size_t pool_bytes) {
    memset(s, 0, sizeof *s);
    session_start(s, port, pool, pool_bytes);
}
/* Names what the lines come from, for messages, and counts its lines from 1: a file's name, or NULL for a terminal. The
 * name is not copied. */
void session_source(session_t *s, const char *name);
/* Feeds one physical line, without its newline. Returns 0, or a negative error after which the rest of the line (and
 * of files being loaded) is forgotten, a report (the text, a caret, place and reason) went to port->warn, and
 * s->error says the same in numbers. The session stays usable. */
int session_line(session_t *s, const char *text);
/* The end of the input: an unfinished line or unfinished inline data is an error. */
int session_end(session_t *s);
/* Forgets what is under way: a line to be continued, inline data (the user thinks better of it). */
void session_cancel(session_t *s);
enum session_state session_state(const session_t *s);
const settings_t *session_settings(const session_t *s);

#endif
