/* control.c - if, else, do for, while, break and continue.
 *
 * A logical line holds a whole block: lines are joined until its braces are closed. So control is a matter of going to
 * another place of the line, and what is open is a small stack of places; nothing recurses. */
#include "lang/session_parts.h"
#include "lang/text_funcs.h"

#if CONFIG_CONTROL
static void go_to(lexer_t *lx, uint32_t at) {
    lx->pos = at;
    lexer_next(lx);
}

/* From behind a { to behind its }. */
static void skip_block(lexer_t *lx) {
    for (int32_t open = 1; open > 0 && lx->tok.kind != TOKEN_END; lexer_next(lx))
        open += (lx->tok.kind == '{') - (lx->tok.kind == '}');
}

/* Goes to the end of the physical line, or of the block it stands in; or only up to an `else` that begins a command. */
static void skip_line(lexer_t *lx, bool up_to_else) {
    int32_t open = 0;
    bool begins = false;
    for (; lx->tok.kind != TOKEN_END; lexer_next(lx)) {
        if (open == 0 && (session_is_line_end(lx) || lx->tok.kind == '}')) return;
        if (open == 0 && begins && up_to_else && lexer_is_name(lx, "else")) return;
        open += (lx->tok.kind == '{') - (lx->tok.kind == '}');
        begins = lx->tok.kind == ';';
    }
}

/* At a { : what stands behind it is executed. */
static int open_block(session_t *s, lexer_t *lx, session_block_t block) {
    session_frame_t *f = session_top(s);
    if (f->blocks == CONFIG_BLOCKS)
        return lang_error_set_number(&s->error, ERR_FULL, lexer_column(lx), "blocks within blocks; most",
                                     CONFIG_BLOCKS);
    block.body = lx->pos;
    f->block[f->blocks++] = block;
    lexer_next(lx);
    return 0;
}

static int condition(session_t *s, lexer_t *lx, bool *yes) {
    *yes = false;
    if (lx->tok.kind != '(') return lexer_unexpected(lx, &s->error, "a condition in brackets expected");
    num_t v;
    int err = expr_number(&s->lang, lx, &v, &s->error);
    *yes = !err && num_sign(v) != 0;
    return err;
}

/* Behind a block, or the one command, that was executed: alternatives are passed over, here or where they come. */
static int pass_else(session_t *s, lexer_t *lx) {
    s->alternative = ALTERNATIVE_PASSED;
    while (lexer_is_name(lx, "else")) {
        s->alternative = ALTERNATIVE_NONE;
        lexer_next(lx);
        if (lexer_is_name(lx, "if")) {
            int32_t open = 0;
            s->alternative = ALTERNATIVE_PASSED;
            do {
                lexer_next(lx);
                open += (lx->tok.kind == '(') - (lx->tok.kind == ')');
            } while (open > 0 && lx->tok.kind != TOKEN_END);
            lexer_next(lx);
        }
        if (!lexer_accept(lx, '{')) {
            if (session_at_end(lx)) s->alternative = ALTERNATIVE_BODY_PASSED;
            skip_line(lx, false);
            return 0;
        }
        skip_block(lx);
    }
    return session_expect_end(s, lx);
}

/* Behind what was not executed: what stands behind `else` is, here or where it comes. */
static int take_else(session_t *s, lexer_t *lx) {
    s->alternative = ALTERNATIVE_TAKEN;
    if (!lexer_is_name(lx, "else")) return session_expect_end(s, lx);
    lexer_next(lx);
    s->alternative = session_at_end(lx) ? ALTERNATIVE_BODY : ALTERNATIVE_NONE;
    return lx->tok.kind == '{' ? open_block(s, lx, (session_block_t){.kind = BLOCK_ELSE}) : 0;
}

/* The block behind a condition, at its {. */
static int body(session_t *s, lexer_t *lx, bool yes) {
    if (yes) return open_block(s, lx, (session_block_t){.kind = BLOCK_IF});
    lexer_next(lx);
    skip_block(lx);
    return take_else(s, lx);
}

int control_open(session_t *s, lexer_t *lx) {
    const bool yes = s->alternative == ALTERNATIVE_BODY;
    if (s->alternative < ALTERNATIVE_BODY)
        return lexer_unexpected(lx, &s->error, "a block stands behind if, else, do or while only");
    if (s->alternative != ALTERNATIVE_BODY_PASSED) return body(s, lx, yes);
    lexer_next(lx);
    skip_block(lx);
    return pass_else(s, lx);
}

static int else_command(session_t *s, lexer_t *lx, const lexer_t *word) {
    *lx = *word;
    if (s->alternative == ALTERNATIVE_PASSED) return pass_else(s, lx);
    if (s->alternative == ALTERNATIVE_TAKEN) return take_else(s, lx);
    return session_fail(s, word, ERR_SYNTAX, "there is no `if` to this `else`");
}

static int if_command(session_t *s, lexer_t *lx) {
    bool yes;
    s->alternative = ALTERNATIVE_PASSED; /* also should a mistake come */
    int err = condition(s, lx, &yes);
    if (err) return err;
    if (lx->tok.kind == '{') return body(s, lx, yes);
    if (session_at_end(lx)) {
        s->alternative = yes ? ALTERNATIVE_BODY : ALTERNATIVE_BODY_LEFT;
        return 0;
    }
    s->alternative = yes ? ALTERNATIVE_PASSED : ALTERNATIVE_TAKEN;
    if (yes) return 0; /* the rest of the line, up to `else` */
    skip_line(lx, true);
    return lexer_is_name(lx, "else") ? take_else(s, lx) : 0;
}

/* The variable of a range, and what it held before. */
static int begin(session_t *s, const lexer_t *name, control_range_t *r) {
    lang_t *l = &s->lang;
    r->now = r->first;
    r->symbol = names_intern(l, SYMBOL_VARIABLE, lexer_text(name), name->tok.len, lexer_column(name), &s->error);
    if (r->symbol < 0) return r->symbol;
    r->was_defined = names_value(l, r->symbol, &r->before);
    return r->was_defined ? session_keep(s, name, &r->before) : 0;
}

/* Behind `in`: a text, whose words are counted through. */
static int words(session_t *s, lexer_t *lx, control_range_t *r) {
    const lexer_t at = *lx;
    value_t v;
    int err = expr_value(&s->lang, lx, &v, &s->error);
    if (err) return err;
    if (v.kind != VALUE_TEXT) return lexer_unexpected(&at, &s->error, "a text with words expected");
    err = session_keep(s, &at, &v);
    if (err) return err;
    r->words = value_chars(v);
    text_words(&s->lang, &v, 1);
    r->first = r->step = 1;
    r->last = v.m;
    return lexer_accept(lx, ']') ? 0 : lexer_unexpected(lx, &s->error, "']' expected");
}

int control_range(session_t *s, lexer_t *lx, control_range_t *r) {
    int32_t v[3] = {0, 0, 1};
    const lexer_t at = *lx;
    if (!lexer_accept(lx, '[')) return lexer_unexpected(lx, &s->error, "[i=first:last] expected");
    const lexer_t name = *lx;
    if (lx->tok.kind == TOKEN_NAME) lexer_next(lx);
    r->words = NULL;
    r->open = false;
    if (name.tok.kind == TOKEN_NAME && lexer_is_name(lx, "in")) {
        lexer_next(lx);
        int err = words(s, lx, r);
        if (err) return err;
        return begin(s, &name, r);
    }
    if (name.tok.kind != TOKEN_NAME || !lexer_accept(lx, '='))
        return lexer_unexpected(lx, &s->error, "[i=first:last] expected");
    for (int k = 0; k < 3; k++) {
        if (k == 1 && lexer_accept(lx, '*')) {
            v[1] = INT32_MAX;
            r->open = true;
            if (!lexer_accept(lx, ':')) break;
            continue;
        }
        int err = set_integer(s, lx, INT32_MIN, INT32_MAX, &v[k], "this number is out of range");
        if (err) return err;
        if (k > 0 && lx->tok.kind != ':') break;
        if (k < 2 && !lexer_accept(lx, ':')) return lexer_unexpected(lx, &s->error, "':' expected");
    }
    if (!lexer_accept(lx, ']')) return lexer_unexpected(lx, &s->error, "']' expected");
    if (v[2] == 0) return session_fail(s, &at, ERR_VALUE, "the step is 0");
    r->first = v[0];
    r->last = v[1];
    r->step = v[2];
    return begin(s, &name, r);
}

bool control_within(const control_range_t *r) {
    return r->step > 0 ? r->now <= r->last : r->now >= r->last;
}

void control_set(session_t *s, const control_range_t *r) {
    value_t v[2] = {value_int(r->now), value_int(r->now)};
    if (r->words) {
        s->texts.working = 0;
        v[0] = value_text(r->words, strlen(r->words));
        text_word(&s->lang, v, 2);
    }
    names_assign(&s->lang, r->symbol, v[0]); /* a word that finds no room is missed when it is asked for */
}

void control_restore(session_t *s, const control_range_t *r) {
    if (r->was_defined)
        names_assign(&s->lang, r->symbol, r->before);
    else
        names_forget(&s->lang, r->symbol);
}

static int one_turn_more(session_t *s, const lexer_t *lx) {
    if (s->turns++ < CONFIG_TURNS) return 0;
    return lang_error_set_number(&s->error, ERR_FULL, lexer_column(lx), "a loop goes round too often; most turns",
                                 CONFIG_TURNS);
}

static int do_command(session_t *s, lexer_t *lx) {
    if (!lexer_is_name(lx, "for")) return lexer_unexpected(lx, &s->error, "`for` expected");
    lexer_next(lx);
    session_block_t block = {.kind = BLOCK_FOR};
    int err = control_range(s, lx, &block.range);
    if (err) return err;
    if (lx->tok.kind != '{') return lexer_unexpected(lx, &s->error, "'{' expected");
    if (control_within(&block.range)) {
        control_set(s, &block.range);
        return open_block(s, lx, block);
    }
    lexer_next(lx);
    skip_block(lx);
    return session_expect_end(s, lx);
}

static int while_command(session_t *s, lexer_t *lx) {
    const session_block_t block = {.kind = BLOCK_WHILE, .again = lx->tok.start};
    bool yes;
    int err = condition(s, lx, &yes);
    if (!err) err = one_turn_more(s, lx);
    if (err) return err;
    if (lx->tok.kind != '{') return lexer_unexpected(lx, &s->error, "'{' expected");
    if (yes) return open_block(s, lx, block);
    lexer_next(lx);
    skip_block(lx);
    return session_expect_end(s, lx);
}

/* Behind the } of the innermost block: again, or on. */
static int end_block(session_t *s, lexer_t *lx) {
    session_frame_t *f = session_top(s);
    session_block_t *b = &f->block[f->blocks - 1];
    if (b->kind == BLOCK_FOR) {
        int err = one_turn_more(s, lx);
        if (err) return err;
        b->range.now += b->range.step;
        if (control_within(&b->range)) {
            go_to(lx, b->body);
            control_set(s, &b->range);
            return 0;
        }
        control_restore(s, &b->range);
    }
    f->blocks--;
    s->alternative = ALTERNATIVE_NONE;
    if (b->kind == BLOCK_IF) return pass_else(s, lx);
    if (b->kind != BLOCK_WHILE) return session_expect_end(s, lx);
    go_to(lx, b->again);
    return while_command(s, lx);
}

static int leave(session_t *s, lexer_t *lx, const lexer_t *word, bool again) {
    session_frame_t *f = session_top(s);
    while (f->blocks > 0 && f->block[f->blocks - 1].kind <= BLOCK_ELSE) f->blocks--;
    if (f->blocks == 0) return session_fail(s, word, ERR_SYNTAX, "this stands in no loop");
    go_to(lx, f->block[f->blocks - 1].body);
    skip_block(lx);
    if (again) return end_block(s, lx);
    f->blocks--;
    if (f->block[f->blocks].kind == BLOCK_FOR) control_restore(s, &f->block[f->blocks].range);
    return session_expect_end(s, lx);
}

int control_close(session_t *s, lexer_t *lx) {
    if (session_top(s)->blocks == 0) return session_fail(s, lx, ERR_SYNTAX, "no block is open that } could close");
    lexer_next(lx);
    return end_block(s, lx);
}

int control_command(session_t *s, lexer_t *lx, const lexer_t *word) {
    switch (lexer_text(word)[0]) {
    case 'i':
        return if_command(s, lx);
    case 'e':
        return else_command(s, lx, word);
    case 'd':
        return do_command(s, lx);
    case 'w':
        return while_command(s, lx);
    default: /* break, continue */
        return leave(s, lx, word, lexer_text(word)[0] == 'c');
    }
}

bool control_is_open(session_frame_t *f) {
    char quote = 0;
    for (; f->counted < f->len; f->counted++) {
        const char c = f->text[f->counted];
        if (quote) {
            if (c == '\\' && quote == '"') f->counted++;
            if (c == quote) quote = 0;
        } else if (c == '#') {
            f->counted = f->len;
            break;
        } else if (c == '\'' || c == '"') {
            quote = c;
        } else {
            f->braces += (c == '{') - (c == '}');
        }
    }
    return f->braces > 0;
}
#endif
