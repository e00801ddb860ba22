/* The same tests for the ways of 32-bit cores. */
#define NUM_DOUBLE_NARROW 1
#define CONFIG_DOUBLE_WORDS 1
#include "src/num/num_double.c"
#include "tests/unit/test_num_double.c"
