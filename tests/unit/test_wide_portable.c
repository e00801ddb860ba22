/* The same tests for the branches of wide.h that machines without a 128-bit integer, or without a product of more than
 * 32 bits, take: products and division must be the same bits. */
#undef __SIZEOF_INT128__
#define __ARM_ARCH_6M__ 1
#include "src/num/wide.c"
#include "tests/unit/test_wide.c"
