/* lines_v2.c - lines.h on libgpiod 2.x. */
#include "hal/linux/lines.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

struct lines_chip {
    struct gpiod_chip *chip;
    struct gpiod_chip_info *info;
};
struct lines_out {
    struct gpiod_line_request *request;
    unsigned count;
};
struct lines_in {
    struct gpiod_line_request *request;
    struct gpiod_edge_event_buffer *buffer;
    unsigned offset;
};

const char *lines_library(void) {
    return gpiod_api_version();
}

lines_chip_t *lines_chip_open(const char *path) {
    lines_chip_t *c = calloc(1, sizeof *c);
    if (!c) return NULL;
    c->chip = gpiod_chip_open(path);
    c->info = c->chip ? gpiod_chip_get_info(c->chip) : NULL;
    if (c->info) return c;
    int err = errno;
    lines_chip_close(c);
    errno = err;
    return NULL;
}

void lines_chip_close(lines_chip_t *chip) {
    if (!chip) return;
    if (chip->info) gpiod_chip_info_free(chip->info);
    if (chip->chip) gpiod_chip_close(chip->chip);
    free(chip);
}

const char *lines_chip_name(lines_chip_t *chip) {
    return gpiod_chip_info_get_name(chip->info);
}
const char *lines_chip_label(lines_chip_t *chip) {
    return gpiod_chip_info_get_label(chip->info);
}
unsigned lines_chip_count(lines_chip_t *chip) {
    return (unsigned)gpiod_chip_info_get_num_lines(chip->info);
}

int lines_find(lines_chip_t *chip, const char *name) {
    int offset = gpiod_chip_get_line_offset_from_name(chip->chip, name);
    return offset < 0 ? -ENOENT : offset;
}

int lines_info(lines_chip_t *chip, unsigned offset, lines_info_t *out) {
    struct gpiod_line_info *info = gpiod_chip_get_line_info(chip->chip, offset);
    if (!info) return -errno;
    const char *name = gpiod_line_info_get_name(info), *consumer = gpiod_line_info_get_consumer(info);
    snprintf(out->name, sizeof out->name, "%s", name ? name : "");
    snprintf(out->consumer, sizeof out->consumer, "%s", consumer ? consumer : "");
    out->used = gpiod_line_info_is_used(info);
    gpiod_line_info_free(info);
    return 0;
}

static enum gpiod_line_value level_of(uint32_t levels, unsigned i) {
    return levels >> i & 1 ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
}

/* One request for lines that all have these settings, or, for outputs, settings and their own first level. */
static struct gpiod_line_request *request(lines_chip_t *chip, struct gpiod_line_settings *settings,
                                          const unsigned *offset, unsigned count, uint32_t levels) {
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *config = gpiod_request_config_new();
    struct gpiod_line_request *made = NULL;
    bool ok = settings && lines && config;
    if (config) gpiod_request_config_set_consumer(config, LINES_CONSUMER);
    for (unsigned i = 0; i < count && ok; i++) {
        ok = gpiod_line_settings_set_output_value(settings, level_of(levels, i)) == 0 &&
             gpiod_line_config_add_line_settings(lines, &offset[i], 1, settings) == 0;
    }
    if (ok) made = gpiod_chip_request_lines(chip->chip, config, lines);
    int err = errno;
    gpiod_request_config_free(config);
    gpiod_line_config_free(lines);
    gpiod_line_settings_free(settings);
    errno = err;
    return made;
}

lines_out_t *lines_out_request(lines_chip_t *chip, const unsigned *offset, unsigned count, uint32_t levels) {
    lines_out_t *out = calloc(1, sizeof *out);
    if (!out) return NULL;
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    if (settings) gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT);
    out->count = count;
    out->request = request(chip, settings, offset, count, levels);
    if (out->request) return out;
    int err = errno;
    free(out);
    errno = err;
    return NULL;
}

int lines_out_write(lines_out_t *out, uint32_t levels) {
    enum gpiod_line_value value[32];
    for (unsigned i = 0; i < out->count; i++) value[i] = level_of(levels, i);
    return gpiod_line_request_set_values(out->request, value) ? -errno : 0;
}

void lines_out_release(lines_out_t *out) {
    if (!out) return;
    gpiod_line_request_release(out->request);
    free(out);
}

lines_in_t *lines_in_request(lines_chip_t *chip, unsigned offset, enum lines_pull pull) {
    static const enum gpiod_line_bias BIAS[] = {GPIOD_LINE_BIAS_PULL_UP, GPIOD_LINE_BIAS_PULL_DOWN,
                                                GPIOD_LINE_BIAS_DISABLED};
    lines_in_t *in = calloc(1, sizeof *in);
    if (!in) return NULL;
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    if (settings) {
        gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT);
        gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_BOTH);
        gpiod_line_settings_set_bias(settings, BIAS[pull]);
    }
    in->offset = offset;
    in->buffer = gpiod_edge_event_buffer_new(1);
    in->request = request(chip, settings, &offset, 1, 0);
    if (in->request && in->buffer) return in;
    int err = errno;
    lines_in_release(in);
    errno = err;
    return NULL;
}

int lines_in_fd(lines_in_t *in) {
    return gpiod_line_request_get_fd(in->request);
}

int lines_in_edge(lines_in_t *in) {
    if (gpiod_line_request_read_edge_events(in->request, in->buffer, 1) < 0) return -errno;
    struct gpiod_edge_event *event = gpiod_edge_event_buffer_get_event(in->buffer, 0);
    return gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE;
}

int lines_in_level(lines_in_t *in) {
    enum gpiod_line_value value = gpiod_line_request_get_value(in->request, in->offset);
    return value == GPIOD_LINE_VALUE_ERROR ? -errno : value == GPIOD_LINE_VALUE_ACTIVE;
}

void lines_in_release(lines_in_t *in) {
    if (!in) return;
    if (in->request) gpiod_line_request_release(in->request);
    gpiod_edge_event_buffer_free(in->buffer);
    free(in);
}
