/* flat_map.h - flat drawings: curves of `plot` and the frame with tics around them.
 *
 * The axes' ranges fill the printable window. A curve is INK_CURVE line 0 of its line space, the parameter counts its
 * points. The frame is line 0 of its own, lines 1... are tics, one after the other along x below and above, then along
 * y left and right. */
#ifndef FLAT_MAP_H
#define FLAT_MAP_H

#include "scene/curve.h"
#include "view/camera.h"

#define FLAT_TIC_UM 2000

typedef struct flat_axes {
    page_window_t window;
    num_t lo[2], hi[2];
    num_t scale[2];  /* lat per unit */
    num_t step[2];   /* from tic to tic */
    num_t first[2];  /* the first tic */
    int32_t tics[2]; /* how many */
    line_space_t frame;
} flat_axes_t;

typedef struct flat_curve {
    const flat_axes_t *axes;
    const curve_t *curve;
    line_space_t lines;
} flat_curve_t;

/* lo < hi on both axes. window: the paper's printable part. */
void flat_axes_setup(flat_axes_t *a, const settings_t *s, const page_window_t *window, const num_t lo[2],
                     const num_t hi[2]);
/* Emits the frame and its tics as pieces of surface number `surface`. */
int flat_axes_draw(const flat_axes_t *a, uint8_t surface, const ink_sink_t *sink);
/* curve and axes outlive c. */
void flat_curve_setup(flat_curve_t *c, const flat_axes_t *axes, const curve_t *curve);
int flat_curve_draw(const flat_curve_t *c, uint8_t surface, const ink_sink_t *sink);

#endif
