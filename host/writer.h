/* writer.h - which file format a name asks for, and the names of further pages. */
#ifndef WRITER_H
#define WRITER_H

#include <stdbool.h>
#include <stddef.h>

#include "host/stroke_file.h"

/* For messages: ".svg .png ...". */
#define WRITER_SUFFIXES ".svg .png .pdf .vcd .seg .hpgl .plt .gcode"

/* Does the end of the name, in small or capital letters, say one of WRITER_SUFFIXES? */
bool writer_knows(const char *path);
/* Writes the drawing as path's suffix wants it. machine is the plotter that .vcd simulates and .gcode addresses.
 * 0, ERR_VALUE for an unknown suffix, ERR_FILE with errno set, or what the simulated plotter reports. */
int writer_write(const drawing_t *d, const machine_t *machine, const char *path);
/* The format of path, if it is text and can be written while it is drawn; or NULL. */
const stroke_format_t *writer_format(const char *path);
/* The name of page 1, 2, ...: a.svg, a-2.svg, a-3.svg. False when it does not fit into room bytes. */
bool writer_page_name(char *name, size_t room, const char *path, int page);

#endif
