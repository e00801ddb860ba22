/* same_main.c - see same.h. */
#include "tests/emu/bare/same.h"

#include <stddef.h>

#include "tests/emu/bare/bare.h"

/* FNV-1a. */
void same_enter(same_t *s, int64_t v, const char *after) {
    for (int i = 0; i < 8; i++) s->hash = (s->hash ^ (uint8_t)((uint64_t)v >> (8 * i))) * 0x100000001b3u;
    if (!s->telling || !after) return;
    bare_number(v);
    bare_text(after);
}

int same_ink(void *ctx, const ink_piece_t *p) {
    const int64_t field[] = {p->family, p->surface, p->line, p->from, p->to};
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) same_enter(ctx, field[i], i < 4 ? " " : "\n");
    return 0;
}

void same_num(const same_t *s, num_t v) {
    if (!s->telling) return;
    bare_text(v.undef ? " undefined" : " ");
    if (v.undef) return;
    bare_number(v.m);
    bare_text("e");
    bare_number(v.e);
}

static void line(uint64_t seed, const same_t *s) {
    bare_number((int64_t)seed);
    bare_text(" ");
    bare_hex(s->hash);
    bare_text("\n");
}

static uint64_t number(const char *p) {
    uint64_t v = 0;
    for (; *p >= '0' && *p <= '9'; p++) v = 10 * v + (uint64_t)(*p - '0');
    return v;
}

int bare_main(int argc, char **argv) {
    const uint64_t first = argc > 1 ? number(argv[1]) : 0;
    const bool one = argc == 2, cut = argc == 4;
    const uint64_t count = argc == 3 ? number(argv[2]) : 1;
    for (uint64_t seed = first; seed < first + count; seed++) {
        same_t s = {.hash = 0xcbf29ce484222325u, .telling = one || cut, .drop = cut ? (uint32_t)number(argv[3]) : 0};
        same_scene(seed, &s);
        line(seed, &s);
    }
    return 0;
}
