/* show_machine.c - the machine, in the words of `set machine`. */
#include "lang/session_parts.h"

void show_value(text_t *t, const char *word, int64_t v, int decimals) {
    text_add(t, word);
    text_add_scaled(t, v, decimals);
}

void show_machine(session_t *s, text_t *t) {
    const machine_t *m = &s->settings.machine;
    text_add(t, "set machine steps ");
    for (int k = 0; k < 2; k++) {
        if (k) text_add(t, ",");
        text_add_num(t, num_from_fixed(m->steps_per_mm_q16[k], 16));
    }
    show_value(t, " speed ", m->draw_speed_um_s, 3);
    show_value(t, " travel ", m->travel_speed_um_s, 3);
    show_value(t, " accel ", m->accel_um_s2, 3);
    show_value(t, " junction ", m->junction_um, 3);
    show_value(t, " lift ", m->lift_us, 6);
    show_value(t, " lower ", m->lower_us, 6);
    show_value(t, " enable ", m->enable_us, 6);
    text_add(t, "\nset machine"); /* a line that the smallest board takes back */
    show_value(t, " pulse ", m->pulse_ns, 3);
    show_value(t, " setup ", m->dir_setup_ns, 3);
    text_add(t, m->swap_xy ? " swap" : " noswap");
    text_add(t, m->kinematics == MACHINE_COREXY ? " corexy" : " cartesian");
    if (m->width_um || m->height_um) {
        show_value(t, " size ", m->width_um, 3);
        show_value(t, ",", m->height_um, 3);
    } else {
        text_add(t, " size none");
    }
    text_add(t, "\n");
}
