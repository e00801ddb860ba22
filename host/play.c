/* play.c - see play.h. */
#include "host/play.h"

int play(const drawing_t *d, motion_t *motion, void (*begun)(size_t stroke, size_t strokes), motion_stats_t *stats) {
    pen_sink_t pen = motion_pen_sink(motion);
    int err = 0;
    for (size_t s = 0; s < d->strokes && !err; s++) {
        size_t n;
        const page_point_t *p = drawing_stroke(d, s, &n);
        if (begun) begun(s, d->strokes);
        err = pen.move(pen.ctx, p[0]);
        for (size_t i = 1; i < n && !err; i++) err = pen.draw(pen.ctx, p[i]);
    }
    int finish = motion_finish(motion, stats);
    return err ? err : finish;
}
