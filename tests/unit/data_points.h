/* data_points.h - the points that gnuplot, and ours, make of a file. */
#ifndef DATA_POINTS_H
#define DATA_POINTS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <unistd.h>

#include <cmocka.h>

#include "session_fixture.h"

typedef struct point {
    double x, y, z;
} point_t;

static inline int compare(const void *a, const void *b) {
    const double *p = a, *q = b;
    for (int k = 0; k < 2; k++)
        if (fabs(p[k] - q[k]) > 1e-9) return p[k] < q[k] ? -1 : 1;
    return 0;
}

/* The points of `splot COMMAND` according to gnuplot itself, sorted; -1 if it is not installed. */
static inline int gnuplot_points(const char *command, const char *data, size_t size, point_t *out, int max) {
    if (system("command -v gnuplot >/dev/null 2>&1") != 0) return -1;
    char path[] = "/tmp/ridgeline-data-XXXXXX", line[512];
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, data, size), (int)size);
    close(fd);
    snprintf(line, sizeof line,
             "gnuplot -e \"set table '/dev/stdout'; file='%s'; set style data lines; splot file %s\" 2>/dev/null", path,
             command);
    FILE *p = popen(line, "r");
    int n = 0;
    while (n < max && fgets(line, sizeof line, p)) {
        char type;
        if (sscanf(line, "%lf %lf %lf %c", &out[n].x, &out[n].y, &out[n].z, &type) != 4) continue;
        if (type != 'u') n++;
    }
    pclose(p);
    unlink(path);
    qsort(out, (size_t)n, sizeof *out, compare);
    return n;
}

static inline int our_points(const fixture_t *f, point_t *out) {
    int n = 0;
    for (int k = 0; k < f->points; k++)
        if (!isnan(f->z[k])) out[n++] = (point_t){f->x[k], f->y[k], f->z[k]};
    qsort(out, (size_t)n, sizeof *out, compare);
    return n;
}

/* Every point of the two, sorted, is the same; what: for messages. */
static inline void assert_points(const char *what, const point_t *ours, int m, const point_t *theirs, int n) {
    if (m != n) fail_msg("%s: %d points, gnuplot %d", what, m, n);
    for (int k = 0; k < n; k++)
        if (fabs(ours[k].x - theirs[k].x) > 1e-4 || fabs(ours[k].y - theirs[k].y) > 1e-4 ||
            fabs(ours[k].z - theirs[k].z) > 1e-4 * fabs(theirs[k].z))
            fail_msg("%s: point %d (%g %g %g), gnuplot (%g %g %g)", what, k, ours[k].x, ours[k].y, ours[k].z,
                     theirs[k].x, theirs[k].y, theirs[k].z);
}

#endif
