/* gpio.h - a machine on the gpio lines of this board: `plot --hal gpio`, `jog`, `home`, `pen`, `off`.
 *
 * The stepping is done by another program, ridgeline-gpio (hal/linux/main.c says why), which is looked for beside this
 * one, or where the environment's RIDGELINE_GPIO says. Signals that ask this program to end are passed on, and the
 * other one makes the machine safe. */
#ifndef GPIO_H
#define GPIO_H

#include <stdbool.h>

#include "host/drawing.h"
#include "motion/machine.h"

typedef struct gpio {
    const char *pins; /* the pin file, or NULL when there is no machine on gpio lines */
    bool dry_run;     /* only say what would happen */
} gpio_t;

/* Draws a page and waits until it is done; asks for new paper first when it is not page 1. Everything worth saying has
 * been said. Returns the exit status: 0, 2 bad pin file, 1 trouble, 128 + signal. */
int gpio_plot(const gpio_t *gpio, int page, const machine_t *machine, const drawing_t *d);

/* True for jog, home, pen and off. */
bool gpio_is_command(const char *word);
/* The command: argv[0] is its name. Returns the exit status. */
int gpio_main(int argc, char **argv);

#endif
