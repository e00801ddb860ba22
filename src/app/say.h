/* say.h - text for the terminal: line feeds become CR LF. Waits while the port's queue is full. Context: main loop. */
#ifndef SAY_H
#define SAY_H

#include <stddef.h>

/* A text of the program, which may be packed (said.h). */
void say(const char *text);
/* One that was put together, or comes from outside. */
void say_line(const char *text);
void say_bytes(const char *text, size_t bytes);

#endif
