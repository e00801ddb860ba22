/* arith.c - see arith.h. Every rule here was checked against gnuplot 5.4 (tests/unit/test_expr.c has the cases). */
#include "lang/arith.h"
#include "lang/lexer.h"
#include "num/func.h"
#include "num/num_double.h"

const char ARITH_UNDEFINED[] = "undefined value";
static const char NOT_BOOLEAN[] = "non-integer passed to boolean operator";

/* The result of real arithmetic on defined operands. */
static const char *store(value_t *a, num_t r) {
    r = num_double(r);
    *a = value_real(r);
    return r.undef ? ARITH_UNDEFINED : NULL;
}

/* Powers up to this are products: within 64 ulp of 2^-62, which is 1/8 of a double's. */
enum { PRODUCT_POWER = 64 };

static bool is_small(int64_t n) {
    return n >= -PRODUCT_POWER && n <= PRODUCT_POWER;
}

static uint64_t magnitude(int64_t v) {
    return v < 0 ? 0u - (uint64_t)v : (uint64_t)v;
}

/* a * b if 64 bits hold it; not the compiler's overflow builtin, which calls a function that a board may lack. */
static bool multiply(int64_t a, int64_t b, int64_t *product) {
    uint64_t ua = magnitude(a), ub = magnitude(b);
    if (((ua | ub) >> 31) != 0 && ub != 0 && ua > (uint64_t)INT64_MAX / ub) return false;
    *product = (int64_t)((uint64_t)a * (uint64_t)b);
    return true;
}

/* a**n as an integer, if that fits. */
static bool integer_product(int64_t base, int64_t n, int64_t *result) {
    *result = 1;
    if (n < 0) return false;
    while (n) {
        if ((n & 1) && !multiply(*result, base, result)) return false;
        n >>= 1;
        if (n && !multiply(base, base, &base)) return false;
    }
    return true;
}

static const char *integer_power(value_t *a, int64_t n) {
    int64_t result;
    if (a->m == 0 && n < 0) return ARITH_UNDEFINED;
    if (integer_product(a->m, n, &result)) {
        *a = value_int(result);
        return NULL;
    }
    num_t b = value_num(*a);
    return store(a, is_small(n) ? num_ipow(b, (int32_t)n) : func_pow(b, num_from_i64(n)));
}

static const char *integer_binary(uint8_t op, value_t *a, int64_t b) {
    int64_t x = a->m;
    unsigned shift = (unsigned)b & 63u; /* as x86 shifts, hence gnuplot on the desktop */
    int64_t r;
    switch (op) {
    case OP_ADD:
        r = (int64_t)((uint64_t)x + (uint64_t)b);
        if (((x ^ r) & (b ^ r)) < 0) return store(a, num_add(value_from_integer(x), value_from_integer(b)));
        break;
    case OP_SUB:
        r = (int64_t)((uint64_t)x - (uint64_t)b);
        if (((x ^ b) & (x ^ r)) < 0) return store(a, num_sub(value_from_integer(x), value_from_integer(b)));
        break;
    case OP_MUL:
        if (!multiply(x, b, &r)) return store(a, num_mul(value_from_integer(x), value_from_integer(b)));
        break;
    case OP_DIV:
    case OP_MOD:
        if (b == 0 || (b == -1 && x == INT64_MIN)) return ARITH_UNDEFINED;
        r = op == OP_DIV ? x / b : x % b;
        break;
    case OP_SHL:
        r = (int64_t)((uint64_t)x << shift);
        break;
    case OP_SHR:
        r = (int64_t)((uint64_t)x >> shift);
        break;
    case OP_LT:
        r = x < b;
        break;
    case OP_LE:
        r = x <= b;
        break;
    case OP_GT:
        r = x > b;
        break;
    case OP_GE:
        r = x >= b;
        break;
    case OP_EQ:
        r = x == b;
        break;
    case OP_NE:
        r = x != b;
        break;
    case OP_BAND:
        r = x & b;
        break;
    case OP_XOR:
        r = x ^ b;
        break;
    default:
        r = x | b;
        break;
    }
    *a = value_int(r);
    return NULL;
}

/* sign: of a - b, or 2 when one of them is undefined. */
static int64_t compare(uint8_t op, int sign) {
    switch (op) {
    case OP_LT:
        return sign == -1;
    case OP_LE:
        return sign == -1 || sign == 0;
    case OP_GT:
        return sign == 1;
    case OP_GE:
        return sign == 0 || sign == 1;
    case OP_EQ:
        return sign == 0;
    default:
        return sign != 0;
    }
}

static const char *real_power(value_t *a, value_t b) {
    if (a->kind == VALUE_UNDEF || b.kind == VALUE_UNDEF) {
        *a = value_undef();
        return NULL;
    }
    num_t n = value_num(b), base = value_num(*a);
    if (num_is_integer(n)) {
        bool ok = true;
        int64_t k = num_to_fixed(n, 0, &ok);
        if (ok && is_small(k)) return store(a, num_ipow(base, (int32_t)k));
    }
    return store(a, func_pow(base, n));
}

static const char *real_binary(uint8_t op, value_t *a, value_t b) {
    bool nan = a->kind == VALUE_UNDEF || b.kind == VALUE_UNDEF;
    num_t x = value_num(*a), y = value_num(b);
    if (op >= OP_LT) {
        *a = value_int(compare(op, nan ? 2 : num_cmp(x, y)));
        return NULL;
    }
    if (nan) {
        *a = value_undef();
        return NULL;
    }
    if (op == OP_SUB) y = num_neg(y);
    if (op == OP_MUL) return store(a, num_double_mul(x, y));
    return store(a, op == OP_DIV ? num_double_div(x, y) : num_double_add(x, y));
}

#if CONFIG_CONTROL
const char *arith_number_of_text(value_t *a) {
    lexer_t lx;
    lexer_start(&lx, value_chars(*a), (size_t)a->e);
    const bool minus = lexer_accept(&lx, '-');
    if (!minus) lexer_accept(&lx, '+');
    const bool number = lx.tok.kind == TOKEN_NUMBER && lx.pos == lx.len;
    *a = number ? lx.tok.value : value_undef();
    if (!number) return SAID("this text is not a number");
    return minus ? arith_unary(OP_NEG, a) : NULL;
}

static const char *numbers(value_t *a, value_t *b) {
    const char *fault = arith_number(a);
    return fault ? fault : arith_number(b);
}
#endif

const char *arith_binary(uint8_t op, value_t *a, value_t b) {
#if CONFIG_CONTROL
    if ((a->kind | b.kind) & VALUE_TEXT && op != OP_BAND && op != OP_XOR && op != OP_BOR) {
        const char *fault = numbers(a, &b);
        if (fault) return fault;
    }
#endif
    if (a->kind == VALUE_INT && b.kind == VALUE_INT)
        return op == OP_POW ? integer_power(a, b.m) : integer_binary(op, a, b.m);
    switch (op) {
    case OP_MOD:
        return SAID("non-integer operand for %");
    case OP_SHL:
    case OP_SHR:
        return SAID("bit shift applied to non-INT");
    case OP_BAND:
    case OP_XOR:
    case OP_BOR:
        return NOT_BOOLEAN;
    case OP_POW:
        return b.kind == VALUE_INT && is_small(b.m) ? arith_power(a, (int32_t)b.m) : real_power(a, b);
    default:
        return real_binary(op, a, b);
    }
}

static const char *factorial(value_t *a) {
    enum { FITS = 20, TOO_LARGE = 300 }; /* 20! < 2^63; 300! is far above every limit */
    if (a->kind != VALUE_INT) return SAID("factorial (!) argument must be an integer");
    int64_t n = a->m;
    if (n > TOO_LARGE) return ARITH_UNDEFINED;
    int64_t r = 1;
    for (int64_t i = 2; i <= n && i <= FITS; i++) r *= i;
    if (n <= FITS) {
        *a = value_int(r);
        return NULL;
    }
    num_t product = num_from_i64(r);
    for (int64_t i = FITS + 1; i <= n; i++) product = num_mul(product, num_from_i64(i));
    return store(a, product);
}

const char *arith_unary(uint8_t op, value_t *a) {
    bool truth;
    const char *text = op == OP_NOT || op == OP_BNOT ? NULL : arith_number(a); /* of texts they are no numbers */
    if (text) return text;
    switch (op) {
    case OP_NEG:
        if (a->kind == VALUE_INT)
            a->m = (int64_t)(0u - (uint64_t)a->m); /* -INT64_MIN stays, as in gnuplot */
        else
            a->m = -a->m;
        return NULL;
    case OP_NOT: {
        const char *fault = arith_truth(*a, &truth);
        if (!fault) *a = value_int(!truth);
        return fault;
    }
    case OP_BNOT:
        if (a->kind != VALUE_INT) return NOT_BOOLEAN;
        a->m = ~a->m;
        return NULL;
    case OP_FACT:
        return factorial(a);
    default:
        return arith_power(a, 2);
    }
}

const char *arith_power(value_t *a, int32_t k) {
    const char *text = arith_number(a);
    if (text) return text;
    if (a->kind == VALUE_INT) return integer_power(a, k);
    if (a->kind == VALUE_UNDEF) {
        if (k == 0) *a = value_real(num_from_i64(1)); /* NaN**0 is 1 in C and so in gnuplot */
        return NULL;
    }
    return store(a, num_ipow(value_num(*a), k));
}

const char *arith_truth(value_t v, bool *truth) {
    *truth = v.m != 0;
    return v.kind == VALUE_INT ? NULL : NOT_BOOLEAN;
}

value_t arith_whole(num_t a) {
    bool ok = true;
    int64_t i = num_to_fixed(a, 0, &ok);
    return ok ? value_int(i) : value_undef();
}
