/* same.c - surfaces: every seed's through the perimeter (with gaps, if it has holes) and as profiles through the
 * horizon. Parts that can be left out: columns, bits 0 .. 8, and rows, bits 9 .. 17. */
#include "tests/emu/bare/same.h"

#include "tests/emu/bare/bare.h"
#include "tests/emu/bare/integer_scene.h"

_Static_assert(INTEGER_SCENE_SIDE <= 9, "a bit for each row and column");

static integer_scene_t scene;

static void tell(const same_t *s, const char *name, const num_t *v, int n) {
    if (!s->telling) return;
    bare_text(name);
    for (int i = 0; i < n; i++) same_num(s, v[i]);
    bare_text("\n");
}

/* At least two columns and two rows stay. */
static void leave_out(uint32_t drop) {
    int nx = 0, ny = 0;
    uint32_t rows = drop >> 9;
    for (int i = 0; i < scene.nx; i++) nx += !(drop >> i & 1);
    for (int j = 0; j < scene.ny; j++) ny += !(rows >> j & 1);
    if (nx < 2) drop = 0, nx = scene.nx;
    if (ny < 2) rows = 0, ny = scene.ny;
    int to = 0, at = 0;
    for (int j = 0; j < scene.ny; j++)
        for (int i = 0; i < scene.nx; i++)
            if (!(drop >> i & 1) && !(rows >> j & 1)) scene.z[to++] = scene.z[j * scene.nx + i];
    for (int i = 0; i < scene.nx; i++)
        if (!(drop >> i & 1)) scene.x[at++] = scene.x[i];
    at = 0;
    for (int j = 0; j < scene.ny; j++)
        if (!(rows >> j & 1)) scene.y[at++] = scene.y[j];
    scene.nx = scene.surface.nx = nx;
    scene.ny = scene.surface.ny = ny;
}

void same_scene(uint64_t seed, same_t *s) {
    const ink_sink_t sink = {s, same_ink};
    integer_scene_random(&scene, seed);
    leave_out(s->drop);
    tell(s, "x", scene.x, scene.nx);
    tell(s, "y", scene.y, scene.ny);
    tell(s, "z", scene.z, scene.nx * scene.ny);
    tell(s, scene.cam.perspective ? "eye" : "direction", scene.cam.eye, 3);
    for (int k = 0; k < scene.nx * scene.ny; k++) {
        same_enter(s, (int64_t)scene.z[k].m, NULL);
        same_enter(s, scene.z[k].e + scene.z[k].undef, NULL);
    }
    int err = integer_scene_measure(&scene);
    same_enter(s, err, " error\n");
    for (enum integer_kernel kernel = KERNEL_PERIMETER; kernel <= KERNEL_HORIZON && !err; kernel += 2) {
        hidden_stats_t stats = {0};
        same_enter(s, integer_scene_draw(&scene, kernel, &sink, &stats), " error, ");
        same_enter(s, stats.facets, " facets, ");
        same_enter(s, stats.tests, " tests, ");
        same_enter(s, stats.crossings, " crossings\n");
    }
}
