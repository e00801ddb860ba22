/* console_parts.h - how the files of the console call each other. Not for other folders. */
#ifndef CONSOLE_PARTS_H
#define CONSOLE_PARTS_H

#include "app/console.h"

/* console.c: what neither the machine nor the data of the last plot use, aligned to 8. */
void *console_free_memory(console_t *c, size_t *bytes);
/* Carries out a line: commands of the board and of the language, up to one that is wrong. 0 or the error, which has
 * been said. The line is written over. */
int console_execute(console_t *c, char *line);
/* A line of the language, or what of a line stands before or behind a command of the board. */
int console_line(console_t *c, const char *line);

/* console_draw.c: the session's plot(). */
int console_draw(console_t *c, const plot_t *plot);

/* console_commands.c: the number of the command of the board that stands from `from` to `end`, negative if it is none.
 */
int console_command_find(const char *from, const char *end);
/* Carries it out: 0 or the error, which has been said. */
int console_command(console_t *c, int number);
/* Draws the saved scene. */
int console_load(console_t *c);
/* Keeps the machine's numbers and autorun if they differ from what is kept. */
int console_keep_settings(console_t *c);
/* Those that are kept, if any; tells the port how the machine is wired. */
void console_load_settings(console_t *c);
/* console.c: waits, looking at what is typed; 0, or ERR_STOPPED by Ctrl-X. */
int console_pause(console_t *c, int32_t ms);
/* console.c: the port is told when the wiring has changed. */
void console_wire(console_t *c);

#endif
