/* lines.h - what the plotter needs of libgpiod: two of its versions behind one set of calls.
 *
 * lines_v1.c speaks to libgpiod 1.6 (Debian 12), lines_v2.c to 2.x (Debian 13); the Makefile takes the one that
 * pkg-config finds. Levels here are electrical, 1 = high: polarity is the caller's, so that both versions do the same.
 *
 * Functions that return int return 0 (or what they say) or -errno. What a call returns is the caller's to release. */
#ifndef LINES_H
#define LINES_H

#include <stdbool.h>
#include <stdint.h>

#define LINES_CONSUMER "ridgeline" /* what gpioinfo shows for our lines */
#define LINES_NAME_MAX 32

typedef struct lines_chip lines_chip_t;
typedef struct lines_out lines_out_t;
typedef struct lines_in lines_in_t;

enum lines_pull { LINES_PULL_UP, LINES_PULL_DOWN, LINES_PULL_NONE };

typedef struct lines_info {
    char name[LINES_NAME_MAX];     /* of the line, or empty */
    char consumer[LINES_NAME_MAX]; /* who has it, or empty */
    bool used;
} lines_info_t;

/* For people: the library's version. */
const char *lines_library(void);

/* path: the device, such as "/dev/gpiochip0". NULL and errno on failure. */
lines_chip_t *lines_chip_open(const char *path);
void lines_chip_close(lines_chip_t *chip);
/* "gpiochip0"; "pinctrl-bcm2711". Valid until the chip is closed. */
const char *lines_chip_name(lines_chip_t *chip);
const char *lines_chip_label(lines_chip_t *chip);
unsigned lines_chip_count(lines_chip_t *chip);
/* The line of that name: its offset, or -ENOENT. */
int lines_find(lines_chip_t *chip, const char *name);
int lines_info(lines_chip_t *chip, unsigned offset, lines_info_t *out);

/* Takes `count` lines (at most 32) as outputs, driven one after the other in this order; bit i of levels is the first
 * level of line i. NULL and errno: EBUSY when somebody else has one. */
lines_out_t *lines_out_request(lines_chip_t *chip, const unsigned *offset, unsigned count, uint32_t levels);
/* All lines of the request in one system call: bit i of levels is line i. Not a subset: 1.x cannot set one line of
 * several without zeroing the others. Cost: about a microsecond, whatever the count. */
int lines_out_write(lines_out_t *out, uint32_t levels);
void lines_out_release(lines_out_t *out);

/* Takes one line as input that reports both edges. NULL and errno. */
lines_in_t *lines_in_request(lines_chip_t *chip, unsigned offset, enum lines_pull pull);
/* Readable (poll) when an edge has come. */
int lines_in_fd(lines_in_t *in);
/* Takes one edge from the queue: 1 rising, 0 falling. Blocks when there is none. */
int lines_in_edge(lines_in_t *in);
/* The level now: 0 or 1. */
int lines_in_level(lines_in_t *in);
void lines_in_release(lines_in_t *in);

#endif
