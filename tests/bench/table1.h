/* table1.h - the heights of Anderson's Table 1, the same for every program that is timed. */
#ifndef TABLE1_H
#define TABLE1_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Coordinate i of n equally spaced ones on [-2,2]. */
static inline double table1_coordinate(int n, int i) {
    return -2 + 4.0 * i / (n - 1);
}

/* Fills z[j * n + i]: "smooth" exp(-x*x-y*y), or "random", uniform on [0,1] by splitmix64 from seed 1982. */
static inline void table1_heights(const char *shape, int n, double *z) {
    uint64_t state = 1982;
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            double x = table1_coordinate(n, i), y = table1_coordinate(n, j);
            uint64_t v = state += 0x9e3779b97f4a7c15u;
            v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
            v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
            v ^= v >> 31;
            *z++ = strcmp(shape, "smooth") ? (double)(v >> 11) * 0x1p-53 : exp(-x * x - y * y);
        }
}

#endif
