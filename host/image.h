/* image.h - the drawing through Cairo: .png and .pdf.
 *
 * Black lines 0.3 mm wide with round caps on white paper. PNG has 200 dots to the inch; PDF has the
 * paper's size and the title in its metadata. */
#ifndef IMAGE_H
#define IMAGE_H

#include "host/drawing.h"

/* 0, ERR_FILE, ERR_VALUE for a paper too large for a bitmap, or ERR_UNSUPPORTED where Cairo is not installed, which is
 * said. */
int image_write_png(const drawing_t *d, const char *path);
int image_write_pdf(const drawing_t *d, const char *path);

#endif
