/* config.h - every capacity of the program, with the arithmetic that turns it into bytes.
 *
 * The defaults are the desktop's. A board overrides them on the compiler's command line (-DCONFIG_LINE_MAX=256)
 * and pays for what it takes; nothing is allocated anywhere else. A capacity that runs out is the ordinary
 * error ERR_FULL with its name in the message. */
#ifndef CONFIG_H
#define CONFIG_H

/* One logical line of commands, continuations and blocks joined, without its end (bytes). Held once for what was typed,
 * once for replot, and once per level of `load`: (2 + CONFIG_LOAD_DEPTH) * (CONFIG_LINE_MAX + 1) bytes. */
#ifndef CONFIG_LINE_MAX
#define CONFIG_LINE_MAX 8192
#endif

/* How deep `load` may nest. 0 leaves out files altogether. */
#ifndef CONFIG_LOAD_DEPTH
#define CONFIG_LOAD_DEPTH 4
#endif

/* Characters read from a file at a time: one such buffer per level of `load` and one for data (bytes). Large, because
 * what a piece begins and ends with is read one character at a time (scene/data_plain.h). */
#ifndef CONFIG_READ_CHUNK
#define CONFIG_READ_CHUNK (CONFIG_64BIT ? 32768 : 512)
#endif

/* Surfaces or curves in one plot command: about 400 bytes each. */
#ifndef CONFIG_PLOT_ITEMS
#define CONFIG_PLOT_ITEMS 32
#endif

/* 0 leaves out solids, their kernels and haloed lines: 40 KB of flash. */
#ifndef CONFIG_SOLIDS
#define CONFIG_SOLIDS 1
#endif

/* Haloed lines, of solids and of grids, and terrains of triangles (0 or 1): 15 KB of flash; needs CONFIG_SOLIDS. */
#ifndef CONFIG_HALO
#define CONFIG_HALO CONFIG_SOLIDS
#endif

/* The polygon area sort, hatching and shadows (0 or 1): 25 KB of flash; needs CONFIG_SOLIDS. */
#ifndef CONFIG_AREA
#define CONFIG_AREA CONFIG_SOLIDS
#endif

/* Parametric surfaces (0 or 1): 2 KB of flash; needs CONFIG_SOLIDS. */
#ifndef CONFIG_PARAMETRIC
#define CONFIG_PARAMETRIC CONFIG_AREA
#endif

/* Lines of data that hide nothing are cut where they cross xrange and yrange (0 or 1): 1 KB of flash. */
#ifndef CONFIG_CROP
#define CONFIG_CROP CONFIG_AREA
#endif

/* set logscale (0 or 1): 2 KB of flash. Without, plots are refused while it is set. */
#ifndef CONFIG_LOGSCALE
#define CONFIG_LOGSCALE CONFIG_AREA
#endif

/* The files '+' and '++', sampling ranges, parametric and polar `plot`, set mapping (0 or 1): 3 KB of flash. */
#ifndef CONFIG_SAMPLED
#define CONFIG_SAMPLED CONFIG_PARAMETRIC
#endif

/* Bounds of autoscaled ends, [0<*<3:] (0 or 1): 64 bytes of RAM a range. */
#ifndef CONFIG_BOUNDED
#define CONFIG_BOUNDED (CONFIG_LOAD_DEPTH > 0)
#endif

/* Binary data (0 or 1): needs files and CONFIG_SAMPLED. */
#ifndef CONFIG_BINARY
#define CONFIG_BINARY (CONFIG_LOAD_DEPTH > 0 && CONFIG_SAMPLED)
#endif

/* set dgrid3d (0 or 1): 3 KB of flash. */
#ifndef CONFIG_SCATTERED
#define CONFIG_SCATTERED CONFIG_AREA
#endif

/* if, do, while, `for`, and texts that are put together (0 or 1): 6 KB of flash. How many blocks may be open; how often
 * loops may go round before what was typed counts as caught in one. */
#ifndef CONFIG_CONTROL
#define CONFIG_CONTROL CONFIG_AREA
#endif
#ifndef CONFIG_BLOCKS
#define CONFIG_BLOCKS 8
#endif
/* Variables that hold text, with their names (bytes). */
#ifndef CONFIG_TEXTS
#define CONFIG_TEXTS (CONFIG_NAME_MAX * 4)
#endif
/* Texts in quotes in compiled expressions, elements of arrays that are texts; results of one evaluation (bytes). */
#ifndef CONFIG_LITERALS
#define CONFIG_LITERALS (CONFIG_NAME_MAX * 8)
#endif
#ifndef CONFIG_TEXT_WORK
#define CONFIG_TEXT_WORK (CONFIG_NAME_MAX * 4)
#endif
/* Elements of all arrays: 16 bytes each. */
#ifndef CONFIG_CELLS
#define CONFIG_CELLS CONFIG_STACK
#endif
#ifndef CONFIG_TURNS
#define CONFIG_TURNS 1000000
#endif

/* Faces that a mesh has twice are one (scene/solid_double.c: 0.6 KB). Without, each is a body of its own: it hides the
 * same, and is drawn with all of its edges, whatever `crease` says. */
#ifndef CONFIG_DOUBLES
#define CONFIG_DOUBLES CONFIG_AREA
#endif

/* Faces with holes (`f ... h ...`; 0 or 1): 1.7 KB of flash. */
#ifndef CONFIG_HOLES
#define CONFIG_HOLES 1
#endif

/* 1: edges of solids that are turned from the eye are not asked what they coincide with (hidden/solid/once_away.h).
 * Nothing depends on it but speed; 0.7 KB of code. */
#ifndef CONFIG_ONCE_AWAY
#define CONFIG_ONCE_AWAY CONFIG_AREA
#endif

/* 1: which bodies are near an edge is looked up (hidden/solid/convex.c), and sides of faces are seen from their
 * pictures. 0: all bodies are asked, as is right where there can only be a few. Nothing depends on it but speed; 1.5 KB
 * of code. */
#ifndef CONFIG_MANY_BODIES
#define CONFIG_MANY_BODIES 1
#endif
/* 1: what a horizon is nowhere below is remembered, and its gap goes far by leaps (hidden/surface/lowest.h). Nothing
 * depends on it but speed; 1.2 KB of code. */
#ifndef CONFIG_LOWEST
#define CONFIG_LOWEST CONFIG_AREA
#endif

/* 1: the core has an instruction that divides. Without one fractions are found by products (view/pencil.h); the same.
 */
#ifndef CONFIG_DIVIDES
#define CONFIG_DIVIDES 1
#endif

/* 1: how far ordering strokes is can be told (path_config_t.tell); 8 bytes of RAM. */
#ifndef CONFIG_TELL_ORDER
#define CONFIG_TELL_ORDER CONFIG_AREA
#endif

/* 1: there may be memory for 65,536 strokes, which are put in order otherwise (path/match.h); 1.5 KB of code. */
#ifndef CONFIG_MANY_STROKES
#define CONFIG_MANY_STROKES 1
#endif

/* 1: registers of 64 bits, a stack of megabytes, and room for code that is longer to be faster. Nothing depends on it
 * but speed. */
#ifndef CONFIG_64BIT
#define CONFIG_64BIT (__SIZEOF_POINTER__ > 4)
#endif

/* 1: memory has caches that are asked for what is needed soon (path_config_t.fetch). Nothing depends on it but speed.
 */
#ifndef CONFIG_FETCH
#define CONFIG_FETCH CONFIG_64BIT
#endif

/* Columns of a data file that `using` may speak of: 16 bytes each. */
#ifndef CONFIG_DATA_COLUMNS
#define CONFIG_DATA_COLUMNS 32
#endif
_Static_assert(CONFIG_DATA_COLUMNS < 64, "data_reader keeps one bit per column in 64");

/* Variables and user functions, those only mentioned included: 24 bytes each. */
#ifndef CONFIG_SYMBOLS
#define CONFIG_SYMBOLS 128
#endif

/* Their names, the code of functions, and expressions that are compiled only to be evaluated once (bytes). A function
 * takes a byte an operator, 2 a name or small integer, 3 a call, 11 another constant. */
#ifndef CONFIG_POOL
#define CONFIG_POOL 8192
#endif

/* Values on the evaluator's stack, arguments and operands of all calls under way: 16 bytes each. */
#ifndef CONFIG_STACK
#define CONFIG_STACK 1024
#endif

/* Points of a row that are evaluated at once, at most 64: each operation is then decoded once for all of them. 16 bytes
 * of the machine's stack each where heights are measured or hidden, and 1.5 KB of code; 1: none. */
#ifndef CONFIG_ROW_POINTS
#define CONFIG_ROW_POINTS (CONFIG_64BIT ? 64 : 16)
#endif

/* Single heights of a surface that are remembered where not all can be, a power of two: ends of lines are asked for
 * several times in turn. 8 bytes each, for each surface; 0: none. */
#ifndef CONFIG_HEIGHTS
#define CONFIG_HEIGHTS 16
#endif
_Static_assert((CONFIG_HEIGHTS & (CONFIG_HEIGHTS - 1)) == 0, "CONFIG_HEIGHTS must be a power of two");

/* 1: a core of 32 bits has quotients and roots of its own, by words (num/num_double.c); they are the same, three times
 * sooner where products of 64 bits and divisions are routines. 0.6 KB of code. */
#ifndef CONFIG_DOUBLE_WORDS
#define CONFIG_DOUBLE_WORDS (__SIZEOF_POINTER__ < 8)
#endif

/* 1: rows have an exp(), a sin() and a cos() of their own, without calls; 1.4 KB of code. */
#ifndef CONFIG_ROW_FUNCTIONS
#define CONFIG_ROW_FUNCTIONS CONFIG_AREA
#endif

/* User functions under way at once, which is the limit of recursion: 8 bytes each (16 on 64-bit machines). gnuplot's
 * limit is 250 too. */
#ifndef CONFIG_CALLS
#define CONFIG_CALLS 250
#endif

/* User functions that one evaluation may call in all, so that no line of text runs for hours. */
#ifndef CONFIG_CALL_WORK
#define CONFIG_CALL_WORK 10000000
#endif

/* Operators and brackets open at once while an expression is compiled: 4 bytes of the machine's stack each. */
#ifndef CONFIG_NESTING
#define CONFIG_NESTING 64
#endif

/* Operations of a straight expression that is taken apart for a grid, calls of functions replaced by what they say:
 * while that is done 6 bytes of the machine's stack each, and 8 of the memory that is lent. */
#ifndef CONFIG_PARTS
#define CONFIG_PARTS (CONFIG_STACK < 64 ? 64 : CONFIG_STACK)
#endif
_Static_assert(CONFIG_PARTS >= 64 && CONFIG_PARTS <= 4096, "lang/parts.h, lang/hoist.h and lang/inline.h count on it");

/* Compiled expressions of one plot command, those in `using` included: a byte an operator, 2 a name, 11 a constant. */
#ifndef CONFIG_PLOT_CODE
#define CONFIG_PLOT_CODE 4096
#endif

/* Physical lines that may be joined into one by `\` and still be told apart in messages: 2 bytes each, at least 1. */
#ifndef CONFIG_JOINS
#define CONFIG_JOINS 256
#endif

/* Names of files, texts to print, and prompts of `pause` (bytes); held 1 + CONFIG_LOAD_DEPTH times. */
#ifndef CONFIG_NAME_MAX
#define CONFIG_NAME_MAX 1000
#endif

/* A board's console: bytes that the port has received and the program has not looked at, at most some ms old; bytes
 * typed ahead. Powers of two. */
#ifndef CONFIG_RECEIVED
#define CONFIG_RECEIVED 128
#endif
#ifndef CONFIG_TYPED
#define CONFIG_TYPED 256
#endif

/* A board's console: definitions of variables and functions as they were typed, for `save` (bytes). */
#ifndef CONFIG_JOURNAL
#define CONFIG_JOURNAL 2048
#endif

/* A board's memory block (console.h) and what the machine's queue takes of it: blocks of look-ahead, pieces. */
#ifndef CONFIG_BOARD_BYTES
#define CONFIG_BOARD_BYTES 131072
#endif
#ifndef CONFIG_MOTION_BLOCKS
#define CONFIG_MOTION_BLOCKS 128
#endif
#ifndef CONFIG_MOTION_PIECES
#define CONFIG_MOTION_PIECES 64
#endif

/* Steps a second that the board's interrupt makes in time on both motors at once; 0: as many as are asked for. And the
 * pen's speed by default (um/s). */
#ifndef CONFIG_STEP_RATE
#define CONFIG_STEP_RATE 0
#endif
/* Steps a second squared that the main loop keeps up with, as near rest every step is planned by itself; 0: any. */
#ifndef CONFIG_STEP_ACCEL
#define CONFIG_STEP_ACCEL 0
#endif
#ifndef CONFIG_SPEED_UM_S
#define CONFIG_SPEED_UM_S 100000
#endif

/* Pieces of ink that may wait for the kernel's next pause (20 bytes each; more if a drawing needs them). 0: what is
 * joined, ordered and drawn is so in the midst of a facet, which takes 1 KB of stack more, but then a drawing that is
 * sure to fit need not be tried first. */
#ifndef CONFIG_WAITING
#define CONFIG_WAITING 0
#endif

/* Drawing while the picture is still being computed: runs of ink that may wait for the machine (20 bytes each; 0: all
 * is ordered first), what hiding a facet takes at most, and ordering a run (us). */
#ifndef CONFIG_OUTBOX
#define CONFIG_OUTBOX 0
#endif
#ifndef CONFIG_FED
#define CONFIG_FED 1 /* 0 leaves it out: 1 KB of flash and what it takes of the stack */
#endif
#ifndef CONFIG_FACET_US
#define CONFIG_FACET_US 100
#endif
#ifndef CONFIG_ORDER_US
#define CONFIG_ORDER_US 1000
#endif

/* The pen's pin can be a servo's (hal.h). */
#ifndef CONFIG_PEN_SERVO
#define CONFIG_PEN_SERVO 1
#endif

/* Width of a step pulse and how long DIR stands before it, by default (ns). What the drivers need, and not less than
 * what the chip's interrupt can keep. */
#ifndef CONFIG_PULSE_NS
#define CONFIG_PULSE_NS 2000
#endif
#ifndef CONFIG_DIR_SETUP_NS
#define CONFIG_DIR_SETUP_NS 1000
#endif

#endif
