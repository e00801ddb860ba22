/* say.h - text for the terminal: line feeds become CR LF. Waits while the port's queue is full. Context: main loop. */
#ifndef SAY_H
#define SAY_H

#include <stddef.h>

void say(const char *text);
void say_bytes(const char *text, size_t bytes);

#endif
