/* words.h - the keywords of the language with gnuplot's shortest abbreviations: "sp$lot" is sp, spl, splo or splot.
 *
 * A table is searched from its start and the first match counts, as in gnuplot, so its order decides what an
 * abbreviation that fits several words means. */
#ifndef LANG_WORDS_H
#define LANG_WORDS_H

#include "lang/lexer.h"

/* The index in the table of the current token, or -1. Does not go on. A table is patterns one behind the other, each
 * ended by a zero, and an empty one: "bin$ary\0mask\0". (A structure of pointer and id would take 7 bytes more a word.)
 */
int words_find(const char *table, const lexer_t *lx);
/* A table with ids is written once, as a list of WORD(pattern, id), and read twice. */
#define WORDS_PATTERN(pattern, id) pattern "\0"
#define WORDS_ID(pattern, id) id,
/* The same for len bytes of text. */
bool words_match(const char *pattern, const char *text, size_t len);

enum command_id {
    CMD_EXIT,
    CMD_HELP,
    CMD_LOAD,
    CMD_PAUSE,
    CMD_PLOT,
    CMD_PRINT,
    CMD_REPLOT,
    CMD_RESET,
    CMD_SET,
    CMD_SHOW,
    CMD_SPLOT,
    CMD_UNSET,
    CMD_CONTROL, /* this and those that follow want their own word, not only what stands behind it */
    CMD_UNDEFINE,
    CMD_ARRAY,
    CMD_EVALUATE,
    CMD_IGNORED,     /* gnuplot's, without a meaning for a plotter: one warning, skipped */
    CMD_UNSUPPORTED, /* gnuplot's, and skipping it would change what follows: an error */
};
extern const char words_command[];
extern const uint8_t words_command_id[];
/* A bit for a warning already given: one per word of words_command and words_set. */
#define WORDS_COMMAND_MAX 64
/* The last of these bits: `with` something else than lines. */
#define WORDS_WARNED_STYLE (WORDS_COMMAND_MAX - 1)

enum set_id {
    SET_ANGLES,
    SET_AUTOSCALE,
    SET_DATAFILE,
    SET_DUMMY,
    SET_HALO,
    SET_CREASE,
    SET_HATCH,
    SET_LIGHT,
    SET_PEN,
    SET_SHADOW,
    SET_HIDDEN3D,
    SET_ISOSAMPLES,
    SET_MACHINE,
    SET_PAPER,
    SET_PARAMETRIC,
    SET_POLAR,
    SET_PRINT,   /* as what is ignored, but for data blocks */
    SET_PALETTE, /* ignored, but rows may follow */
    SET_LOGSCALE,
    SET_NONLINEAR, /* ignored, but plots are refused while it is set; so are parametric and polar where they are not */
    SET_DGRID,
    SET_MAPPING,
    SET_TRANGE,
    SET_URANGE,
    SET_VRANGE,
    SET_SAMPLES,
    SET_STYLE,
    SET_TITLE,
    SET_VIEW,
    SET_XRANGE,
    SET_YRANGE,
    SET_ZRANGE,
    SET_XYPLANE,
    SET_TICSLEVEL,
    SET_ALL,       /* show only */
    SET_VARIABLES, /* show only */
    SET_FUNCTIONS, /* show only */
    SET_VERSION,   /* show only */
    SET_IGNORED,
    SET_BORDER, /* this and the next four: not drawn, but they count for the box of the axes */
    SET_TICS,
    SET_XTICS,
    SET_YTICS,
    SET_ZTICS,
};
extern const char words_set[];
extern const uint8_t words_set_id[];
#define WORDS_SET_MAX 192

enum style_id { STYLE_LINES, STYLE_OTHER };
extern const char words_style[];
extern const uint8_t words_style_id[];

#endif
