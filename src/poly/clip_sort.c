/* clip_sort.c - segments in the order of their left ends: byte by byte from the last one (radix), by x and where
 * that is equal by y; few by insertion, where they are not very few after they were dealt out along x.
 */
#include "poly/clip_inner.h"

#include <string.h>

#define FEW 64
#define VERY_FEW 20

enum { BY_Y, BY_X };

static uint32_t word(const clip_seg_t *s, int which) {
    return (uint32_t)(which == BY_X ? s->l.x : s->l.y) ^ 0x80000000u;
}

static void insertion(clip_seg_t *s, int32_t n) {
    for (int32_t k = 1; k < n; k++) {
        clip_seg_t moved = s[k];
        int32_t j = k;
        for (; j > 0 && poly_before(moved.l, s[j - 1].l); j--) s[j] = s[j - 1];
        s[j] = moved;
    }
}

/* Deals 2 to FEW segments out to as many columns of equal width, so that each is near its place, and copies them back.
 * Equal ones keep their order. */
static void deal(clip_seg_t *s, int32_t n, clip_seg_t *spare) {
    uint32_t least = word(&s[0], BY_X), most = least;
    for (int32_t k = 1; k < n; k++) {
        const uint32_t x = word(&s[k], BY_X);
        least = x < least ? x : least;
        most = x > most ? x : most;
    }
    const uint32_t columns_q32 =
        (uint32_t)(((uint64_t)n << 32) / ((uint64_t)(most - least) + (uint64_t)n)); /* in a unit */
    uint8_t start[FEW + 1] = {0};
    for (int32_t k = 0; k < n; k++) start[((uint64_t)(word(&s[k], BY_X) - least) * columns_q32 >> 32) + 1]++;
    for (int32_t b = 1; b < n; b++) start[b] = (uint8_t)(start[b] + start[b - 1]);
    for (int32_t k = 0; k < n; k++) spare[start[(uint64_t)(word(&s[k], BY_X) - least) * columns_q32 >> 32]++] = s[k];
    memcpy(s, spare, (size_t)n * sizeof *s);
}

/* By one coordinate, keeping the order of equals. */
static void radix(clip_seg_t *s, int32_t n, clip_seg_t *spare, int which) {
    clip_seg_t *from = s, *to = spare;
    uint32_t differ = 0;
    for (int32_t k = 1; k < n; k++) differ |= word(&from[k], which) ^ word(&from[0], which);
    for (int shift = 0; shift < 32; shift += 8) {
        if (!(differ >> shift & 0xff)) continue;
        int32_t start[256] = {0}, at = 0;
        for (int32_t k = 0; k < n; k++) start[word(&from[k], which) >> shift & 0xff]++;
        for (int b = 0; b < 256; b++) {
            int32_t count = start[b];
            start[b] = at;
            at += count;
        }
        for (int32_t k = 0; k < n; k++) to[start[word(&from[k], which) >> shift & 0xff]++] = from[k];
        clip_seg_t *swap = from;
        from = to;
        to = swap;
    }
    if (from != s) memcpy(s, from, (size_t)n * sizeof(clip_seg_t));
}

void clip_sort(clip_seg_t *s, int32_t n, clip_seg_t *spare) {
    if (n <= FEW) {
        if (n > VERY_FEW) deal(s, n, spare);
        insertion(s, n);
        return;
    }
    radix(s, n, spare, BY_X);
    for (int32_t from = 0, to = 0; from < n; from = to) {
        for (to = from + 1; to < n && s[to].l.x == s[from].l.x;) to++;
        if (to - from > FEW)
            radix(s + from, to - from, spare, BY_Y);
        else
            insertion(s + from, to - from);
    }
}
