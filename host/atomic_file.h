/* atomic_file.h - the file that an output becomes, all at once: what was there before stays until the new one is whole,
 * so that neither a full disk nor a program that is killed leaves half a drawing, or the beginning of one and the rest
 * of another. (After a power failure either may be lost: to wait for the disk would take longer than a plot.)
 *
 * The new file has no name until atomic_file_keep gives it one: nothing is left behind, whatever happens. What cannot
 * be replaced is written in place, as every program does it: devices and pipes, what a link leads to, a file of
 * somebody else's or with more than one name, a folder in which nothing can be made, a file system without unnamed
 * files. */
#ifndef ATOMIC_FILE_H
#define ATOMIC_FILE_H

#include <stdbool.h>
#include <sys/types.h>

typedef struct atomic_file {
    const char *path; /* the caller's, and has to stay */
    int fd;           /* to be written to */
    bool is_unnamed;  /* or it is written in place */
    bool is_new;      /* nothing was there */
    bool asks_ahead;  /* for disk space, */
    off_t ahead;      /* and has asked for so many bytes */
} atomic_file_t;

/* Only an unnamed file; false when there can be none: nothing has been touched then. */
bool atomic_file_open_unnamed(atomic_file_t *t, const char *path);
/* 0, or ERR_FILE with errno set. */
int atomic_file_open(atomic_file_t *t, const char *path);
/* Before bytes that end at `end` are written: asking for much at once takes the system half the time. */
void atomic_file_ahead(atomic_file_t *t, off_t end);
/* An unnamed file is empty again. False with errno set. */
bool atomic_file_restart(atomic_file_t *t);
/* It is whole, and so long. 0, or ERR_FILE with errno set. */
int atomic_file_keep(atomic_file_t *t, off_t length);
/* It is not to be: what was there stays; what was written in place, if it is a plain file, is empty. */
void atomic_file_drop(atomic_file_t *t);

#endif
