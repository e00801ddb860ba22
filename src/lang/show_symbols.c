/* show_symbols.c - variables and functions. */
#include "lang/session_parts.h"

void show_symbols(session_t *s, enum symbol_kind kind) {
    const lang_t *l = &s->lang;
    for (int i = 0; i < l->symbols; i++) {
        const symbol_t *y = &l->symbol[i];
        if (y->kind != kind || !y->defined) continue;
        char line[128];
        text_t t = text_start(line, sizeof line - 1);
        text_add_bytes(&t, (const char *)l->pool + y->name, y->name_len);
        if (kind == SYMBOL_VARIABLE) {
            char value[VALUE_TEXT_MAX];
            text_add(&t, " = ");
            text_add_bytes(&t, value, value_format(y->u.value, value));
        } else {
            text_add(&t, "() of ");
            text_add_int(&t, y->params);
            text_add(&t, y->params == 1 ? " argument" : " arguments");
        }
        t.size++;
        text_add(&t, "\n");
        s->port->print(s->port->ctx, line);
    }
#if CONFIG_CONTROL
    const texts_t *x = &s->texts;
    for (size_t at = 0; kind == SYMBOL_VARIABLE && at < x->used; at += strlen(x->store + at) + 1) {
        s->port->print(s->port->ctx, x->store + at);
        s->port->print(s->port->ctx, " = \"");
        at += strlen(x->store + at) + 1;
        s->port->print(s->port->ctx, x->store + at);
        s->port->print(s->port->ctx, "\"\n");
    }
#endif
}
