/* keep.h - the scene as a text that makes it again: definitions as they were typed, settings as `show` tells them, and
 * the last plot command.
 *
 * Definitions have no text in the session, so those that were carried out are remembered in a journal of CONFIG_JOURNAL
 * bytes; options that `show` does not tell (border, tics) go there, too. Context: main loop. */
#ifndef KEEP_H
#define KEEP_H

#include "config.h"
#include "lang/session.h"
#include "lang/text.h"

typedef struct keep {
    uint16_t len;
    bool full; /* something had no place, or could not be told from the line */
    char journal[CONFIG_JOURNAL];
} keep_t;
_Static_assert(CONFIG_JOURNAL <= UINT16_MAX, "the length is 16 bits");

void keep_clear(keep_t *k);
/* After a line was carried out: those of its commands that end before byte `done`. */
void keep_line(keep_t *k, const char *line, size_t done);

/* The end of the command that begins at p: a semicolon, comment or the end of the text, outside of quotes. */
const char *keep_command_end(const char *p);

/* What the session prints while it is captured, instead of going to the terminal. */
typedef struct keep_capture {
    text_t text;
    bool on, cut;  /* cut: there was no room */
    bool machine;  /* want `set machine` lines, else all others */
    bool skipping; /* a line that is not wanted */
    bool in_line;
} keep_capture_t;

/* To be called from the session's print while capture->on. */
void keep_print(keep_capture_t *c, const char *text);

/* Writes the scene to buf (ended by a zero). Returns its length or ERR_EMPTY (nothing drawn yet), ERR_DATA (inline data
 * cannot be kept), ERR_FULL (no room, or the journal is full). */
int keep_scene(const keep_t *k, session_t *s, keep_capture_t *c, char *buf, size_t room);
/* The same with the command for the machine's numbers. */
int keep_machine(session_t *s, keep_capture_t *c, char *buf, size_t room);

#endif
