/* trace_path.c - see trace_path.h. */
#include "host/trace_path.h"
#include <stdlib.h>

void trace_path_page(const machine_t *m, const double motor[2], double page_mm[2]) {
    double a = motor[0] * 65536 / m->steps_per_mm_q16[0], b = motor[1] * 65536 / m->steps_per_mm_q16[1];
    if (m->invert[0]) a = -a;
    if (m->invert[1]) b = -b;
    double u = a, v = b;
    if (m->kinematics == MACHINE_COREXY) {
        u = (a + b) / 2;
        v = (a - b) / 2;
    }
    page_mm[0] = m->swap_xy ? v : u;
    page_mm[1] = m->swap_xy ? u : v;
}

bool trace_knots_add(trace_knots_t *k, double time_s, double pos) {
    if (k->count == k->room) {
        size_t room = k->room ? k->room * 2 : 1024;
        double *t = realloc(k->time_s, room * sizeof *t);
        if (!t) return false;
        k->time_s = t;
        double *p = realloc(k->pos, room * sizeof *p);
        if (!p) return false;
        k->pos = p;
        k->room = room;
    }
    k->time_s[k->count] = time_s;
    k->pos[k->count++] = pos;
    return true;
}

double trace_knots_at(const trace_knots_t *k, size_t *cursor, double time_s) {
    if (k->count == 0) return 0;
    while (*cursor < k->count && k->time_s[*cursor] <= time_s) ++*cursor;
    size_t i = *cursor; /* the first knot after time_s */
    if (i == 0) return k->pos[0];
    if (i == k->count) return k->pos[i - 1];
    double t0 = k->time_s[i - 1], t1 = k->time_s[i];
    return k->pos[i - 1] + (k->pos[i] - k->pos[i - 1]) * (time_s - t0) / (t1 - t0);
}

void trace_knots_free(trace_knots_t *k) {
    free(k->time_s);
    free(k->pos);
    *k = (trace_knots_t){0};
}
