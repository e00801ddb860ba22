/* text_funcs.c - see text_funcs.h. */
#include "lang/text_funcs.h"
#include "lang/arith.h"
#include "lang/format.h"

#if CONFIG_CONTROL
static const char NOT_TEXT[] = "a text is needed here, not a number";
static const char NO_ROOM[] = "no memory for this text";

/* Gives n bytes of text, which may lie anywhere but in work's free part. */
static const char *give(lang_t *l, value_t *out, const char *text, size_t n) {
    char *room = texts_room(l->texts, n);
    if (!room) return NO_ROOM;
    memcpy(room, text, n);
    room[n] = '\0';
    *out = value_text(room, n);
    return NULL;
}

const char *text_literal(lang_t *l, value_t *a, int n) {
    (void)n;
    const char *text = l->texts->literal + a->m;
    *a = value_text(text, strlen(text));
    return NULL;
}

/* A number as it is printed; digits: VALUE_TEXT_MAX bytes. */
static value_t shown(value_t v, char *digits) {
    return v.kind == VALUE_TEXT ? v : value_text(digits, value_format(v, digits));
}

const char *text_concat(lang_t *l, value_t *a, int n) {
    char left[VALUE_TEXT_MAX], right[VALUE_TEXT_MAX];
    const value_t u = shown(a[0], left), v = shown(a[1], right);
    (void)n;
    char *room = l->texts ? texts_room(l->texts, (size_t)u.e + (size_t)v.e) : NULL; /* numbers can be joined, too */
    if (!room) return NO_ROOM;
    memcpy(room, value_chars(u), (size_t)u.e);
    memcpy(room + u.e, value_chars(v), (size_t)v.e + 1);
    *a = value_text(room, (size_t)u.e + (size_t)v.e);
    return NULL;
}

static const char *compare(value_t *a, bool equal) {
    if ((a[0].kind & a[1].kind) != VALUE_TEXT) return NOT_TEXT;
    *a = value_int((strcmp(value_chars(a[0]), value_chars(a[1])) == 0) == equal);
    return NULL;
}

const char *text_eq(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    return compare(a, true);
}

const char *text_ne(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    return compare(a, false);
}

/* Does a character begin at this byte? */
static bool begins(char c) {
    return ((unsigned char)c & 0xc0) != 0x80;
}

static int64_t characters(const char *from, const char *to) {
    int64_t n = 0;
    for (; from < to; from++) n += begins(*from);
    return n;
}

/* Where character number k begins, k > 0; at the end if there are fewer. */
static const char *character(const char *text, int64_t k) {
    for (; *text; text++)
        if (begins(*text) && --k <= 0) break;
    return text;
}

const char *text_slice(lang_t *l, value_t *a, int n) {
    (void)n;
    if (a[0].kind != VALUE_TEXT) return NOT_TEXT;
    if (a[1].kind != VALUE_INT || a[2].kind != VALUE_INT) return SAID("the number of a character is an integer");
    const int64_t first = a[1].m > 1 ? a[1].m : 1, last = a[2].m;
    const char *from = character(value_chars(a[0]), first), *to = from;
    if (last >= first) to = character(from, last >= INT32_MAX ? last : last - first + 2);
    return give(l, a, from, (size_t)(to - from));
}

const char *text_strlen(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    if (a->kind != VALUE_TEXT) return NOT_TEXT;
    *a = value_int(characters(value_chars(*a), value_chars(*a) + a->e));
    return NULL;
}

const char *text_strstrt(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    if ((a[0].kind & a[1].kind) != VALUE_TEXT) return NOT_TEXT;
    const char *text = value_chars(a[0]), *at = text;
    bool found;
    while (!(found = strncmp(at, value_chars(a[1]), (size_t)a[1].e) == 0) && *at) at++;
    *a = value_int(found ? characters(text, at) + 1 : 0);
    return NULL;
}

/* The word at or behind text; *len 0: there is none. */
static const char *next_word(const char *text, size_t *len) {
    text += strspn(text, " \t\n");
    *len = strcspn(text, " \t\n");
    return text;
}

const char *text_word(lang_t *l, value_t *a, int n) {
    (void)n;
    if (a[0].kind != VALUE_TEXT) return NOT_TEXT;
    if (a[1].kind != VALUE_INT) return SAID("the number of a word is an integer");
    size_t len = 0;
    const char *at = value_chars(a[0]);
    for (int64_t k = 0; k < a[1].m; k++) {
        at = next_word(at + len, &len);
        if (len == 0) break;
    }
    return give(l, a, at, len);
}

const char *text_words(lang_t *l, value_t *a, int n) {
    (void)l, (void)n;
    if (a->kind != VALUE_TEXT) return NOT_TEXT;
    int64_t words = 0;
    size_t len;
    for (const char *at = next_word(value_chars(*a), &len); len > 0; at = next_word(at + len, &len)) words++;
    *a = value_int(words);
    return NULL;
}

/* One conversion; f says which. */
static const char *convert(text_t *t, const format_t *f, value_t v) {
    if (f->type == 's') {
        if (v.kind != VALUE_TEXT) return SAID("a text for %s is needed");
        format_text(t, f, value_chars(v), (size_t)v.e);
        return NULL;
    }
    const char *fault = arith_number(&v);
    if (!fault) format_number(t, f, v);
    return fault;
}

const char *text_sprintf(lang_t *l, value_t *a, int n) {
    if (a->kind != VALUE_TEXT) return SAID("a format in quotes is needed");
    texts_t *x = l->texts;
    text_t t = text_start(x->work + x->working, sizeof x->work - x->working);
    int next = 1;
    for (const char *p = value_chars(a[0]); *p;) {
        const size_t plain = strcspn(p, "%");
        text_add_bytes(&t, p, plain);
        p += plain;
        if (!*p) break;
        format_t f;
        const size_t used = format_read(++p, &f);
        if (used == 0) return SAID("a conversion of the format is not supported");
        p += used;
        if (f.type == '%') {
            text_add(&t, "%");
            continue;
        }
        if (next == n) return SAID("a value for each % of the format is needed");
        const char *fault = convert(&t, &f, a[next++]);
        if (fault) return fault;
    }
    if (t.len + 1 >= t.size) return NO_ROOM;
    x->working += t.len + 1;
    *a = value_text(t.buf, t.len);
    return NULL;
}

const char *text_of_column(lang_t *l, value_t *a, int n) {
    (void)l, (void)n, (void)a;
    return SAID("texts in columns of data are not kept");
}

static const symbol_t *array_of(const lang_t *l, value_t v) {
    const symbol_t *s = &l->symbol[v.m];
    return s->kind == SYMBOL_ARRAY && s->defined ? s : NULL;
}

const char *array_element(lang_t *l, value_t *a, int n) {
    (void)n;
    const symbol_t *s = array_of(l, a[0]);
    if (!s) return SAID("this array is not defined");
    if (a[1].kind != VALUE_INT) return SAID("the index of an array is an integer");
    if (a[1].m < 1 || a[1].m > s->u.cells.len) return SAID("array index out of range");
    *a = l->cell[s->u.cells.start + a[1].m - 1];
    return NULL;
}

const char *array_size(lang_t *l, value_t *a, int n) {
    (void)n;
    const symbol_t *s = array_of(l, a[0]);
    if (!s) return SAID("this array is not defined");
    *a = value_int(s->u.cells.len);
    return NULL;
}
#endif
