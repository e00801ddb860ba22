/* mesh.h - a triangulated terrain: vertices and triangles in the memory the port lends.
 *
 * A terrain has one height over each (x, y); triangles that overlap in plan are the file's mistake and are not
 * detected. Vertices are packed (packed.h): 24 bytes each; a triangle is 12 bytes. */
#ifndef MESH_H
#define MESH_H

#include "scene/packed.h"
#include <stdint.h>

typedef struct mesh {
    int32_t nv, nf;
    const packed_t (*vertex)[3]; /* x, y, z: unpack with packed_num() */
    const int32_t (*face)[3];    /* indices of vertices, 0 <= index < nv, three different ones */
} mesh_t;

#endif
