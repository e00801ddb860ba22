/* horizon.h - profiles without their hidden parts (P. Greenspun and J. J. Little 1988).
 *
 * Profiles come front to back; each is clipped against the horizons that the nearer ones left, and raises them. The
 * paper recurses over lists; this is the same clip as an iteration over the envelope of hidden/surface/envelope.h. An
 * infinite surface (the paper's) shows its upper side only; a finite one has a lower horizon as well. */
#ifndef HORIZON_H
#define HORIZON_H

#include "hidden/hidden.h"
#include "scene/profiles.h"
#include "view/camera.h"

/* Draws the visible pieces of the profiles into job->sink, family INK_PROFILE, `line` the profile, the parameter
 * counts its vertices. Each point is evaluated twice: once to find the scale, once to draw.
 * Profiles behind the eye, or nearer to it than a 64th of the farthest one, are left out. Returns 0, ERR_EMPTY when no
 * point in front of the eye is defined, ERR_FULL when the horizons do not fit, or the sink's error. */
int horizon_draw(const profiles_t *src, const camera_t *cam, bool infinite, const hidden_job_t *job,
                 hidden_stats_t *stats);

/* Memory for `vertices` horizon vertices (both horizons together). */
size_t horizon_bytes(int32_t vertices);

#endif
