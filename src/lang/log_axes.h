/* log_axes.h - `set logscale`, internal to src/lang: see log_axes.c. Axis k: 0 x, 1 y, 2 z. */
#ifndef LOG_AXES_H
#define LOG_AXES_H

#include "lang/session.h"

#if CONFIG_LOGSCALE
/* What follows `set logscale`, or `unset logscale`; all axes are linear. */
int log_axes_set(session_t *s, lexer_t *lx, bool on);
void log_axes_reset(session_t *s);
/* s->plot.range, and settings.log_axes; the range in which functions are drawn along an open axis. */
int log_axes_ranges(session_t *s, const lexer_t *at);
void log_axes_open_range(const session_t *s, int k, num_t range[2]);
/* Places of the view are logarithms while a plot is drawn. ERR_VALUE: one has none. */
typedef struct log_axes_view {
    num_t eye[3], to[3], xyplane;
} log_axes_view_t;
int log_axes_view(session_t *s, log_axes_view_t *was);
void log_axes_view_back(session_t *s, const log_axes_view_t *was);
#endif

#endif
