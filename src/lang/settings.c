/* settings.c - what holds before anything was set. */
#include "lang/settings.h"

void settings_default(settings_t *s) {
    *s = (settings_t){0};
    const range_t all = {.auto_lo = true, .auto_hi = true};
    const num_t one = num_from_i64(1);
    s->x = s->y = s->z = all;
    s->samples[0] = s->samples[1] = 100;
    s->isosamples[0] = s->isosamples[1] = 10;
    s->hidden = HIDDEN_PERIMETER;
    s->halo_um = 500;
#if CONFIG_AREA
    s->light[0].on = true;
    s->light[0].milli[0] = -1000;
    s->light[0].milli[1] = -2000;
    s->light[0].milli[2] = 3000;
    for (int k = 0; k < LINE_CLASSES; k++) s->pen[k] = 1;
#endif
    s->view.rot_x = num_from_i64(60);
    s->view.rot_z = num_from_i64(30);
    s->view.scale = s->view.zscale = one;
    s->xyplane = num_ldexp(one, -1);
    s->border_base = true;
    s->tics = SETTINGS_TICS_ALL;
    s->paper.width_um = 297000;
    s->paper.height_um = 210000;
    s->paper.margin_um = 10000;
    machine_default(&s->machine);
}
