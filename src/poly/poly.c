/* poly.c - see poly.h. */
#include "poly/poly.h"

int64_t poly_area2(const poly_t *p) {
    /* Relative to one point the sum of the whole is at most 2 (2^31 - 2)^2 < 2^63, whatever its terms wrap to. */
    uint64_t sum = 0;
    int32_t first = 0;
    for (int32_t k = 0; k < p->contours; first = p->end[k++]) {
        poly_point_t a = p->v[p->end[k] - 1].at;
        for (int32_t i = first; i < p->end[k]; a = p->v[i++].at)
            sum += (uint64_t)poly_orient(p->v[0].at, a, p->v[i].at);
    }
    return (int64_t)sum;
}
