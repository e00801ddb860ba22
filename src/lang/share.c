/* share.c - see share.h.
 *
 * In stack code an operand is a run of bytes, and equal operands are equal runs. So: note for each operation where its
 * operand starts, take the longest run that occurs twice, keep its value behind the first and load it instead of
 * the others; again until nothing of use is left. Taking the longest first keeps a shared part from hiding a larger one
 * around it. */
#include "lang/share.h"
#include "lang/builtins.h"
#include "lang/code.h"

typedef struct parts {
    int n;
    uint16_t start[SHARE_OPS]; /* of the operand that operation i completes */
    uint16_t end[SHARE_OPS];
    bool leaf[SHARE_OPS]; /* it is a constant, variable or argument */
} parts_t;

/* Operands taken by the operation at p, or -1 if it forbids sharing. */
static int operands_of(const uint8_t *p) {
    uint8_t op = *p;
    if (op >= OP_ADD && op <= OP_BOR) return 2;
    if ((op >= OP_NEG && op <= OP_POWI) || op == OP_REAL1 || op == OP_KEEP) return 1;
    if (op == OP_FUNC) return BUILTINS[p[1]].flags & BUILTIN_IMPURE ? -1 : p[2];
    return op < OP_SET || (op > OP_SET && op < OP_ADD) || op == OP_LOCAL ? 0 : -1;
}

/* False if the code must be left alone. */
static bool find_parts(const uint8_t *code, parts_t *parts) {
    uint16_t open[SHARE_OPS] = {0}; /* where the operands on the stack start */
    int depth = 0;
    uint16_t at = 0;
    for (parts->n = 0; code[at] != OP_RET; parts->n++) {
        int takes = operands_of(code + at);
        if (takes < 0 || parts->n == SHARE_OPS) return false;
        uint16_t start = takes == 0 ? at : open[depth - takes];
        depth += 1 - takes;
        open[depth - 1] = start;
        parts->leaf[parts->n] = takes == 0;
        parts->start[parts->n] = start;
        at = (uint16_t)(at + 1 + code_operands(code[at]));
        parts->end[parts->n] = at;
    }
    return true;
}

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
    while (*kept < SHARE_MAX && len + 3u <= room && find_parts(code, &p)) {
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
