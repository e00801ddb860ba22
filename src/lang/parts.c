/* parts.c - see parts.h. */
#include "lang/parts.h"
#include "lang/builtins.h"
#include "lang/code.h"

/* Operands taken by the operation at p, or -1 if it may not be moved. */
static int operands_of(const uint8_t *p, bool calls) {
    uint8_t op = *p;
    if (op >= OP_ADD && op <= OP_BOR) return 2;
    if ((op >= OP_NEG && op <= OP_POWI) || op == OP_REAL1 || op == OP_KEEP) return 1;
    if (op == OP_FUNC) return BUILTINS[p[1]].flags & BUILTIN_IMPURE ? -1 : p[2];
    if (op == OP_CALL) return calls ? p[2] : -1;
    return op < OP_SET || (op > OP_SET && op < OP_ADD) || op == OP_LOCAL ? 0 : -1;
}

bool parts_find(const uint8_t *code, bool calls, parts_t *parts) {
    uint16_t open[PARTS_MAX + 1] = {0}; /* where the operands on the stack start */
    int depth = 0;
    uint16_t at = code[0] == OP_FRAME ? 2 : 0;
    for (parts->n = 0; code[at] != OP_RET; parts->n++) {
        int takes = operands_of(code + at, calls);
        if (takes < 0 || parts->n == PARTS_MAX) return false;
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
