/* facet_range.h - how many horizon vertices are there in a facet's range? Anderson's open question, measured. */
#ifndef FACET_RANGE_H
#define FACET_RANGE_H

enum facet_range_shape { RANGE_SMOOTH, RANGE_RANDOM, RANGE_FRACTAL };

typedef struct facet_range {
    double mean; /* vertices of both horizons strictly within the range of a facet */
    int most;    /* of one facet */
    int peak;    /* vertices of both horizons at most */
} facet_range_t;

/* n x n points on [-2,2]^2, from (6,8,3). */
facet_range_t facet_range_measure(enum facet_range_shape shape, int n);

#endif
