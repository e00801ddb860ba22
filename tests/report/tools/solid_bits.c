/* solid_bits - convex kernel and area sort on a lattice of SOLID_BITS bits (scene/solid.h), compiled once for each.
 *
 *     solid_bits_N      one line for each kernel and family: kernel, family, bits below a step, scenes, wrong, missing,
 *                       false, end (steps), ns per element
 *
 * The reference gets the bodies as their files have them. An A4 page is 2^14 steps wide, so that many bits of the
 * scene's are above a step. */
#include <inttypes.h>
#include <stdio.h>

#include "scene/solid.h"
#include "tests/report/solid_rows.h"

int main(void) {
    solid_rows_bits();
    for (const row_t *w = row; w < row + rows; w++) {
        printf("%s\t%s\t%d\t%" PRId64 "\t%" PRId64 "\t%.3f\t%.3f\t%.3f\t%.0f\n", w->kernel, w->family, SOLID_BITS - 14,
               w->scenes, w->wrong, w->missing, w->falsely, w->end, 1e9 * w->seconds / (double)w->elements);
    }
    return 0;
}
