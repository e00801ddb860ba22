/* eval_row_wide.c - see eval_row_arith.h.
 *
 * Mostly one of the operands is the same for all points, a constant or what depends on the row alone: what has to do
 * with it is done once. Whatever is not a real number of 53 bits, zeros included, is left to arith_binary. */
#include "lang/eval_row_arith.h"
#include "num/num_double.h"

#if EVAL_ROW_MAX > 1 && CONFIG_64BIT

#define SPARE 0x3FF /* the bits of a significand that a double has not */
#define ONE ((uint64_t)1 << 62)

/* What is the same for all points: an integer is the real number that it becomes beside one. */
static num_t the_same(const value_t *v) {
    return value_num(*v);
}
static bool is_usual(int64_t m) {
    return m != 0 && (m & SPARE) == 0;
}
static inline bool is_rare(const value_t *v) {
    return NUM_FAST_RARE((v->kind | (v->m & SPARE)) != 0 || v->m == 0);
}

static void slow(eval_row_work_t *w, int k, uint8_t op, const eval_row_operand_t of[2], value_t *to) {
    eval_row_slow(w, k, op, of[0].at + k * of[0].step, of[1].at + k * of[1].step, to);
}

static inline void put(eval_row_work_t *w, int k, value_t *to, num_t r) {
    if (NUM_FAST_RARE(eval_row_put(to, r))) w->dead |= (eval_row_points_t)1 << k;
}

/* am 2^ae + bm 2^be of usual ones, rounded. As num_double_add, which has the reasons; but with ten bits to spare what
 * is below the lowest one of the larger is either nothing, or the tops are not next to one another and it is enough to
 * know that there is something. */
static inline __attribute__((always_inline)) num_t sum(int64_t am, int32_t ae, int64_t bm, int32_t be) {
    int32_t d = ae - be;
    const int64_t other = (am ^ bm) & (d >> 31), big = am ^ other, small = bm ^ other;
    const int32_t e = ae - (d & d >> 31);
    d = d < 0 ? -d : d;
    if (NUM_FAST_RARE(d > 63)) return (num_t){big, e, false};
    int64_t sign = big >> 63;
    const int64_t S = (small ^ sign) - sign, s = S >> d;
    uint64_t u = ints_abs64(big) + (uint64_t)s;
    const int64_t flip = (S & (int64_t)u) >> 63;
    u = (u ^ (uint64_t)flip) - (uint64_t)flip;
    sign ^= flip;
    if (NUM_FAST_RARE(u == 0)) return (num_t){0, 0, false};
    u |= (uint64_t)s << d != (uint64_t)S;
    const int n = ints_clz64(u);
    return num_double_round(u << n, e - n, sign);
}

/* The sum of x, or -x where minus is ~0, and c. */
static void sums_with(eval_row_work_t *w, eval_row_operand_t x, int64_t minus, num_t c, uint8_t op,
                      const eval_row_operand_t of[2], value_t *to) {
    const int n = w->n;
    for (int k = 0; k < n; k++, x.at += x.step, to++) {
        if (is_rare(x.at))
            slow(w, k, op, of, to);
        else
            put(w, k, to, sum((x.at->m ^ minus) - minus, x.at->e, c.m, c.e));
    }
}

void eval_row_sum(eval_row_work_t *w, uint8_t op, eval_row_operand_t a, eval_row_operand_t b, value_t *to) {
    const eval_row_operand_t of[2] = {a, b};
    const int64_t minus = op == OP_SUB ? -1 : 0;
    const int n = w->n, same = b.step == 0 ? 1 : 0;
    num_t c = the_same(of[same].at);
    if (of[same].step == 0 && is_usual(c.m)) {
        if (same == 1) c.m = (c.m ^ minus) - minus;
        sums_with(w, of[1 - same], same == 1 ? 0 : minus, c, op, of, to);
        return;
    }
    for (int k = 0; k < n; k++, a.at += a.step, b.at += b.step, to++) {
        if (is_rare(a.at) || is_rare(b.at))
            slow(w, k, op, of, to);
        else
            put(w, k, to, sum(a.at->m, a.at->e, (b.at->m ^ minus) - minus, b.at->e));
    }
}

/* The product of x and a power of two, or its negative where minus is ~0. */
static void powers(eval_row_work_t *w, eval_row_operand_t x, int64_t minus, int32_t by, uint8_t op,
                   const eval_row_operand_t of[2], value_t *to) {
    const int n = w->n;
    for (int k = 0; k < n; k++, x.at += x.step, to++) {
        if (is_rare(x.at))
            slow(w, k, op, of, to);
        else
            put(w, k, to, num_double_make((x.at->m ^ minus) - minus, x.at->e + by));
    }
}

/* The product of m 2^e, |m| = u / 2, and x. */
static inline num_t product(uint64_t u, int64_t m, int32_t e, const value_t *x) {
    const wide_u_t p = wide_mul_u64(u, ints_abs64(x->m) << 1); /* its top is at bit 126 or 127 */
    const int t = (int)(p.hi >> 63) ^ 1;
    return num_double_round(p.hi << t | (p.lo != 0), e + x->e + 62 - t, m ^ x->m);
}

static void products_of(eval_row_work_t *w, eval_row_operand_t x, num_t c, const eval_row_operand_t of[2],
                        value_t *to) {
    const int n = w->n;
    const uint64_t u = ints_abs64(c.m) << 1;
    for (int k = 0; k < n; k++, x.at += x.step, to++) {
        if (is_rare(x.at))
            slow(w, k, OP_MUL, of, to);
        else
            put(w, k, to, product(u, c.m, c.e, x.at));
    }
}

void eval_row_product(eval_row_work_t *w, eval_row_operand_t a, eval_row_operand_t b, value_t *to) {
    const eval_row_operand_t of[2] = {a, b};
    const int n = w->n, same = b.step == 0 ? 1 : 0;
    const num_t c = the_same(of[same].at);
    if (of[same].step == 0 && is_usual(c.m)) {
        if (ints_abs64(c.m) == ONE)
            powers(w, of[1 - same], c.m >> 63, c.e + 62, OP_MUL, of, to);
        else
            products_of(w, of[1 - same], c, of, to);
        return;
    }
    for (int k = 0; k < n; k++, a.at += a.step, b.at += b.step, to++) {
        if (is_rare(a.at) || is_rare(b.at))
            slow(w, k, OP_MUL, of, to);
        else
            put(w, k, to, product(ints_abs64(a.at->m) << 1, a.at->m, a.at->e, b.at));
    }
}

void eval_row_quotient(eval_row_work_t *w, eval_row_operand_t a, eval_row_operand_t b, value_t *to) {
    const eval_row_operand_t of[2] = {a, b};
    const num_t c = the_same(b.at);
    if (b.step == 0 && ints_abs64(c.m) == ONE) {
        powers(w, a, c.m >> 63, -62 - c.e, OP_DIV, of, to);
        return;
    }
    const int n = w->n;
    for (int k = 0; k < n; k++, a.at += a.step, b.at += b.step, to++) {
        if (is_rare(a.at) || is_rare(b.at))
            eval_row_slow(w, k, OP_DIV, a.at, b.at, to);
        else
            put(w, k, to, num_double_div(eval_row_num(a.at), eval_row_num(b.at)));
    }
}

#endif
