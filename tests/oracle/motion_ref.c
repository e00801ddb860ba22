/* motion_ref.c - see motion_ref.h. */
#include "tests/oracle/motion_ref.h"
#include <math.h>
#include <stdlib.h>

/* Angle by which b turns from a, 0..pi. */
static double turn(const double a[2], const double b[2]) {
    return fabs(atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]));
}

static double corner_speed(double angle, double before, double after, const motion_ref_limits_t *l) {
    if (angle < 2e-8) return l->speed; /* straight, but for rounding */
    double s = sin((acos(-1) - angle) / 2);
    double by_junction = sqrt(l->accel * l->junction * s / (1 - s));
    double by_radius = sqrt(l->accel * (before + after) / (4 * tan(angle / 2)));
    return fmin(l->speed, fmin(by_junction, by_radius));
}

double motion_ref_run(const motion_ref_point_t *p, size_t n, const motion_ref_limits_t *l, motion_ref_line_t *out) {
    if (n < 2) return 0;
    motion_ref_line_t *line = out ? out : malloc((n - 1) * sizeof *line);
    double *v = calloc(n, sizeof *v); /* at the vertices */
    double last[2] = {0, 0}, last_length = 0;
    for (size_t i = 0; i + 1 < n; i++) {
        double d[2] = {p[i + 1].x - p[i].x, p[i + 1].y - p[i].y}, length = hypot(d[0], d[1]);
        line[i].length = length;
        if (i && length > 0 && last_length > 0)
            v[i] = corner_speed(turn(last, d), last_length, length, l);
        else if (i && last_length > 0)
            v[i] = l->speed;
        if (length > 0) {
            last[0] = d[0], last[1] = d[1];
            last_length = length;
        }
    }
    v[n - 1] = 0;
    for (size_t i = n - 1; i-- > 0;) v[i] = fmin(v[i], sqrt(v[i + 1] * v[i + 1] + 2 * l->accel * line[i].length));
    double time = 0;
    for (size_t i = 0; i + 1 < n; i++) {
        motion_ref_line_t *k = &line[i];
        v[i + 1] = fmin(v[i + 1], sqrt(v[i] * v[i] + 2 * l->accel * k->length));
        k->v_in = v[i];
        k->v_out = v[i + 1];
        k->v_top = fmin(l->speed, sqrt((v[i] * v[i] + v[i + 1] * v[i + 1]) / 2 + l->accel * k->length));
        k->start_s = time;
        time = motion_ref_when(k, l->accel, k->length);
    }
    free(v);
    if (!out) free(line);
    return time;
}

double motion_ref_when(const motion_ref_line_t *k, double accel, double s) {
    double rise = (k->v_top * k->v_top - k->v_in * k->v_in) / (2 * accel);
    double fall = (k->v_top * k->v_top - k->v_out * k->v_out) / (2 * accel);
    if (s < rise) return k->start_s + (sqrt(k->v_in * k->v_in + 2 * accel * s) - k->v_in) / accel;
    double t = k->start_s + (k->v_top - k->v_in) / accel;
    double hold = fmax(k->length - rise - fall, 0);
    if (s < rise + hold) return t + (s - rise) / k->v_top;
    if (hold > 0) t += hold / k->v_top;
    double left = fmax(k->length - s, 0);
    return t + (k->v_top - sqrt(k->v_out * k->v_out + 2 * accel * left)) / accel;
}

double motion_ref_where(const motion_ref_line_t *k, double accel, double t) {
    double lo = 0, hi = k->length;
    for (int i = 0; i < 50; i++) {
        double middle = (lo + hi) / 2;
        if (motion_ref_when(k, accel, middle) < t)
            lo = middle;
        else
            hi = middle;
    }
    return lo;
}

double motion_ref_travel(double length, const motion_ref_limits_t *l) {
    motion_ref_point_t p[2] = {{0, 0}, {length, 0}};
    return motion_ref_run(p, 2, l, NULL);
}
