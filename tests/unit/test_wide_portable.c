/* The same tests for the branch of wide.h that machines without a 128-bit integer take: its products and its
 * division must be the same bits. */
#undef __SIZEOF_INT128__
#include "src/num/wide.c"
#include "tests/unit/test_wide.c"
