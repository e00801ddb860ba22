/* scene_files.h - what a scene reads: files, for which it is looked where their names say and then beside the scene,
 * and data blocks, which are kept here. Functions return 0, a handle or a count, or a negative error. */
#ifndef SCENE_FILES_H
#define SCENE_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/* Files are also looked for in the folder of this one. */
void scene_files_are_beside(const char *scene);

/* A file, or the block $name as it is now. binary: nothing in it ends a line, and nothing is a solid. */
int scene_files_open(const char *name, bool binary);
/* Up to size bytes: how many, 0 at the end. Lines end with LF, however they do in the file. */
int scene_files_read(int handle, char *buf, int size);
void scene_files_close(int handle);
/* Bytes of the file, 0 if nobody knows. */
off_t scene_files_size(int handle);

/* session_port_t's keep. */
int scene_files_keep(const char *name, const char *text, size_t n);

#endif
