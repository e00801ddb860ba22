/* clip_sort.c - segments in the order of their left ends: byte by byte from the last one (radix), by x and where
 * that is equal by y; few by insertion.
 */
#include "poly/clip_inner.h"

#include <string.h>

#define FEW 48

enum { BY_Y, BY_X };

static uint32_t word(const clip_seg_t *s, int which) {
    return (uint32_t)(which == BY_X ? s->l.x : s->l.y) ^ 0x80000000u;
}

/* Borders run to and fro, so what comes next often has its place at one of the ends; else it is looked for. */
static void insertion(clip_seg_t *s, int32_t n) {
    for (int32_t k = 1; k < n; k++) {
        const clip_seg_t moved = s[k];
        if (!poly_before(moved.l, s[k - 1].l)) continue;
        int32_t lo = 0;
        for (int32_t left = k - 1; left > 0;) { /* without a branch to guess wrong */
            const int32_t half = left / 2;
            const bool before = poly_before(moved.l, s[lo + half].l);
            lo = before ? lo : lo + half + 1;
            left = before ? half : left - half - 1;
        }
        memmove(s + lo + 1, s + lo, (size_t)(k - lo) * sizeof *s);
        s[lo] = moved;
    }
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
