/* fuzz_session.c - whole conversations: any text, any files, and a port that looks at what it is to draw.
 *
 * The input is split at bytes 0xff: the first part is typed, the others are what files hold, whatever their names. */
#include <stdlib.h>
#include <string.h>

#include "lang/session.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { PARTS = 4, POOL = 4096 };
static struct {
    const uint8_t *text;
    size_t size, at;
} part[PARTS];
static int parts, opened;
static session_t session;
static uint64_t pool[POOL];
static volatile size_t seen;

static void say(void *ctx, const char *text) {
    (void)ctx;
    seen += strlen(text);
}
static int open_file(void *ctx, const char *name) {
    (void)ctx;
    if (parts < 2 || strlen(name) > CONFIG_NAME_MAX) return ERR_FILE;
    int handle = 1 + opened++ % (parts - 1);
    part[handle].at = 0;
    return handle;
}
static int read_file(void *ctx, int handle, char *buf, int size) {
    (void)ctx;
    size_t left = part[handle].size - part[handle].at, n = left < (size_t)size ? left : (size_t)size;
    memcpy(buf, part[handle].text + part[handle].at, n);
    part[handle].at += n;
    return (int)n;
}
static void close_file(void *ctx, int handle) {
    (void)ctx;
    if (handle < 1 || handle >= parts) abort();
}
static int wait(void *ctx, const char *prompt, int32_t ms) {
    (void)ctx;
    seen += strlen(prompt) + (size_t)(ms < 0);
    return 0;
}

/* A number is normalised or undefined. */
static void check(num_t a, bool may_be_undefined) {
    if (a.undef) {
        if (!may_be_undefined) abort();
        return;
    }
    uint64_t mag = a.m < 0 ? 0 - (uint64_t)a.m : (uint64_t)a.m;
    if (a.m == 0 ? a.e != 0 : mag >> 62 != 1) abort();
}

static void look(const surface_t *s) {
    if (s->nx < 2 || s->ny < 2) abort();
    int32_t i[3] = {0, s->nx / 2, s->nx - 1}, j[3] = {0, s->ny / 2, s->ny - 1};
    for (int k = 0; k < 3; k++) {
        check(s->x_of(s->ctx, i[k]), false);
        check(s->y_of(s->ctx, j[k]), false);
        check(s->z_of(s->ctx, i[k], j[2 - k]), true);
    }
    if (num_cmp(s->x_of(s->ctx, 0), s->x_of(s->ctx, s->nx - 1)) >= 0) abort();
    if (num_cmp(s->y_of(s->ctx, 0), s->y_of(s->ctx, s->ny - 1)) >= 0) abort();
}

static int draw(void *ctx, const plot_t *plot) {
    (void)ctx;
    if (plot->n < 1 || plot->n > CONFIG_PLOT_ITEMS) abort();
    for (int k = 0; k < plot->n; k++) {
        const plot_item_t *item = &plot->item[k];
        for (int32_t i = 0; i < item->title_len; i++) seen += (size_t)item->title[i];
        if (plot->kind == PLOT_SOLIDS && !item->solid) {
            look(&item->surface);
        } else if (plot->kind == PLOT_SURFACES) {
            look(&item->surface);
            look(&item->rows);
            look(&item->cols);
        } else if (plot->kind == PLOT_CURVES) {
            check(item->curve.x_of(item->curve.ctx, item->curve.n - 1), false);
            check(item->curve.y_of(item->curve.ctx, 0), true);
        } else {
            const mesh_t *m = &item->mesh;
            for (mesh_walk_t w = mesh_walk(m); mesh_next(&w);)
                for (int32_t v = 0; v < w.count; v++)
                    if (mesh_at(&w, v) < 0 || mesh_at(&w, v) >= m->nv) abort();
        }
    }
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const session_port_t port = {.print = say,
                                        .warn = say,
                                        .open = open_file,
                                        .open_binary = open_file,
                                        .read = read_file,
                                        .close = close_file,
                                        .pause = wait,
                                        .plot = draw};
    parts = opened = 0;
    for (size_t at = 0; parts < PARTS; parts++) {
        const uint8_t *end = memchr(data + at, 0xff, size - at);
        size_t n = end ? (size_t)(end - (data + at)) : size - at;
        part[parts].text = data + at;
        part[parts].size = n;
        at += n + 1;
        if (!end) {
            parts++;
            break;
        }
    }
    session_init(&session, &port, pool, sizeof pool);
    char line[8192];
    for (size_t at = 0; at < part[0].size;) {
        size_t n = 0;
        while (at + n < part[0].size && part[0].text[at + n] != '\n') n++;
        size_t len = n < sizeof line - 1 ? n : sizeof line - 1;
        memcpy(line, part[0].text + at, len);
        line[len] = '\0';
        int err = session_line(&session, line);
        if (err > 0 || (err < 0 && session.error.code != err)) abort();
        at += n + 1;
    }
    session_end(&session);
    return 0;
}
