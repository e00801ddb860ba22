/* chart.c - choosing a chart's kind and scales once per scene, and charting rows. */
#include "view/chart.h"

#include "num/wide.h"
#include "view/chart_around.h"

#include <string.h>

/* A single sector is used while directions differ by less than this slope: at its border a unit of a is then
 * MAX_SLOPE^2 + 1 times as fine in angle as in its middle. */
#define MAX_SLOPE 8
/* A single sector's w has one scale: slopes that differ by more than 2^MAX_STEEP take the zones of CHART_AROUND. */
#define MAX_STEEP 9

_Static_assert(30 - 7 >= 17 + 5, "at MAX_SLOPE 32 units are left to a quarter of a step on A4 (2^-17 of the page)");

static num_t max_num(num_t a, num_t b) {
    return num_cmp(a, b) < 0 ? b : a;
}

static num_t middle(num_t a, num_t b) {
    return num_ldexp(num_add(a, b), -1);
}

static num_t x_at(const chart_t *c, int32_t i) {
    return c->grid->src->x_of(c->grid->src->ctx, i);
}
static num_t y_at(const chart_t *c, int32_t j) {
    return c->grid->src->y_of(c->grid->src->ctx, j);
}

/* The eye's cell along one axis: the last index in [0, n - 2] whose coordinate is not beyond the eye. */
static int32_t cell_of(num_t (*of)(void *ctx, int32_t k), void *ctx, int32_t n, num_t eye, int8_t *side) {
    *side = num_cmp(eye, of(ctx, 0)) < 0 ? -1 : num_cmp(eye, of(ctx, n - 1)) > 0 ? 1 : 0;
    int32_t lo = 0, hi = n - 1;
    while (hi - lo > 1) {
        int32_t m = lo + (hi - lo) / 2;
        if (num_cmp(of(ctx, m), eye) <= 0) {
            lo = m;
        } else {
            hi = m;
        }
    }
    return lo;
}

/* Is the view vertical, or so nearly that over the whole surface no height shifts a point by 2^-40 of its width?
 * Heights may be 10^20 times the width and more, so the sizes of the box have to be in it. */
static bool looks_straight_down(const num_t e[3], const num_t x[2], const num_t y[2], const num_t z[2]) {
    if (e[0].m == 0 && e[1].m == 0) return true;
    const num_t height = num_sub(z[1], z[0]);
    if (height.m == 0) return false;
    const num_t down = num_ldexp(num_abs(num_div(e[2], height)), -40);
    return num_cmp(num_abs(num_div(e[0], num_sub(x[1], x[0]))), down) <= 0 &&
           num_cmp(num_abs(num_div(e[1], num_sub(y[1], y[0]))), down) <= 0;
}

static void init_parallel(chart_t *c, const num_t x[2], const num_t y[2], const num_t z[2]) {
    const num_t *e = c->cam->eye;
    num_t flat = num_sqrt(num_add(num_mul(e[0], e[0]), num_mul(e[1], e[1])));
    if (flat.undef || looks_straight_down(e, x, y, z)) {
        c->kind = CHART_VERTICAL;
        return;
    }
    c->x_ref = middle(x[0], x[1]);
    c->y_ref = middle(y[0], y[1]);
    c->z_ref = middle(z[0], z[1]);
    c->turn[0] = num_div(e[0], flat);
    c->turn[1] = num_div(e[1], flat);
    num_t climb = num_div(e[2], flat);
    num_t half_x = num_sub(x[1], c->x_ref), half_y = num_sub(y[1], c->y_ref), half_z = num_sub(z[1], c->z_ref);
    num_t slack = num_from_fixed((1 << 16) + 1, 16);
    num_t most_a = num_add(num_abs(num_mul(c->turn[1], half_x)), num_abs(num_mul(c->turn[0], half_y)));
    num_t most_w = num_add(num_abs(num_mul(c->turn[0], half_x)), num_abs(num_mul(c->turn[1], half_y)));
    most_w = num_add(num_mul(num_abs(climb), most_w), half_z);
    c->x_bits = plane_bits_below(num_mul(most_a, slack), 30);
    c->z_bits = plane_bits_below(num_mul(most_w, slack), 30);
    for (int32_t i = 0; i < c->grid->nx; i++) {
        num_t dx = num_sub(x_at(c, i), c->x_ref);
        num_t climbed = num_mul(climb, num_mul(c->turn[0], dx));
        c->p[i] = plane_fixed(num_mul(c->turn[1], dx), c->x_bits);
        c->s[i] = -plane_fixed(climbed, c->z_bits);
    }
    c->turn[1] = num_mul(climb, c->turn[1]); /* what a row needs */
}

static bool has_eye(const chart_t *c, num_t at, num_t eye) {
    return c->cam->perspective ? num_cmp(at, eye) == 0 : num_sign(eye) == 0;
}

bool chart_column_has_eye(const chart_t *c, int32_t i) {
    return has_eye(c, x_at(c, i), c->cam->eye[0]);
}
bool chart_row_has_eye(const chart_t *c, int32_t j) {
    return has_eye(c, y_at(c, j), c->cam->eye[1]);
}

int8_t chart_seen(const chart_t *c, grid_t *g) {
    if (!c->cam->perspective) return 0;
    if (c->side_x != 0 || c->side_y != 0) return 0;
    /* The eye is above or below its cell, whose height there is a mean of its corners': how far is that above the eye?
     */
    const num_t *eye = c->cam->eye;
    num_t x0 = x_at(c, c->i0), x1 = x_at(c, c->i0 + 1), y0 = y_at(c, c->j0), y1 = y_at(c, c->j0 + 1);
    num_t u = num_div(num_sub(eye[0], x0), num_sub(x1, x0)), v = num_div(num_sub(eye[1], y0), num_sub(y1, y0));
    num_t one = num_from_i64(1), above = num_from_i64(0);
    bool defined = false;
    for (int k = 0; k < 4; k++) {
        num_t z, part = num_mul(k & 1 ? u : num_sub(one, u), k >> 1 ? v : num_sub(one, v));
        if (part.m == 0 || !grid_value(g, c->i0 + (k & 1), c->j0 + (k >> 1), &z)) continue;
        above = num_add(above, num_mul(part, num_sub(z, eye[2])));
        defined = true;
    }
    if (!defined) above = num_sub(middle(g->z_min, g->z_max), eye[2]);
    return num_sign(above) > 0 ? -1 : 1;
}

/* Is z, seen from beyond the range v, too steep for one scale of w? The scale is as fine as the greatest slope allows;
 * how fine it must be depends on the least one. */
static bool is_steep(const num_t z[2], const num_t v[2], const num_t eye_z, num_t eye_v) {
    const bool before = num_cmp(eye_v, v[0]) < 0;
    const num_t near = before ? num_sub(v[0], eye_v) : num_sub(eye_v, v[1]);
    const num_t far = before ? num_sub(v[1], eye_v) : num_sub(eye_v, v[0]);
    const num_t z0 = num_sub(z[0], eye_z), z1 = num_sub(z[1], eye_z);
    const num_t most = num_div(max_num(num_abs(z0), num_abs(z1)), near);
    num_t least = num_from_i64(1);
    if (num_sign(z0) > 0) least = max_num(least, num_div(z0, far));
    if (num_sign(z1) < 0) least = max_num(least, num_div(num_abs(z1), far));
    return num_cmp(most, num_ldexp(least, MAX_STEEP)) > 0;
}

/* How many times as wide as its nearest distance a rectangle is seen, in the world or in units of its own sides,
 * whatever is less: a long one that is seen from its short end is narrow, however near that end is for its length. */
static num_t slope_of(const num_t u[2], const num_t v[2], num_t eye_u, num_t eye_v) {
    const num_t wide = max_num(num_abs(num_sub(u[0], eye_u)), num_abs(num_sub(u[1], eye_u)));
    const num_t near = num_cmp(eye_v, v[0]) < 0 ? num_sub(v[0], eye_v) : num_sub(eye_v, v[1]);
    const num_t slope = num_div(wide, near), own = num_div(num_mul(slope, num_sub(v[1], v[0])), num_sub(u[1], u[0]));
    return num_cmp(own, slope) < 0 ? own : slope;
}

void chart_init(chart_t *c, grid_t *const grid[], int32_t n, const camera_t *cam, chart_column_t *column) {
    grid_t *g = grid[0];
    const surface_t *src = g->src;
    const num_t *e = cam->eye;
    *c = (chart_t){.grid = g, .cam = cam, .column = column, .p = (int32_t *)(void *)column};
    c->s = c->p + g->nx;
    const num_t x[2] = {x_at(c, 0), x_at(c, g->nx - 1)}, y[2] = {y_at(c, 0), y_at(c, g->ny - 1)};
    num_t z[2] = {g->z_min, g->z_max};
    for (int32_t k = 1; k < n; k++) {
        if (num_cmp(grid[k]->z_min, z[0]) < 0) z[0] = grid[k]->z_min;
        z[1] = max_num(z[1], grid[k]->z_max);
    }
    if (!cam->perspective) {
        c->side_x = (int8_t)num_sign(e[0]);
        c->side_y = (int8_t)num_sign(e[1]);
        c->i0 = c->side_x > 0 ? g->nx - 2 : 0;
        c->j0 = c->side_y > 0 ? g->ny - 2 : 0;
        c->kind = CHART_PARALLEL;
        init_parallel(c, x, y, z);
        return;
    }
    c->i0 = cell_of(src->x_of, src->ctx, g->nx, e[0], &c->side_x);
    c->j0 = cell_of(src->y_of, src->ctx, g->ny, e[1], &c->side_y);
    num_t limit = num_from_i64(MAX_SLOPE), slope_x = limit, slope_y = limit;
    if (c->side_y != 0 && !is_steep(z, y, e[2], e[1])) slope_y = slope_of(x, y, e[0], e[1]);
    if (c->side_x != 0 && !is_steep(z, x, e[2], e[0])) slope_x = slope_of(y, x, e[1], e[0]);
    if (num_cmp(slope_y, limit) < 0 && num_cmp(slope_y, slope_x) <= 0) {
        c->kind = CHART_NORTH;
        c->sign = (int8_t)-c->side_y;
        plane_init(&c->plane, true, x, y, z, e);
        c->z_bits = c->plane.z_bits;
        for (int32_t i = 0; i < g->nx; i++) {
            int32_t p = plane_u(&c->plane, x_at(c, i));
            c->p[i] = c->sign > 0 ? -p : p;
        }
    } else if (num_cmp(slope_x, limit) < 0) {
        c->kind = CHART_EAST;
        c->sign = (int8_t)-c->side_x;
        plane_init(&c->plane, true, y, x, z, (num_t[3]){e[1], e[0], e[2]});
        c->z_bits = c->plane.z_bits;
        for (int32_t i = 0; i < g->nx; i++) {
            int32_t p = plane_u_of_v(&c->plane, x_at(c, i));
            column[i].p = c->sign > 0 ? p : -p;
            column[i].s = plane_z_of_v(&c->plane, x_at(c, i));
            column[i].r = plane_reciprocal(&c->plane, x_at(c, i));
        }
    } else {
        c->kind = CHART_AROUND;
        chart_around_init(c, grid, n, x, y, z);
    }
}

/* How the heights of one grid become numerators of w: multiples of 2^z_exp become multiples of 2^-z_bits. */
typedef struct rise {
    uint8_t down, up; /* (zi >> down) << up */
    int32_t origin;   /* what zi counts from */
} rise_t;

static rise_t rise_of(const chart_t *c, const grid_t *g, num_t z_ref) {
    const int32_t up = g->z_exp + c->z_bits;
    return (rise_t){.down = (uint8_t)(up < 0 ? (up < -31 ? 31 : -up) : 0),
                    .up = (uint8_t)(up > 0 ? (up > 31 ? 31 : up) : 0),
                    .origin = plane_fixed(num_sub(g->z_origin, z_ref), c->z_bits)};
}

/* A height, plus s. Heights count from any point of the surface, so a term may need 33 bits; the sum fits, and unsigned
 * arithmetic gets it right. */
static inline int32_t raised(const rise_t *r, int32_t zi, int32_t s) {
    return (int32_t)(((uint32_t)(zi >> r->down) << r->up) + (uint32_t)r->origin + (uint32_t)s);
}

/* Here and below: zi are the heights from line->first on. They may lie in the upper half of the row's points: each is
 * read before anything is written there. */
static void row_parallel(const chart_t *c, const rise_t *rise, num_t y, const int32_t *zi, chart_line_t *line) {
    num_t dy = num_sub(y, c->y_ref);
    int32_t q = -plane_fixed(num_mul(c->turn[0], dy), c->x_bits), t = -plane_fixed(num_mul(c->turn[1], dy), c->z_bits);
    for (int32_t i = line->first; i <= line->last; i++) {
        line->at[i] = (pencil_t){c->p[i] + q, raised(rise, *zi++, c->s[i] + t)};
    }
}

static void row_north(const chart_t *c, const rise_t *rise, num_t y, const int32_t *zi, chart_line_t *line) {
    const int32_t s = plane_z_of_v(&c->plane, y);
    const int32_t q = c->sign > 0 ? -plane_u_of_v(&c->plane, y) : plane_u_of_v(&c->plane, y);
    const uint32_t r = plane_reciprocal(&c->plane, y);
    const int32_t *p = c->p;
    line->r = r;
    for (int32_t i = line->first; i <= line->last; i++) {
        line->at[i] = (pencil_t){plane_project(p[i] + q, r), plane_project(raised(rise, *zi++, s), r)};
    }
}

static void row_east(const chart_t *c, const rise_t *rise, num_t y, const int32_t *zi, chart_line_t *line) {
    const int32_t q = c->sign < 0 ? -plane_u(&c->plane, y) : plane_u(&c->plane, y);
    for (int32_t i = line->first; i <= line->last; i++) {
        const chart_column_t *k = &c->column[i];
        line->at[i] = (pencil_t){plane_project(k->p + q, k->r), plane_project(raised(rise, *zi++, k->s), k->r)};
    }
}

/* A row's abscissae: p + q, divided by a distance. */
typedef struct across {
    int32_t q;
    uint32_t r; /* CHART_NORTH */
} across_t;

static across_t across_of(const chart_t *c, int32_t j) {
    const num_t y = y_at(c, j);
    if (c->kind == CHART_PARALLEL)
        return (across_t){-plane_fixed(num_mul(c->turn[0], num_sub(y, c->y_ref)), c->x_bits), 0};
    const bool north = c->kind == CHART_NORTH;
    const int32_t q = north ? plane_u_of_v(&c->plane, y) : plane_u(&c->plane, y);
    return (across_t){north == (c->sign > 0) ? -q : q, north ? plane_reciprocal(&c->plane, y) : 0};
}

static int32_t abscissa(const chart_t *c, across_t row, int32_t i) {
    if (c->kind == CHART_PARALLEL) return c->p[i] + row.q;
    if (c->kind == CHART_NORTH) return plane_project(c->p[i] + row.q, row.r);
    return plane_project(c->column[i].p + row.q, c->column[i].r);
}

int32_t chart_abscissa(const chart_t *c, int32_t i, int32_t j) {
    return abscissa(c, across_of(c, j), i);
}

/* Columns of a row before `a`, where abscissae rise by `sign` times the column. */
static int32_t columns_before(const chart_t *c, across_t row, int32_t sign, int32_t a) {
    int32_t lo = 0, hi = c->grid->nx;
    while (lo < hi) {
        const int32_t m = (lo + hi) / 2;
        if (sign * abscissa(c, row, m) < sign * a) {
            lo = m + 1;
        } else {
            hi = m;
        }
    }
    return lo;
}

/* Of a row: columns from `first` on are at the stretch's beginning or beyond [0], at its end or before [1]; so are
 * those before `end`. */
typedef struct reach {
    int32_t first[2], end[2];
} reach_t;

static reach_t reach_of(const chart_t *c, int32_t j, int32_t lo, int32_t hi) {
    const across_t row = across_of(c, j);
    const int32_t nx = c->grid->nx, sign = abscissa(c, row, 0) <= abscissa(c, row, nx - 1) ? 1 : -1;
    const int32_t met = columns_before(c, row, sign, sign > 0 ? lo : hi);
    const int32_t left = columns_before(c, row, sign, (sign > 0 ? hi : lo) + sign);
    return sign > 0 ? (reach_t){{met, 0}, {nx, left}} : (reach_t){{0, met}, {left, nx}};
}

static reach_t join(reach_t a, reach_t b) {
    for (int k = 0; k < 2; k++) {
        a.first[k] = pencil_min(a.first[k], b.first[k]);
        a.end[k] = pencil_max(a.end[k], b.end[k]);
    }
    return a;
}

/* A facet reaches into the stretch if one of its corners is at its beginning or beyond, and one at its end or before.
 * Both facets' rows at a row of points are looked at as one: r is joined from three. */
static void set_columns(const chart_t *c, reach_t r, chart_line_t *line) {
    line->first = pencil_max(pencil_max(r.first[0], r.first[1]) - 1, 0);
    line->last = pencil_min(pencil_min(r.end[0], r.end[1]), c->grid->nx - 1);
}

static void find_columns(const chart_t *c, int32_t j, int32_t lo, int32_t hi, chart_line_t *line) {
    reach_t r = reach_of(c, j, lo, hi);
    if (j > 0) r = join(r, reach_of(c, j - 1, lo, hi));
    if (j + 1 < c->grid->ny) r = join(r, reach_of(c, j + 1, lo, hi));
    set_columns(c, r, line);
}

int32_t chart_columns_over(const chart_t *c, int32_t lo, int32_t hi) {
    int32_t most = 0;
    if (c->kind >= CHART_AROUND) return c->grid->nx;
    reach_t before = reach_of(c, 0, lo, hi), at = before;
    for (int32_t j = 0; j < c->grid->ny; j++) {
        const reach_t after = j + 1 < c->grid->ny ? reach_of(c, j + 1, lo, hi) : at;
        chart_line_t line;
        set_columns(c, join(join(before, at), after), &line);
        most = pencil_max(most, line.last - line.first + 1);
        before = at;
        at = after;
    }
    return most;
}

/* line->first and last are set, and line->at[first] is where its memory begins. */
static void fill_row(const chart_t *c, grid_t *g, int32_t j, chart_line_t *line) {
    const num_t y = y_at(c, j);
    const int32_t nx = c->grid->nx, columns = line->last - line->first + 1;
    const bool plane = c->kind == CHART_NORTH || c->kind == CHART_EAST;
    line->j = j;
    if (c->kind == CHART_AROUND) {
        chart_around_row(c, g, j, y, line);
        line->in_plane = pencil_abs(line->dy) <= CHART_IN_PLANE;
        return;
    }
    const rise_t rise = rise_of(c, g, plane ? c->plane.z_ref : c->z_ref);
    /* Where heights are not kept they come packed into the upper half of the row's points. */
    pencil_t *at = line->at + line->first;
    int32_t *packed = (int32_t *)(void *)at + columns;
    const int32_t *zi = columns == nx && line->hole == NULL ? grid_kept_row(g, j) : NULL;
    if (zi == NULL) {
        zi = packed;
        if (columns == nx)
            grid_row(g, j, packed, line->hole);
        else
            for (int32_t i = 0; i < columns; i++) grid_height(g, line->first + i, j, &packed[i]);
    }
    switch (c->kind) {
    case CHART_PARALLEL:
        row_parallel(c, &rise, y, zi, line);
        break;
    case CHART_VERTICAL:
        memset(at, 0, (size_t)columns * sizeof *at);
        break;
    case CHART_NORTH:
        row_north(c, &rise, y, zi, line);
        break;
    case CHART_EAST:
        row_east(c, &rise, y, zi, line);
        break;
    case CHART_AROUND:
        break;
    }
}

void chart_row(const chart_t *c, grid_t *g, int32_t j, chart_line_t *line) {
    const int32_t nx = c->grid->nx;
    line->at += line->first;
    line->first = 0;
    line->last = nx - 1;
    fill_row(c, g, j, line);
    if (c->kind != CHART_AROUND) line->in_plane = pencil_abs(line->at[nx - 1].a - line->at[0].a) <= CHART_IN_PLANE;
}

void chart_row_over(const chart_t *c, grid_t *g, int32_t j, int32_t lo, int32_t hi, chart_line_t *line) {
    if (c->kind >= CHART_AROUND) {
        chart_row(c, g, j, line);
        return;
    }
    pencil_t *mem = line->at + line->first;
    find_columns(c, j, lo, hi, line);
    line->at = mem - line->first;
    fill_row(c, g, j, line);
    const across_t row = across_of(c, j);
    line->in_plane = pencil_abs(abscissa(c, row, c->grid->nx - 1) - abscissa(c, row, 0)) <= CHART_IN_PLANE;
}

int64_t chart_unproject(int32_t u_q30, uint32_t g0, uint32_t g1) {
    if (g0 == g1 || u_q30 <= 0 || u_q30 >= (1 << 30)) return (int64_t)u_q30 << 16;
    uint64_t n = (uint64_t)(uint32_t)u_q30 * g1, d = n + (uint64_t)((UINT32_C(1) << 30) - (uint32_t)u_q30) * g0, rest;
    if (g0 >> 4 <= g1 && g1 >> 4 <= g0) return (int64_t)pencil_fraction(n, d) << 16;
    return (int64_t)wide_div_u64(n >> 18, n << 46, d, &rest);
}
