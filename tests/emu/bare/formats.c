/* Fixed point as one would write it by hand: products in twice the width, exp by a power of two and a polynomial of
 * the format's own precision. */
#include "tests/emu/bare/formats.h"

#include <math.h>
#include <stdint.h>

#include "num/func.h"
#include "num/wide.h"

#define SIDE 16

const char *const formats_name[FORMATS] = {"Q16.16", "Q32.32", "float", "double", "num_t"};
const char *const formats_formula_name[FORMULAS] = {"x**2-y**2", "1/(x**2+y**2)", "exp(-x**2-y**2)"};

/* Results go here, so that they are worked out. */
static volatile int32_t sink_32;
static volatile int64_t sink_64;
static volatile float sink_float;
static volatile double sink_double;
static volatile int64_t sink_num;

static int32_t mul16(int32_t a, int32_t b) {
    return (int32_t)(((int64_t)a * b) >> 16);
}
static int64_t mul32(int64_t a, int64_t b) {
    wide_t p = wide_mul_s64(a, b);
    return (int64_t)((uint64_t)p.hi << 32 | (uint64_t)p.lo >> 32);
}

/* 2^f for f in [0, 1), Taylor's series of exp(f ln 2), and a shift. */
static int32_t exp16(int32_t x) {
    int32_t t = mul16(x, 94548); /* log2 e */
    int32_t whole = t >> 16, f = t & 0xffff, r = 0;
    static const int32_t term[] = {10, 87, 630, 3638, 15743, 45426, 65536};
    for (int i = 0; i < 7; i++) r = mul16(r, f) + term[i];
    return whole < -31 ? 0 : whole < 0 ? r >> -whole : r << (whole & 15);
}
static int64_t exp32(int64_t x) {
    int64_t t = mul32(x, 6196328019); /* log2 e */
    int64_t whole = t >> 32, f = t & 0xffffffff, r = 0;
    static const int64_t term[] = {30,       437,       5676,       65513,      661483,    5726623,
                                   41309552, 238388332, 1031764991, 2977044472, 4294967296};
    for (int i = 0; i < 11; i++) r = mul32(r, f) + term[i];
    return whole < -63 ? 0 : whole < 0 ? r >> -whole : r << (whole & 31);
}

static void in_q16(enum formats_formula f, int i, int j) {
    int32_t x = -131072 + i * 17476, y = -131072 + j * 17476, xx = mul16(x, x), yy = mul16(y, y);
    sink_32 = f == FORMULA_SADDLE ? xx - yy
              : f == FORMULA_POLE ? (int32_t)(((int64_t)1 << 32) / (xx + yy))
                                  : exp16(-xx - yy);
}
static void in_q32(enum formats_formula f, int i, int j) {
    int64_t x = -8589934592 + i * (int64_t)1145324612, y = -8589934592 + j * (int64_t)1145324612;
    int64_t xx = mul32(x, x), yy = mul32(y, y);
    uint64_t rest;
    sink_64 = f == FORMULA_SADDLE ? xx - yy
              : f == FORMULA_POLE ? (int64_t)wide_div_u64(1, 0, (uint64_t)(xx + yy), &rest) /* 2^64 */
                                  : exp32(-xx - yy);
}
static void in_float(enum formats_formula f, int i, int j) {
    float x = -2 + (float)i * (4.0f / 15), y = -2 + (float)j * (4.0f / 15), xx = x * x, yy = y * y;
    sink_float = f == FORMULA_SADDLE ? xx - yy : f == FORMULA_POLE ? 1 / (xx + yy) : expf(-xx - yy);
}
static void in_double(enum formats_formula f, int i, int j) {
    double x = -2 + i * (4.0 / 15), y = -2 + j * (4.0 / 15), xx = x * x, yy = y * y;
    sink_double = f == FORMULA_SADDLE ? xx - yy : f == FORMULA_POLE ? 1 / (xx + yy) : exp(-xx - yy);
}
static void in_num(enum formats_formula f, int i, int j) {
    num_t x = num_from_fixed(-131072 + i * 17476, 16), y = num_from_fixed(-131072 + j * 17476, 16);
    num_t xx = num_mul(x, x), yy = num_mul(y, y);
    num_t r = f == FORMULA_SADDLE ? num_sub(xx, yy)
              : f == FORMULA_POLE ? num_div(num_from_i64(1), num_add(xx, yy))
                                  : func_exp(num_neg(num_add(xx, yy)));
    sink_num = r.m;
}

int formats_run(enum formats_format format, enum formats_formula formula) {
    static void (*const in[FORMATS])(enum formats_formula f, int i, int j) = {in_q16, in_q32, in_float, in_double,
                                                                              in_num};
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) in[format](formula, i, j);
    return SIDE * SIDE;
}
