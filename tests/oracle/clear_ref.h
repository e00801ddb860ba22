/* clear_ref.h - the reference for translucent faces and for lines on faces, by rays.
 *
 * Not the kernel's method, which sorts polygons twice and takes parts of lines from each other: of each edge and each
 * line on a face rays say what all faces hide, and what those hide that are not translucent (solid_ref.h). What the
 * first leaves is to be drawn; what only the second leaves is to be drawn as hidden; of a line on a face both only
 * where the face has a picture. */
#ifndef CLEAR_REF_H
#define CLEAR_REF_H

#include "tests/oracle/solid_scenes.h"

/* solid_scene_random() with translucent faces, some or all, and with lines on faces, which may reach beyond them. */
void clear_scene_random(solid_scene_t *s, uint64_t seed, int objects);
/* The same of solid_scene_polygons(). */
void clear_scene_polygons(solid_scene_t *s, uint64_t seed, int objects);

typedef struct clear_report {
    judge_report_t edges[2], details[2]; /* [0]: as drawn; [1]: with what is drawn as hidden */
    area_stats_t area;
    int lost; /* pieces on lines that there are not */
} clear_report_t;

/* Draws it by the area sort and judges it. False if it is beyond the limits of run_cases.h. */
bool clear_scene_judge(const solid_scene_t *s, clear_report_t *out);

#endif
