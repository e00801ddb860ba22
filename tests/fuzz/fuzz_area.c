/* fuzz_area.c - OBJ text with holes in faces through the area sort, with lights, shadows and hatching, in memory that
 * may be too small. */
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "hidden/area/area.h"
#include "hidden/area/area_tone.h"
#include "hidden/line_class.h"
#include "scene/obj_reader.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { POOL = 1024, HEAD = 10 };

static int take(void *ctx, const ink_piece_t *p) {
    const solid_t *s = ctx;
    if (p->line < 0 || p->from < 0 || p->to > INK_ONE || p->from >= p->to) abort();
    if (p->family == INK_SEGMENT && p->line >= s->ne + s->nd) abort();
    return 0;
}

static int32_t signed_at(const uint8_t *data, int k) {
    return (int8_t)data[k];
}

/* data: 0 switches, 1 .. 3 the view, 4 the size of a chunk, 5 .. 7 a light, 8 memory, 9 hatching. */
static void draw(const solid_t *s, const uint8_t *data) {
    static uint64_t place[SOLID_MAP_BYTES(POOL / 3) / 8], kernel[60000];
    static solid_map_t map;
    settings_t set;
    camera_t cam;
    hatch_t hatch;
    hidden_stats_t stats;
    area_stats_t area;
    view_box_t box = {.solid = true};
    area_tone_t tone = {.hatch = &hatch, .lights = 1, .shadow = data[0] & 64};
    settings_default(&set);
    set.view.rot_x = num_from_i64(data[1]);
    set.view.rot_z = num_from_i64(data[2]);
    set.view.from = data[0] & 2;
    for (int k = 0; k < 3; k++) {
        set.view.eye[k] = num_ldexp(num_from_i64(signed_at(data, 1 + k)), (data[0] >> 4 & 3) * 2 - 6);
        tone.light[0].at[k] = num_from_i64(signed_at(data, 5 + k));
        box.lo[k] = s->lo[k];
        box.hi[k] = s->hi[k];
    }
    tone.light[0].point = data[0] & 128;
    const ink_sink_t sink = {(void *)(uintptr_t)s, take};
    const hidden_job_t job = {
        .mem = kernel, .bytes = data[0] & 4 ? (size_t)data[8] * 512 : sizeof kernel, .sink = &sink};
    if (camera_setup(&cam, &set, &box) || solid_map_setup(&map, s, &cam, place)) return;
    hatch_setup(&hatch, &cam.window, num_from_i64(data[9]), LAT_PER_MM * (2 + data[9] % 16));
    int err = area_draw(&map, data[0] & (64 | 128) ? &tone : NULL, data[0] & 8 ? &sink : NULL, &job, &stats, &area);
    if (err && err != ERR_FULL && err != ERR_VALUE && err != ERR_LIGHT) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < HEAD) return 0;
    static packed_t memory[POOL];
    static uint64_t lent[30000];
    obj_reader_t r;
    solid_t solid;
    mesh_t mesh;
    const mesh_t *list[1] = {&mesh};
    data_pool_t pool = {memory, 0, POOL};
    obj_reader_start(&r, &pool, NULL, data[0] & 1, 0);
    if (data[9] & 1) r.clear = "g\0glass\0", r.clear_now = true;
    size_t chunk = 1 + data[4] % 32;
    int err = 0;
    for (size_t at = HEAD; !err && at < size; at += chunk)
        err = obj_reader_feed(&r, (const char *)data + at, size - at < chunk ? size - at : chunk);
    if (!err) err = obj_reader_finish(&r, &mesh);
    if (!err && r.clear) mesh.clear = r.clear_any;
    if (err || solid_build(&solid, list, 1, lent, sizeof lent)) return 0;
    draw(&solid, data);
    return 0;
}
