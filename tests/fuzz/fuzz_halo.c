/* Raw bytes as the edges of a wire frame: coordinates of one, two or four bytes, so that ends meet, lines coincide and
 * ranges are exceeded. Whatever comes, the visible pieces of an edge are in order and within it. */
#include "error.h"
#include "hidden/halo/halo.h"

#include <stdlib.h>
#include <string.h>

typedef struct seen {
    int32_t edges, id;
    uint32_t to;
    int64_t sum;
} seen_t;

static int take(void *ctx, int32_t id, uint32_t from, uint32_t to) {
    seen_t *s = ctx;
    if (id < 0 || id >= s->edges || from >= to || to > 1u << 30) abort();
    if (id == s->id && from <= s->to) abort();
    s->id = id;
    s->to = to;
    s->sum += to - from;
    return 0;
}

static int32_t number(const uint8_t **at, int bytes) {
    int32_t v = 0;
    int8_t small;
    int16_t middle;
    if (bytes == 1) memcpy(&small, *at, 1), v = small;
    if (bytes == 2) memcpy(&middle, *at, 2), v = middle;
    if (bytes == 4) memcpy(&v, *at, 4), v /= 2;
    *at += bytes;
    return v;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static uint64_t memory[40000];
    if (size < 4) return 0;
    const int bytes = 1 << data[0] % 3;
    const int32_t reach = data[1] & 1 ? (data[2] + 16) << data[1] / 16 : 0;
    const int32_t width = (data[3] + 16) << (data[1] / 16 < 3 ? data[1] / 16 : 3);
    const uint8_t *at = data + 4, *end = data + size;
    halo_t h;
    halo_init(&h, memory, sizeof memory - (data[1] & 2 ? 250000 : 0));
    while (end - at >= 6 * bytes && h.edges < 2000) {
        halo_point_t p[2];
        for (int k = 0; k < 2; k++)
            p[k].x = number(&at, bytes), p[k].y = number(&at, bytes), p[k].z = number(&at, bytes);
        halo_add(&h, h.edges, p[0], p[1]);
    }
    if (halo_cut(&h, reach) != 0) return 0;
    seen_t s = {.edges = h.edges, .id = -1}, all = s, more = s;
    if (halo_draw(&h, 0, &(halo_sink_t){&all, take}) || all.sum != (int64_t)h.edges << 30) abort();
    const int32_t wide = reach != 0 && width > reach ? reach : width;
    if (halo_draw(&h, wide / 2, &(halo_sink_t){&more, take}) || halo_draw(&h, wide, &(halo_sink_t){&s, take})) abort();
    return 0;
}
