/* pins.h - the pin file: which line of which chip is which pin of the plotter.
 *
 *     chip   gpiochip0              # for the lines below that name none; a name, a path or a label
 *     x_step 17                     # by offset,
 *     x_dir  GPIO27                 # by the line's name, looked for on that chip and then on all others,
 *     y_step gpiochip0:22           # or with its own chip
 *     enable 25 active_low          # outputs are active_high unless they say otherwise
 *     limit_x "GPIO5" active_high   # inputs are active_low; pull_up (the default), pull_down or no_pull
 *
 * x_step x_dir y_step y_dir pen enable are needed and must be on one chip, because one system call writes them all;
 * limit_x limit_y estop may be left out and be anywhere. A line may be used once. A name that looks like an offset,
 * or has a space or a colon in it, is put in quotes.
 *
 * Everything is checked before a line is touched, and every mistake is told as `file:line:column: what`. */
#ifndef PINS_H
#define PINS_H

#include "hal/linux/lines.h"

#include <stdio.h>

/* Outputs in the order in which they are driven when they are taken: motors off and pen up before anything else. */
enum pins_name {
    PINS_ENABLE,
    PINS_PEN,
    PINS_X_DIR,
    PINS_Y_DIR,
    PINS_X_STEP,
    PINS_Y_STEP,
    PINS_OUTPUTS,
    PINS_LIMIT_X = PINS_OUTPUTS,
    PINS_LIMIT_Y,
    PINS_ESTOP,
    PINS_COUNT
};

#define PINS_CHIPS_MAX 32 /* /dev/gpiochip0 .. 31 */

typedef struct pins_pin {
    bool given;
    bool active_low;
    enum lines_pull pull;
    int chip; /* index into pins_t.chip */
    unsigned offset;
    int line, column; /* in the file, of the line's name */
} pins_pin_t;

typedef struct pins {
    lines_chip_t *chip[PINS_CHIPS_MAX]; /* by number; NULL when it does not exist or cannot be opened */
    pins_pin_t pin[PINS_COUNT];
} pins_t;

/* "x_step" */
const char *pins_name(enum pins_name pin);
/* Reads and checks a pin file and opens the chips. Returns how many mistakes there were, each told in a line to
 * `complaints`: unknown names and words, missing and duplicate pins, chips and lines that do not exist or are used by
 * somebody. name: of the file, for the messages. pins_close in any case. */
int pins_read(pins_t *p, FILE *file, const char *name, FILE *complaints);
void pins_close(pins_t *p);
/* "gpiochip0 line 17 (GPIO17), active high" */
void pins_describe(const pins_t *p, enum pins_name pin, char *text, size_t size);

#endif
