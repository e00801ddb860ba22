/* page.h - page coordinates and the way from a line of the scene to them.
 *
 * Page lattice: 1 lat = 2^-15 mm (an 80 steps/mm machine has 409.6 lat to the step), x to the right, y up, origin at
 * the lower left corner of the paper. int32_t holds 65 m, so any paper fits; everything that leaves the view
 * stage has been cut to the paper. */
#ifndef PAGE_H
#define PAGE_H

#include <stdbool.h>
#include <stdint.h>

#define LAT_PER_MM_BITS 15
#define LAT_PER_MM (1 << LAT_PER_MM_BITS)

typedef struct page_point {
    int32_t x_lat, y_lat;
} page_point_t;

/* Where a parameter of a line lies on the page. Pure: the same answer whenever asked. False if the point is not
 * on the paper (only possible when the caller made the parameter up; pieces are cut beforehand). */
typedef struct ink_map {
    void *ctx;
    bool (*point)(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t, page_point_t *out);
} ink_map_t;

/* Takes the strokes of a drawing, in drawing order: one move (pen up, to the start of a stroke), then draws (pen down)
 * up to the next move. Return 0 or a negative error, which stops the drawing. */
typedef struct pen_sink {
    void *ctx;
    int (*move)(void *ctx, page_point_t to);
    int (*draw)(void *ctx, page_point_t to);
} pen_sink_t;

#endif
