/* plot_bounds.c - ranges whose autoscaled ends are bounded, as [0<*<2:*<9]: with the data at hand, an end that they
 * would put outside of its bounds becomes a fixed one. Bodies and points on no grid are taken as they are. */
#include "lang/session_parts.h"

#if CONFIG_BOUNDED
/* An autoscaled end that the data would put outside of its bounds is fixed there. */
static void bound_range(range_t *r, const num_t extent[2]) {
    for (int high = 0; high < 2; high++) {
        const num_t *least = &r->bound[2 * high], *most = least + 1;
        bool *open = high ? &r->auto_hi : &r->auto_lo;
        num_t *end = high ? &r->hi : &r->lo;
        if (!*open) continue;
        if ((r->bounded >> 2 * high & 1) && num_cmp(extent[high], *least) < 0)
            *end = *least;
        else if ((r->bounded >> 2 * high & 2) && num_cmp(extent[high], *most) > 0)
            *end = *most;
        else
            continue;
        *open = false;
    }
}

static bool take_in(num_t extent[2], num_t v, bool any) {
    if (v.undef) return any;
    if (!any || num_cmp(v, extent[0]) < 0) extent[0] = v;
    if (!any || num_cmp(v, extent[1]) > 0) extent[1] = v;
    return true;
}

/* The heights of all grids and curves; false: there are none. */
static bool heights(const session_t *s, int32_t n, num_t extent[2]) {
    bool any = false;
    for (int32_t k = 0; k < n; k++) {
        const plot_item_t *item = &s->plot.item[k];
        const surface_t *f = &item->surface;
        if (item->solid) continue;
        if (s->plot.kind == PLOT_CURVES) {
            for (int32_t i = 0; i < item->curve.n; i++)
                any = take_in(extent, item->curve.y_of(item->curve.ctx, i), any);
            continue;
        }
        for (int32_t j = 0; j < f->ny; j++)
            for (int32_t i = 0; i < f->nx; i++) any = take_in(extent, f->z_of(f->ctx, i, j), any);
    }
    return any;
}
int plot_items_in_bounds(session_t *s) {
    const int axes = s->plot.kind == PLOT_CURVES ? 1 : 2;
    num_t extent[2];
    for (int k = 0; k < axes; k++)
        if (s->plot.range[k].bounded) {
            plot_extent(s, k, extent);
            bound_range(&s->plot.range[k], extent);
        }
    const int n = plot_items(s);
    if (n > 0 && s->plot.range[axes].bounded && heights(s, n, extent)) bound_range(&s->plot.range[axes], extent);
    return n;
}
#endif
