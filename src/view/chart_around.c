/* chart_around.c - see chart_around.h. */
#include "view/chart_around.h"

#define SLOPE_BITS 28 /* slopes count 2^-28 */
#define STEEP ((int64_t)1 << (SLOPE_BITS + 18))

/* A zone ends 2^6 times as steep as the one before, less what that one has used up already. */
#define WIDTH ((1 << SLOPE_BITS) - (1 << (SLOPE_BITS - 6)))
const int32_t chart_zone_border[CHART_ZONES] = {1 << SLOPE_BITS, (1 << SLOPE_BITS) + WIDTH,
                                                (1 << SLOPE_BITS) + 2 * WIDTH, (1 << SLOPE_BITS) + 3 * WIDTH};

_Static_assert((INT64_C(1) << SLOPE_BITS) + 3 * (int64_t)WIDTH <= PENCIL_LIMIT, "the steepest slope has coordinates");

static num_t max_num(num_t a, num_t b) {
    return num_cmp(a, b) < 0 ? b : a;
}

static num_t farthest(const num_t v[2], num_t eye) {
    return max_num(num_abs(num_sub(v[0], eye)), num_abs(num_sub(v[1], eye)));
}

/* How far the eye is from a range; 0 inside. */
static num_t nearest(const num_t v[2], num_t eye) {
    if (num_cmp(eye, v[0]) < 0) return num_sub(v[0], eye);
    return num_cmp(eye, v[1]) > 0 ? num_sub(eye, v[1]) : num_from_i64(0);
}

/* 2^(31 + b) / d with b the number of bits of d, 32 bits; d > 0. */
static uint32_t reciprocal(uint32_t d, int32_t *b) {
    *b = 32 - __builtin_clz(d);
    uint64_t r = ((uint64_t)1 << (31 + *b)) / d;
    return r > UINT32_MAX ? UINT32_MAX : (uint32_t)r;
}

/* A coordinate relative to the eye. An eye that is beyond the border by less than the chart can tell is a unit beyond
 * it: over the border the surface would look different. */
static int32_t apart(num_t v, num_t eye, int8_t side, int bits) {
    const int32_t d = plane_fixed(num_sub(v, eye), bits);
    return d == 0 && num_cmp(v, eye) != 0 ? -side : d;
}

void chart_around_init(chart_t *c, grid_t *const grid[], int32_t n, const num_t x[2], const num_t y[2],
                       const num_t z[2]) {
    const num_t *e = c->cam->eye, far_z = farthest(z, e[2]);
    c->x_ref = e[0], c->y_ref = e[1], c->z_ref = e[2];
    c->x_bits = plane_bits_below(farthest(x, e[0]), 30);
    c->y_bits = plane_bits_below(farthest(y, e[1]), 30);
    /* From far above or below all slopes are steep: the first zone then ends where they begin. */
    const int16_t d_bits = c->x_bits < c->y_bits ? c->x_bits : c->y_bits;
    const num_t far_d = max_num(farthest(x, e[0]), farthest(y, e[1]));
    const num_t least = num_div(nearest(z, e[2]), far_d);
    const int16_t first = least.m == 0 ? 0 : (int16_t)(-1 - plane_bits_below(least, 0));
    const int16_t slope = (int16_t)(d_bits - (first > 0 ? first : 0));
    /* Heights get 60 bits, but no more than 16 beyond those of the distances: see chart_zone_height. */
    const int16_t most = (int16_t)(slope + 16);
    c->z_bits = plane_bits_below(far_z, 60);
    if (far_z.m == 0 || c->z_bits > most) c->z_bits = most;
    c->z_shift = (int16_t)(c->z_bits - slope);
    for (int32_t k = 0; k < n; k++) c->tall |= grid_is_tall(grid[k], e);
    for (int32_t i = 0; i < c->grid->nx; i++) {
        chart_column_t *k = &c->column[i];
        k->p = apart(c->grid->src->x_of(c->grid->src->ctx, i), e[0], c->side_x, c->x_bits);
        if (k->p != 0) k->r = reciprocal((uint32_t)(k->p < 0 ? -k->p : k->p), &k->s);
    }
}

int64_t chart_zone_height(const chart_t *c, int k, int32_t d) {
    const int shift = c->z_shift + 6 * k; /* <= 16 + 12, so 58 bits at most */
    return shift >= 0 ? (int64_t)d << shift : shift > -63 ? (int64_t)d >> -shift : 0;
}

bool chart_in_one_zone(int32_t low, int32_t high) {
    if (low < 0 && high <= 0) {
        const int32_t swap = -low;
        low = -high;
        high = swap;
    }
    if (low < 0) return -low <= chart_zone_border[0] && high <= chart_zone_border[0];
    int k = 0;
    while (k < CHART_ZONES - 1 && low >= chart_zone_border[k]) k++;
    return high <= chart_zone_border[k];
}

/* v * 2^shift, no more than STEEP + 1; v >= 0. */
static int64_t scaled(int64_t v, int shift) {
    if (shift <= 0) return shift > -63 ? v >> -shift : 0;
    return shift > 46 || v > STEEP >> shift ? STEEP + 1 : v << shift;
}

/* a and w of a point seen in sector k: 0 south, 1 east, 2 north, 3 west; r and b: reciprocal of its distance. */
static inline bool around(const chart_t *c, int sector, int32_t across, int64_t dz, uint32_t r, int32_t b,
                          pencil_t *at) {
    const int sh = 31 + b - (CHART_SECTOR_BITS - 1); /* rounded: a diagonal comes out exact */
    int32_t a = (int32_t)(((int64_t)across * (int64_t)r + ((int64_t)1 << (sh - 1))) >> sh);
    at->a = a + (2 * sector - 3) * (1 << (CHART_SECTOR_BITS - 1));
    const uint64_t z = dz < 0 ? 0 - (uint64_t)dz : (uint64_t)dz;
    const int64_t product = (int64_t)((z >> 32) * r + (((z & UINT32_MAX) * r) >> 32)); /* of up to 92 bits */
    int64_t w = scaled(product, SLOPE_BITS + 1 - b - c->z_shift);
    const bool shown = w <= STEEP;
    if (!shown) {
        w = PENCIL_LIMIT;
    } else if (w > (int64_t)1 << SLOPE_BITS) {
        int k = 1;
        while (w > (int64_t)1 << (SLOPE_BITS + 6 * k)) k++;
        w = chart_zone_border[k - 1] + ((w - ((int64_t)1 << (SLOPE_BITS + 6 * (k - 1)))) >> (6 * k));
    }
    at->w = (int32_t)(dz < 0 ? -w : w);
    return shown;
}

bool chart_around(const chart_t *c, int sector, int32_t dx, int32_t dy, int64_t dz, pencil_t *at) {
    int32_t along = sector & 1 ? dx : dy, across = sector & 1 ? dy : dx;
    if (sector == 0 || sector == 3) along = -along;
    if (sector >= 2) across = -across;
    at->a = CHART_NONE;
    if (along <= 0) return false;
    int32_t b;
    uint32_t r = reciprocal((uint32_t)along, &b);
    return around(c, sector, across, dz, r, b, at);
}

int chart_sector(int32_t dx, int32_t dy) {
    int32_t ax = dx < 0 ? -dx : dx, ay = dy < 0 ? -dy : dy;
    return ax > ay ? (dx > 0 ? 1 : 3) : (dy > 0 ? 2 : 0);
}

/* Heights of a grid's row, relative to the eye. */
static void load_heights(const chart_t *c, grid_t *g, int32_t j, chart_line_t *line) {
    const int32_t nx = g->nx;
    if (c->tall) {
        for (int32_t i = 0; i < nx; i++) {
            num_t z;
            const bool defined = grid_value(g, i, j, &z);
            line->z[i] = defined ? num_to_fixed(num_sub(z, c->z_ref), c->z_bits, NULL) : 0;
            if (line->hole != NULL) line->hole[i] = !defined;
        }
        return;
    }
    const int up = g->z_exp + c->z_bits;
    const int64_t origin = num_to_fixed(num_sub(g->z_origin, c->z_ref), c->z_bits, NULL);
    int32_t *zi = (int32_t *)(void *)line->at;
    grid_row(g, j, zi, line->hole);
    for (int32_t i = 0; i < nx; i++) {
        const uint64_t share = up >= 0 ? (uint64_t)(int64_t)zi[i] << (up > 62 ? 62 : up)
                                       : (uint64_t)((int64_t)zi[i] >> (up < -62 ? 62 : -up));
        line->z[i] = (int64_t)(share + (uint64_t)origin);
    }
}

void chart_around_row(const chart_t *c, grid_t *g, int32_t j, num_t y, chart_line_t *line) {
    const int32_t dy = apart(y, c->y_ref, c->side_y, c->y_bits);
    int32_t ay = dy < 0 ? -dy : dy, b = 0;
    uint32_t r = ay == 0 ? 0 : reciprocal((uint32_t)ay, &b);
    line->dy = dy;
    load_heights(c, g, j, line);
    for (int32_t i = 0; i < c->grid->nx; i++) {
        const chart_column_t *k = &c->column[i];
        const int32_t dx = k->p;
        const int64_t dz = line->z[i];
        int sector = chart_sector(dx, dy);
        bool shown = false;
        if (sector & 1) {
            shown = around(c, sector, sector == 3 ? -dy : dy, dz, k->r, k->s, &line->at[i]);
        } else if (ay != 0) {
            shown = around(c, sector, sector == 2 ? -dx : dx, dz, r, b, &line->at[i]);
        }
        /* The cut's two sides have different a: what lies on it takes the careful way of split edges. */
        if (!shown || (dx == dy && dx < 0)) line->at[i].a = CHART_NONE;
    }
}
