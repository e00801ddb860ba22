/* plot.h - what one plot command asks to be drawn: the boundary between the language and the drawing.
 *
 * The session builds a plot_t once the whole command is known to be right, and hands it to the port's plot().
 * Everything in it lives until plot() returns. */
#ifndef PLOT_H
#define PLOT_H

#include "config.h"
#include "lang/settings.h"
#include "scene/curve.h"
#include "scene/mesh.h"
#include "scene/surface.h"

enum plot_kind {
    PLOT_SURFACES, /* splot of expressions and data grids */
    PLOT_CURVES,   /* plot */
    PLOT_SOLIDS,   /* splot with OBJ files: solids, maybe among surfaces; or with HIDDEN_HORIZON a terrain */
};

typedef struct plot_item {
    /* What `title` says, else the expression or file name, as it was typed; nothing for notitle. Not ended by a zero.
     */
    const char *title;
    int16_t title_len;
    bool solid; /* of PLOT_SOLIDS: mesh, otherwise surface */
#if CONFIG_CROP
    bool cropped; /* rows and cols end at the ranges of x and y, between two points of surface */
#endif
    bool parametric; /* this mesh is a surface: its axes are scaled as theirs */
#if CONFIG_PARAMETRIC
    num_t extent[2][2]; /* of it along x and y, what is left out too: lo, hi */
#endif
    union {
        struct {
            surface_t surface; /* the grid that hidden lines are removed from: isosamples x isosamples, or the data */
            /* With HIDDEN_NONE gnuplot draws isolines more finely than they lie apart: the lines of constant y are the
             * rows of `rows`, with samples[0] points each, the lines of constant x the columns of `cols`, with
             * samples[1] points each. For data both equal `surface`, but for a point more where they are cropped. */
            surface_t rows, cols;
            const surface_anywhere_t *anywhere; /* for profiles that leave the grid; NULL for data */
        };
        curve_t curve;
        mesh_t mesh;
    };
} plot_item_t;

typedef struct plot {
    enum plot_kind kind;
    int32_t n; /* items, 1 or more */
    const plot_item_t *item;
    /* As `set`, with the ranges given in this command in place of x, y, z. Points of data outside of the x and y
     * ranges have already been left out; z limits are left to grid_measure(). */
    const settings_t *settings;
} plot_t;

#endif
