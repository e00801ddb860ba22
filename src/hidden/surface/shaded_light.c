/* shaded_light.c - see shaded_light.h. */
#include "hidden/surface/shaded_light.h"

#include "config.h"
#include "num/ints.h"
#include "num/num_vec.h"

#if CONFIG_AREA

void shaded_weigh_lights(shaded_t *s) {
    num_t sum[3], length2, one = num_from_i64(1);
    for (int k = 0; k < 3; k++) sum[k] = num_from_i64(0);
    for (int32_t l = 0; l < s->lights; l++) {
        for (int k = 0; k < 3; k++) {
            const num_t at = s->light[l].at[k];
            s->to[l][k] = s->light[l].point ? num_mul(s->cam->unit[k], num_sub(at, s->middle[k])) : at;
        }
        num_vec_unit(s->to[l]);
        for (int k = 0; k < 3; k++) sum[k] = num_add(sum[k], s->to[l][k]);
    }
    length2 = num_vec_dot(sum, sum);
    if (num_cmp(length2, one) < 0) length2 = one;
    s->full_q30 = num_to_fixed(num_sqrt(length2), 30, NULL);
}

int64_t shaded_brightness(const shaded_t *s, const grid_t *g, int32_t i, int32_t j, const shaded_vertex_t *v[4],
                          bool turn) {
    const surface_t *f = g->src;
    const num_t *unit = s->cam->unit;
    num_t x = num_mul(unit[0], num_sub(f->x_of(f->ctx, i + 1), f->x_of(f->ctx, i)));
    num_t y = num_mul(unit[1], num_sub(f->y_of(f->ctx, j + 1), f->y_of(f->ctx, j)));
    num_t a = num_mul(unit[2], num_ldexp(num_from_i64((int64_t)v[2]->z - v[0]->z), g->z_exp));
    num_t b = num_mul(unit[2], num_ldexp(num_from_i64((int64_t)v[3]->z - v[1]->z), g->z_exp));
    /* diagonals (x, y, a) and (-x, y, b) */
    num_t n[3] = {num_mul(y, num_sub(b, a)), num_neg(num_mul(x, num_add(a, b))), num_ldexp(num_mul(x, y), 1)};
    if (!num_vec_unit(n)) return 0;
    int64_t sum = 0;
    for (int32_t l = 0; l < s->lights; l++) {
        num_t to[3];
        for (int k = 0; k < 3; k++) to[k] = s->to[l][k];
        if (s->light[l].point) {
            num_t z = num_add(g->z_origin, num_ldexp(num_from_i64(v[0]->z), g->z_exp));
            const num_t at[3] = {f->x_of(f->ctx, i), f->y_of(f->ctx, j), z};
            for (int k = 0; k < 3; k++) to[k] = num_mul(unit[k], num_sub(s->light[l].at[k], at[k]));
            if (!num_vec_unit(to)) continue;
        }
        int64_t q30 = num_to_fixed(num_vec_dot(n, to), 30, NULL);
        if (turn) q30 = -q30;
        sum += q30 > 0 ? q30 : 0;
    }
    return ints_muldiv_round(sum, INK_ONE, s->full_q30);
}

#endif
