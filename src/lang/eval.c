/* eval.c - runs the stack code.
 *
 * The loop handles real operands itself, inline; whatever is rarer goes to arith.c. `top` points at the value
 * pushed last; arguments of a call are where the caller pushed them, so a call moves nothing. The compiler has
 * counted the values that a piece of code needs, so the stack is checked once for each call and not for each push. */
#include "lang/arith.h"
#include "lang/builtins.h"
#include "lang/expr.h"
#include "num/num_double.h"

/* Values go to and from the stack field by field: a load that spans two stores still under way, as that of a whole
 * value would, stalls a desktop core for longer than an addition takes (measured: 3 ns an operator). */
static inline num_t real_of(const value_t *v) {
    return (num_t){v->m, v->e, false};
}

static inline void put(value_t *to, int64_t m, int32_t e, uint8_t kind) {
    to->m = m;
    to->e = e;
    to->kind = kind;
}

static inline void put_real(value_t *to, num_t n) {
    put(to, n.m, n.e, n.undef);
}
static inline void put_int(value_t *to, int64_t i) {
    put(to, i, 0, VALUE_INT);
}
static inline void copy(value_t *to, const value_t *from) {
    put(to, from->m, from->e, from->kind);
}

static int fail(lang_t *l, value_t *out, int code, const char *text, int symbol) {
    l->fault.code = code;
    l->fault.text = text;
    l->fault.symbol = (int16_t)symbol;
    *out = value_undef();
    return code;
}

/* An undefined result is no error of the evaluation; expr_value looks at the fault to tell 1/0 from NaN. */
static int end_undefined(lang_t *l, value_t *out) {
    fail(l, out, ERR_VALUE, ARITH_UNDEFINED, -1);
    return 0;
}

/* Can the function behind OP_CALL be entered; top: the last argument. Returns NULL or the reason. */
static const char *refusal(const lang_t *l, const symbol_t *s, int args, const value_t *top, int calls, int *code) {
    *code = ERR_NAME;
    if (!s->defined) return "undefined function";
    *code = ERR_VALUE;
    if (s->params != args) return "wrong number of arguments for function";
    *code = ERR_FULL;
    if (calls == CONFIG_CALLS) return "recursion too deep in function";
    size_t used = (size_t)(top + 1 - args - l->stack);
    if (used + s->u.code.stack > CONFIG_STACK) return "out of stack in function";
    return NULL;
}

#define BINARY_REAL(fast)                                                                                              \
    if (NUM_FAST_RARE((top[-1].kind | top->kind) != VALUE_REAL)) goto binary;                                          \
    top--;                                                                                                             \
    put_real(top, fast(real_of(top), real_of(top + 1)));                                                               \
    if (NUM_FAST_RARE(top->kind != VALUE_REAL)) return end_undefined(l, out);                                          \
    break

#define COMPARE_REAL(relation)                                                                                         \
    if (NUM_FAST_RARE((top[-1].kind | top->kind) != VALUE_REAL)) goto binary;                                          \
    top--;                                                                                                             \
    put_int(top, num_fast_cmp(real_of(top), real_of(top + 1)) relation 0);                                             \
    break

int expr_eval(lang_t *l, const expr_t *e, const num_t *args, value_t *out) {
    l->fault.code = 0;
    if (e->stack > CONFIG_STACK) return fail(l, out, ERR_FULL, "expression needs more than the stack", -1);
    value_t *base = l->stack, *top = base - 1;
    for (int i = 0; i < e->params; i++) put_real(++top, args[i]);
    const uint8_t *pc = e->code;
    const char *fault;
    int calls = 0;
    int32_t work = 0;
    bool truth;
    for (;;) {
        uint8_t op = *pc++;
        switch (op) {
        case OP_ARG:
        case OP_ARG + 1:
        case OP_ARG + 2:
        case OP_ARG + 3:
        case OP_ARG + 4:
        case OP_ARG + 5:
        case OP_ARG + 6:
        case OP_ARG + 7:
            *++top = base[op - OP_ARG];
            break;
        case OP_VAR: {
            const symbol_t *s = &l->symbol[*pc];
            if (NUM_FAST_RARE(!s->defined)) return fail(l, out, ERR_NAME, "undefined variable", *pc);
            copy(++top, &s->u.value);
            pc++;
            break;
        }
        case OP_SET:
            l->symbol[*pc].defined = true;
            l->symbol[*pc++].u.value = *top;
            break;
        case OP_INT8:
            *++top = value_int(code_int8(pc++));
            break;
        case OP_INT64:
            *++top = code_int64(pc);
            pc += 8;
            break;
        case OP_REAL:
            *++top = code_real(pc);
            pc += 10;
            break;
        case OP_REAL_SHORT:
            put_real(++top, code_real_short(pc));
            pc += 3;
            break;
        case OP_SUB: /* one copy of the addition, inlined, serves both */
            if (NUM_FAST_RARE((top[-1].kind | top->kind) != VALUE_REAL)) goto binary;
            top->m = -top->m;
            /* fall through */
        case OP_ADD:
            BINARY_REAL(num_double_add);
        case OP_MUL:
            BINARY_REAL(num_double_mul);
        case OP_DIV:
            BINARY_REAL(num_double_div);
        case OP_LT:
            COMPARE_REAL(<);
        case OP_LE:
            COMPARE_REAL(<=);
        case OP_GT:
            COMPARE_REAL(>);
        case OP_GE:
            COMPARE_REAL(>=);
        case OP_MOD:
        case OP_POW:
        case OP_SHL:
        case OP_SHR:
        case OP_EQ:
        case OP_NE:
        case OP_BAND:
        case OP_XOR:
        case OP_BOR:
        binary:
            top--;
            fault = arith_binary(op, top, top[1]);
            if (fault) goto failed;
            break;
        case OP_SQUARE:
            if (NUM_FAST_RARE(top->kind != VALUE_REAL)) goto unary;
            put_real(top, num_double_mul(real_of(top), real_of(top)));
            if (NUM_FAST_RARE(top->kind != VALUE_REAL)) return end_undefined(l, out);
            break;
        case OP_NEG:
            if (NUM_FAST_RARE(top->kind != VALUE_REAL)) goto unary;
            top->m = -top->m;
            break;
        case OP_NOT:
        case OP_BNOT:
        case OP_FACT:
        unary:
            fault = arith_unary(op, top);
            if (fault) goto failed;
            break;
        case OP_POWI:
            fault = arith_power(top, code_int8(pc++));
            if (fault) goto failed;
            break;
        case OP_POP:
            top--;
            break;
        case OP_JUMP:
            pc += 2 + code_u16(pc);
            break;
        case OP_JZ:
            fault = arith_truth(*top--, &truth);
            if (fault) goto failed;
            pc += truth ? 2 : 2 + code_u16(pc);
            break;
        case OP_AND:
        case OP_OR:
            fault = arith_truth(*top, &truth);
            if (fault) goto failed;
            if (truth == (op == OP_OR)) {
                *top = value_int(truth);
                pc += 2 + code_u16(pc);
            } else {
                top--;
                pc += 2;
            }
            break;
        case OP_BOOL:
            fault = arith_truth(*top, &truth);
            if (fault) goto failed;
            *top = value_int(truth);
            break;
        case OP_REAL1:
            if (NUM_FAST_RARE(top->kind != VALUE_REAL)) {
                if (top->kind == VALUE_UNDEF) {
                    pc++;
                    break;
                }
                put_real(top, value_num(*top));
            }
            put_real(top, num_double(BUILTINS[*pc++].real1(real_of(top))));
            if (NUM_FAST_RARE(top->kind != VALUE_REAL)) return end_undefined(l, out);
            break;
        case OP_FUNC:
            top -= pc[1] - 1;
            fault = BUILTINS[pc[0]].any(l, top, pc[1]);
            if (fault) goto failed;
            pc += 2;
            break;
        case OP_FRAME:
            top += *pc++;
            break;
        case OP_KEEP:
            copy(&base[*pc++], top);
            break;
        case OP_LOCAL:
            copy(++top, &base[*pc++]);
            break;
        case OP_CALL: {
            const symbol_t *s = &l->symbol[pc[0]];
            int code;
            fault = refusal(l, s, pc[1], top, calls, &code);
            if (NUM_FAST_RARE(fault != NULL)) return fail(l, out, code, fault, pc[0]);
            if (NUM_FAST_RARE(++work > CONFIG_CALL_WORK))
                return fail(l, out, ERR_FULL, "too many calls in one evaluation", -1);
            l->call[calls].pc = pc + 2;
            l->call[calls++].base = (uint16_t)(base - l->stack);
            base = top + 1 - s->params;
            pc = l->pool + s->u.code.start;
            break;
        }
        default: /* OP_RET */
            if (calls == 0) {
                copy(out, top);
                return 0;
            }
            copy(base, top);
            top = base;
            base = l->stack + l->call[--calls].base;
            pc = l->call[calls].pc;
            break;
        }
    }
failed:
    if (fault == ARITH_UNDEFINED) return end_undefined(l, out);
    return fail(l, out, ERR_VALUE, fault, -1);
}
