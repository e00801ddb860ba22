/* lines_v1.c - lines.h on libgpiod 1.6. */
#include "hal/linux/lines.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

struct lines_chip {
    struct gpiod_chip *chip;
};
struct lines_out {
    struct gpiod_line_bulk bulk;
    unsigned count;
};
struct lines_in {
    struct gpiod_line *line;
};

const char *lines_library(void) {
    return gpiod_version_string();
}

lines_chip_t *lines_chip_open(const char *path) {
    lines_chip_t *c = calloc(1, sizeof *c);
    if (!c) return NULL;
    c->chip = gpiod_chip_open(path);
    if (c->chip) return c;
    int err = errno;
    free(c);
    errno = err;
    return NULL;
}

/* Releases its lines too, in this version. */
void lines_chip_close(lines_chip_t *chip) {
    if (!chip) return;
    gpiod_chip_close(chip->chip);
    free(chip);
}

const char *lines_chip_name(lines_chip_t *chip) {
    return gpiod_chip_name(chip->chip);
}
const char *lines_chip_label(lines_chip_t *chip) {
    return gpiod_chip_label(chip->chip);
}
unsigned lines_chip_count(lines_chip_t *chip) {
    return gpiod_chip_num_lines(chip->chip);
}

int lines_find(lines_chip_t *chip, const char *name) {
    struct gpiod_line *line = gpiod_chip_find_line(chip->chip, name);
    return line ? (int)gpiod_line_offset(line) : -ENOENT;
}

int lines_info(lines_chip_t *chip, unsigned offset, lines_info_t *out) {
    struct gpiod_line *line = gpiod_chip_get_line(chip->chip, offset);
    if (!line || gpiod_line_update(line)) return -errno;
    const char *name = gpiod_line_name(line), *consumer = gpiod_line_consumer(line);
    snprintf(out->name, sizeof out->name, "%s", name ? name : "");
    snprintf(out->consumer, sizeof out->consumer, "%s", consumer ? consumer : "");
    out->used = gpiod_line_is_used(line);
    return 0;
}

static void spread(uint32_t levels, unsigned count, int *value) {
    for (unsigned i = 0; i < count; i++) value[i] = levels >> i & 1;
}

lines_out_t *lines_out_request(lines_chip_t *chip, const unsigned *offset, unsigned count, uint32_t levels) {
    const struct gpiod_line_request_config config = {
        .consumer = LINES_CONSUMER,
        .request_type = GPIOD_LINE_REQUEST_DIRECTION_OUTPUT,
    };
    int value[32];
    lines_out_t *out = calloc(1, sizeof *out);
    if (!out) return NULL;
    out->count = count;
    gpiod_line_bulk_init(&out->bulk);
    for (unsigned i = 0; i < count; i++) {
        struct gpiod_line *line = gpiod_chip_get_line(chip->chip, offset[i]);
        if (!line) goto failed;
        gpiod_line_bulk_add(&out->bulk, line);
    }
    spread(levels, count, value);
    if (gpiod_line_request_bulk(&out->bulk, &config, value) == 0) return out;
failed:;
    int err = errno;
    free(out);
    errno = err;
    return NULL;
}

int lines_out_write(lines_out_t *out, uint32_t levels) {
    int value[32];
    spread(levels, out->count, value);
    return gpiod_line_set_value_bulk(&out->bulk, value) ? -errno : 0;
}

void lines_out_release(lines_out_t *out) {
    if (!out) return;
    gpiod_line_release_bulk(&out->bulk);
    free(out);
}

lines_in_t *lines_in_request(lines_chip_t *chip, unsigned offset, enum lines_pull pull) {
    static const int FLAG[] = {GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP, GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN,
                               GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE};
    const struct gpiod_line_request_config config = {
        .consumer = LINES_CONSUMER,
        .request_type = GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES,
        .flags = FLAG[pull],
    };
    lines_in_t *in = calloc(1, sizeof *in);
    if (!in) return NULL;
    in->line = gpiod_chip_get_line(chip->chip, offset);
    if (in->line && gpiod_line_request(in->line, &config, 0) == 0) return in;
    int err = errno;
    free(in);
    errno = err;
    return NULL;
}

int lines_in_fd(lines_in_t *in) {
    return gpiod_line_event_get_fd(in->line);
}

int lines_in_edge(lines_in_t *in) {
    struct gpiod_line_event event;
    if (gpiod_line_event_read(in->line, &event)) return -errno;
    return event.event_type == GPIOD_LINE_EVENT_RISING_EDGE;
}

int lines_in_level(lines_in_t *in) {
    int level = gpiod_line_get_value(in->line);
    return level < 0 ? -errno : level;
}

void lines_in_release(lines_in_t *in) {
    if (!in) return;
    gpiod_line_release(in->line);
    free(in);
}
