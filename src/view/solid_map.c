/* solid_map.c - see solid_map.h. */
#include "view/solid_map.h"

#include "error.h"
#include "num/ints.h"
#include "num/wide.h"
#include "view/cut.h"

#define ROW_BITS 62 /* of the coefficients that a lattice coordinate is multiplied by */

static bool lines_at(void *ctx, uint8_t family, int32_t line, int64_t t_q30, page_h_t *h) {
    (void)family;
    const solid_map_t *m = ctx;
    const solid_edge_t *e = &m->solid->edge[line];
    if (t_q30 == INK_ONE) {
        *h = solid_map_vertex(m, e->v[1]);
        return true;
    }
    *h = solid_map_vertex(m, e->v[0]);
    if (t_q30 == 0) return true;
    page_h_t to = solid_map_vertex(m, e->v[1]);
    *h = line_space_mix(h, &to, (int32_t)t_q30);
    return true;
}

/* Row r of the camera on the lattice: shares of the coordinates, and what is there at the origin. */
static void lattice_row(const solid_map_t *m, int r, num_t out[4]) {
    const solid_t *s = m->solid;
    out[3] = m->cam->m[r][3];
    for (int k = 0; k < 3; k++) {
        out[3] = num_add(out[3], num_mul(m->cam->m[r][k], s->origin[k]));
        out[k] = num_ldexp(m->cam->m[r][k], -s->shift);
    }
}

/* The most fractional bits with which |a| < 2^bits. */
static int32_t bits_for(const num_t *a, int n, int bits) {
    int32_t most = INT32_MIN;
    for (int k = 0; k < n; k++)
        if (a[k].m != 0 && a[k].e + 63 > most) most = a[k].e + 63;
    return most == INT32_MIN ? 0 : bits - most;
}

/* A row of a parallel view in 32 bits: (by . v + rest) / 2^shift. */
typedef struct quick_row {
    int32_t by[3], shift;
    int64_t rest;
} quick_row_t;

#define QUICK_BITS 30  /* of coefficients */
#define QUICK_LEAST 32 /* bits below a lat: three coefficients rounded to halves times 2^27 are a twentieth of one */

/* Returns whether the quick rows will do, of which the first two are set. */
static bool setup_rows(solid_map_t *m, quick_row_t quick[3]) {
    const int32_t frac_bits = m->lines.frac_bits;
    const int rows = m->cam->perspective ? 3 : 2;
    bool enough = rows == 2;
    m->row[2][3] = enough ? (int64_t)1 << frac_bits : 0;
    for (int r = 0; r < rows; r++) {
        num_t row[4];
        lattice_row(m, r, row);
        /* coefficients as fine as they fit, but not finer than the result needs: 2^-32 of its units */
        int32_t bits = bits_for(row, 3, ROW_BITS), shift = bits - ROW_BITS + QUICK_BITS;
        if (bits > frac_bits + SOLID_BITS + 4) bits = frac_bits + SOLID_BITS + 4;
        if (bits < frac_bits) bits = frac_bits; /* far beyond any use; camera_scale has seen to it */
        m->row_bits[r] = bits - frac_bits;
        if (shift > frac_bits) shift = frac_bits; /* sums fit */
        enough = enough && shift >= QUICK_LEAST;
        for (int k = 0; k < 4; k++) {
            m->row[r][k] = num_to_fixed(row[k], k < 3 ? bits : frac_bits, NULL);
            if (!enough) continue;
            const int64_t a = num_to_fixed(row[k], shift, NULL);
            if (k < 3)
                quick[r].by[k] = (int32_t)a;
            else
                quick[r].rest = a + ((int64_t)1 << (shift - 1));
        }
        quick[r].shift = shift;
    }
    return enough;
}

static int setup_eye(solid_map_t *m) {
    const solid_t *s = m->solid;
    num_t e[3];
    for (int k = 0; k < 3; k++) {
        num_t from = m->cam->perspective ? num_sub(m->cam->eye[k], s->origin[k]) : m->cam->eye[k];
        e[k] = num_ldexp(from, s->shift);
    }
    int32_t bits = bits_for(e, 3, SOLID_EYE_BITS);
    /* p w has to be as small as e */
    if (m->cam->perspective && bits > SOLID_EYE_BITS - SOLID_BITS) bits = SOLID_EYE_BITS - SOLID_BITS;
    for (int k = 0; k < 3; k++) m->eye.e[k] = num_to_fixed(e[k], bits, NULL);
    /* An eye farther away than 2^50 lattice units sees what a parallel view shows. */
    m->eye.w = m->cam->perspective && bits >= 0 ? (int64_t)1 << bits : 0;
    return m->eye.e[0] == 0 && m->eye.e[1] == 0 && m->eye.e[2] == 0 && m->eye.w == 0 ? ERR_VALUE : 0;
}

/* Parallel: depth is against the direction to the eye. */
static void setup_depth(solid_map_t *m, quick_row_t *quick) {
    uint64_t most = 0;
    for (int k = 0; k < 3; k++) {
        uint64_t a = ints_abs64(m->eye.e[k]);
        most = a > most ? a : most;
    }
    m->z_shift = (most ? 64 - ints_clz64(most) : 0) + SOLID_BITS + 1 - SOLID_Z_BITS; /* three products of 2^27 */
    const int32_t drop = SOLID_EYE_BITS - QUICK_BITS;
    for (int k = 0; k < 3; k++) {
        m->z_row[k] = -m->eye.e[k];
        quick->by[k] = (int32_t)(m->z_row[k] >> drop);
    }
    quick->shift = m->z_shift - drop;
    quick->rest = 0;
}

/* The lower half of a / 2^n, rounded down; 0 < n < 64. */
static inline int64_t low_sar(wide_t a, int32_t n) {
    return (int64_t)(a.lo >> n | (uint64_t)a.hi << (64 - n));
}

static inline int64_t row_times(const solid_map_t *m, int r, const solid_vertex_t *v) {
    const int64_t *a = m->row[r];
    const int32_t bits = m->row_bits[r]; /* at most SOLID_BITS + 4 */
    wide_t sum = wide_dot3(a, v->at);
    if (bits > 0) sum.lo = (uint64_t)low_sar(wide_add(sum, (wide_t){0, (uint64_t)1 << (bits - 1)}), bits);
    return (int64_t)(sum.lo + (uint64_t)a[3]);
}

int64_t solid_map_fine(const solid_map_t *m, int32_t v) {
    const solid_vertex_t *p = &m->solid->vertex[v];
    wide_t sum = wide_dot3(m->lines.perspective ? m->row[2] : m->z_row, p->at);
    int32_t drop = m->lines.perspective ? m->row_bits[2] - SOLID_FINE_E : m->z_shift - (SOLID_FINE_Z - SOLID_Z_BITS);
    sum = drop > 0 ? wide_sar(wide_add(sum, wide_shl((wide_t){0, 1}, drop - 1)), drop) : wide_shl(sum, -drop);
    uint64_t rest = m->lines.perspective ? (uint64_t)m->row[2][3] << SOLID_FINE_E : 0;
    return (int64_t)(sum.lo + rest);
}

page_h_t solid_map_vertex(const solid_map_t *m, int32_t v) {
    const solid_vertex_t *p = &m->solid->vertex[v];
    page_h_t h = {row_times(m, 0, p), row_times(m, 1, p), m->row[2][3]};
    if (m->lines.perspective) h.e = row_times(m, 2, p);
    return h;
}

static int32_t limit(int64_t a) {
    return a < -SOLID_PLACE_MOST ? -SOLID_PLACE_MOST : a > SOLID_PLACE_MOST ? SOLID_PLACE_MOST : (int32_t)a;
}

static int32_t perspective_depth(const solid_map_t *m, int64_t e) {
    /* near_e <= e, so 1/e in (0, 1/near_e] */
    return -(int32_t)ints_muldiv_round(m->lines.near_e, (int64_t)1 << SOLID_Z_BITS, e);
}

/* Where E is one and all is in front of the eye. */
static inline int32_t place_flat(const solid_map_t *m, int64_t x) {
    return limit((x + ((int64_t)1 << (m->lines.frac_bits - 1))) >> m->lines.frac_bits);
}

static solid_place_t place_of(const solid_map_t *m, const page_h_t *h) {
    if (!m->lines.perspective) return (solid_place_t){place_flat(m, h->x), place_flat(m, h->y), 0};
    return (solid_place_t){limit(ints_div_round(h->x, h->e)), limit(ints_div_round(h->y, h->e)),
                           perspective_depth(m, h->e)};
}

static solid_place_t place_vertex(const solid_map_t *m, int32_t v) {
    page_h_t h = solid_map_vertex(m, v);
    if (h.e < m->lines.near_e) return (solid_place_t){0, 0, INT32_MIN};
    solid_place_t p = place_of(m, &h);
    if (!m->lines.perspective) p.z = (int32_t)low_sar(wide_dot3(m->z_row, m->solid->vertex[v].at), m->z_shift);
    return p;
}

static inline int64_t quick_times(const quick_row_t *q, const int32_t v[3]) {
    const int64_t sum = wide_mul_s32(q->by[0], v[0]) + wide_mul_s32(q->by[1], v[1]) + wide_mul_s32(q->by[2], v[2]);
    return (sum + q->rest) >> q->shift;
}

/* All vertices of a parallel view of usual size; none is beyond the limit. */
static void place_quickly(const solid_map_t *m, const quick_row_t row[3]) {
    solid_place_t *p = m->place;
    for (const solid_vertex_t *v = m->solid->vertex, *end = v + m->solid->nv; v < end; v++, p++) {
        p->x = (int32_t)quick_times(&row[0], v->at);
        p->y = (int32_t)quick_times(&row[1], v->at);
        p->z = (int32_t)quick_times(&row[2], v->at);
    }
}

bool solid_place_is_good(const solid_place_t *p) {
    return p->z != INT32_MIN && p->x > -SOLID_PLACE_MOST && p->x < SOLID_PLACE_MOST && p->y > -SOLID_PLACE_MOST &&
           p->y < SOLID_PLACE_MOST;
}

int solid_map_setup(solid_map_t *m, const solid_t *solid, const camera_t *cam, void *place) {
    *m = (solid_map_t){.solid = solid, .cam = cam, .place = place};
    int err = camera_scale(cam, solid->lo, solid->hi, &m->lines);
    if (err) return err;
    m->lines.ctx = m;
    m->lines.at = lines_at;
    err = setup_eye(m);
    if (err) return err;
    quick_row_t quick[3];
    m->all_good = setup_rows(m, quick);
    setup_depth(m, &quick[2]);
    if (m->all_good) {
        place_quickly(m, quick);
        return 0;
    }
    bool all_good = true;
    for (int32_t v = 0; v < solid->nv; v++) {
        m->place[v] = place_vertex(m, v);
        m->any_behind |= solid_map_is_behind(m, v);
        all_good = all_good && solid_map_is_good(m, v);
    }
    m->all_good = all_good;
    return 0;
}

#define AROUND_LAT (1 << 20) /* edges end so far outside of the window, 32 mm: ink is cut to it exactly */
#define AROUND_MOST ((1 << 25) - 1)

static page_window_t around_window(const page_window_t *w) {
    const page_window_t out = {w->x0_lat - AROUND_LAT, w->y0_lat - AROUND_LAT, w->x1_lat + AROUND_LAT,
                               w->y1_lat + AROUND_LAT};
    return (page_window_t){
        out.x0_lat < -AROUND_MOST ? -AROUND_MOST : out.x0_lat, out.y0_lat < -AROUND_MOST ? -AROUND_MOST : out.y0_lat,
        out.x1_lat > AROUND_MOST ? AROUND_MOST : out.x1_lat, out.y1_lat > AROUND_MOST ? AROUND_MOST : out.y1_lat};
}

bool solid_map_edge(const solid_map_t *m, int32_t edge, solid_place_t end[2], int64_t t_q30[2], int32_t *off_lat) {
    const solid_edge_t *e = &m->solid->edge[edge];
    for (int k = 0; k < 2; k++) {
        end[k] = m->place[e->v[k]];
        t_q30[k] = k * INK_ONE;
    }
    *off_lat = 0;
    if (solid_map_is_good(m, e->v[0]) && solid_map_is_good(m, e->v[1])) return true;
    const page_window_t around = around_window(m->lines.window);
    const page_h_t h[2] = {solid_map_vertex(m, e->v[0]), solid_map_vertex(m, e->v[1])};
    int64_t near[2] = {0, INK_ONE};
    if (!cut_between(&m->lines, &around, &h[0], &h[1], &near[0], &near[1])) return false;
    for (int k = 0; k < 2; k++) {
        const bool behind = solid_map_is_behind(m, e->v[k]);
        /* halved, the difference of opposite signs fits */
        const int64_t t =
            behind ? ints_muldiv_round(INK_ONE, h[!k].e / 2 - m->lines.near_e / 2, h[!k].e / 2 - h[k].e / 2) : 0;
        if (behind) t_q30[k] = k ? t : INK_ONE - t;
        if (near[k] == k * INK_ONE) continue;
        page_h_t cut = line_space_mix(&h[0], &h[1], (int32_t)near[k]);
        if (cut.e < m->lines.near_e) cut.e = m->lines.near_e; /* rounded to the wrong side */
        solid_place_t p = place_of(m, &cut);
        const int64_t far = (p.x < 0 ? -(int64_t)p.x : p.x) + (p.y < 0 ? -(int64_t)p.y : p.y);
        const int32_t off = (int32_t)(far / cut.e) + 2;
        if (off > *off_lat) *off_lat = off;
        if (!behind) p.z = end[k].z;
        end[k] = p;
    }
    return t_q30[0] < t_q30[1];
}
