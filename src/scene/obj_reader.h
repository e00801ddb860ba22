/* obj_reader.h - a Wavefront OBJ file, character by character, into a mesh.
 *
 * Taken: `v x y z` (a weight or colours behind it are passed over), `f a b c ...` (ours: `h d e f ...` behind it is a
 * hole in the polygon, and so on), ours: `d a b ...`, a line on the face before it (obj_detail.c: contours and tones),
 * `l a b ...`, `o` and `g`; vertices of faces and lines may be written a/t/n and may count backwards from the last
 * (-1); a `\` at the end of a line continues it; `#` begins a comment. Passed over, since lines have no use for them:
 * vt, vn, s, mtllib, usemap, and what else only concerns looks; usemtl and the names of o and g say what is
 * translucent, if `clear` has names. Any other word is named once, with its line, through `notice`, and passed over
 * too. Inline data end at a line that is just `e`. Each vertex goes through the transformation on its way into memory.
 * Memory, from the pool: 24 bytes a vertex upwards; downwards 4 bytes for each face, line or object and each of their
 * vertices. */
#ifndef OBJ_READER_H
#define OBJ_READER_H

#include "config.h"
#include "scene/affine.h"
#include "scene/data_grid.h"
#include "scene/mesh.h"

#define OBJ_WORD_MAX 48

typedef struct obj_reader {
    data_pool_t *pool;
    const affine_t *affine;   /* NULL: as they are */
    mesh_t mesh;              /* so far */
    char token[OBJ_WORD_MAX]; /* the word being read */
    int32_t token_len;
    int32_t token_at; /* character it begins at, from 1 */
    int32_t words;    /* complete words on this line */
    char what;        /* v, f, l, o, or 0 for a line without interest */
    bool comment, joins;
    bool inline_data, stopped; /* the line `e` was seen */
#if CONFIG_AREA
    /* Names of translucent materials, groups and objects, a zero behind each and another behind all; NULL: none. */
    const char *clear;
    bool clear_group, clear_material, clear_now; /* the last o or g, the last usemtl; as written to the mesh */
    bool clear_any;                              /* some face is */
#endif
    int32_t head;    /* word of the element's head */
    int32_t contour; /* word where its contour at hand begins */
    int32_t detail;  /* of a line `d`: word of its first head */
    int32_t rings;   /* and how many closed contours it has */
    num_t vertex[3];
    uint32_t named; /* bits: words that have been named */
    /* What is not supported; may be NULL. text is not ended by a zero. */
    void (*notice)(void *ctx, int32_t line, const char *text, int32_t len);
    void *notice_ctx;
    int32_t line, at; /* where we are; after an error: where it is */
    enum data_grid_trouble trouble;
} obj_reader_t;

/* pool, and affine unless NULL, are used until the end. inline_data: `e` ends it. first_line: number of the line before
 * the first. Set notice afterwards. */
void obj_reader_start(obj_reader_t *r, data_pool_t *pool, const affine_t *affine, bool inline_data, int32_t first_line);
/* Takes n characters. Returns 0, ERR_DATA or ERR_FULL: trouble, line and at say why and where. Once stopped is set
 * the rest is not looked at. */
int obj_reader_feed(obj_reader_t *r, const char *text, size_t n);
/* The end of the file. Returns 0, ERR_EMPTY when there is neither face nor line, or an error as above. */
int obj_reader_finish(obj_reader_t *r, mesh_t *out);

#endif
