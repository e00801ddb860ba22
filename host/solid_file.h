/* solid_file.h - STL and OFF files, read as the Wavefront OBJ text that the core understands.
 *
 * Triangles come with corners of their own; the core puts together what falls together (scene/solid.h). */
#ifndef SOLID_FILE_H
#define SOLID_FILE_H

#include <stdbool.h>
#include <stdio.h>

/* By its name: .stl or .off, in small or capital letters. */
bool solid_file_is(const char *name);
/* Reads all of f, called `name`, and closes it. Returns a stream of OBJ text, or NULL: then stderr has been told what
 * is wrong, and where. */
FILE *solid_file_open(FILE *f, const char *name);

#endif
