/* ink.h - visible ink, the one thing all hidden-line kernels produce.
 *
 * A kernel decides visibility and says where along a line of the scene something is visible; it does not know
 * the page. A piece is an interval of one line: line `line` of family `family`, from parameter `from` to `to`
 * (from < to). The integer part of a parameter (q30) is the index of a vertex of that line, the fraction the
 * position in space (not on the page) between it and the next. So a piece costs 24 bytes however long it is,
 * and its points can be computed again when the pen gets there. */
#ifndef INK_H
#define INK_H

#include <stdint.h>

#define INK_ONE ((int64_t)1 << 30) /* parameter of one grid cell */

enum ink_family {
    INK_ROW,     /* y = y_j: line is j, the parameter counts columns */
    INK_COL,     /* x = x_i: line is i, the parameter counts rows */
    INK_PROFILE, /* profile `line` of a horizon scene, the parameter counts its vertices */
    INK_CURVE,   /* a flat polyline: curves of `plot`, axes, annotations */
    INK_SEGMENT, /* a straight line in space: edge `line` of a scene of solids, the parameter ends at INK_ONE */
};

typedef struct ink_piece {
    uint8_t family;  /* enum ink_family */
    uint8_t surface; /* which of several surfaces, 0 first */
    int32_t line;
    int64_t from_q30, to_q30;
} ink_piece_t;

/* Takes one piece. Returns 0 or a negative error, which ends the kernel and is returned by it. */
typedef struct ink_sink {
    void *ctx;
    int (*piece)(void *ctx, const ink_piece_t *p);
} ink_sink_t;

#endif
