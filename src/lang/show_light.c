/* show_light.c - pens and lights, in the words of `set pen` and `set light`. */
#include "lang/session_parts.h"

#if CONFIG_AREA
void show_pens(text_t *t, const settings_t *set) {
    bool same = true;
    for (int k = 1; k < LINE_CLASSES; k++) same &= set->pen[k] == set->pen[0];
    text_add(t, "set pen");
    for (int k = 0; k < (same ? 1 : LINE_CLASSES); k++) {
        text_add(t, " ");
        if (!same) text_add(t, set_pen_class(k));
        if (!same) text_add(t, " ");
        text_add_int(t, set->pen[k]);
    }
    text_add(t, "\n");
}

void show_lights(text_t *t, const settings_t *set) {
    bool several = !set->light[0].on;
    for (int k = 1; k < LIGHTS_MAX; k++) several |= set->light[k].on;
    if (several) text_add(t, "unset light; unset light 1\n");
    for (int k = 0; k < LIGHTS_MAX; k++) {
        if (!set->light[k].on) continue;
        text_add(t, "set light ");
        if (several) text_add_int(t, k + 1);
        if (several) text_add(t, " ");
        if (set->light[k].point) text_add(t, "from ");
        for (int i = 0; i < 3; i++) show_value(t, i ? "," : "", set->light[k].milli[i], 3);
        text_add(t, "\n");
    }
}
#endif
