/* scene_files.c - in stdio. */
#define _GNU_SOURCE /* fmemopen */
#include "host/scene_files.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "config.h"
#include "error.h"
#include "host/progress.h"
#include "host/solid_file.h"

enum { FILES_MAX = 16 };

/* A data block. */
typedef struct block {
    struct block *next;
    char name[40];
    char *text;
    size_t len, room;
} block_t;

static struct {
    char folder[PATH_MAX]; /* of the scene, with its slash, or empty */
    FILE *file[FILES_MAX];
    off_t size[FILES_MAX], done[FILES_MAX]; /* of files: bytes; 0 if nobody knows */
    bool binary[FILES_MAX];                 /* nothing in it ends a line */
    block_t *block;                         /* all of them */
} files;

void scene_files_are_beside(const char *scene) {
    const char *slash = strrchr(scene, '/');
    size_t n = slash ? (size_t)(slash - scene) + 1 : 0;
    if (n >= sizeof files.folder) n = 0;
    memcpy(files.folder, scene, n);
    files.folder[n] = 0;
}

static block_t *find_block(const char *name) {
    block_t *b = files.block;
    while (b && strcmp(b->name, name) != 0) b = b->next;
    return b;
}

static void forget_blocks(const char *name, bool begins) {
    for (block_t **at = &files.block; *at;) {
        block_t *b = *at;
        if (begins ? strncmp(b->name, name, strlen(name)) != 0 : strcmp(b->name, name) != 0) {
            at = &b->next;
            continue;
        }
        *at = b->next;
        free(b->text);
        free(b);
    }
}

int scene_files_keep(const char *name, const char *text, size_t n) {
    if (!text && n > 0) {
        forget_blocks(name, n == 2);
        return 0;
    }
    block_t *b = find_block(name);
    if (!b) {
        b = calloc(1, sizeof *b);
        if (!b) return ERR_FULL;
        snprintf(b->name, sizeof b->name, "%s", name);
        b->next = files.block;
        files.block = b;
    }
    if (!text) b->len = 0;
    if (b->len + n >= b->room) {
        const size_t room = 2 * (b->len + n) + 256;
        char *more = realloc(b->text, room);
        if (!more) return ERR_FULL;
        b->text = more;
        b->room = room;
    }
    if (text) memcpy(b->text + b->len, text, n);
    b->len += text ? n : 0;
    return 0;
}

static FILE *open_file(const char *name) {
    const block_t *b = name[0] == '$' ? find_block(name) : NULL;
    if (!b) return fopen(name, "rb");
    if (b->len == 0) return fopen("/dev/null", "rb");
    FILE *copy = fmemopen(NULL, b->len + 1, "w+"); /* the block may change while it is read */
    if (!copy) return NULL;
    if (fwrite(b->text, 1, b->len, copy) == b->len) rewind(copy);
    return copy;
}

int scene_files_open(const char *name, bool binary) {
    int handle = 0;
    while (handle < FILES_MAX && files.file[handle]) handle++;
    if (handle == FILES_MAX) return ERR_FULL;
    FILE *f = open_file(name);
    if (!f && name[0] != '/' && files.folder[0]) {
        char path[PATH_MAX];
        int n = snprintf(path, sizeof path, "%s%s", files.folder, name);
        if (n > 0 && (size_t)n < sizeof path) f = fopen(path, "rb");
    }
    if (!f) return ERR_FILE;
    if (solid_file_is(name) && !binary) f = solid_file_open(f, name);
    if (!f) return ERR_DATA;
    setvbuf(f, NULL, _IOFBF, CONFIG_READ_CHUNK / 8); /* larger pieces are read where they are wanted */
    struct stat about;
    files.file[handle] = f;
    files.binary[handle] = binary;
    files.size[handle] = fileno(f) >= 0 && fstat(fileno(f), &about) == 0 && S_ISREG(about.st_mode) ? about.st_size : 0;
    files.done[handle] = 0;
    progress_begin();
    return handle;
}

int scene_files_read(int handle, char *buf, int size) {
    FILE *f = files.file[handle];
    size_t n = fread(buf, 1, (size_t)size, f);
    files.done[handle] += (off_t)n;
    if (files.size[handle]) progress_update("reading", files.done[handle], files.size[handle]);
    for (char *cr = buf, *end = buf + (files.binary[handle] ? 0 : n);
         (cr = memchr(cr, '\r', (size_t)(end - cr))) != NULL; cr++) {
        const int next = cr + 1 < end ? cr[1] : fgetc(f);
        if (cr + 1 == end && next != EOF) ungetc(next, f);
        if (next != '\n') *cr = '\n'; /* lines may end with CR alone */
    }
    return n == 0 && ferror(f) ? ERR_FILE : (int)n;
}

void scene_files_close(int handle) {
    progress_wipe();
    fclose(files.file[handle]);
    files.file[handle] = NULL;
}

off_t scene_files_size(int handle) {
    return files.size[handle];
}
