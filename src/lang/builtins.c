/* builtins.c - the table of functions, and those that care for the kind of their arguments. */
#include "lang/builtins.h"
#include "lang/arith.h"
#include "lang/text_funcs.h"
#include "num/func.h"
#include "num/noise.h"
#include "num/num_double.h"

static const char *give(value_t *out, num_t r) {
    r = num_double(r);
    *out = value_real(r);
    return r.undef ? ARITH_UNDEFINED : NULL;
}

static const char *fn_abs(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    return a->m < 0 ? arith_unary(OP_NEG, a) : NULL;
}

static const char *fn_real(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    if (a->kind == VALUE_INT) *a = value_real(value_num(*a));
    return NULL;
}

static const char *fn_sgn(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    *a = value_int((a->m > 0) - (a->m < 0));
    return NULL;
}

static const char *whole(value_t *a, num_t (*round)(num_t)) {
    if (a->kind == VALUE_REAL) *a = arith_whole(round(value_num(*a)));
    return NULL;
}

static const char *fn_int(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    return a->kind == VALUE_UNDEF ? ARITH_UNDEFINED : whole(a, num_trunc);
}

static const char *fn_floor(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    return whole(a, num_floor);
}

static const char *fn_ceil(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    return whole(a, num_ceil);
}

static const char *fn_atan2(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    num_t y = value_num(a[0]), x = value_num(a[1]);
    if (y.undef || x.undef) {
        *a = value_undef();
        return NULL;
    }
    return y.m == 0 && x.m == 0 ? ARITH_UNDEFINED : give(a, func_atan2(y, x));
}

/* The smallest argument if sign is -1, the largest if it is 1; NaN if there is one. */
static const char *extreme(value_t *a, int n, int sign) {
    value_t best = a[0];
    for (int i = 1; i < n && best.kind != VALUE_UNDEF; i++) {
        bool better;
        if (a[i].kind == VALUE_UNDEF)
            better = true;
        else if (best.kind == VALUE_INT && a[i].kind == VALUE_INT)
            better = sign < 0 ? a[i].m < best.m : a[i].m > best.m;
        else
            better = num_cmp(value_num(a[i]), value_num(best)) == sign;
        if (better) best = a[i];
    }
    a[0] = best;
    return NULL;
}

static const char *fn_max(lang_t *l, value_t *a, int n) {
    (void)l;
    return extreme(a, n, 1);
}

static const char *fn_min(lang_t *l, value_t *a, int n) {
    (void)l;
    return extreme(a, n, -1);
}

static const char *fn_rand(lang_t *l, value_t *a, int n) {
    (void)n;
    num_t arg = value_num(*a);
    if (arg.undef) return NULL;
    int sign = num_sign(arg);
    if (sign < 0 || l->seed[0] == 0) l->seed[0] = l->seed[1] = NOISE_START;
    if (sign > 0) {
        bool ok = true;
        int64_t seed = num_to_fixed(num_trunc(arg), 0, &ok);
        if (!ok || seed < 1 || seed >= NOISE_M2) return SAID("illegal seed value");
        l->seed[0] = l->seed[1] = (int32_t)seed;
    }
    *a = value_real(noise_next(l->seed));
    return NULL;
}

static const char *fn_column(lang_t *l, value_t *a, int n) {
    (void)n;
    if (!l->column) return SAID("a column of data makes no sense here");
    bool ok = true;
    int64_t i = a->kind == VALUE_INT ? a->m : num_to_fixed(num_trunc(value_num(*a)), 0, &ok);
    if (!ok || i < INT16_MIN || i > INT16_MAX) return SAID("no such column");
    *a = l->column(l->column_ctx, (int32_t)i);
    return a->kind == VALUE_UNDEF ? ARITH_UNDEFINED : NULL;
}

/* Not the same for the same arguments, as far as the compiler can know. */
#define TEXTS (BUILTIN_IMPURE | BUILTIN_TEXTS)
#define TEXT (TEXTS | BUILTIN_TEXT)

const builtin_t BUILTINS[] = {
#if CONFIG_CONTROL
    {BUILTIN_IS_TEXT, 1, 1, TEXT, NULL, text_literal},
    {BUILTIN_IS_CONCAT, 2, 2, TEXT, NULL, text_concat},
    {BUILTIN_IS_EQ, 2, 2, TEXTS, NULL, text_eq},
    {BUILTIN_IS_NE, 2, 2, TEXTS, NULL, text_ne},
    {BUILTIN_IS_SLICE, 3, 3, TEXT, NULL, text_slice},
    {BUILTIN_IS_ELEMENT, 2, 2, TEXTS, NULL, array_element},
    {BUILTIN_IS_SIZE, 1, 1, TEXTS, NULL, array_size},
#endif
    {"abs", 1, 1, 0, NULL, fn_abs},
    {"acos", 1, 1, BUILTIN_ARC, func_acos, NULL},
    {"asin", 1, 1, BUILTIN_ARC, func_asin, NULL},
    {"atan", 1, 1, BUILTIN_ARC, func_atan, NULL},
    {"atan2", 2, 2, BUILTIN_ARC, NULL, fn_atan2},
    {"besj0", 1, 1, 0, func_besj0, NULL},
    {"besj1", 1, 1, 0, func_besj1, NULL},
    {"ceil", 1, 1, 0, NULL, fn_ceil},
    {"column", 1, 1, TEXTS | BUILTIN_COLUMNS, NULL, fn_column},
#if CONFIG_CONTROL
    {"columnhead", 0, 1, TEXT | BUILTIN_COLUMNS, NULL, text_of_column},
#endif
    {"cos", 1, 1, BUILTIN_ANGLE, func_cos, NULL},
    {"cosh", 1, 1, 0, func_cosh, NULL},
    {"erf", 1, 1, 0, func_erf, NULL},
    {"exp", 1, 1, 0, func_exp, NULL},
    {"floor", 1, 1, 0, NULL, fn_floor},
    {"gamma", 1, 1, 0, func_gamma, NULL},
#if CONFIG_CONTROL
    {"gprintf", 2, 2, TEXT, NULL, text_sprintf},
#endif
    {"int", 1, 1, 0, NULL, fn_int},
    {"invnorm", 1, 1, 0, func_invnorm, NULL},
    {"log", 1, 1, 0, func_log, NULL},
    {"log10", 1, 1, 0, func_log10, NULL},
    {"max", 2, 8, BUILTIN_OURS, NULL, fn_max},
    {"min", 2, 8, BUILTIN_OURS, NULL, fn_min},
    {"norm", 1, 1, 0, func_norm, NULL},
    {"rand", 1, 1, BUILTIN_IMPURE, NULL, fn_rand},
    {"real", 1, 1, 0, NULL, fn_real},
    {"sgn", 1, 1, 0, NULL, fn_sgn},
    {"sin", 1, 1, BUILTIN_ANGLE, func_sin, NULL},
    {"sinh", 1, 1, 0, func_sinh, NULL},
#if CONFIG_CONTROL
    {"sprintf", 1, 8, TEXT, NULL, text_sprintf},
#endif
    {"sqrt", 1, 1, 0, num_double_sqrt, NULL},
#if CONFIG_CONTROL
    {"strcol", 1, 1, TEXT | BUILTIN_COLUMNS, NULL, text_of_column},
    {"stringcolumn", 1, 1, TEXT | BUILTIN_COLUMNS, NULL, text_of_column},
    {"strlen", 1, 1, TEXTS, NULL, text_strlen},
    {"strstrt", 2, 2, TEXTS, NULL, text_strstrt},
    {"substr", 3, 3, TEXT, NULL, text_slice},
#endif
    {"tan", 1, 1, BUILTIN_ANGLE, func_tan, NULL},
    {"tanh", 1, 1, 0, func_tanh, NULL},
#if CONFIG_CONTROL
    {"word", 2, 2, TEXT, NULL, text_word},
    {"words", 1, 1, TEXTS, NULL, text_words},
#endif
};

int builtins_find(const char *name, size_t len) {
    for (size_t i = 0; i < sizeof BUILTINS / sizeof BUILTINS[0]; i++) {
        if (strlen(BUILTINS[i].name) == len && memcmp(BUILTINS[i].name, name, len) == 0) return (int)i;
    }
    return -1;
}
