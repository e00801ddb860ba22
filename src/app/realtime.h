/* realtime.h - what the console answers at any time, also while a drawing runs; and what was typed ahead.
 *
 *     ?       one line of status: <Run|MPos:12.345,67.890|Pen:down|Done:42%|Left:93s>
 *     !       hold: brakes to a standstill along the path
 *     ~       resume
 *     Ctrl-X  stop: brakes, pen up; forgets what was typed ahead
 *
 * As in Grbl, but ? ! ~ are also operators of the language: they count when they come first on a line, and not where
 * rows of data are expected. Ctrl-X always counts. All other bytes wait in a ring of CONFIG_TYPED bytes until they are
 * read.
 *
 * Flow control: XOFF is sent when the ring is half full or something long begins, XON when there is room
 * again. What comes all the same and finds no place, or was lost by the port, leaves LINE_EDIT_LOST in the stream.
 *
 * Context: main loop. */
#ifndef REALTIME_H
#define REALTIME_H

#include "app/carriage.h"
#include "app/picture.h"
#include "config.h"
#include "lang/text.h"

_Static_assert((CONFIG_TYPED & (CONFIG_TYPED - 1)) == 0 && CONFIG_TYPED >= 16 && CONFIG_TYPED <= 32768,
               "CONFIG_TYPED is a power of two");

typedef struct realtime {
    carriage_t *carriage;
    const picture_t *picture; /* being drawn, or NULL */
    uint16_t head, tail;      /* bytes into and out of the ring so far */
    bool line_start;          /* nothing has come yet of this line */
    bool data;                /* rows of data are expected: set by the console */
    bool lost;                /* a mark is due in the ring */
    bool busy, off;           /* something long is under way; the other side was told to stop */
    bool cancelled;           /* Ctrl-X came: the console forgets its line and clears this */
    uint8_t alarm_said;       /* enum carriage_alarm */
    uint16_t most;            /* bytes that ever waited in the ring */
    uint8_t ring[CONFIG_TYPED];
} realtime_t;

#define REALTIME_STATUS_MAX 96

void realtime_init(realtime_t *r, carriage_t *carriage);
/* Takes what has come and answers; tells of an alarm; feeds the watchdog; a fault if the stack
 * has run over. To be called at least every few ms. */
void realtime_poll(realtime_t *r);
/* The next byte typed, or -1. */
int realtime_read(realtime_t *r);
/* Something begins, or ends, during which nothing is read. */
void realtime_busy(realtime_t *r, bool busy);
/* The status line without its end. */
void realtime_status(const realtime_t *r, text_t *t);

#endif
