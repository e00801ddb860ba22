/* lines.h - random small scripts: assignments, functions, settings, conditions and loops, and slips of the pen. */
#ifndef COMPARE_LINES_H
#define COMPARE_LINES_H

#include <stddef.h>
#include <stdint.h>

enum { LINES_TEXT = 1 << 15 };

/* Writes a script of some lines that both programs should carry out, or refuse, alike. */
void lines_draw(uint64_t *rng, char text[LINES_TEXT]);

#endif
