/* digits.c - made by the compiler: to make it at the start would take a plot of a hundred facets a hundredth longer. */
#include "host/digits.h"

/* The first of three digits that is not a leading zero, the one after it, and what they leave. */
#define FIRST(a, b, c) ((a) ? '0' + (a) : (b) ? '0' + (b) : '0' + (c))
#define SECOND(a, b, c) ((a) ? '0' + (b) : (b) ? '0' + (c) : 0)
#define THIRD(a, c) ((a) ? '0' + (c) : 0)
#define COUNT(a, b) ((a) ? 3 : (b) ? 2 : 1)
#define KEPT(a, b, c) ((c) ? 4 : (b) ? 3 : (a) ? 2 : 0)

/* clang-format off */
#define ONE(a, b, c) {{'.', '0' + (a), '0' + (b), '0' + (c)}, {'0' + (a), '0' + (b), '0' + (c), 0}, \
                      {FIRST(a, b, c), SECOND(a, b, c), THIRD(a, c), COUNT(a, b)}, {KEPT(a, b, c)}},
#define TEN(a, b) ONE(a, b, 0) ONE(a, b, 1) ONE(a, b, 2) ONE(a, b, 3) ONE(a, b, 4) \
                  ONE(a, b, 5) ONE(a, b, 6) ONE(a, b, 7) ONE(a, b, 8) ONE(a, b, 9)
#define HUNDRED(a) TEN(a, 0) TEN(a, 1) TEN(a, 2) TEN(a, 3) TEN(a, 4) TEN(a, 5) TEN(a, 6) TEN(a, 7) TEN(a, 8) TEN(a, 9)
const digits_t DIGITS[1000] = {HUNDRED(0) HUNDRED(1) HUNDRED(2) HUNDRED(3) HUNDRED(4)
                               HUNDRED(5) HUNDRED(6) HUNDRED(7) HUNDRED(8) HUNDRED(9)};
/* clang-format on */
