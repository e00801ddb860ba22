/* same.c - seeded scenes through the kernels, and a hash of all that they say: one line a scene, the same on every
 * machine. With an argument, that scene alone with its heights, eye and ink. */
#include "tests/emu/bare/bare.h"
#include "tests/emu/bare/integer_scene.h"

#include <stddef.h>

#ifndef SAME_SCENES
#define SAME_SCENES 5000
#endif

static integer_scene_t scene;
static bool telling;

/* FNV-1a. */
static void hash(uint64_t *h, int64_t v) {
    for (int i = 0; i < 8; i++) *h = (*h ^ (uint8_t)((uint64_t)v >> (8 * i))) * 0x100000001b3u;
}

static int take(void *ctx, const ink_piece_t *p) {
    const int64_t field[] = {p->family, p->surface, p->line, p->from, p->to};
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        hash(ctx, field[i]);
        if (telling) bare_number(field[i]);
        if (telling) bare_text(i < 4 ? " " : "\n");
    }
    return 0;
}

static void tell(const char *name, const num_t *v, int n) {
    bare_text(name);
    for (int i = 0; i < n; i++) {
        bare_text(v[i].undef ? " undefined" : " ");
        if (!v[i].undef) bare_number(v[i].m);
        if (!v[i].undef) bare_text("e");
        if (!v[i].undef) bare_number(v[i].e);
    }
    bare_text("\n");
}

static void one(uint64_t seed) {
    uint64_t h = 0xcbf29ce484222325u;
    ink_sink_t sink = {&h, take};
    integer_scene_random(&scene, seed);
    if (telling) {
        tell("x", scene.x, scene.nx);
        tell("y", scene.y, scene.ny);
        tell("z", scene.z, scene.nx * scene.ny);
        tell(scene.cam.perspective ? "eye" : "direction", scene.cam.eye, 3);
    }
    for (int k = 0; k < scene.nx * scene.ny; k++) {
        hash(&h, (int64_t)scene.z[k].m);
        hash(&h, scene.z[k].e + scene.z[k].undef);
    }
    int err = integer_scene_measure(&scene);
    hash(&h, err);
    for (enum integer_kernel kernel = KERNEL_PERIMETER; kernel <= KERNEL_HORIZON && !err; kernel += 2) {
        hidden_stats_t stats = {0};
        hash(&h, integer_scene_draw(&scene, kernel, &sink, &stats));
        hash(&h, stats.facets);
        hash(&h, stats.tests);
        hash(&h, stats.crossings);
    }
    bare_number((int64_t)seed);
    bare_text(" ");
    bare_hex(h);
    bare_text("\n");
}

int bare_main(int argc, char **argv) {
    uint64_t seed = 0;
    telling = argc > 1;
    for (const char *p = telling ? argv[1] : ""; *p; p++) seed = 10 * seed + (uint64_t)(*p - '0');
    if (telling) one(seed);
    for (; !telling && seed < SAME_SCENES; seed++) one(seed);
    return 0;
}
