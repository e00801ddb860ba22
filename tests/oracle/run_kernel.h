/* run_kernel.h - a scene of doubles through the kernels under test, and what they drew as the judge's pieces. */
#ifndef RUN_KERNEL_H
#define RUN_KERNEL_H

#include "hidden/hidden.h"
#include "num/num.h"
#include "tests/oracle/scenes.h"
#include "view/camera.h"

typedef struct drawing {
    judge_piece_t *piece;
    size_t n, cap;
} run_drawing_t;

void run_drawing_free(run_drawing_t *d);
/* v exactly, as long as it is finite. */
num_t run_num(double v);
/* The eye as the kernels want it; the matrix, which they do not look at, is left zero. */
camera_t run_camera(const exact_eye_t *eye);
/* A sink that collects into d. Families other than rows and columns keep their numbers. */
ink_sink_t run_sink(run_drawing_t *d);
/* Draws s by the perimeter kernel, with plenty of memory. Returns its result. */
int run_perimeter(const scene_t *s, run_drawing_t *d, hidden_stats_t *stats);

/* In which strips run_perimeter hides; ends 0: as a whole. */
extern hidden_strips_t run_strips;
/* The same in so many bytes of memory, lent from the heap so that a sanitizer sees its ends. */
int run_perimeter_in(const scene_t *s, run_drawing_t *d, size_t bytes, hidden_stats_t *stats);

/* Draws n surfaces over the same grid together, sheet[k] by its own arrays and all with the eye of the first; d[k] gets
 * the pieces of surface k. */
int run_several(const surface_ref_t *sheet, int n, run_drawing_t *d, hidden_stats_t *stats);

#endif
