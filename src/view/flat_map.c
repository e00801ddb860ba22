/* flat_map.c - see flat_map.h. */
#include "view/flat_map.h"

#include "view/autoscale.h"

#include <stddef.h>

#define FRAC_BITS 26 /* 2^25 lat of paper leave room for curves that shoot far past it */
#define FAR ((int64_t)1 << 59)

static int64_t saturate(num_t lat) {
    int64_t v = num_to_fixed(lat, FRAC_BITS, NULL);
    return v > FAR ? FAR : v < -FAR ? -FAR : v;
}

static int64_t axis_lat(const flat_axes_t *a, int k, num_t v) {
    int32_t origin = k == 0 ? a->window.x0_lat : a->window.y0_lat;
    return saturate(num_add(num_mul(num_sub(v, a->lo[k]), a->scale[k]), num_from_i64(origin)));
}

static int64_t fixed_lat(int32_t lat) {
    return (int64_t)lat << FRAC_BITS;
}

/* Vertex `at` of frame line `line`. */
static page_h_t frame_vertex(const flat_axes_t *a, int32_t line, int32_t at) {
    const page_window_t *w = &a->window;
    page_h_t h = {.e = (int64_t)1 << FRAC_BITS};
    if (line == 0) {
        h.x = fixed_lat(at == 1 || at == 2 ? w->x1_lat : w->x0_lat);
        h.y = fixed_lat(at == 2 || at == 3 ? w->y1_lat : w->y0_lat);
        return h;
    }
    int32_t n = line - 1;
    int axis = n < 2 * a->tics[0] ? 0 : 1;
    if (axis) n -= 2 * a->tics[0];
    bool far_side = n >= a->tics[axis];
    if (far_side) n -= a->tics[axis];
    num_t v = num_add(a->first[axis], num_mul(a->step[axis], num_from_i64(n)));
    int64_t along = axis_lat(a, axis, v);
    int32_t tic = (int32_t)((int64_t)FLAT_TIC_UM * LAT_PER_MM / 1000) * at;
    int32_t edge =
        axis == 0 ? (far_side ? w->y1_lat - tic : w->y0_lat + tic) : (far_side ? w->x1_lat - tic : w->x0_lat + tic);
    h.x = axis == 0 ? along : fixed_lat(edge);
    h.y = axis == 0 ? fixed_lat(edge) : along;
    return h;
}

static bool frame_at(void *ctx, uint8_t family, int32_t line, int64_t t_q30, page_h_t *h) {
    (void)family;
    int32_t at = (int32_t)(t_q30 >> 30), s = (int32_t)(t_q30 & (INK_ONE - 1));
    *h = frame_vertex(ctx, line, at);
    if (s) {
        page_h_t next = frame_vertex(ctx, line, at + 1);
        *h = line_space_mix(h, &next, s);
    }
    return true;
}

void flat_axes_setup(flat_axes_t *a, const settings_t *s, const page_window_t *window, const num_t lo[2],
                     const num_t hi[2]) {
    *a = (flat_axes_t){.window = *window};
    const int32_t size[2] = {window->x1_lat - window->x0_lat, window->y1_lat - window->y0_lat};
    for (int k = 0; k < 2; k++) {
        num_t span = num_sub(hi[k], lo[k]);
        a->lo[k] = lo[k];
        a->hi[k] = hi[k];
        a->scale[k] = num_div(num_from_i64(size[k]), span);
        a->step[k] = autoscale_step(span, autoscale_tics(s, k) == AUTOSCALE_LOG);
        a->first[k] = num_mul(num_ceil(num_div(lo[k], a->step[k])), a->step[k]);
        num_t room = num_floor(num_div(num_sub(hi[k], a->first[k]), a->step[k]));
        a->tics[k] = (int32_t)num_to_fixed(room, 0, NULL) + 1;
    }
    a->frame = (line_space_t){
        .ctx = a, .at = frame_at, .window = &a->window, .all_inside = true, .frac_bits = FRAC_BITS, .near_e = 1};
}

int flat_axes_draw(const flat_axes_t *a, uint8_t surface, const ink_sink_t *sink) {
    int32_t lines = 1 + 2 * (a->tics[0] + a->tics[1]);
    for (int32_t k = 0; k < lines; k++) {
        ink_piece_t p = {.family = INK_CURVE, .surface = surface, .line = k, .to = k == 0 ? 4 * INK_ONE : INK_ONE};
        int err = sink->piece(sink->ctx, &p);
        if (err) return err;
    }
    return 0;
}

static bool curve_vertex(const flat_curve_t *c, int32_t i, page_h_t *h) {
    num_t y = c->curve->y_of(c->curve->ctx, i);
    if (y.undef) return false;
    h->x = axis_lat(c->axes, 0, c->curve->x_of(c->curve->ctx, i));
    h->y = axis_lat(c->axes, 1, y);
    h->e = (int64_t)1 << FRAC_BITS;
    return true;
}

static bool curve_at(void *ctx, uint8_t family, int32_t line, int64_t t_q30, page_h_t *h) {
    (void)family, (void)line;
    int32_t at = (int32_t)(t_q30 >> 30), s = (int32_t)(t_q30 & (INK_ONE - 1));
    if (!curve_vertex(ctx, at, h)) return false;
    page_h_t next;
    if (s == 0) return true;
    if (!curve_vertex(ctx, at + 1, &next)) return false;
    *h = line_space_mix(h, &next, s);
    return true;
}

void flat_curve_setup(flat_curve_t *c, const flat_axes_t *axes, const curve_t *curve) {
    *c = (flat_curve_t){.axes = axes, .curve = curve};
    c->lines = (line_space_t){.ctx = c, .at = curve_at, .window = &axes->window, .frac_bits = FRAC_BITS, .near_e = 1};
}

int flat_curve_draw(const flat_curve_t *c, uint8_t surface, const ink_sink_t *sink) {
    int32_t start = -1;
    for (int32_t i = 0; i <= c->curve->n; i++) {
        bool defined = i < c->curve->n && !c->curve->y_of(c->curve->ctx, i).undef;
        if (defined && start < 0) start = i;
        if (defined || start < 0) continue;
        if (i - 1 > start) {
            ink_piece_t p = {.family = INK_CURVE, .surface = surface, .from = start * INK_ONE, .to = (i - 1) * INK_ONE};
            int err = sink->piece(sink->ctx, &p);
            if (err) return err;
        }
        start = -1;
    }
    return 0;
}
