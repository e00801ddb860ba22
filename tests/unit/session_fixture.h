/* session_fixture.h - a session with a port that remembers: what was said, and what was to be drawn. */
#ifndef SESSION_FIXTURE_H
#define SESSION_FIXTURE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lang/session.h"

#define FIXTURE_FILES 8
#define FIXTURE_POINTS 20000

typedef struct fixture_item {
    int nx, ny;
    int first; /* of its points in fixture_t.z; x and y stand beside it */
    char title[64];
} fixture_item_t;

typedef struct fixture {
    session_t session;
    session_port_t port;
    char out[8192], err[8192];
    struct {
        const char *name, *text;
        size_t at, size; /* size 0: up to a zero */
    } file[FIXTURE_FILES];
    int pauses, plots;
    int32_t pause_ms;
    char prompt[64];
    /* the last plot */
    enum plot_kind kind;
    int items;
    settings_t settings;
    fixture_item_t item[CONFIG_PLOT_ITEMS];
    double x[FIXTURE_POINTS], y[FIXTURE_POINTS], z[FIXTURE_POINTS];
    int points;
    int32_t rows_nx, rows_ny, cols_nx, cols_ny; /* of the first item */
    mesh_t mesh;
    int mesh_items;  /* solids among its items */
    int plot_result; /* what the port answers */
    uint64_t pool[FIXTURE_POINTS];
} fixture_t;

static inline double fixture_double(num_t a) {
    return a.undef ? NAN : ldexp((double)a.m, a.e);
}

static inline void fixture_say(char *buf, size_t size, const char *text) {
    size_t n = strlen(buf);
    snprintf(buf + n, size - n, "%s", text);
}
static inline void fixture_print(void *ctx, const char *text) {
    fixture_t *f = ctx;
    fixture_say(f->out, sizeof f->out, text);
}
static inline void fixture_warn(void *ctx, const char *text) {
    fixture_t *f = ctx;
    fixture_say(f->err, sizeof f->err, text);
}
static inline int fixture_open(void *ctx, const char *name) {
    fixture_t *f = ctx;
    for (int i = 0; i < FIXTURE_FILES; i++) {
        if (!f->file[i].name || strcmp(f->file[i].name, name) != 0) continue;
        f->file[i].at = 0;
        return i;
    }
    return ERR_FILE;
}
/* Small, uneven pieces, so that every field is cut somewhere. */
static inline int fixture_read(void *ctx, int handle, char *buf, int size) {
    fixture_t *f = ctx;
    const char *text = f->file[handle].text + f->file[handle].at;
    const size_t size_known = f->file[handle].size;
    int n = (int)(size_known ? size_known - f->file[handle].at : strlen(text)),
        most = 1 + (int)(f->file[handle].at * 7 % 13);
    if (n > most) n = most;
    if (n > size) n = size;
    memcpy(buf, text, (size_t)n);
    f->file[handle].at += (size_t)n;
    return n;
}
static inline void fixture_close(void *ctx, int handle) {
    (void)ctx;
    (void)handle;
}
static inline int fixture_pause(void *ctx, const char *prompt, int32_t ms) {
    fixture_t *f = ctx;
    f->pauses++;
    f->pause_ms = ms;
    snprintf(f->prompt, sizeof f->prompt, "%s", prompt);
    return 0;
}

static inline void fixture_keep(fixture_t *f, const plot_item_t *from, fixture_item_t *to) {
    to->first = f->points;
    snprintf(to->title, sizeof to->title, "%.*s", (int)from->title_len, from->title);
    bool curve = f->kind == PLOT_CURVES;
    const surface_t *s = &from->surface;
    to->nx = curve ? from->curve.n : s->nx;
    to->ny = curve ? 1 : s->ny;
    for (int j = 0; j < to->ny; j++) {
        for (int i = 0; i < to->nx && f->points < FIXTURE_POINTS; i++, f->points++) {
            f->x[f->points] = fixture_double(curve ? from->curve.x_of(from->curve.ctx, i) : s->x_of(s->ctx, i));
            f->y[f->points] = curve ? 0 : fixture_double(s->y_of(s->ctx, j));
            f->z[f->points] = fixture_double(curve ? from->curve.y_of(from->curve.ctx, i) : s->z_of(s->ctx, i, j));
        }
    }
}

static inline int fixture_plot(void *ctx, const plot_t *plot) {
    fixture_t *f = ctx;
    f->plots++;
    f->kind = plot->kind;
    f->items = plot->n;
    f->settings = *plot->settings;
    f->points = 0;
    f->mesh_items = 0;
    if (plot->kind == PLOT_SOLIDS) {
        for (int k = plot->n - 1; k >= 0; k--) { /* the first one is kept */
            if (!plot->item[k].solid) continue;
            f->mesh = plot->item[k].mesh;
            f->mesh_items++;
        }
        return f->plot_result;
    }
    if (plot->kind == PLOT_SURFACES) {
        f->rows_nx = plot->item[0].rows.nx;
        f->rows_ny = plot->item[0].rows.ny;
        f->cols_nx = plot->item[0].cols.nx;
        f->cols_ny = plot->item[0].cols.ny;
    }
    for (int k = 0; k < plot->n; k++) fixture_keep(f, &plot->item[k], &f->item[k]);
    return f->plot_result;
}

static inline fixture_t *fixture_new(void) {
    fixture_t *f = calloc(1, sizeof *f);
    f->port = (session_port_t){.ctx = f,
                               .print = fixture_print,
                               .warn = fixture_warn,
                               .open = fixture_open,
                               .read = fixture_read,
                               .close = fixture_close,
                               .pause = fixture_pause,
                               .plot = fixture_plot};
#if CONFIG_BINARY
    f->port.open_binary = fixture_open;
#endif
    session_init(&f->session, &f->port, f->pool, sizeof f->pool);
    return f;
}

/* For cmocka: each test has a new one. */
static inline int fixture_setup(void **state) {
    *state = fixture_new();
    return 0;
}
static inline int fixture_teardown(void **state) {
    free(*state);
    return 0;
}

static inline void fixture_file(fixture_t *f, int slot, const char *name, const char *text) {
    f->file[slot].name = name;
    f->file[slot].text = text;
    f->file[slot].size = 0;
}

/* Feeds text line by line; stops at the first error and returns it. */
static inline int fixture_feed(fixture_t *f, const char *text) {
    char line[4096];
    f->out[0] = f->err[0] = '\0';
    while (*text) {
        size_t n = strcspn(text, "\n");
        snprintf(line, sizeof line, "%.*s", (int)n, text);
        int err = session_line(&f->session, line);
        if (err) return err;
        text += n;
        if (*text) text++;
    }
    return 0;
}

#endif
