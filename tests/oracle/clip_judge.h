/* clip_judge.h - is what the clipper makes of two polygons right?
 *
 * Each pair is judged by slab areas (slab_area.h) against what was asked for, and by laws that hold exactly: no two
 * edges of a result cross or overlap, areas add up, a result clipped again stays itself, every hole lies in its outer
 * contour. A result may differ from the exact one by what rounding crossings does: where no crossing was rounded by
 * nothing, otherwise by at most half a unit in x and in y a sweep along all borders. */
#ifndef CLIP_JUDGE_H
#define CLIP_JUDGE_H

#include "poly/clip.h"

#define CLIP_SHAPE_MOST 4096

/* A polygon with room of its own; poly and out are the same one. Must not move once it is cleared. */
typedef struct clip_shape {
    poly_vertex_t v[CLIP_SHAPE_MOST];
    int32_t end[CLIP_SHAPE_MOST], outer[CLIP_SHAPE_MOST];
    clip_out_t out;
    poly_t poly;
} clip_shape_t;

void clip_shape_clear(clip_shape_t *s);
void clip_shape_add(clip_shape_t *s, int32_t x, int32_t y);
/* The vertices since the last time are a contour. */
void clip_shape_close(clip_shape_t *s);
void clip_shape_print(const char *name, const clip_shape_t *s);

typedef struct clip_account {
    int64_t pairs, rounded, contours, holes, sweeps, exact;
    int most_sweeps;
    double worst; /* symmetric difference over length of all borders: mean displacement, units */
} clip_account_t;

/* The results that are judged: all six at a time. */
extern const enum clip_result clip_judge_table[6];

/* exact: by slabs in rationals. Returns what is wrong, or NULL. */
const char *clip_judge(const clip_shape_t *subject, const clip_shape_t *clip, enum clip_fill fill, bool exact,
                       clip_account_t *account);
/* The results of the last clip_judge, as in the table. */
extern clip_shape_t clip_judge_result[6];
/* The area by which result k differs from the exact one. */
double clip_judge_off(const clip_shape_t *subject, const clip_shape_t *clip, enum clip_fill fill, int k, bool exact);

#endif
