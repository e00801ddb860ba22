/* Clenshaw's recurrence (Mathematics of Computation 9, 1955): b_k = c_k + 2 t b_(k+1) - b_(k+2). */
#include "num/func_inner.h"

int64_t func_chebyshev(const int64_t *c, int n, int64_t t) {
    int64_t b1 = 0, b2 = 0;
    while (--n > 0) {
        int64_t b = c[n] + (int64_t)wide_sar(wide_mul_s64(t, b1), 61).lo - b2;
        b2 = b1;
        b1 = b;
    }
    return c[0] + (int64_t)wide_sar(wide_mul_s64(t, b1), 62).lo - b2;
}
