/* scattered.c - see scattered.h. */
#include "scene/scattered.h"
#include "config.h"
#include "error.h"
#include "num/func.h"

#if CONFIG_SCATTERED
void scattered_default(scattered_spec_t *spec) {
    const num_t one = num_from_i64(1);
    *spec = (scattered_spec_t){.nx = 10, .ny = 10, .q = 1, .scale = {one, one}};
}

void scattered_start(scattered_t *s, data_pool_t *pool) {
    *s = (scattered_t){.pool = pool, .point = pool->base + pool->low};
}

int scattered_point(scattered_t *s, const num_t p[3]) {
    if (p[0].undef || p[1].undef || p[2].undef) return 0;
    if (s->pool->high - s->pool->low < 3 || s->n == INT32_MAX) return ERR_FULL;
    for (int k = 0; k < 3; k++) s->point[(size_t)s->n * 3 + (size_t)k] = packed_from_num(p[k]);
    for (int k = 0; k < 2; k++) {
        if (s->n == 0 || num_cmp(p[k], s->end[k][0]) < 0) s->end[k][0] = p[k];
        if (s->n == 0 || num_cmp(p[k], s->end[k][1]) > 0) s->end[k][1] = p[k];
    }
    s->pool->low += 3;
    s->n++;
    return 0;
}

/* Of a point so far away; *exact: it counts alone. */
static num_t weight(const scattered_spec_t *spec, num_t dx, num_t dy, bool *exact) {
    const num_t one = num_from_i64(1), none = num_from_i64(0);
    if (spec->weight == SCATTERED_QNORM) {
        const num_t r2 = num_add(num_mul(dx, dx), num_mul(dy, dy));
        const num_t d = num_mul(num_ipow(r2, spec->q / 2), spec->q % 2 ? num_sqrt(r2) : one);
        *exact = num_sign(d) == 0;
        return *exact ? one : num_div(one, d);
    }
    const num_t x = num_div(dx, spec->scale[0]), y = num_div(dy, spec->scale[1]);
    const num_t square = num_add(num_mul(x, x), num_mul(y, y));
    const bool inside = num_cmp(square, one) < 0;
    switch (spec->weight) {
    case SCATTERED_GAUSS:
        return func_exp(num_neg(square));
    case SCATTERED_EXP:
        return func_exp(num_neg(num_sqrt(square)));
    case SCATTERED_CAUCHY:
        return num_div(one, num_add(one, square));
    case SCATTERED_HANN:
        return inside ? num_ldexp(num_add(one, func_cos(num_mul(func_pi(), num_sqrt(square)))), -1) : none;
    default:
        return inside ? one : none;
    }
}

/* Undefined where all weights are 0. */
static num_t height(const scattered_t *s, const scattered_spec_t *spec, num_t x, num_t y) {
    num_t sum = num_from_i64(0), weights = sum;
    for (int32_t i = 0; i < s->n; i++) {
        const packed_t *p = s->point + (size_t)i * 3;
        const num_t z = packed_num(p[2]);
        bool exact = false;
        const num_t w = weight(spec, num_sub(packed_num(p[0]), x), num_sub(packed_num(p[1]), y), &exact);
        if (exact) return z;
        sum = num_add(sum, num_mul(w, z));
        weights = num_add(weights, w);
    }
    return spec->density ? sum : num_div(sum, weights);
}

int scattered_grid(const scattered_t *s, const scattered_spec_t *spec, data_grid_t *g) {
    enum data_grid_trouble trouble;
    if (s->n == 0 || num_cmp(s->end[0][0], s->end[0][1]) == 0 || num_cmp(s->end[1][0], s->end[1][1]) == 0)
        return ERR_EMPTY;
    data_grid_start(g, s->pool);
    int err = 0;
    for (int32_t j = 0; j < spec->ny && !err; j++) {
        const num_t y = num_between(s->end[1], j, spec->ny);
        for (int32_t i = 0; i < spec->nx && !err; i++) {
            const num_t x = num_between(s->end[0], i, spec->nx);
            err = data_grid_point(g, x, y, height(s, spec, x, y), &trouble);
        }
        if (!err) err = data_grid_break(g, &trouble);
    }
    return err ? err : data_grid_finish(g, &trouble);
}
#endif
