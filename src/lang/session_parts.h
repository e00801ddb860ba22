/* session_parts.h - how the files of src/lang that carry out commands call each other. Not for other folders.
 *
 * Every function that takes a lexer starts at its current token and returns 0 with the lexer at the command's end, or
 * a negative error with s->error filled, column included. */
#ifndef SESSION_PARTS_H
#define SESSION_PARTS_H

#include "lang/session.h"
#include "lang/text.h"

/* session.c: the source of lines that is read now */
session_frame_t *session_top(session_t *s);
/* session.c: variables and functions, those that hold text, too */
void session_forget_names(session_t *s);
/* session_lines.c: the frame's logical line is forgotten; gets characters; is complete: either it is to be continued or
 * begins to be executed. */
void session_forget_line(session_frame_t *f);
int session_append(session_t *s, session_frame_t *f, const char *text, size_t n);
void session_end_line(session_frame_t *f);
/* The next logical line of a loaded file: 1, 0 at its end, or an error. One line, or piece of a line, of inline data,
 * or of a data block, in it. */
int session_next_line(session_t *s, session_frame_t *f);
int session_file_data(session_t *s, session_frame_t *f);
int session_file_block(session_t *s, session_frame_t *f);
#define SESSION_NO_BRACE "a { is not closed"
#define SESSION_NO_END "the data block has no end"
/* session_rows.c: is this line a row that is passed over? */
bool session_pass_over(session_t *s, const char *text);
/* session_report.c: tells s->error */
void session_report(session_t *s);
/* Is the current token the end of a command? */
bool session_at_end(const lexer_t *lx);
/* ERR_SYNTAX unless it is. */
int session_expect_end(session_t *s, const lexer_t *lx);
/* Goes on to the end of the command, whatever it holds. */
void session_skip(lexer_t *lx);
/* An error at the current token. */
int session_fail(session_t *s, const lexer_t *lx, int code, const char *message);
/* session_text.c: copies the text at lx, which must be one, and goes on. size bytes with the zero. */
int session_string(session_t *s, lexer_t *lx, char *out, size_t size, const char *expected);
#if CONFIG_CONTROL
/* A value that is to stay, which only a text does not by itself: it is kept until all names are forgotten. at: who
 * wants it. */
int session_keep(session_t *s, const lexer_t *at, value_t *v);
/* Is what begins here a text, or an element of an array? */
bool session_is_text(const session_t *s, const lexer_t *lx);
/* Or a call of a function that may give one? */
bool session_may_be_text(const session_t *s, const lexer_t *lx);
/* array.c: array A[3] = [1, 2, 3], behind its word; A[2] = 5: 1 if it was that, 0 with lx untouched, or an error; an
 * array without an index: print A. */
int array_command(session_t *s, lexer_t *lx);
int array_assign(session_t *s, lexer_t *lx);
bool array_is_whole(const session_t *s, const lexer_t *lx);
int array_print(session_t *s, lexer_t *lx);
#else
static inline bool session_is_text(const session_t *s, const lexer_t *lx) {
    (void)s;
    return lx->tok.kind == TOKEN_STRING;
}
#define session_may_be_text session_is_text
#endif
/* `what word why`, with the line, for people. */
void session_warn(session_t *s, const char *what, const char *word, size_t len, const char *why);
/* The same once for each bit. */
void session_warn_once(session_t *s, uint8_t *bits, int index, const char *what, const lexer_t *lx, const char *why);
/* Begins to execute a file at the next command. */
int session_load(session_t *s, const char *name, const lexer_t *at);

/* Is the current token the end of a physical line? */
static inline bool session_is_line_end(const lexer_t *lx) {
    return lx->tok.kind == ';' && *lexer_text(lx) == '\n';
}

#if CONFIG_CONTROL
/* control.c: if and its like, behind their word; at a } or {; does the text so far hold an open brace? */
int control_command(session_t *s, lexer_t *lx, const lexer_t *word);
int control_close(session_t *s, lexer_t *lx);
int control_open(session_t *s, lexer_t *lx);
bool control_is_open(session_frame_t *f);
/* `[i=first:last:step]`, at its bracket; is there a value left; the variable gets it; has what it had before. */
int control_range(session_t *s, lexer_t *lx, control_range_t *r);
bool control_within(const control_range_t *r);
void control_set(session_t *s, const control_range_t *r);
void control_restore(session_t *s, const control_range_t *r);
#endif

/* commands.c */
int session_say(session_t *s, const char *text);
int command_execute(session_t *s, lexer_t *lx);

#if CONFIG_CONTROL
int undefine_command(session_t *s, lexer_t *lx); /* undefine.c */
#endif
/* set.c */
int set_command(session_t *s, lexer_t *lx);
int set_unset_command(session_t *s, lexer_t *lx); /* unset.c */
void set_reset(session_t *s);
/* The index in words_set of the option at lx, or an error that says what is missing; the error for one of `show` only.
 */
int set_find_option(session_t *s, lexer_t *lx, const char *missing);
int set_unknown(session_t *s, const lexer_t *word);
/* The tics that an option of gnuplot is about, or 0. */
uint8_t set_tics_of(uint8_t id);
/* What makes axes of another kind: on or off. Is it such an option? */
bool set_axes(session_t *s, uint8_t id, bool on);
/* An integer within [lo, hi]; what names it in the message. */
int set_integer(session_t *s, lexer_t *lx, int32_t lo, int32_t hi, int32_t *out, const char *message);
/* A number times 10^decimals, rounded, within [lo, hi] (already scaled). */
int set_scaled(session_t *s, lexer_t *lx, int decimals, int64_t lo, int64_t hi, int64_t *out, const char *message);

/* set_range.c: `[lo:hi]`, at its bracket. With name, also `[u=lo:hi]`; *name is then at u. With step, also
 * `[lo:hi:step]`.
 */
int set_range(session_t *s, lexer_t *lx, range_t *r, lexer_t *name, num_t *step);
int set_range_option(session_t *s, lexer_t *lx, range_t *r);
int set_autoscale(session_t *s, lexer_t *lx);

/* set_text.c; index, word: of `datafile`, for its warning */
int set_title(session_t *s, lexer_t *lx);
int set_dummy(session_t *s, lexer_t *lx);
int set_angles(session_t *s, lexer_t *lx);
int set_mapping(session_t *s, lexer_t *lx);
int set_datafile(session_t *s, lexer_t *lx, int index, const lexer_t *word);

/* set_view.c, set_page.c, set_machine.c */
int set_view(session_t *s, lexer_t *lx);
int set_hidden3d(session_t *s, lexer_t *lx);
int set_halo(session_t *s, lexer_t *lx);  /* set_halo.c */
int set_hatch(session_t *s, lexer_t *lx); /* set_light.c */
int set_light(session_t *s, lexer_t *lx);
int set_no_light(session_t *s, lexer_t *lx);
int set_shadow(session_t *s, lexer_t *lx);
int set_pen(session_t *s, lexer_t *lx);   /* set_pen.c */
int set_dgrid(session_t *s, lexer_t *lx); /* set_dgrid.c */
void show_dgrid(const session_t *s, text_t *t);
int set_crease(session_t *s, lexer_t *lx);
const char *set_pen_class(int k); /* its name */
int set_xyplane(session_t *s, lexer_t *lx);
int set_paper(session_t *s, lexer_t *lx);
int set_machine(session_t *s, lexer_t *lx);
/* set_wiring.c: what follows these words of `set machine` */
int set_machine_pen(session_t *s, lexer_t *lx, machine_t *m);
int set_machine_limits(session_t *s, lexer_t *lx, machine_t *m);
int set_machine_home(session_t *s, lexer_t *lx, machine_t *m);
int set_machine_invert(session_t *s, lexer_t *lx, machine_t *m);
void show_wiring(const machine_t *m, text_t *t);

/* show.c, help.c */
int show_command(session_t *s, lexer_t *lx);
void show_range(text_t *t, const char *name, const range_t *r); /* show_range.c */
/* show_symbols.c, show_light.c, show_machine.c */
void show_symbols(session_t *s, enum symbol_kind kind);
void show_pens(text_t *t, const settings_t *set);
void show_lights(text_t *t, const settings_t *set);
void show_machine(session_t *s, text_t *t);
void show_value(text_t *t, const char *word, int64_t v, int decimals); /* v / 10^decimals */
int help_command(session_t *s, lexer_t *lx);

/* block.c. `$name`, at its $, with the $ into out; `$name << END`; one physical line of the block, or its end */
int block_name(session_t *s, lexer_t *lx, char *out, size_t size);
int block_print(session_t *s, lexer_t *lx);
void block_of_palette(session_t *s, lexer_t lx);
int block_evaluate(session_t *s, lexer_t *lx);
int block_command(session_t *s, lexer_t *lx);
int block_line(session_t *s, const char *text, size_t n);

/* plot_parse.c: the whole command becomes s->plot.source[]; nothing is read or drawn. lx: behind the command's word. */
int plot_parse(session_t *s, lexer_t *lx, enum plot_kind kind);
/* plot_ranges.c: the ranges in front of it, into plot.range and the like; the variables, into params. */
int plot_ranges(session_t *s, lexer_t *lx, enum plot_kind kind, expr_params_t *params);
/* One element, appended to them. plot_iteration.c: with `for` in front; is no variable of theirs used elsewhere; the
 * variables have what they had. */
int plot_element(session_t *s, lexer_t *lx, enum plot_kind kind, const expr_params_t *params);
#if CONFIG_CONTROL
/* plot_parse.c: is the text at lx one that stands in the line as it is; one that is put together, kept for the plot */
bool plot_is_plain(const lexer_t *lx);
int plot_text(session_t *s, lexer_t *lx, const char **text);
int plot_iteration(session_t *s, lexer_t *lx, enum plot_kind kind, const expr_params_t *params);
int plot_iteration_check(session_t *s);
void plot_iteration_end(session_t *s);
#endif
/* plot_data.c: start reading the data of src; characters of them (*stopped: the line `e` was among them); the data of
 * source[next] are complete; the reader's error, in the data's own lines; a whole file. */
int plot_data_start(session_t *s, session_source_t *src, bool inline_data, int32_t first_line);
int plot_data_feed(session_t *s, const char *text, size_t n, bool *stopped);
int plot_data_done(session_t *s);
int plot_data_failed(session_t *s, const session_source_t *src, int err);
int plot_data_read(session_t *s, session_source_t *src);
static inline bool session_is_curved(const session_source_t *src) {
#if CONFIG_PARAMETRIC
    return src->kind != SOURCE_EXPR && src->curved;
#else
    return (void)src, false;
#endif
}
/* How many surfaces, curves or bodies an element is. */
static inline int32_t session_items(const session_source_t *src) {
#if CONFIG_PARAMETRIC
    if (src->empty) return 0;
#endif
    return src->kind != SOURCE_EXPR && !src->solid ? src->grids + session_is_curved(src) : 1;
}
/* plot_parametric.c: source[next], of three expressions, becomes a mesh. The ranges of the command as limits. */
int plot_parametric(session_t *s, session_source_t *src);
void plot_limits(const session_t *s, isolines_t *iso);
/* plot_items.c: fills s->plot.item[]; the number of items, or an error. */
int plot_items(session_t *s);
/* The extent of the data along x (k = 0) or y; where functions are drawn if there are none. */
void plot_extent(session_t *s, int k, num_t out[2]);
/* plot_bounds.c: plot_items, within the bounds of the ranges. */
int plot_items_in_bounds(session_t *s);
/* plot_run.c */
int plot_fail(session_t *s, const session_source_t *src, int code, const char *message); /* at src's column */
int plot_command(session_t *s, lexer_t *lx, enum plot_kind kind, uint32_t from);         /* where its line begins */
int plot_replot(session_t *s, lexer_t *lx);
void plot_forget_coming(session_t *s); /* it was not drawn: the one before stays the last */
/* Inline data, any number of characters. *stopped: the line `e` was among them, and the plot went on or is done. */
int plot_feed(session_t *s, const char *text, size_t n, bool *stopped);
/* The end of the text in place of a line `e`. */
int plot_feed_end(session_t *s);

#endif
