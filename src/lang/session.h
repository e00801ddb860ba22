/* session.h - a conversation in the command language: lines of text in, plots and messages out.
 *
 * The session owns settings, variables, functions and the last plot command, all inside session_t; the caller owns
 * session_t and the memory for data. Everything else it needs (files, a terminal, drawing) it asks of the port.
 * Nothing is drawn if any part of a plot command is wrong, and a line is executed command by command: what stands
 * before a wrong command has been done.
 *
 * Context: main loop only. No recursion: `load` has its own small stack of files. */
#ifndef SESSION_H
#define SESSION_H

#include "config.h"
#include "error.h"
#include "lang/plot.h"
#include "lang/settings.h"
#include <stddef.h>

/* What the host or board does for a session. Functions return 0 (or a count) or a negative error, which ends the
 * line and comes back from session_line(). None may be NULL. */
typedef struct session_port {
    void *ctx;
    void (*print)(void *ctx, const char *text); /* what `print`, `show`, `help` say; contains its own newlines */
    void (*warn)(void *ctx, const char *text);  /* warnings and errors; contains its own newlines */
    /* Opens a data file or a script for reading: a handle >= 0, or ERR_FILE. */
    int (*open)(void *ctx, const char *name);
    /* Up to size bytes: how many, 0 at the end, or a negative error. */
    int (*read)(void *ctx, int handle, char *buf, int size);
    void (*close)(void *ctx, int handle);
    /* pause: shows prompt (may be ""), waits ms milliseconds, or for Return when ms < 0. */
    int (*pause)(void *ctx, const char *prompt, int32_t ms);
    /* Draws. Called once for every splot, plot and replot. */
    int (*plot)(void *ctx, const plot_t *plot);
} session_port_t;

enum session_state {
    SESSION_READY, /* the next line is a command */
    SESSION_MORE,  /* the last line ended in `\` or is otherwise unfinished */
    SESSION_DATA,  /* rows of inline data, up to a line `e` */
    SESSION_QUIT,  /* `quit` was executed: feed no more lines */
};

typedef struct session session_t;

/* Starts a session with default settings. pool: memory for data (8-byte aligned), 8 bytes a height, may be NULL with
 * pool_bytes 0. port and pool are used until the session's end. */
void session_init(session_t *s, const session_port_t *port, void *pool, size_t pool_bytes);
/* Names what the lines come from, for messages, and counts its lines from 1: a file's name, or NULL for a terminal. The
 * name is not copied. */
void session_source(session_t *s, const char *name);
/* Feeds one physical line, without its newline. Returns 0, or a negative error after which the rest of the line (and
 * of files being loaded) is forgotten, a report of three lines (text, caret, place and reason) went to port->warn, and
 * s->error says the same in numbers. The session stays usable. */
int session_line(session_t *s, const char *text);
/* The end of the input: an unfinished line or unfinished inline data is an error. */
int session_end(session_t *s);
enum session_state session_state(const session_t *s);
const settings_t *session_settings(const session_t *s);

#endif
