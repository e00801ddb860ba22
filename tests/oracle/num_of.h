/* num_of.h - between the program's numbers and the floating point of references. */
#ifndef NUM_OF_H
#define NUM_OF_H

#include "num/num.h"
#include <math.h>

static inline double num_value(num_t a) {
    return ldexp((double)a.m, a.e);
}

/* Exact: a double's 53 bits fit. */
static inline num_t num_of(double v) {
    int e;
    double f = frexp(v, &e);
    return num_from_fixed((int64_t)ldexp(f, 53), 53 - e);
}

#endif
