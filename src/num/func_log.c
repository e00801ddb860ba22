/* log, log10.
 *
 * a = 2^k * f; with c_j an 11-bit approximation of 1/f for the j-th of 64 intervals, r = c_j f - 1 is exact in
 * 75 bits and |r| <= 2^-6.97, and log a = k log 2 - log c_j + log(1 + r). At both ends of the octave c_j is a
 * power of two, so that near a = 1 nothing cancels: r is a - 1 itself. (P. T. P. Tang, "Table-driven
 * implementation of the logarithm function in IEEE floating-point arithmetic", ACM TOMS 16, 1990.) */
#include "num/func.h"
#include "num/func_inner.h"
#include "num/func_tables.h"
#include "num/num_fast.h"

typedef struct parts {
    int32_t k, j;
    wide_t r;  /* Q73 */
    int64_t v; /* Q67: log(1 + r) = r - r v, 0.5 |r| roughly */
} parts_t;

/* Worst error of v: 2^-61.5, at the largest |r|. */
static parts_t split(num_t a) {
    parts_t p;
    uint64_t m = (uint64_t)a.m;
    p.j = (int32_t)((m + ((uint64_t)1 << 55)) >> 56) - 64;
    p.k = a.e + 62 + (p.j >= FUNC_TABLES_LOG_HALF);
    wide_u_t f = wide_mul_u64_u32(m, func_tables_log_factor[p.j]);
    p.r = (wide_t){(int64_t)f.hi - ((int64_t)1 << 9), f.lo};
    int64_t r = (int64_t)wide_sar(p.r, 4).lo; /* Q69, below 2^62.1 */
    int32_t rh = (int32_t)(r >> 32);          /* Q37 */
    /* g = 1/2 - r/3 + r^2/4 - ... ; from 1/5 to 1/10 in Q33, then Q62 */
    int32_t h = 954437177 - (int32_t)(wide_mul_s32(rh, 858993459) >> 37);
    h = 1073741824 - (int32_t)(wide_mul_s32(rh, h) >> 37);
    h = 1227133513 - (int32_t)(wide_mul_s32(rh, h) >> 37);
    h = 1431655765 - (int32_t)(wide_mul_s32(rh, h) >> 37);
    h = 1717986918 - (int32_t)(wide_mul_s32(rh, h) >> 37);
    int64_t g = ((int64_t)1 << 60) - (wide_scale(r, h) >> 8);
    g = 0x1555555555555555 - (wide_mulhi_s64(r, g) >> 5);
    g = ((int64_t)1 << 61) - (wide_mulhi_s64(r, g) >> 5);
    p.v = wide_mulhi_s64(r, g);
    return p;
}

static wide_t sum(const parts_t *p) {
    wide_t l = wide_sub(wide_shl(p->r, 43), wide_sar(wide_mul_s64((int64_t)wide_sar(p->r, 4).lo, p->v), 20));
    l = wide_add(l, func_tables_log[p->j]);
    /* k log 2: log 2 in Q116 is 0x000b17217f7d1cf7'9abc9e3b39803f2f */
    uint32_t n = (uint32_t)(p->k < 0 ? -p->k : p->k);
    wide_u_t low = wide_mul_u64_u32(0x9abc9e3b39803f2fu, n);
    wide_t step = {(int64_t)(low.hi + n * 0x000b17217f7d1cf7u), low.lo};
    return p->k < 0 ? wide_sub(l, step) : wide_add(l, step);
}

wide_t func_log_wide(num_t a) {
    parts_t p = split(a);
    return sum(&p);
}

num_t func_log(num_t a) {
    if (a.m <= 0) return num_undef();
    parts_t p = split(a);
    if (p.k != 0 || (p.j != 0 && p.j != 64)) return num_from_wide(sum(&p), 116);
    /* |a - 1| < 2^-7: relative to r */
    num_t r = num_from_wide(p.r, 73);
    return num_sub(r, num_mul(r, num_from_fixed(p.v, 67)));
}

num_t func_log10(num_t a) {
    if (a.m <= 0) return num_undef();
    parts_t p = split(a);
    if (p.k == 0 && (p.j == 0 || p.j == 64)) {
        /* log10(e) */
        return num_mul(func_log(a), (num_t){0x6f2dec549b9438cb, -64, false});
    }
    /* In more than 63 bits, so that log10(1000) is 3. */
    wide_t l = sum(&p);
    bool negative = l.hi < 0;
    if (negative) l = wide_neg(l);
    wide_u_t q = wide_mul_u64((uint64_t)l.hi, 0x6f2dec549b9438cau);
    uint64_t b = wide_mulhi_u64((uint64_t)l.hi, 0x9aadd557d699ee19u), c = wide_mulhi_u64(l.lo, 0x6f2dec549b9438cau);
    wide_t product = wide_add((wide_t){(int64_t)q.hi, q.lo}, wide_add((wide_t){0, b}, (wide_t){0, c}));
    return num_from_wide(negative ? wide_neg(product) : product, 116);
}
