/* The same tests for the branches of wide.h that machines without a 128-bit integer take: products and division must be
 * the same bits. (The Cortex-M0's own products are compared in tests/emu/bare/same_numbers.c.) */
#undef __SIZEOF_INT128__
#include "src/num/wide.c"
#include "tests/unit/test_wide.c"
