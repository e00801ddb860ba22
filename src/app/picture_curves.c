/* picture_curves.c - flat curves of `plot` in a frame with tics. */
#include "app/picture_stages.h"

#include "error.h"
#include "view/autoscale.h"

/* The range of all curves' points that count: y of points inside the x range. */
static int measure(const plot_t *plot, num_t lo[2], num_t hi[2]) {
    bool any = false;
    for (int32_t k = 0; k < plot->n; k++) {
        const curve_t *c = &plot->item[k].curve;
        for (int32_t i = 0; i < c->n; i++) {
            const num_t v[2] = {c->x_of(c->ctx, i), c->y_of(c->ctx, i)};
            if (v[1].undef) continue;
            for (int axis = 0; axis < 2; axis++) {
                if (!any || num_cmp(v[axis], lo[axis]) < 0) lo[axis] = v[axis];
                if (!any || num_cmp(v[axis], hi[axis]) > 0) hi[axis] = v[axis];
            }
            any = true;
        }
    }
    return any ? 0 : ERR_EMPTY;
}

int picture_curves(picture_t *p, const pen_sink_t *pen) {
    const plot_t *plot = p->plot;
    const settings_t *s = plot->settings;
    num_t lo[2], hi[2];
    int err = measure(plot, lo, hi);
    if (!err) err = autoscale_range(&s->x, autoscale_tics(s, 0), &lo[0], &hi[0]);
    if (!err) err = autoscale_range(&s->y, autoscale_tics(s, 1), &lo[1], &hi[1]);
    if (!err) err = camera_flat(&p->camera, s, lo, hi);
    if (err) return err;
    if (p->hooks && p->hooks->begin) p->hooks->begin(p->hooks->ctx, &p->camera);
    flat_axes_setup(&p->axes, s, &p->camera.window, lo, hi);
    int64_t points = 0;
    for (int32_t k = 0; k < plot->n; k++) {
        flat_curve_setup(&p->curve[k], &p->axes, &plot->item[k].curve);
        p->lines[k] = p->curve[k].lines;
        points += plot->item[k].curve.n;
    }
    p->lines[plot->n] = p->axes.frame;
    p->spaces = plot->n + 1;
    err = picture_open(p, pen, 1, 2 * points + 256);
    if (!err) err = flat_axes_draw(&p->axes, (uint8_t)plot->n, &p->sink);
    for (int32_t k = 0; !err && k < plot->n; k++) err = flat_curve_draw(&p->curve[k], (uint8_t)k, &p->sink);
    p->stats.facets = points - plot->n;
    p->stats.evaluated = points;
    return err ? err : picture_close(p);
}
