/* fuzz_picture.c - any text through the whole program above the motors: session, evaluation, hiding, ordering.
 *
 * Whatever is typed, the pen must stay on the paper, and sanitizers must have nothing to say. Scenes larger than a few
 * thousand points are left out, they would only be slow. Files are not there: opening one fails. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/picture.h"
#include "error.h"
#include "lang/session.h"

enum { POINTS_MAX = 2000, MEMORY = 1 << 18, POOL = 1 << 14 };

static int64_t width_lat, height_lat;

static int stay_on_paper(void *ctx, page_point_t p) {
    (void)ctx;
    if (p.x_lat < 0 || p.y_lat < 0 || p.x_lat > width_lat || p.y_lat > height_lat) {
        fprintf(stderr, "the pen left the paper: %d %d\n", (int)p.x_lat, (int)p.y_lat);
        abort();
    }
    return 0;
}

static int64_t size_of(const plot_t *plot) {
    const settings_t *s = plot->settings;
    int64_t points = 0;
    for (int i = 0; i < plot->n; i++) {
        const plot_item_t *item = &plot->item[i];
        if (plot->kind != PLOT_SURFACES) {
            points += s->samples[0];
            continue;
        }
        points += (int64_t)item->surface.nx * item->surface.ny + (int64_t)item->rows.nx * item->rows.ny +
                  (int64_t)item->cols.nx * item->cols.ny;
        if (s->hidden == HIDDEN_HORIZON) points += (int64_t)s->samples[0] * s->isosamples[1];
    }
    return points;
}

static int port_plot(void *ctx, const plot_t *plot) {
    static picture_t picture;
    static uint64_t memory[MEMORY / 8];
    (void)ctx;
    if (size_of(plot) > POINTS_MAX) return 0;
    width_lat = ((int64_t)plot->settings->paper.width_um * LAT_PER_MM + 999) / 1000;
    height_lat = ((int64_t)plot->settings->paper.height_um * LAT_PER_MM + 999) / 1000;
    const pen_sink_t pen = {NULL, stay_on_paper, stay_on_paper};
    return picture_draw(&picture, plot, memory, sizeof memory, &pen, NULL);
}

static void port_text(void *ctx, const char *text) {
    (void)ctx;
    if (strlen(text) > 100000) abort(); /* reads all of it */
}

static int port_open(void *ctx, const char *name) {
    (void)ctx, (void)name;
    return ERR_FILE;
}

static int port_read(void *ctx, int handle, char *buf, int size) {
    (void)ctx, (void)handle, (void)buf, (void)size;
    abort();
}

static void port_close(void *ctx, int handle) {
    (void)ctx, (void)handle;
    abort();
}

static int port_pause(void *ctx, const char *prompt, int32_t ms) {
    (void)ms;
    port_text(ctx, prompt);
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const session_port_t PORT = {.print = port_text,
                                        .warn = port_text,
                                        .open = port_open,
                                        .read = port_read,
                                        .close = port_close,
                                        .pause = port_pause,
                                        .plot = port_plot};
    static session_t session;
    static uint64_t pool[POOL / 8];
    static char line[8192];
    session_init(&session, &PORT, pool, sizeof pool);
    session_source(&session, "fuzz");
    session_line(&session, "set isosamples 6; set samples 6"); /* what the text may change */
    for (size_t i = 0; i < size && session_state(&session) != SESSION_QUIT;) {
        size_t n = 0;
        while (i + n < size && data[i + n] != '\n' && n + 1 < sizeof line) n++;
        memcpy(line, data + i, n);
        line[n] = 0;
        session_line(&session, line);
        i += n + 1;
    }
    session_end(&session);
    return 0;
}
