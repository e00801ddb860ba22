/* subject.h - the scenes of the report: a kernel and a family of surfaces, drawn, judged and timed. */
#ifndef REPORT_SUBJECT_H
#define REPORT_SUBJECT_H

#include "scene/grid.h"
#include "scene/profiles.h"
#include "tests/oracle/run_horizon.h"
#include "tests/oracle/run_kernel.h"

enum subject_kernel { KERNEL_PERIMETER, KERNEL_WINDOWS, KERNEL_HORIZON, KERNELS };
enum subject_family { FAMILY_SMOOTH, FAMILY_RANDOM, FAMILY_CLIFFS, FAMILY_GRAZING, FAMILY_FAR, FAMILIES };
extern const char *const subject_kernel_name[KERNELS];
extern const char *const subject_family_name[FAMILIES];

typedef struct subject {
    enum subject_kernel kernel;
    enum subject_family family;
    int n;
    scene_t scene;
    num_t *x, *y, *z; /* the same as the kernels want them */
    int32_t *cache;
    size_t bytes;
    void *mem;
    camera_t cam;
    surface_t surface;
    grid_t grid;
    profiles_t profiles;
    /* profiles for the judge: row ny - 1, nearest, first; from right to left in x, as the viewer sees them */
    exact_point_t *point;
    int *first;
    unsigned char *gap;
    horizon_ref_t horizon;
} subject_t;

/* u must not move while it is used. n x n points on [-2,2]^2. KERNEL_WINDOWS has every twelfth point undefined,
 * KERNEL_HORIZON draws the rows as profiles. Fixed seeds: the same scene every time. */
void subject_make(subject_t *u, enum subject_kernel kernel, enum subject_family family, int n);
void subject_free(subject_t *u);
/* Draws once into sink. Returns the kernel's result. */
int subject_draw(subject_t *u, const ink_sink_t *sink, hidden_stats_t *stats);
/* Draws and judges every so-manieth line (0: all). Returns 0 unless the drawing failed. */
int subject_judge(subject_t *u, int every, judge_report_t *rep, hidden_stats_t *stats);
/* CPU time of a drawing per facet (per segment for the horizon), heights in memory, ink dropped: the least of a few. */
double subject_ns(subject_t *u);
/* CPU seconds of this process. */
double subject_clock(void);

#endif
