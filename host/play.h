/* play.h - feeds a drawing to the motion stage. */
#ifndef PLAY_H
#define PLAY_H

#include "host/drawing.h"
#include "motion/motion.h"

/* Every stroke, then home, also after an error. motion: initialised. begun, if not NULL, is told which stroke of how
 * many comes next. stats may be NULL. Returns the first error. */
int play(const drawing_t *d, motion_t *motion, void (*begun)(size_t stroke, size_t strokes), motion_stats_t *stats);

#endif
