/* keep.c - see keep.h. */
#include "app/keep.h"

#include <string.h>

#include "error.h"

void keep_clear(keep_t *k) {
    k->len = 0;
    k->full = false;
}

static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
static bool is_name(char c) {
    return is_letter(c) || (c >= '0' && c <= '9');
}

static const char *skip_blanks(const char *p, const char *end) {
    while (p < end && (*p == ' ' || *p == '\t')) p++;
    return p;
}

static bool find(const char *p, const char *end, const char *word) {
    size_t n = strlen(word);
    for (; (size_t)(end - p) >= n; p++)
        if (memcmp(p, word, n) == 0) return true;
    return false;
}

/* name = ..., name(arguments) = ...; or set and unset of what `show` does not tell. */
static bool is_wanted(const char *p, const char *end) {
    p = skip_blanks(p, end);
    const char *name = p;
    if (p == end || !is_letter(*p)) return false;
    while (p < end && is_name(*p)) p++;
    const char *after = p;
    p = skip_blanks(p, end);
    if (p < end && *p == '(') {
        while (p < end && *p != ')') p++;
        p = skip_blanks(p < end ? p + 1 : p, end);
    }
    if (p < end && *p == '=') return p + 1 == end || p[1] != '=';
    bool set = after - name >= 2 && (memcmp(name, "se", 2) == 0 || memcmp(name, "un", 2) == 0);
    return set && (find(after, end, "tics") || find(after, end, " bo"));
}

static void add(keep_t *k, const char *text, size_t n) {
    if (n + 1 > sizeof k->journal - k->len) {
        k->full = true;
        return;
    }
    memcpy(k->journal + k->len, text, n);
    k->len = (uint16_t)(k->len + n + 1);
    k->journal[k->len - 1] = '\n';
}

const char *keep_command_end(const char *p) {
    char quote = 0;
    for (; *p; p++) {
        if (quote) {
            if (*p == '\\' && quote == '"' && p[1])
                p++;
            else if (*p == quote)
                quote = 0;
        } else if (*p == '\'' || *p == '"') {
            quote = *p;
        } else if (*p == ';' || *p == '#') {
            break;
        }
    }
    return p;
}

void keep_line(keep_t *k, const char *line, size_t done) {
    for (const char *p = line;;) {
        const char *end = keep_command_end(p);
        if ((size_t)(end - line) >= done) return;
        if (is_wanted(p, end)) {
            if (end > p && end[-1] == '\\')
                k->full = true; /* goes on in the next line */
            else
                add(k, p, (size_t)(end - p));
        }
        if (*end != ';') return;
        p = end + 1;
    }
}

static bool begins(const char *text, const char *with) {
    return strncmp(text, with, strlen(with)) == 0;
}

void keep_print(keep_capture_t *c, const char *text) {
    if (!c->in_line) {
        bool machine = begins(text, "set machine");
        c->skipping = c->machine ? !machine : machine || !(begins(text, "set ") || begins(text, "unset "));
    }
    size_t n = strlen(text);
    for (size_t i = 0; i < n && !c->skipping; i++) {
        size_t len = c->text.len;
        text_add_bytes(&c->text, text + i, 1);
        if (c->text.len == len) c->cut = true;
    }
    c->in_line = n > 0 && text[n - 1] != '\n';
}

static void capture(session_t *s, keep_capture_t *c, const char *command) {
    c->on = true;
    c->cut = c->in_line = false;
    session_line(s, command);
    c->on = false;
}

int keep_machine(session_t *s, keep_capture_t *c, char *buf, size_t room) {
    c->text = text_start(buf, room);
    c->machine = true;
    capture(s, c, "show machine");
    return c->cut ? ERR_FULL : (int)c->text.len;
}

int keep_scene(const keep_t *k, session_t *s, keep_capture_t *c, char *buf, size_t room) {
    size_t last = strlen(s->last);
    if (last == 0) return ERR_EMPTY;
    if (find(s->last, s->last + last, "'-'") || find(s->last, s->last + last, "\"-\"")) return ERR_DATA;
    if (k->full) return ERR_FULL;
    c->text = text_start(buf, room);
    c->machine = false;
    text_add_bytes(&c->text, k->journal, k->len);
    capture(s, c, "show all");
    text_add(&c->text, s->last);
    text_add(&c->text, "\n");
    return c->cut || c->text.len + 1 >= room ? ERR_FULL : (int)c->text.len;
}
