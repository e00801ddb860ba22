/* settings.h - everything `set`, `unset` and `reset` change, as plain data for the stages after the language. */
#ifndef SETTINGS_H
#define SETTINGS_H

#include "config.h"
#include "hidden/line_class.h"
#include "motion/machine.h"
#include "num/num.h"

#define SETTINGS_TITLE_MAX 80
#define LIGHTS_MAX 4

typedef struct range {
    bool auto_lo, auto_hi; /* this end is autoscaled; the value is then not used */
    bool reverse;          /* [hi:lo] was typed: the axis runs backwards; lo < hi all the same */
    num_t lo, hi;
#if CONFIG_BOUNDED
    uint8_t bounded; /* bit k: bound[k] holds for where an autoscaled end may be */
    num_t bound[4];  /* of lo: least, greatest; of hi */
#endif
} range_t;

enum hidden_mode {
    HIDDEN_PERIMETER, /* default: perimeter for surfaces, convex for solids */
    HIDDEN_HORIZON,
    HIDDEN_NONE,
    HIDDEN_CONVEX, /* this and area are for solids; surfaces take the perimeter */
    HIDDEN_HALO,
    HIDDEN_AREA,
};

enum settings_tics { SETTINGS_TICS_X = 1, SETTINGS_TICS_Y = 2, SETTINGS_TICS_Z = 4, SETTINGS_TICS_ALL = 7 };

typedef struct settings {
    range_t x, y, z;       /* autoscaled x, y of a function plot are [-10:10] */
    int32_t samples[2];    /* set samples a,b; 100,100 */
    int32_t isosamples[2]; /* set isosamples a,b; 10,10 */
    enum hidden_mode hidden;
    bool dashed;           /* set hidden3d dashed: hidden parts of solids are drawn with dashes */
    bool horizon_infinite; /* set hidden3d horizon infinite: upper side only */
    int32_t halo_um;       /* set halo W: to each side of a nearer line; 500 */
#if CONFIG_AREA
    int32_t hatch_um;   /* set hatch A,P: pitch; 0: no hatching. For set hidden3d area, as the next three */
    int32_t hatch_mdeg; /* its angle */
    struct {
        int32_t milli[3]; /* direction to the light, thousandths; for `point` its place */
        bool on, point;
    } light[LIGHTS_MAX]; /* set light N ...; the first alone, from -1,-2,3 */
    bool shadow;         /* set shadow on */
    bool shadow_outline; /* set shadow outline: their borders are lines */
    bool outline;        /* set hidden3d ... outline: of solids only silhouettes, and creases that `crease` asks for */
    bool seams;          /* set hidden3d ... seams: where solids cut through each other there is a line */
    int32_t crease_mdeg; /* set crease A: for solids that say nothing else (mesh.h); 0: all edges */
    uint8_t pen[LINE_CLASSES]; /* set pen ...: 1 .. PENS_MAX */
#endif
    bool halo_ends; /* set halo W ends: also beyond its ends and beside it */
    struct {
        bool from;           /* set view from ...: perspective; otherwise gnuplot's rotation */
        num_t rot_x, rot_z;  /* degrees; 60, 30 */
        num_t scale, zscale; /* 1, 1 */
        uint8_t equal;       /* set view equal: 2: x and y have the same units; 3: z too; 0 */
        num_t eye[3];
        bool has_to; /* otherwise: the middle of the scene's box */
        num_t to[3];
    } view;
    bool xyplane_at; /* set xyplane at Z; otherwise relative: */
    num_t xyplane;   /* Z, or the fraction of the z range below it: 0.5 (set ticslevel is the same) */
    /* What gnuplot would draw on the base plane and along the axes. Nothing of it is drawn here, but an axis with tics
     * is autoscaled to whole ones, and a base plane with nothing on it does not count for the box. */
    bool border_base; /* any of the border's four lower edges */
    uint8_t tics;     /* enum settings_tics */
#if CONFIG_LOGSCALE
    uint8_t log_axes; /* of what is being plotted: bits 0 to 2: x, y, z are logarithms */
#endif
    struct {
        int32_t width_um, height_um, margin_um; /* A4 landscape, margin 10 mm */
    } paper;
    machine_t machine;
    char title[SETTINGS_TITLE_MAX];
} settings_t;

void settings_default(settings_t *s);

#endif
