/* The same tests for the additions of 32-bit cores. */
#define NUM_DOUBLE_NARROW 1
#include "test_num_double.c"
