/* ink.h - visible ink, the one thing all hidden-line kernels produce.
 *
 * A kernel decides visibility and says where along a line of the scene something is visible; it does not know
 * the page. A piece is an interval of one line: line `line` of family `family`, from parameter `from` to `to`
 * (from < to). The integer part of a parameter is the index of a vertex of that line, the fraction the
 * position in space (not on the page) between it and the next. So a piece costs 24 bytes however long it is,
 * and its points can be computed again when the pen gets there.
 *
 * A parameter counts ink_one(family) to an edge. The edges of a surface may be a million times as long as the way from
 * the eye to them (cliffs, poles), and an end must be good to a step nevertheless: 2^46. All others have 2^30. */
#ifndef INK_H
#define INK_H

#include <stdint.h>

#define INK_ONE_BITS 30
#define INK_ONE ((int64_t)1 << INK_ONE_BITS) /* parameter of one edge */
#define INK_GRID_BITS 46
#define INK_GRID_ONE ((int64_t)1 << INK_GRID_BITS) /* the same of INK_ROW and INK_COL */
#define INK_GRID_POINTS (1 << 16)                  /* a row or column has no more vertices */

enum ink_family {
    INK_ROW,     /* y = y_j: line is j, the parameter counts columns */
    INK_COL,     /* x = x_i: line is i, the parameter counts rows */
    INK_PROFILE, /* profile `line` of a horizon scene, the parameter counts its vertices */
    INK_CURVE,   /* a flat polyline: curves of `plot`, axes, annotations */
    INK_SEGMENT, /* a straight line in space: edge `line` of a scene of solids, the parameter ends at INK_ONE */
};

static inline int ink_bits(uint8_t family) {
    return family <= INK_COL ? INK_GRID_BITS : INK_ONE_BITS;
}
static inline int64_t ink_one(uint8_t family) {
    return (int64_t)1 << ink_bits(family);
}

/* The vertex after t on the way to `to`, forward or back; `to` itself if there is none before it. */
int64_t ink_next(uint8_t family, int64_t t, int64_t to);

typedef struct ink_piece {
    uint8_t family;  /* enum ink_family */
    uint8_t surface; /* which of several surfaces, 0 first */
    int32_t line;
    int64_t from, to;
} ink_piece_t;

/* Takes one piece. Returns 0 or a negative error, which ends the kernel and is returned by it. */
typedef struct ink_sink {
    void *ctx;
    int (*piece)(void *ctx, const ink_piece_t *p);
} ink_sink_t;

#endif
