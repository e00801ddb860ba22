/* num_vec.c - see num_vec.h. */
#include "num/num_vec.h"

num_t num_vec_dot(const num_t a[3], const num_t b[3]) {
    return num_add(num_add(num_mul(a[0], b[0]), num_mul(a[1], b[1])), num_mul(a[2], b[2]));
}

void num_vec_cross(const num_t a[3], const num_t b[3], num_t out[3]) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = num_sub(num_mul(a[i], b[j]), num_mul(a[j], b[i]));
    }
}

void num_vec_near_one(num_t v[3], int n) {
    int32_t most = INT32_MIN;
    for (int k = 0; k < n; k++)
        if (v[k].m != 0 && v[k].e > most) most = v[k].e;
    if (most == INT32_MIN) return;
    for (int k = 0; k < 3; k++) v[k] = num_ldexp(v[k], -63 - most);
}

bool num_vec_unit(num_t v[3]) {
    num_t near_one[3] = {v[0], v[1], v[2]};
    num_vec_near_one(near_one, 3);
    num_t length = num_sqrt(num_vec_dot(near_one, near_one));
    if (length.undef || num_sign(length) <= 0) return false;
    for (int k = 0; k < 3; k++) v[k] = num_div(near_one[k], length);
    return true;
}
