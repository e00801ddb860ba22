/* Nanoseconds per operation of src/num, beside the same operation of the C library in double precision.
 * Operands come from an array, so what is measured is throughput with unpredictable data, not a hot constant. */
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "num/func.h"
#include "num/num_fast.h"

enum { COUNT = 2048, ROUNDS = 200 };

static num_t a[COUNT], b[COUNT];
static double da[COUNT], db[COUNT];
static volatile int64_t sink;
static volatile double dsink;

static uint64_t seed = 88172645463325252u;
static double uniform(double lo, double hi) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return lo + (hi - lo) * ldexp((double)(seed >> 11), -53);
}

static num_t from_double(double d) {
    int e;
    double f = frexp(d, &e);
    return num_from_fixed((int64_t)ldexp(f, 60), 60 - e);
}

static void fill(double lo, double hi) {
    for (int i = 0; i < COUNT; i++) {
        da[i] = uniform(lo, hi);
        db[i] = uniform(lo, hi);
        a[i] = from_double(da[i]);
        b[i] = from_double(db[i]);
    }
}

static double now_ns(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* The least of ROUNDS passes over the array: the machine is shared. */
#define MEASURE(result, statement)                                                                                     \
    do {                                                                                                               \
        double best = 1e30;                                                                                            \
        for (int round = 0; round < ROUNDS; round++) {                                                                 \
            double start = now_ns();                                                                                   \
            for (int i = 0; i < COUNT; i++) statement;                                                                 \
            double t = now_ns() - start;                                                                               \
            if (t < best) best = t;                                                                                    \
        }                                                                                                              \
        result = best / COUNT;                                                                                         \
    } while (0)

#define SHOW(name, lo, hi, expression, double_expression)                                                              \
    do {                                                                                                               \
        double ns, peer;                                                                                               \
        int64_t sum = 0;                                                                                               \
        double dsum = 0;                                                                                               \
        fill(lo, hi);                                                                                                  \
        MEASURE(ns, sum ^= (expression).m);                                                                            \
        MEASURE(peer, dsum += (double_expression));                                                                    \
        sink = sum;                                                                                                    \
        dsink = dsum;                                                                                                  \
        printf("%-16s [%6g, %6g] %8.2f ns   double %7.2f ns\n", name, (double)(lo), (double)(hi), ns, peer);           \
    } while (0)

static num_t fixed(num_t v) {
    return (num_t){num_fast_to_fixed(v, 30, NULL), 0, false};
}
static num_t compared(num_t v, num_t w) {
    return (num_t){num_fast_cmp(v, w), 0, false};
}

int main(void) {
    num_t two = num_from_i64(2);
    SHOW("num_add", -10, 10, num_add(a[i], b[i]), da[i] + db[i]);
    SHOW("num_fast_add", -10, 10, num_fast_add(a[i], b[i]), da[i] + db[i]);
    SHOW("num_fast_sub", -10, 10, num_fast_sub(a[i], b[i]), da[i] - db[i]);
    SHOW("num_mul", -10, 10, num_mul(a[i], b[i]), da[i] * db[i]);
    SHOW("num_fast_mul", -10, 10, num_fast_mul(a[i], b[i]), da[i] * db[i]);
    SHOW("num_fast_cmp", -10, 10, compared(a[i], b[i]), da[i] < db[i]);
    SHOW("to_fixed", -10, 10, fixed(a[i]), nearbyint(da[i]));
    SHOW("num_div", -10, 10, num_div(a[i], b[i]), da[i] / db[i]);
    SHOW("num_sqrt", 0, 10, num_sqrt(a[i]), sqrt(da[i]));
    SHOW("func_exp", -10, 10, func_exp(a[i]), exp(da[i]));
    SHOW("func_log", 0, 10, func_log(a[i]), log(da[i]));
    SHOW("func_pow", 0, 10, func_pow(a[i], b[i]), pow(da[i], db[i]));
    SHOW("func_pow(x, 2)", -10, 10, func_pow(a[i], two), pow(da[i], 2));
    SHOW("func_sin", -10, 10, func_sin(a[i]), sin(da[i]));
    SHOW("func_cos", -10, 10, func_cos(a[i]), cos(da[i]));
    SHOW("func_sin", 1e6, 1e15, func_sin(a[i]), sin(da[i]));
    SHOW("func_tan", -10, 10, func_tan(a[i]), tan(da[i]));
    SHOW("func_atan", -10, 10, func_atan(a[i]), atan(da[i]));
    SHOW("func_atan2", -10, 10, func_atan2(a[i], b[i]), atan2(da[i], db[i]));
    SHOW("func_asin", -1, 1, func_asin(a[i]), asin(da[i]));
    SHOW("func_sinh", -3, 3, func_sinh(a[i]), sinh(da[i]));
    SHOW("func_tanh", -3, 3, func_tanh(a[i]), tanh(da[i]));
    SHOW("func_erf", -3, 3, func_erf(a[i]), erf(da[i]));
    SHOW("func_norm", -5, 5, func_norm(a[i]), erfc(da[i]));
    SHOW("func_gamma", -5, 10, func_gamma(a[i]), tgamma(da[i]));
    SHOW("func_besj0", -8, 8, func_besj0(a[i]), j0(da[i]));
    SHOW("func_besj0", 8, 100, func_besj0(a[i]), j0(da[i]));
    return 0;
}
