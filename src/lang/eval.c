/* eval.c - runs the stack code.
 *
 * The loop handles real operands itself, inline; whatever is rarer goes to arith.c. The value pushed last stays in
 * local variables (m, e, kind), which the compiler keeps in registers; `sp` points at the one below it. So there is
 * always one value, and the first push of a call stores one that means nothing. Arguments of a call are where the
 * caller pushed them, nothing is moved. The compiler of expressions has counted the values that a piece of code needs,
 * so the stack is checked once for each call and not for each push.
 *
 * Values go to and from the stack field by field: a load that spans two stores still under way, as that of a whole
 * value would, stalls a desktop core for longer than an addition takes. Each of the two saved about
 * 1.5 ns an operator. */
#include "lang/arith.h"
#include "lang/builtins.h"
#include "lang/expr.h"
#include "num/num_double.h"

static inline void put(value_t *to, int64_t m, int32_t e, uint8_t kind) {
    to->m = m;
    to->e = e;
    to->kind = kind;
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

/* Can the function behind OP_CALL be entered; top: where the last argument is. Returns NULL or the reason. */
static const char *refusal(const lang_t *l, const symbol_t *s, int args, const value_t *top, int calls, int *code) {
    *code = ERR_NAME;
    if (!s->defined) return SAID("undefined function");
    *code = ERR_VALUE;
    if (s->params != args) return SAID("wrong number of arguments for function");
    *code = ERR_FULL;
    if (calls == CONFIG_CALLS) return SAID("recursion too deep in function");
    size_t used = (size_t)(top + 1 - args - l->stack);
    if (used + s->u.code.stack > CONFIG_STACK) return SAID("out of stack in function");
    return NULL;
}

/* What the loop does with the topmost value. */
#define TOP_REAL ((num_t){m, e, false})
#define TOP_VALUE ((value_t){m, e, kind})
#define SPILL() (sp++, put(sp, m, e, kind))
#define TAKE(from) (m = (from)->m, e = (from)->e, kind = (from)->kind)
#define TAKE_INT(value) (m = (value), e = 0, kind = VALUE_INT)
#define DROP() (TAKE(sp), sp--)

#define TAKE_REAL(expression)                                                                                          \
    do {                                                                                                               \
        num_t result = (expression);                                                                                   \
        if (NUM_FAST_RARE(result.undef)) return end_undefined(l, out);                                                 \
        m = result.m;                                                                                                  \
        e = result.e;                                                                                                  \
        kind = VALUE_REAL;                                                                                             \
    } while (0)
#define BINARY_REAL(function)                                                                                          \
    if (NUM_FAST_RARE((sp->kind | kind) != VALUE_REAL)) goto mixed;                                                    \
    TAKE_REAL(function(((num_t){sp->m, sp->e, false}), TOP_REAL));                                                     \
    sp--;                                                                                                              \
    break
/* condition: on sign, that of the difference */
#define COMPARE_REAL(condition)                                                                                        \
    if (NUM_FAST_RARE((sp->kind | kind) != VALUE_REAL)) goto mixed;                                                    \
    sign = num_fast_cmp((num_t){sp->m, sp->e, false}, TOP_REAL);                                                       \
    TAKE_INT(condition);                                                                                               \
    sp--;                                                                                                              \
    break

int expr_eval(lang_t *l, const expr_t *x, const num_t *args, value_t *out) {
    for (int i = 0; i < x->params; i++) put(&l->stack[i], args[i].m, args[i].e, args[i].undef);
    return expr_run(l, x, out);
}

int expr_run(lang_t *l, const expr_t *x, value_t *out) {
    l->fault.code = 0;
    if (x->stack > CONFIG_STACK) return fail(l, out, ERR_FULL, "expression needs more than the stack", -1);
    value_t *base = l->stack, *sp = base + x->params - 1;
    int64_t m = 0;
    int32_t e = 0;
    uint8_t kind = VALUE_REAL;
    const uint8_t *pc = x->code;
    const char *fault;
    int calls = 0, sign;
    int32_t work = 0;
    bool truth;
#if CONFIG_CONTROL
    value_t text;
    if (l->texts) l->texts->working = 0;
#endif
    for (;;) {
        uint8_t op = *pc++;
    again:
        switch (op) {
        case OP_ARG:
        case OP_ARG + 1:
        case OP_ARG + 2:
        case OP_ARG + 3:
        case OP_ARG + 4:
        case OP_ARG + 5:
        case OP_ARG + 6:
        case OP_ARG + 7:
            SPILL();
            TAKE(&base[op - OP_ARG]);
            break;
        case OP_VAR: {
            const symbol_t *s = &l->symbol[*pc];
            const value_t *v = &s->u.value;
            if (NUM_FAST_RARE(!s->defined)) {
#if CONFIG_CONTROL
                if (names_value(l, *pc, &text))
                    v = &text;
                else
#endif
                    return fail(l, out, ERR_NAME, "undefined variable", *pc);
            }
            SPILL();
            TAKE(v);
            pc++;
            break;
        }
        case OP_SET: /* of a number it is always done */
            if (!names_assign(l, *pc, TOP_VALUE) && CONFIG_CONTROL)
                return fail(l, out, ERR_FULL, "no memory for the text", *pc);
            pc++;
            break;
        case OP_INT8:
            SPILL();
            TAKE_INT(code_int8(pc));
            pc++;
            break;
        case OP_INT64: {
            SPILL();
            TAKE_INT(code_int64(pc).m);
            pc += 8;
            break;
        }
        case OP_REAL: {
            value_t v = code_real(pc);
            SPILL();
            TAKE(&v);
            pc += 10;
            break;
        }
        case OP_REAL_SHORT: {
            num_t n = code_real_short(pc);
            SPILL();
            TAKE_REAL(n);
            pc += 3;
            break;
        }
        case OP_SUB: /* one copy of the addition, inlined, serves both */
            if (NUM_FAST_RARE((sp->kind | kind) != VALUE_REAL)) goto mixed;
            m = -m;
            /* fall through */
        case OP_ADD:
            BINARY_REAL(num_double_add);
        case OP_MUL:
            BINARY_REAL(num_double_mul);
        case OP_DIV:
            BINARY_REAL(num_double_div);
        case OP_LT:
            COMPARE_REAL(sign < 0);
        case OP_LE:
            COMPARE_REAL(sign <= 0);
        case OP_GT:
            COMPARE_REAL(sign > 0);
        case OP_GE:
            COMPARE_REAL(sign >= 0);
        mixed: /* an integer meets a real and becomes one: 7*y inside of a function */
            if ((sp->kind ^ kind) != (VALUE_REAL ^ VALUE_INT)) goto binary;
            if (kind == VALUE_INT) {
                TAKE_REAL(value_from_integer(m));
            } else {
                num_t left = value_from_integer(sp->m);
                put(sp, left.m, left.e, VALUE_REAL);
            }
            goto again;
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
            fault = arith_binary(op, sp, TOP_VALUE);
            if (fault) goto failed;
            DROP();
            break;
        case OP_SQUARE:
            if (NUM_FAST_RARE(kind != VALUE_REAL)) goto unary;
            TAKE_REAL(num_double_mul(TOP_REAL, TOP_REAL));
            break;
        case OP_NEG:
            if (NUM_FAST_RARE(kind != VALUE_REAL)) goto unary;
            m = -m;
            break;
        case OP_NOT:
        case OP_BNOT:
        case OP_FACT:
        unary : {
            value_t v = TOP_VALUE;
            fault = arith_unary(op, &v);
            if (fault) goto failed;
            TAKE(&v);
            break;
        }
        case OP_POWI: {
            value_t v = TOP_VALUE;
            fault = arith_power(&v, code_int8(pc++));
            if (fault) goto failed;
            TAKE(&v);
            break;
        }
        case OP_POP:
            DROP();
            break;
        case OP_JUMP:
            pc += 2 + code_u16(pc);
            break;
        case OP_JZ:
            fault = arith_truth(TOP_VALUE, &truth);
            if (fault) goto failed;
            DROP();
            pc += truth ? 2 : 2 + code_u16(pc);
            break;
        case OP_AND:
        case OP_OR:
            fault = arith_truth(TOP_VALUE, &truth);
            if (fault) goto failed;
            if (truth == (op == OP_OR)) {
                TAKE_INT(truth);
                pc += 2 + code_u16(pc);
            } else {
                DROP();
                pc += 2;
            }
            break;
        case OP_BOOL:
            fault = arith_truth(TOP_VALUE, &truth);
            if (fault) goto failed;
            TAKE_INT(truth);
            break;
        case OP_REAL1: {
            const builtin_t *f = &BUILTINS[*pc++];
            if (NUM_FAST_RARE(kind == VALUE_UNDEF)) break;
#if CONFIG_CONTROL
            if (NUM_FAST_RARE(kind == VALUE_TEXT)) {
                text = TOP_VALUE;
                fault = arith_number(&text);
                if (fault) goto failed;
                TAKE(&text);
            }
#endif
            const num_t r = f->real1(NUM_FAST_RARE(kind == VALUE_INT) ? value_num(TOP_VALUE) : TOP_REAL);
            TAKE_REAL(num_double((num_t){r.m, r.e, r.undef})); /* as it is, it would be copied as a whole */
            break;
        }
        case OP_FUNC: {
            SPILL();
            sp -= pc[1];
            fault = builtin_call(&BUILTINS[pc[0]], l, sp + 1, pc[1]);
            if (fault) goto failed;
            TAKE(sp + 1);
            pc += 2;
            break;
        }
        case OP_FRAME:
            sp += *pc++;
            break;
        case OP_KEEP:
            put(&base[*pc++], m, e, kind);
            break;
        case OP_LOCAL:
            SPILL();
            TAKE(&base[*pc]);
            pc++;
            break;
        case OP_CALL: {
            const symbol_t *s = &l->symbol[pc[0]];
            int code;
            SPILL();
            fault = refusal(l, s, pc[1], sp, calls, &code);
            if (NUM_FAST_RARE(fault != NULL)) return fail(l, out, code, fault, pc[0]);
            if (NUM_FAST_RARE(++work > CONFIG_CALL_WORK))
                return fail(l, out, ERR_FULL, "too many calls in one evaluation", -1);
            l->call[calls].pc = pc + 2;
            l->call[calls++].base = (uint16_t)(base - l->stack);
            base = sp + 1 - s->params;
            pc = l->pool + s->u.code.start;
            break;
        }
        default: /* OP_RET */
            if (calls == 0) {
                put(out, m, e, kind);
                return 0;
            }
            sp = base - 1;
            base = l->stack + l->call[--calls].base;
            pc = l->call[calls].pc;
            break;
        }
    }
failed:
    if (fault == ARITH_UNDEFINED) return end_undefined(l, out);
    return fail(l, out, ERR_VALUE, fault, -1);
}
