/* drawing.h - one page of strokes in memory: what the core's pen drew, kept until every file of it is written.
 *
 * A stroke is what the pen draws between lowering and lifting: one point where it goes down, then one or more
 * where it goes to. Points are page lat (src/view/page.h). Costs 8 bytes a point and 8 a stroke; the core
 * itself never holds a drawing, only the host does, because one drawing may become several files. One that becomes a
 * single file need not be kept: its strokes are handed on as they come. */
#ifndef DRAWING_H
#define DRAWING_H

#include <stddef.h>
#include <stdint.h>

#include "view/camera.h"
#include "view/page.h"

#define DRAWING_TITLE_MAX 128
#define DRAWING_CHANGES_MAX 16

/* A stroke of n >= 2 points. */
typedef void drawing_take_t(void *ctx, const page_point_t *point, size_t n);

typedef struct drawing {
    page_point_t *point; /* of all strokes, in drawing order */
    size_t points, point_room;
    size_t *first; /* index in point[] of the first point of each stroke */
    size_t strokes, stroke_room;
    struct {
        size_t stroke; /* from this one on */
        int pen;
    } change[DRAWING_CHANGES_MAX];
    int changes;          /* none: pen 1 draws everything */
    bool lifted;          /* the pen is up, over: */
    page_point_t over;    /* where the next stroke begins, if it draws anything */
    drawing_take_t *take; /* gets the strokes; NULL: they are kept */
    void *take_ctx;
    double camera_mm[3][4];      /* from (x, y, z, 1) to page mm: x = row 0 / row 2, y = row 1 / row 2 */
    int32_t width_um, height_um; /* of the paper */
    char title[DRAWING_TITLE_MAX];
} drawing_t;

/* How far the pen goes. */
typedef struct drawing_length {
    double down_mm; /* drawing */
    double up_mm;   /* between strokes, from the origin to the first and from the last back to it */
} drawing_length_t;

/* An empty drawing on A4 landscape, camera the identity. It owns memory from its first point on. */
void drawing_init(drawing_t *d);
/* Forgets the strokes and keeps the memory, for the next page. */
void drawing_clear(drawing_t *d);
void drawing_free(drawing_t *d);

/* The camera's rows 0 and 1 are lat per world unit; they are kept as mm. */
void drawing_set_camera(drawing_t *d, const camera_t *c);
/* Keeps whole characters, at most DRAWING_TITLE_MAX - 1 bytes. What is not UTF-8 becomes `?`, control characters
 * blanks: it goes into XML, JSON and PDF. */
void drawing_set_title(drawing_t *d, const char *title);

/* A sink that appends to d, which must outlive it. A move without a draw after it leaves nothing; a draw to where
 * the pen already is makes a dot. Returns ERR_FULL when the machine has no memory left. */
pen_sink_t drawing_sink(drawing_t *d);

/* Strokes from now on are handed on when they are over, and only counted here; with NULL they are kept. The one that is
 * being drawn is over. */
void drawing_hand_on(drawing_t *d, drawing_take_t *take, void *ctx);

/* Strokes from now on are drawn with this pen, numbered from 1. ERR_FULL after DRAWING_CHANGES_MAX changes. */
int drawing_take_pen(drawing_t *d, int pen);
/* The pen of stroke s. */
int drawing_pen(const drawing_t *d, size_t s);
/* How pen 1, 2, ... looks on a screen: 0xRRGGBB; the first is black. */
unsigned drawing_colour(int pen);
/* Is any pen but the first used? */
bool drawing_has_pens(const drawing_t *d);

/* Stroke s < d->strokes: its *n >= 2 points. */
const page_point_t *drawing_stroke(const drawing_t *d, size_t s, size_t *n);

drawing_length_t drawing_measure(const drawing_t *d);

#endif
