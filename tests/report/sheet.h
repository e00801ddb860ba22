/* sheet.h - contact sheets: for each case ours on the left and a naive drawing on the right, as PNG. In the naive one
 * red is what ours has not, blue what it lacks of ours; unless the right one is no drawing of the same lines. */
#ifndef REPORT_SHEET_H
#define REPORT_SHEET_H

#include <stdbool.h>
#include <stddef.h>

#define SHEET_CASES 30 /* on one sheet */

typedef struct sheet_box {
    double x0, y0, x1, y1;
} sheet_box_t;

/* Strokes on the page, in mm. */
typedef struct strokes {
    float (*at)[4]; /* x, y of both ends */
    size_t n, room;
} strokes_t;

void strokes_add(strokes_t *s, double x0, double y0, double x1, double y1);
void strokes_free(strokes_t *s);

/* A white page, text on it (shade: how red), and the page as DIR/NAME-NUMBER.png, which ends the program if it fails.
 */
struct _cairo *sheet_begin(double zoom, int width, int height);
void sheet_text(struct _cairo *cr, double x, double y, const char *text, double shade);
void sheet_end(struct _cairo *cr, const char *dir, const char *name, int number);

typedef struct sheets {
    const char *dir, *name; /* DIR/NAME-1.png ... */
    int cases, entered;
    double zoom; /* of the whole sheet; 0: 1 */
    bool apart;  /* differences are not marked */
    struct _cairo *cr;
} sheets_t;

/* How many sheets there are for so many cases. */
int sheets_count(int cases);
/* Enters the next case. part: what of the page is shown; NULL: all that has ink in ours. Writes each sheet that is
 * full, the last one with the last case; ends the program if that fails. */
void sheets_enter(sheets_t *s, const char *name, const char *naive, const strokes_t *ours, const strokes_t *other,
                  const sheet_box_t *part);

#endif
