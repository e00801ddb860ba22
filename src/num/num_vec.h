/* num_vec.h - three numbers as a vector. Undefined where num.h's operations are. */
#ifndef NUM_VEC_H
#define NUM_VEC_H

#include "num/num.h"

num_t num_vec_dot(const num_t a[3], const num_t b[3]);
void num_vec_cross(const num_t a[3], const num_t b[3], num_t out[3]);
/* Scales it by a power of two, so that the largest of the first n parts is near 1 and squares are numbers still. */
void num_vec_near_one(num_t v[3], int n);
/* Brings it to length 1; false, and left as it is, without a length. */
bool num_vec_unit(num_t v[3]);

#endif
