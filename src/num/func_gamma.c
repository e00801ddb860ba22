/* gamma.
 *
 * gamma(x) = gamma(1 + f) times or divided by the integers' distance between: 1/gamma is entire, so 16
 * Chebyshev terms are enough for one interval, and the product costs less than Stirling's series with
 * its logarithm would, is exact for factorials, and needs no reflection formula. At most 200 factors of 3/4
 * ulp each: 2^-55. */
#include <stddef.h>

#include "num/func.h"
#include "num/func_inner.h"
#include "num/func_tables.h"
#include "num/num_fast.h"

#define GAMMA_LIMIT 200 /* gamma(200) is above the largest number, 1/gamma(200) below the least */

/* 1/gamma(1 + f), 0 <= f <= 1. */
static num_t reciprocal(num_t f) {
    if (f.m == 0) return num_from_i64(1);
    return FUNC_CHEBYSHEV(func_tables_rgamma, num_to_fixed(f, 63, NULL) - ((int64_t)1 << 62));
}

num_t func_gamma(num_t a) {
    num_t one = num_from_i64(1), product = one, limit = num_from_i64(GAMMA_LIMIT);
    if (a.m <= 0 && num_is_integer(a)) return num_undef();
    if (a.undef || num_cmp(a, limit) > 0) return num_undef();
    if (num_cmp(a, num_neg(limit)) < 0) return num_from_i64(0);
    if (a.m > 0 && num_cmp(a, one) >= 0) {
        /* (a - 1) (a - 2) ... down to 1 + f */
        num_t x = num_sub(a, one);
        for (; num_cmp(x, one) >= 0; x = num_sub(x, one)) product = num_mul(product, x);
        return num_div(product, reciprocal(x));
    }
    /* a (a + 1) ... up to f: every sum is exact, because it has no more digits than its operands */
    num_t x = a;
    for (; x.m < 0; x = num_add(x, one)) product = num_mul(product, x);
    product = num_mul(num_mul(product, x), reciprocal(x));
    return product.undef ? num_from_i64(0) : num_div(one, product);
}
