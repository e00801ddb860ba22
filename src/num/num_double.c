/* num_double.c - quotients and roots that round once.
 *
 * num.h gives 63 bits with an error below one unit. Rounding those to 53 is right unless they stand next to the middle
 * between two doubles; then the exact product of the middle with the divisor (or itself) decides. */
#include "num/num_double.h"
#include "num/double_words.h"

num_t double_words_decide(num_t r, int64_t am, int shift, uint64_t with) {
    uint64_t middle = (ints_abs64(r.m) & ~(uint64_t)0x3FF) | 0x200;
    wide_u_t p = wide_mul_u64(middle, with ? with : middle); /* below 2^126 */
    uint64_t ua = ints_abs64(am), hi = ua >> (64 - shift), lo = ua << shift;
    uint64_t u = middle << 1;
    if (hi != p.hi || lo != p.lo) u += hi > p.hi || (hi == p.hi && lo > p.lo) ? 1 : -(uint64_t)1;
    return num_double_round(u, r.e - 1, r.m);
}

#if CONFIG_DOUBLE_WORDS

num_t num_double_div(num_t a, num_t b) {
    return double_words_div(a, b);
}

num_t num_double_sqrt(num_t a) {
    return double_words_sqrt(a);
}

#else

/* Bits 9 .. 0 within 2 of the middle. */
static bool is_close(num_t r) {
    return ((ints_abs64(r.m) - 0x1FE) & 0x3FF) <= 4;
}

num_t num_double_div(num_t a, num_t b) {
    num_t q = num_div(a, b);
    if (q.m == 0 || !is_close(q)) return num_double(q);
    return double_words_decide(q, a.m, a.e - b.e - q.e, ints_abs64(b.m));
}

num_t num_double_sqrt(num_t a) {
    num_t r = num_sqrt(a);
    if (r.m == 0 || !is_close(r)) return num_double(r);
    return double_words_decide(r, a.m, a.e - 2 * r.e, 0);
}

#endif
