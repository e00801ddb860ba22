/* plot_options.h - what may stand behind an element of a plot command. Not for other folders. */
#ifndef PLOT_OPTIONS_H
#define PLOT_OPTIONS_H

#include "lang/session.h"

/* plot_options.c: matrix, nonuniform, index, every, skip, using: into src->spec and src->part. */
int plot_options_data(session_t *s, lexer_t *lx, session_source_t *src);
/* plot_moves.c: translate X,Y,Z; rotate X,Y,Z; scale S or X,Y,Z; any number of them, carried out in this order: added
 * to a. And crease A and translucent, which go to src; names: PLOT_NAMES_MAX for those behind translucent, or NULL. */
int plot_options_moves(session_t *s, lexer_t *lx, affine_t *a, session_source_t *src, char *names);
/* What an angle of `crease` is in mesh_t.smooth_q30. */
int32_t plot_options_cosine(num_t degrees);
/* The option `word` again: an error. */
int plot_options_twice(session_t *s, const lexer_t *word, bool *seen);
/* plot_looks.c: title, with lines, and what concerns colours and widths. */
int plot_options_style(session_t *s, lexer_t *lx, session_source_t *src);
#if CONFIG_BINARY
/* plot_binary.c: binary and the words that belong to it, into src->layout; the end of all options. */
int plot_binary_options(session_t *s, lexer_t *lx, session_source_t *src);
int plot_binary_fields(session_t *s, session_source_t *src);
#endif
#if CONFIG_SAMPLED
/* plot_sampled.c: `sample` and ranges in front of an element, whose names go to params; the file '+', or '++', whose
 * using expressions know params until the element's end; the expressions of a parametric or polar curve; computes all
 * of it. */
int plot_sampling(session_t *s, lexer_t *lx, expr_params_t *params, session_source_t *src);
void plot_sampled_file(session_t *s, session_source_t *src, bool surface, expr_params_t *params);
int plot_sampled_curve(session_t *s, lexer_t *lx, const expr_params_t *params, session_source_t *src);
int plot_sampled_read(session_t *s, session_source_t *src);
#endif
/* plot_parse.c: compiles an expression without dummy variables, or with those of what is sampled, into the plot's code.
 */
int plot_options_expression(session_t *s, lexer_t *lx, expr_t *out);

#endif
