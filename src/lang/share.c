/* share.c - see share.h.
 *
 * Equal operands are equal runs of bytes (parts.h). So: note for each operation where its
 * operand starts, take the longest run that occurs twice, keep its value behind the first and load it instead of
 * the others; again until nothing of use is left. Taking the longest first keeps a shared part from hiding a larger one
 * around it. */
#include "lang/share.h"
#include "lang/code.h"
#include "lang/parts.h"

static bool same(const uint8_t *code, const parts_t *p, int i, int k) {
    size_t len = (size_t)(p->end[i] - p->start[i]);
    return p->end[k] - p->start[k] == (int)len && memcmp(code + p->start[i], code + p->start[k], len) == 0;
}

/* The first operation that completes the longest repeated operand, or -1. Two bytes (x**2) are not worth keeping. */
static int longest_repeated(const uint8_t *code, const parts_t *p) {
    int best = -1, best_len = 2;
    for (int i = 0; i < p->n; i++) {
        int len = p->end[i] - p->start[i];
        if (p->leaf[i] || len <= best_len) continue;
        for (int k = i + 1; k < p->n; k++) {
            if (!same(code, p, i, k)) continue;
            best = i;
            best_len = len;
            break;
        }
    }
    return best;
}

/* Replaces `old` bytes at `at` by the two of an operation. */
static uint16_t splice(uint8_t *code, uint16_t len, uint16_t at, uint16_t old, uint8_t op, uint8_t operand) {
    memmove(code + at + 2, code + at + old, (size_t)(len - at - old));
    code[at] = op;
    code[at + 1] = operand;
    return (uint16_t)(len + 2 - old);
}

uint16_t share_parts(uint8_t *code, uint16_t len, size_t room, uint8_t params, uint8_t *kept) {
    parts_t p;
    *kept = 0;
    /* A share adds 1 byte at the most, 2 for OP_KEEP less what each part replaced gives back; the frame 2. */
    while (*kept < SHARE_MAX && len + 3u <= room && parts_find(code, false, &p)) {
        int first = longest_repeated(code, &p);
        if (first < 0) break;
        uint8_t slot = (uint8_t)(params + *kept);
        uint16_t old = (uint16_t)(p.end[first] - p.start[first]);
        for (int k = p.n - 1; k > first; k--) {
            if (same(code, &p, first, k)) len = splice(code, len, p.start[k], old, OP_LOCAL, slot);
        }
        len = splice(code, len, p.end[first], 0, OP_KEEP, slot);
        ++*kept;
    }
    return *kept ? splice(code, len, 0, 0, OP_FRAME, *kept) : len;
}
