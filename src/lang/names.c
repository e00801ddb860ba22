/* names.c - symbols in an array, searched from the front.
 *
 * A linear search is enough: names are looked up when text is compiled, never when it is evaluated, and a board holds
 * some dozens of them. */
#include "lang/names.h"
#include "num/func.h"
#include "num/num_double.h"

static const char *name_of(const lang_t *l, const symbol_t *s) {
    return (const char *)l->pool + s->name;
}

void names_reset(lang_t *l) {
    l->degrees = false;
#if CONFIG_CONTROL
    l->iterations = 0;
    l->cells = 0;
    l->texts = NULL;
#endif
    /* The largest part is left as it is: pool and stack are never read before they are written. */
    l->symbols = 0;
    l->bodies_end = 0;
    l->names_start = CONFIG_POOL;
    l->seed[0] = l->seed[1] = 0;
    l->column = NULL;
    l->column_ctx = NULL;
    l->fault.code = 0;
    lang_error_t ignored; /* both fit into an empty table */
    names_set(l, "pi", 2, value_real(num_double(func_pi())), &ignored);
    names_set(l, "NaN", 3, value_undef(), &ignored);
}

int names_find(const lang_t *l, enum symbol_kind kind, const char *name, size_t len) {
    for (int i = 0; i < l->symbols; i++) {
        const symbol_t *s = &l->symbol[i];
        if (s->kind == kind && s->name_len == len && memcmp(name_of(l, s), name, len) == 0) return i;
    }
    return -1;
}

int names_find_defined(const lang_t *l, enum symbol_kind kind, const char *name, size_t len) {
    const int i = names_find(l, kind, name, len);
    return i >= 0 && l->symbol[i].defined ? i : -1;
}

int names_intern(lang_t *l, enum symbol_kind kind, const char *name, size_t len, int32_t column, lang_error_t *err) {
    int found = names_find(l, kind, name, len);
    if (found >= 0) return found;
    if (l->symbols == CONFIG_SYMBOLS)
        return lang_error_set_number(err, ERR_FULL, column, "too many variables and functions", CONFIG_SYMBOLS);
    if (len > UINT8_MAX) return lang_error_set_number(err, ERR_FULL, column, "name too long", UINT8_MAX);
    if (len > (size_t)(l->names_start - l->bodies_end))
        return lang_error_set_number(err, ERR_FULL, column, "no memory for names and functions (bytes)", CONFIG_POOL);
    l->names_start = (uint16_t)(l->names_start - len);
    memcpy(l->pool + l->names_start, name, len);
    symbol_t *s = &l->symbol[l->symbols];
    *s = (symbol_t){.name = l->names_start, .name_len = (uint8_t)len, .kind = (uint8_t)kind};
    return l->symbols++;
}

/* A variable that holds a text is an undefined symbol whose name is among the texts: what only knows numbers need not
 * ask. */
bool names_value(lang_t *l, int symbol, value_t *out) {
    const symbol_t *s = &l->symbol[symbol];
    *out = s->u.value;
#if CONFIG_CONTROL
    const char *text = s->defined || !l->texts ? NULL : texts_get(l->texts, name_of(l, s), s->name_len);
    if (text) {
        const size_t len = strlen(text);
        char *copy = texts_room(l->texts, len);
        if (copy) memcpy(copy, text, len + 1);
        *out = copy ? value_text(copy, len) : value_undef();
        return true;
    }
#endif
    return s->defined;
}

bool names_assign(lang_t *l, int symbol, value_t v) {
    symbol_t *s = &l->symbol[symbol];
    bool done = true;
#if CONFIG_CONTROL
    const bool text = v.kind == VALUE_TEXT;
    if (l->texts && (text || !s->defined)) /* what holds a number has no text to forget */
        done = texts_set(l->texts, name_of(l, s), s->name_len, text ? value_chars(v) : NULL);
    s->defined = !text;
#else
    s->defined = true;
#endif
    s->u.value = v;
    return done;
}

#if CONFIG_CONTROL
static void drop_cells(lang_t *l, symbol_t *a) {
    const uint16_t start = a->u.cells.start, len = a->u.cells.len;
    memmove(l->cell + start, l->cell + start + len, (size_t)(l->cells - start - len) * sizeof *l->cell);
    l->cells = (uint16_t)(l->cells - len);
    for (int i = 0; i < l->symbols; i++) {
        symbol_t *other = &l->symbol[i];
        if (other->kind == SYMBOL_ARRAY && other->defined && other->u.cells.start > start)
            other->u.cells.start = (uint16_t)(other->u.cells.start - len);
    }
}

void names_forget(lang_t *l, int symbol) {
    symbol_t *s = &l->symbol[symbol];
    if (s->defined && s->kind == SYMBOL_FUNCTION) names_define_function(l, symbol, 0, 0, 0); /* its body goes */
    if (s->defined && s->kind == SYMBOL_ARRAY) drop_cells(l, s);
    if (s->kind == SYMBOL_VARIABLE && l->texts) texts_set(l->texts, name_of(l, s), s->name_len, NULL);
    s->defined = false;
}
#endif

int names_set(lang_t *l, const char *name, size_t len, value_t v, lang_error_t *err) {
    int i = names_intern(l, SYMBOL_VARIABLE, name, len, 0, err);
    if (i < 0) return i;
#if CONFIG_CONTROL
    const int array = names_find(l, SYMBOL_ARRAY, name, len);
    if (array >= 0) names_forget(l, array);
#endif
    if (names_assign(l, i, v) || !CONFIG_CONTROL) return 0; /* of a number it is always done */
    return lang_error_set_number(err, ERR_FULL, 0, "no memory for this text; bytes for all", CONFIG_TEXTS);
}

void names_release(lang_t *l, uint16_t mark) {
    while (l->symbols > mark && !l->symbol[l->symbols - 1].defined) {
        l->symbols--;
        l->names_start = (uint16_t)(l->names_start + l->symbol[l->symbols].name_len);
    }
}

/* Takes a body out of the pool and closes the gap. */
static void drop_body(lang_t *l, uint16_t start, uint16_t len) {
    memmove(l->pool + start, l->pool + start + len, (size_t)(l->bodies_end - start - len));
    l->bodies_end = (uint16_t)(l->bodies_end - len);
    for (int i = 0; i < l->symbols; i++) {
        symbol_t *s = &l->symbol[i];
        if (s->kind == SYMBOL_FUNCTION && s->defined && s->u.code.start > start)
            s->u.code.start = (uint16_t)(s->u.code.start - len);
    }
}

void names_define_function(lang_t *l, int symbol, uint8_t params, uint16_t len, uint16_t stack) {
    symbol_t *s = &l->symbol[symbol];
    symbol_t old = *s;
    s->defined = true;
    s->params = params;
    s->u.code.start = l->bodies_end;
    s->u.code.len = len;
    s->u.code.stack = stack;
    l->bodies_end = (uint16_t)(l->bodies_end + len);
    if (old.defined) drop_body(l, old.u.code.start, old.u.code.len);
}
