/* figure.h - a small plot of series of points, linear or logarithmic, as SVG. */
#ifndef FIGURE_H
#define FIGURE_H

#include <stdbool.h>

#define FIGURE_POINTS 512
#define FIGURE_SERIES 24

typedef struct figure_point {
    double x, y;
    int series;
    const char *label; /* beside the mark, or NULL */
    bool ring;         /* marked */
} figure_point_t;

typedef struct figure {
    const char *title, *x_title, *y_title;
    bool x_log, y_log, joined; /* joined: a line from point to point of a series */
    bool front;                /* a line through the points of a series that no other of it is better than in both */
    double y_line;             /* a horizontal line, if not 0 */
    double y_floor;            /* if not 0: what is less is drawn there, and the axis says 0 */
    const char *name[FIGURE_SERIES];
    int line_of[FIGURE_SERIES]; /* a line without marks, in the colour of the series of this number less one; 0: points
                                 */
    int series, points;
    figure_point_t point[FIGURE_POINTS];
} figure_t;

/* Starts an empty figure. The texts are kept as pointers. */
void figure_init(figure_t *f, const char *title, const char *x_title, const char *y_title);
/* Adds a series; returns its number. */
int figure_series(figure_t *f, const char *name);
/* Adds the line y = a + b x from x = 0 to `to`, for that series. */
void figure_line(figure_t *f, int series, double a, double b, double to);
/* Adds a point. On logarithmic axes what is not positive is left out, but for y with a floor. */
void figure_add(figure_t *f, int series, double x, double y, const char *label);
/* Marks the last one with a ring. */
void figure_mark(figure_t *f);
/* Writes the file; ends the program if that fails. */
void figure_write(const figure_t *f, const char *name);
/* Several figures on one page, so many beside each other. */
void figure_write_panels(const figure_t *f, int n, int columns, const char *name);

#endif
