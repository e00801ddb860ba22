/* Heights by num.h and func.h; viewpoints on the grid's own coordinates as often as not. */
#include "tests/emu/bare/integer_scene.h"

#include "hidden/surface/horizon.h"
#include "hidden/surface/perimeter.h"
#include "num/func.h"

/* splitmix64 (Steele, Lea, Flood 2014). */
uint64_t integer_next(uint64_t *rng) {
    uint64_t z = *rng += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}
uint32_t integer_below(uint64_t *rng, uint32_t n) {
    return (uint32_t)(integer_next(rng) >> 32) % n;
}
static num_t uniform(uint64_t *rng) {
    return num_from_fixed((int64_t)(integer_next(rng) >> 11), 53);
}
static num_t ratio(int64_t a, int64_t b) {
    return num_div(num_from_i64(a), num_from_i64(b));
}

static num_t x_of(void *ctx, int32_t i) {
    return ((integer_scene_t *)ctx)->x[i];
}
static num_t y_of(void *ctx, int32_t j) {
    return ((integer_scene_t *)ctx)->y[j];
}
static num_t z_of(void *ctx, int32_t i, int32_t j) {
    const integer_scene_t *s = ctx;
    return s->z[j * s->nx + i];
}

static void uniform_grid(integer_scene_t *s, int nx, int ny) {
    s->nx = nx;
    s->ny = ny;
    for (int i = 0; i < nx; i++) s->x[i] = num_sub(ratio(4 * i, nx - 1), num_from_i64(2));
    for (int j = 0; j < ny; j++) s->y[j] = num_sub(ratio(4 * j, ny - 1), num_from_i64(2));
    s->surface = (surface_t){nx, ny, s, x_of, y_of, z_of, NULL, NULL};
}

static void look_from(integer_scene_t *s, bool perspective, num_t x, num_t y, num_t z) {
    s->cam = (camera_t){.perspective = perspective, .eye = {x, y, z}};
}

static num_t smooth(num_t x, num_t y) {
    return func_exp(num_neg(num_add(num_mul(x, x), num_mul(y, y))));
}

static num_t cliffs(num_t x, num_t y, uint64_t *rng) {
    num_t a = num_mul(ratio(13, 10), func_sin(num_ldexp(x, 1)));
    num_t b = num_mul(ratio(17, 10), func_cos(num_add(num_mul(ratio(3, 2), y), x)));
    return num_add(num_floor(num_add(a, b)), num_mul(ratio(1, 100), uniform(rng)));
}

void integer_scene_family(integer_scene_t *s, enum integer_family family, int n, bool holes) {
    uint64_t rng = 1982;
    uniform_grid(s, n, n);
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++)
            s->z[j * n + i] = family == FAMILY_SMOOTH   ? smooth(s->x[i], s->y[j])
                              : family == FAMILY_CLIFFS ? cliffs(s->x[i], s->y[j], &rng)
                                                        : uniform(&rng);
    for (int k = 0; k < n * n && holes; k++)
        if (integer_below(&rng, 12) == 0) s->z[k] = num_undef();
    int64_t far = family == FAMILY_FAR ? 1000 : 1;
    look_from(s, true, num_from_i64(6 * far), num_from_i64(8 * far), num_from_i64(3 * far));
    if (family == FAMILY_GRAZING) look_from(s, true, num_from_i64(4), num_from_i64(5), ratio(98, 100));
}

static num_t height(int shape, const integer_scene_t *s, int i, int j, uint64_t *rng) {
    num_t west = i ? s->z[j * s->nx + i - 1] : num_from_i64(0);
    switch (shape) {
    case 0:
        return smooth(s->x[i], s->y[j]);
    case 1:
        return cliffs(s->x[i], s->y[j], rng);
    case 2: /* coincidences */
        return ratio(integer_below(rng, 3), 2);
    case 3:
        return integer_below(rng, 6) ? num_from_i64(0) : num_ldexp(uniform(rng), 1);
    case 4: /* differences of a millionth */
        return num_add(num_from_i64(1), num_ldexp(uniform(rng), -20));
    case 5:
        return num_add(west, num_sub(uniform(rng), ratio(1, 2)));
    case 6:
        return ratio((i + j) & 1, 2);
    default:
        return uniform(rng);
    }
}

static void put_eye(integer_scene_t *s, uint64_t *rng) {
    int i = (int)integer_below(rng, (uint32_t)s->nx);
    int j = (int)integer_below(rng, (uint32_t)s->ny);
    int across = (int)integer_below(rng, 3);
    int tilt = (int)integer_below(rng, 3);
    num_t x = num_mul(num_sub(uniform(rng), ratio(1, 2)), num_from_i64(20));
    num_t y = num_mul(num_sub(uniform(rng), ratio(1, 2)), num_from_i64(20));
    num_t z = num_mul(num_sub(uniform(rng), ratio(1, 4)), num_from_i64(4));
    int64_t sign = integer_below(rng, 2) ? 1 : -1;
    switch (integer_below(rng, 8)) {
    case 0: /* in a grid plane */
        look_from(s, true, s->x[i], num_from_i64(9 * sign), z);
        break;
    case 1: /* over a vertex */
        look_from(s, true, s->x[i], s->y[j], num_add(num_from_i64(6), z));
        break;
    case 2: /* level with a vertex */
        look_from(s, true, num_add(x, num_from_i64(13 * sign)), y, num_add(s->z[j * s->nx + i], num_from_i64(0)));
        break;
    case 3:
        look_from(s, false, num_from_i64(sign), num_from_i64(across - 1), ratio(tilt, 2));
        break;
    case 4:
        look_from(s, false, x, y, z);
        break;
    case 5:
        look_from(s, true, num_ldexp(x, 20), num_ldexp(y, 20), num_ldexp(z, 20));
        break;
    default:
        look_from(s, true, x, y, z);
        break;
    }
    if (s->cam.eye[2].undef) s->cam.eye[2] = ratio(1, 2); /* level with a hole */
}

void integer_scene_random(integer_scene_t *s, uint64_t seed) {
    uint64_t rng = seed;
    /* One call a statement: the order of arguments is each compiler's own. */
    int nx = 2 + (int)integer_below(&rng, INTEGER_SCENE_SIDE - 1);
    int ny = 2 + (int)integer_below(&rng, INTEGER_SCENE_SIDE - 1);
    uniform_grid(s, nx, ny);
    int shape = (int)integer_below(&rng, 8);
    bool holes = integer_below(&rng, 4) == 0;
    for (int j = 0; j < s->ny; j++)
        for (int i = 0; i < s->nx; i++) s->z[j * s->nx + i] = height(shape, s, i, j, &rng);
    for (int k = 0; k < s->nx * s->ny && holes; k++)
        if (integer_below(&rng, 6) == 0) s->z[k] = num_undef();
    put_eye(s, &rng);
}

int integer_scene_measure(integer_scene_t *s) {
    return grid_measure(&s->grid, &s->surface, NULL, NULL, s->cache, NULL, NULL);
}

static int32_t points(void *ctx, int32_t k) {
    return (void)k, ((integer_scene_t *)ctx)->nx;
}

/* The farthest row for +y first, from right to left, as a viewer there sees it. */
static void point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    const integer_scene_t *s = ctx;
    int i = s->nx - 1 - v, j = s->ny - 1 - k;
    xyz[0] = s->x[i];
    xyz[1] = s->y[j];
    xyz[2] = s->z[j * s->nx + i];
}

int integer_scene_draw(integer_scene_t *s, enum integer_kernel kernel, const ink_sink_t *sink, hidden_stats_t *stats) {
    hidden_job_t job = {.mem = s->mem, .bytes = sizeof s->mem, .sink = sink};
    if (kernel != KERNEL_HORIZON) return perimeter_draw(&s->grid, &s->cam, &job, stats);
    profiles_t p = {.count = s->ny, .max_points = s->nx, .ctx = s, .points = points, .point = point};
    for (int i = 0; i < 2; i++) {
        p.side[i] = num_from_i64(i ? 0 : -1);
        p.away[i] = num_from_i64(i ? -1 : 0);
    }
    return horizon_draw(&p, &s->cam, false, &job, stats);
}
