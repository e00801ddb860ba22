/* func_degrees.c - sines of degrees, for views and turned objects: along an axis they must be exact. */
#include "num/func.h"

#include <stddef.h>

num_t func_sin_degrees(num_t a) {
    num_t turn = num_from_i64(360);
    a = num_sub(a, num_mul(turn, num_floor(num_div(a, turn))));
    num_t quarters = num_div(a, num_from_i64(90));
    if (num_is_integer(quarters)) {
        static const int8_t SINE[4] = {0, 1, 0, -1};
        return num_from_i64(SINE[num_to_fixed(quarters, 0, NULL) & 3]);
    }
    return func_sin(num_div(num_mul(a, func_pi()), num_from_i64(180)));
}
