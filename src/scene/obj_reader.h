/* obj_reader.h - a Wavefront OBJ file, character by character, into a mesh.
 *
 * Taken: `v x y z` and `f a b c ...`, whose vertices may be written a/t/n and may count backwards from the last (-1);
 * a polygon becomes a fan of triangles, triangles with a vertex twice are dropped. Everything else is passed over.
 * Memory, from the pool: 24 bytes a vertex upwards, 12 bytes a triangle downwards. */
#ifndef OBJ_READER_H
#define OBJ_READER_H

#include "scene/data_grid.h"
#include "scene/mesh.h"

typedef struct obj_reader {
    data_pool_t *pool;
    int32_t nv, nf;
    char token[48]; /* the word being read */
    int32_t token_len;
    int32_t token_at; /* character it begins at, from 1 */
    int32_t words;    /* complete words on this line */
    char what;        /* v, f, or 0 for a line without interest */
    bool comment;
    int32_t first, before; /* vertices of the fan */
    packed_t vertex[3];
    int32_t line, at; /* where we are; after an error: where it is */
    enum data_grid_trouble trouble;
} obj_reader_t;

/* pool is used until the end. */
void obj_reader_start(obj_reader_t *r, data_pool_t *pool);
/* Takes n characters. Returns 0, ERR_DATA or ERR_FULL: trouble, line and at say why and where. */
int obj_reader_feed(obj_reader_t *r, const char *text, size_t n);
/* The end of the file. Returns 0, ERR_EMPTY when there is no triangle, or an error as above. */
int obj_reader_finish(obj_reader_t *r, mesh_t *out);

#endif
