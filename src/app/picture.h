/* picture.h - one picture: from a plot command to strokes of the pen.
 *
 *     measure (ranges of heights) -> view (camera, maps) -> hide (the scene's kernel) -> cut -> join, order -> pen
 *
 * The kernel is the cheapest that is right for the scene: perimeter for grids, horizon for profiles, plain lines where
 * nothing can hide anything (`unset hidden3d`; a graph of a function from straight above or below).
 *
 * Memory: one lent block. In it, in this order of urgency: the kernel's rows and horizons, the pool that orders the
 * ink, tables of the page map, and a cache of heights. The last two only save time and are left out when they do not
 * fit. */
#ifndef PICTURE_H
#define PICTURE_H

#include "app/arena.h"
#include "app/picture_pens.h"
#include "hidden/area/area.h"
#include "hidden/area/area_border.h"
#include "hidden/hatch.h"
#include "hidden/hidden.h"
#include "hidden/surface/shaded.h"
#include "lang/plot.h"
#include "path/path.h"
#include "path/waiting.h"
#include "scene/profiles_cache.h"
#include "scene/profiles_mesh.h"
#include "view/cut.h"
#include "view/flat_map.h"
#include "view/page_map.h"
#include "view/profile_map.h"
#include "view/solid_map.h"

#define PICTURE_GRIDS_MAX (2 * CONFIG_PLOT_ITEMS) /* rows and columns of each item */
#define PICTURE_LINES_MAX (PICTURE_GRIDS_MAX + 1) /* or a frame */

enum picture_stage {
    PICTURE_MEASURE, /* evaluating all points for their range */
    PICTURE_HIDE,    /* evaluating again if need be, hiding, joining */
    PICTURE_DRAW,    /* ordering and drawing what is left in the pool */
    PICTURE_DONE,
};

/* How the memory is divided between hiding and ordering. Hiding needs what the scene asks for; ordering draws
 * everything with any amount, but with more lifts and ways the less it has. */
enum picture_share {
    PICTURE_SHARE_USUAL,  /* half, or a quarter of a large block, to hiding */
    PICTURE_SHARE_SMOOTH, /* hiding gets as much as most smooth surfaces need, if that is more */
    PICTURE_SHARE_HIDING, /* ordering gets the least */
    PICTURE_SHARE_STRIPS, /* and a surface is hidden in strips one after the other (hidden_strips_t) */
    PICTURE_SHARES
};

typedef struct picture_hooks {
    void *ctx;
    enum picture_share share;
    uint16_t strips; /* PICTURE_SHARE_STRIPS: hidden_strips_t.ends; 0: two, as a start for picture_try */
    /* Called at the start of each stage with done == 0, and now and then with how much of it is done; may be NULL. */
    void (*progress)(void *ctx, enum picture_stage stage, int32_t done, int32_t of);
    /* Called before the first stroke of each pen, which has a number from 1 on; may be NULL. An error ends the drawing.
     */
    int (*pen)(void *ctx, int number);
    /* Called when the view is known, before the first stroke; may be NULL. */
    void (*begin)(void *ctx, const camera_t *cam);
    bool measured; /* p is as picture_measure or picture_try left it with this plot, and nobody used the memory since:
                    * one surface is not measured again, unless its cache would lie elsewhere */
    bool only_measure; /* picture_measure's */
    bool generous;     /* the memory was too little before: what had a small part of it gets more */
    int32_t waiting;   /* pieces of ink that may wait for a kernel's pause (path/waiting.h); 0: it need not pause */
    const path_feed_t *feed; /* draw while the picture is still being computed; or NULL */
} picture_hooks_t;

typedef struct picture_stats {
    int64_t facets;    /* cells of the grids whose four corners are defined; segments of profiles or curves */
    int64_t evaluated; /* points evaluated, in all stages */
    hidden_stats_t hidden;
    path_stats_t path;
    size_t cache_bytes, map_bytes, kernel_bytes, path_bytes; /* of the lent block; kernel and path: what they used */
} picture_stats_t;

typedef struct picture {
    const plot_t *plot;
    const picture_hooks_t *hooks;
    bool trial;                  /* only to see whether it fits */
    bool pauses;                 /* the kernel does */
    bool gave_all;               /* to hiding: ordering has the least */
    hidden_strips_t strips;      /* as picture_try found them */
    int32_t pieces, pieces_most; /* of ink in a trial: since the last pause, and the most between two */
    hidden_pause_t pause;
    waiting_t waiting;
    enum picture_stage stage;     /* as last told to the hooks */
    int32_t stage_done, stage_of; /* and how far it is */
    arena_t arena;
    camera_t camera;
    path_t path;
    ink_map_t map_ink; /* for path: lines[] by number */
#if CONFIG_FETCH
    ink_fetch_t fetch; /* of what it reads, or NULL */
#endif
    cut_t cut;
#if CONFIG_AREA
    pens_t pens;
#endif
    ink_sink_t sink;                       /* where kernels put their ink: cut, or path directly */
    line_space_t lines[PICTURE_LINES_MAX]; /* by the number of the surface in a piece */
    int32_t spaces;                        /* of them in use */
    union {                                /* by the kind of scene */
        struct {
            grid_t grid[PICTURE_GRIDS_MAX];
            page_map_t map[PICTURE_GRIDS_MAX];
#if CONFIG_AREA
            hatch_t surface_hatch; /* lines[spaces - 1], if surfaces are hatched */
            shaded_t shaded;
            light_t lights[LIGHTS_MAX];
#endif
        };
        struct {
            profiles_t profiles;
            profiles_sampled_t sampled;
            profiles_mesh_t mesh;
            profiles_cache_t profiles_cache;
            profile_map_t profile_map;
        };
        struct {
            solid_t solid;
            solid_map_t solid_map;
            bool found_same; /* what coincides is known, and takes: */
            size_t same_bytes;
#if CONFIG_AREA
            area_stats_t area; /* of `set hidden3d area` */
            hatch_t hatch;     /* lines[LINE_HATCH] */
            borders_t borders; /* lines[LINE_SHADOW] */
#endif
        };
        struct {
            flat_axes_t axes;
            flat_curve_t curve[CONFIG_PLOT_ITEMS];
        };
    };
    picture_stats_t stats;
} picture_t;

/* Draws plot into pen, strokes in drawing order; the pen is at home before and not sent home after. p needs no
 * preparation; p->stats is filled in, as far as the work got, whatever is returned. hooks may be NULL.
 * Returns 0 or: ERR_EMPTY nothing is defined; ERR_VALUE ranges or view cannot be used; ERR_FULL mem is too small
 * (nothing or a part was drawn); ERR_UNSUPPORTED no kernel draws this scene correctly; or the pen's error. */
int picture_draw(picture_t *p, const plot_t *plot, void *mem, size_t bytes, const pen_sink_t *pen,
                 const picture_hooks_t *hooks);
/* The same work up to the ordering of ink, without drawing: whether picture_draw would get through with this memory.
 * Returns as it does. */
int picture_try(picture_t *p, const plot_t *plot, void *mem, size_t bytes, const picture_hooks_t *hooks);
/* Does its kernel pause, so that pieces may wait (picture_hooks_t)? Then picture_try tells how many have to. */
bool picture_pauses(const plot_t *plot);
/* Is this memory, in its usual division, enough for all but freakish scenes of this size? Otherwise picture_try tells.
 */
bool picture_is_safe(const plot_t *plot, size_t bytes);
/* Would it be if there were no holes, which take three times as much? Then this tells, for far less than picture_try:
 * it measures the surface and returns 0 if it has none, ERR_FULL if it has, or as picture_draw does. */
bool picture_is_safe_whole(const plot_t *plot, size_t bytes);
int picture_measure(picture_t *p, const plot_t *plot, void *mem, size_t bytes, picture_hooks_t *hooks);
/* About how large a block it would have needed, after picture_try has returned ERR_FULL. */
size_t picture_needs(const picture_t *p);
/* What ordering takes at the least, beside hiding. */
size_t picture_rest(const picture_t *p);
/* How much is drawn and how much there will be, as far as it can be told: exact once all is hidden. For picture_draw's
 * hooks and pen sink. */
typedef struct picture_progress {
    int64_t vertices_drawn, vertices, strokes_drawn, strokes;
} picture_progress_t;
picture_progress_t picture_progress(const picture_t *p);
/* A block large enough for most scenes of this size with everything cached; ERR_FULL asks for more all the same. */
size_t picture_bytes(const plot_t *plot);

#endif
