/* picture_stages.h - what the files of src/app/picture*.c share; not for others. */
#ifndef PICTURE_STAGES_H
#define PICTURE_STAGES_H

#include "app/picture.h"

/* The kinds of scenes. Each measures, sets the camera up, opens the ink stages and runs its kernels. */
int picture_surfaces(picture_t *p, const pen_sink_t *pen); /* picture_surfaces.c */
int picture_profiles(picture_t *p, const pen_sink_t *pen); /* picture_profiles.c */
int picture_curves(picture_t *p, const pen_sink_t *pen);   /* picture_curves.c */
int picture_solids(picture_t *p, const pen_sink_t *pen);   /* picture_solids.c */
/* What set hidden3d halo does with either scene, once it is open; job's memory is the kernel's. */
int picture_halo_surfaces(picture_t *p, const hidden_job_t *job); /* picture_halo.c */
int picture_halo_solids(picture_t *p, const hidden_job_t *job);
size_t picture_halo_bytes(const plot_t *plot, int32_t crossings_each);
/* Solids and nothing else: a unit is equally long along all axes. */
bool picture_is_solid(const plot_t *plot);
/* Bytes that putting solids together and hiding their lines takes, but for freakish scenes. */
size_t picture_solids_bytes(const plot_t *plot);
/* About what it takes in fact, after a trial that did not get through. */
size_t picture_solids_needs(const picture_t *p);
#if CONFIG_AREA
/* Does `set hatch` count for it? */
bool picture_is_hatched(const plot_t *plot);
/* Its lines, on the camera's page. */
void picture_setup_hatch(const picture_t *p, hatch_t *hatch);
/* Those that are on. Returns how many. */
int32_t picture_lights(const settings_t *set, light_t light[LIGHTS_MAX]);
#endif
/* A terrain that is cut into profiles? Otherwise PLOT_SOLIDS are solids. */
static inline bool picture_is_terrain(const plot_t *plot) {
    return plot->kind == PLOT_SOLIDS && plot->settings->hidden == HIDDEN_HORIZON;
}
#if CONFIG_AREA
/* Surfaces alone that are drawn as solids: they are to cast shadows; or hide each other, and have not the same points.
 */
bool picture_surfaces_are_solids(const plot_t *plot);
#endif
/* Drawn as solids? */
static inline bool picture_wants_solids(const plot_t *plot) {
#if CONFIG_AREA
    if (plot->kind == PLOT_SURFACES) return picture_surfaces_are_solids(plot);
#endif
    return plot->kind == PLOT_SOLIDS && !picture_is_terrain(plot);
}

/* The axes' box for a scene that reaches from lo to hi (x, y, z), and from it the camera. Rotation views take gnuplot's
 * box: whole tics on autoscaled axes, and the base plane below. */
int picture_camera(picture_t *p, const num_t lo[3], const num_t hi[3]);
/* Opens cut and path on the line spaces 0 .. spaces - 1. growing: lines that grow at the same time; runs: how many
 * the pool can use at most. Takes what is left of the arena. */
int picture_open(picture_t *p, const pen_sink_t *pen, int32_t growing, int64_t runs);
/* Draws what the pool still holds. */
int picture_close(picture_t *p);
void picture_tell(picture_t *p, enum picture_stage stage, int32_t done, int32_t of);
/* So much is hidden, after so many facets more: draws what can be drawn meanwhile. */
void picture_hidden(picture_t *p, int32_t done, int32_t of, int32_t facets);
/* A sink that draws nothing. */
ink_sink_t picture_drop(picture_t *p);
/* The kernel's share of the arena: half of a small one, a quarter of a large one. */
void *picture_kernel_memory(picture_t *p, size_t *bytes);
/* A share of what is left of the arena for what only saves time, without what ordering asks for at least. */
size_t picture_spare(const picture_t *p, size_t share);
/* For the job of a kernel that pauses; to be called before picture_open. NULL if it need not. */
const hidden_pause_t *picture_pause(picture_t *p);
/* The strips of a surface, to save memory, or NULL. */
static inline hidden_strips_t *picture_strips(picture_t *p) {
    if (!p->hooks || p->hooks->share != PICTURE_SHARE_STRIPS) return NULL;
    p->strips = (hidden_strips_t){p->hooks->strips ? p->hooks->strips : HIDDEN_TWO_STRIPS, p->trial};
    return &p->strips;
}

#endif
