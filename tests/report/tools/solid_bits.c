/* solid_bits - convex kernel and area sort on a lattice of SOLID_BITS bits (scene/solid.h), compiled once for each;
 * with as many as are shipped also haloes and the clipper on coarser pages.
 *
 *     solid_bits_N      one line for each kernel, family and lattice: kernel, family, bits below a step (an "s" after
 *                       those shipped), scenes, wrong, missing, false, end (steps), bytes, ns per element
 *
 * The reference gets the bodies as their files have them. An A4 page is 2^14 steps wide, so that many bits of the
 * scene's are above a step. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "scene/solid.h"
#include "tests/report/solid_rows.h"

#define SHIPPED 28

int main(void) {
    solid_rows_bits();
    if (SOLID_BITS == SHIPPED) solid_rows_page_bits();
    for (const row_t *w = row; w < row + rows; w++) {
        const bool page = !isnan(w->per_step), shipped = page ? w->per_step > LAT_PER_STEP - 1 : SOLID_BITS == SHIPPED;
        printf("%s\t%s\t%.3g%s\t%" PRId64 "\t%" PRId64 "\t%.3f\t%.3f\t", w->kernel, w->family,
               page ? log2(w->per_step) : SOLID_BITS - 14, shipped ? "s" : "", w->scenes, w->wrong, w->missing,
               w->falsely);
        printf(isnan(w->end) ? "-" : "%.3f", w->end);
        printf("\t%zu\t%.0f\n", w->bytes, 1e9 * w->seconds / (double)w->elements);
    }
    return 0;
}
