/* surface_strokes.h - what a kernel drew of a surface, as strokes for a sheet. */
#ifndef REPORT_SURFACE_STROKES_H
#define REPORT_SURFACE_STROKES_H

#include "tests/oracle/run_kernel.h"
#include "tests/report/sheet.h"

/* What is on the page, and in the box unless that is NULL. To be freed. */
strokes_t surface_strokes(const scene_t *s, const run_drawing_t *d, const sheet_box_t *box);

#endif
