/* data_place.c - see data_place.h. */
#include "scene/data_place.h"
#include "num/func.h"
#include "scene/log_scale.h"

#if CONFIG_SAMPLED
static num_t radians(const data_spec_t *s, num_t angle) {
    return s->degrees ? num_mul(angle, num_div(func_pi(), num_from_i64(180))) : angle;
}

static void map(const data_spec_t *s, num_t p[3]) {
    if (s->mapping == DATA_CARTESIAN) return;
    const num_t a = radians(s, p[0]), second = p[1];
    num_t r = s->mapping == DATA_POLAR ? second : p[2];
    if (s->mapping == DATA_SPHERICAL) {
        const num_t latitude = radians(s, second);
        p[2] = num_mul(r, func_sin(latitude));
        r = num_mul(r, func_cos(latitude));
    } else {
        p[2] = second;
    }
    p[0] = num_mul(r, func_cos(a));
    p[1] = num_mul(r, func_sin(a));
}
#endif

#if CONFIG_SAMPLED || CONFIG_LOGSCALE
void data_place(const data_spec_t *s, num_t p[3]) {
#if CONFIG_SAMPLED
    map(s, p);
#endif
#if CONFIG_LOGSCALE
    for (int k = 0; s->log_base && k < (s->flat ? 2 : 3); k++) p[k] = log_scale(s->log_base[k], p[k]);
#endif
}
#endif
