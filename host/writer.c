/* writer.c - one table of suffixes. */
#include "host/writer.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "error.h"
#include "host/gcode.h"
#include "host/hpgl.h"
#include "host/image.h"
#include "host/plotter.h"
#include "host/seg.h"
#include "host/svg.h"

typedef struct writer {
    const char *suffix;
    const stroke_format_t *format; /* one of the three */
    int (*write)(const drawing_t *d, const char *path);
    int (*write_for)(const drawing_t *d, const machine_t *machine, const char *path);
} writer_t;

static const writer_t WRITERS[] = {
    {".svg", .format = &SVG_FORMAT},     {".png", .write = image_write_png},       {".pdf", .write = image_write_pdf},
    {".seg", .format = &SEG_FORMAT},     {".hpgl", .format = &HPGL_FORMAT},        {".plt", .format = &HPGL_FORMAT},
    {".gcode", .format = &GCODE_FORMAT}, {".vcd", .write_for = plotter_write_vcd},
};

/* Where the suffix of the last part of the path begins, or its end. */
static const char *suffix_of(const char *path) {
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    return dot && (!slash || dot > slash + 1) && dot != path ? dot : path + strlen(path);
}

static const writer_t *find(const char *path) {
    const char *suffix = suffix_of(path);
    for (size_t i = 0; i < sizeof WRITERS / sizeof WRITERS[0]; i++)
        if (strcasecmp(suffix, WRITERS[i].suffix) == 0) return &WRITERS[i];
    return NULL;
}

bool writer_knows(const char *path) {
    return find(path) != NULL;
}

int writer_write(const drawing_t *d, const machine_t *machine, const char *path) {
    const writer_t *w = find(path);
    if (!w) return ERR_VALUE;
    if (w->format) return stroke_file_write(w->format, d, machine, path);
    return w->write ? w->write(d, path) : w->write_for(d, machine, path);
}

const stroke_format_t *writer_format(const char *path) {
    const writer_t *w = find(path);
    return w ? w->format : NULL;
}

bool writer_page_name(char *name, size_t room, const char *path, int page) {
    const char *suffix = suffix_of(path);
    int n = page <= 1 ? snprintf(name, room, "%s", path)
                      : snprintf(name, room, "%.*s-%d%s", (int)(suffix - path), path, page, suffix);
    return n >= 0 && (size_t)n < room;
}
