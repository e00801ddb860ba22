/* expr_columns.c - which columns of data an expression looks at. */
#include "lang/builtins.h"
#include "lang/code.h"
#include "lang/expr.h"

#if CONFIG_64BIT || CONFIG_BINARY
static bool goes_to(const uint8_t *code, const uint8_t *target) {
    for (const uint8_t *p = code; p < target; p += 1 + code_operands(*p)) {
        const bool jumps = *p == OP_JUMP || *p == OP_JZ || *p == OP_AND || *p == OP_OR;
        if (jumps && p + CODE_JUMP_LEN + code_u16(p + 1) == target) return true;
    }
    return false;
}

/* Code of the expression itself, where columns are told; they cannot be in a function. */
static bool scan(const uint8_t *code, uint16_t len, uint64_t *columns, bool called[CONFIG_SYMBOLS]) {
    const uint8_t *before = code;
    for (const uint8_t *p = code; p < code + len; before = p, p += 1 + code_operands(*p)) {
        if (*p == OP_CALL) called[p[1]] = true;
        if (*p == OP_SET) return false;
        if (*p != OP_FUNC || !(BUILTINS[p[1]].flags & (BUILTIN_IMPURE | BUILTIN_COLUMNS))) continue;
        const bool is_column = columns && p[1] == builtins_find("column", 6) && *before == OP_INT8;
        if (!is_column || goes_to(code, p)) return false;
        const int c = code_int8(before + 1);
        if (c < 0 || c > CONFIG_DATA_COLUMNS) return false;
        *columns |= (uint64_t)1 << c;
    }
    return true;
}

bool expr_is_of_columns(const lang_t *l, const expr_t *e, uint64_t *columns) {
    bool called[CONFIG_SYMBOLS] = {false}, seen[CONFIG_SYMBOLS] = {false};
    *columns = 0;
    if (e->params || !scan(e->code, e->len, columns, called)) return false;
    for (int i = 0; i < l->symbols;) {
        const symbol_t *s = &l->symbol[i];
        if (called[i] && !seen[i] && s->defined) {
            seen[i] = true;
            if (!scan(l->pool + s->u.code.start, s->u.code.len, NULL, called)) return false;
            i = 0; /* it may call functions that stand before it */
        } else {
            i++;
        }
    }
    return true;
}
#endif
