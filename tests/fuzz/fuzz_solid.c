/* fuzz_solid.c - OBJ text, cut anywhere, put together, mapped and drawn in memory that may be too small. */
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "hidden/solid/convex.h"
#include "hidden/solid/once.h"
#include "hidden/solid/seams.h"
#include "scene/obj_reader.h"
#include "view/cut.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { POOL = 4096, SEAMS = 2000, VERTICES = POOL / 3 + 2 * SEAMS };

typedef struct drawn {
    const solid_t *solid;
    int64_t last_to;
    int32_t line;
} drawn_t;

static int take(void *ctx, const ink_piece_t *p) {
    drawn_t *d = ctx;
    if (p->family != INK_SEGMENT || p->line < 0 || p->line >= d->solid->ne || p->from < 0 || p->to > INK_ONE ||
        p->from >= p->to)
        abort();
    if (p->line == d->line && p->from < d->last_to) abort(); /* in order, disjoint */
    if (p->line < d->line) abort();
    d->line = p->line;
    d->last_to = p->to;
    return 0;
}

static int check(void *ctx, const ink_piece_t *p) {
    const solid_map_t *m = ctx;
    if (p->line < 0 || p->line >= m->solid->ne || p->from < 0 || p->to > INK_ONE || p->from >= p->to) abort();
    return 0;
}

/* The same, cut to the page, and what coincides once. */
static void draw_once(solid_map_t *m, void *mem, size_t bytes) {
    once_t once;
    hidden_stats_t stats;
    if (once_build(&once, m, true, bytes & 1024, mem, bytes)) return;
    cut_t cut[2] = {{&m->lines, once_seen(&once, (ink_sink_t){m, check})},
                    {&m->lines, once_dashed(&once, (ink_sink_t){m, check})}};
    const ink_sink_t sink = cut_sink(&cut[0]), other = cut_sink(&cut[1]);
    const hidden_job_t job = {.mem = (char *)mem + once.bytes, .bytes = bytes - once.bytes, .sink = &sink};
    if (convex_draw(m, &other, &job, &stats) == 0) once_finish(&once);
}

static void draw(const solid_t *s, const uint8_t *data) {
    static uint64_t place[SOLID_MAP_BYTES(VERTICES) / 8], kernel[60000];
    static solid_map_t map;
    settings_t set;
    camera_t cam;
    hidden_stats_t stats;
    view_box_t box = {.solid = true};
    settings_default(&set);
    set.view.rot_x = num_from_i64(data[1]);
    set.view.rot_z = num_from_i64(data[2]);
    set.view.from = data[0] & 2;
    for (int k = 0; k < 3; k++) {
        set.view.eye[k] = num_ldexp(num_from_i64((int8_t)data[1 + k]), (data[0] >> 4) - 8);
        box.lo[k] = s->lo[k];
        box.hi[k] = s->hi[k];
    }
    drawn_t visible = {s, 0, -1}, hidden = visible;
    const ink_sink_t sink = {&visible, take}, other = {&hidden, take};
    const hidden_job_t job = {
        .mem = kernel, .bytes = data[0] & 4 ? (size_t)data[3] * 64 : sizeof kernel, .sink = &sink};
    if (camera_setup(&cam, &set, &box) || solid_map_setup(&map, s, &cam, place)) return;
    convex_draw(&map, &other, &job, &stats);
    draw_once(&map, kernel, job.bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 5) return 0;
    static packed_t memory[POOL];
    static uint64_t lent[30000];
    obj_reader_t r;
    solid_t solid;
    mesh_t mesh;
    const mesh_t *list[1] = {&mesh};
    data_pool_t pool = {memory, 0, data[0] & 8 ? (size_t)data[4] : POOL};
    obj_reader_start(&r, &pool, NULL, data[0] & 1, 0);
    size_t chunk = 1 + data[4] % 32;
    int err = 0;
    for (size_t at = 5; !err && at < size; at += chunk)
        err = obj_reader_feed(&r, (const char *)data + at, size - at < chunk ? size - at : chunk);
    if (!err) err = obj_reader_finish(&r, &mesh);
    if (err) {
        if (err != ERR_EMPTY && (r.trouble == DATA_OK || !data_grid_text(r.trouble) || r.line < 1)) abort();
        return 0;
    }
    mesh.smooth_q30 = data[3] & 1 ? 1000000000 : 0;
    if (solid_bytes(list, 1) <= sizeof lent) {
        err = solid_build(&solid, list, 1, lent, sizeof lent);
        if (err == ERR_FULL || solid.bytes > sizeof lent) abort();
    } else {
        err = solid_build(&solid, list, 1, lent, sizeof lent);
    }
    if (err) return 0;
    draw(&solid, data);
    /* with the lines in which its bodies meet, in memory that may be too small */
    static uint64_t more[SEAMS * 12];
    const int32_t edges = solid.ne;
    const size_t room = data[0] & 4 ? (size_t)data[3] * 64 : sizeof more;
    size_t kept = 0;
    solid_free_details(&solid);
    err = seams_add(&solid, more, room, &kept);
    if (kept > room || (err && err != ERR_FULL) || solid.ne < edges || solid.nv > VERTICES) abort();
    if (!err && kept > 0) draw(&solid, data);
    return 0;
}
