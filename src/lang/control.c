/* control.c - if, else, do for, while, break and continue.
 *
 * A logical line holds a whole block: lines are joined until its braces are closed. So control is a matter of going to
 * another place of the line, and what is open is a small stack of places; nothing recurses. */
#include "lang/session_parts.h"

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

static int push(session_t *s, const lexer_t *lx, const session_block_t *block) {
    session_frame_t *f = session_top(s);
    if (f->blocks == CONFIG_BLOCKS)
        return lang_error_set_number(&s->error, ERR_FULL, lexer_column(lx), "blocks within blocks; most",
                                     CONFIG_BLOCKS);
    f->block[f->blocks++] = *block;
    return 0;
}

/* At a { : what stands behind it is executed. */
static int open_block(session_t *s, lexer_t *lx, session_block_t block) {
    block.body = lx->pos;
    int err = push(s, lx, &block);
    if (!err) lexer_next(lx);
    return err;
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

static int one_turn_more(session_t *s, const lexer_t *lx) {
    if (s->turns++ < CONFIG_TURNS) return s->port->turn ? s->port->turn(s->port->ctx) : 0;
    return lang_error_set_number(&s->error, ERR_FULL, lexer_column(lx), "a loop goes round too often; most turns",
                                 CONFIG_TURNS);
}

/* Is the innermost block a `for` in front of another one, in which nothing is left to do? */
static session_block_t *outer_for(session_t *s) {
    session_frame_t *f = session_top(s);
    session_block_t *b = f->blocks > 0 ? &f->block[f->blocks - 1] : NULL;
    return b && b->kind == BLOCK_FOR && b->again ? b : NULL;
}

/* At a `for`: it, and those that follow it, are begun. Returns 1 when the block is executed, 0 when there is no value
 * for it, and it was passed over. */
static int begin_for(session_t *s, lexer_t *lx) {
    for (;;) {
        session_block_t block = {.kind = BLOCK_FOR};
        lexer_next(lx);
        int err = control_range(s, lx, &block.range);
        if (err) return err;
        const bool outer = lexer_is_name(lx, "for");
        if (!outer && lx->tok.kind != '{') return lexer_unexpected(lx, &s->error, "'{' expected");
        if (!control_within(&block.range)) break;
        control_set(s, &block.range);
        if (!outer) {
            err = open_block(s, lx, block);
            return err ? err : 1;
        }
        block.again = lx->tok.start;
        err = push(s, lx, &block);
        if (err) return err;
    }
    while (lx->tok.kind != '{' && lx->tok.kind != TOKEN_END) lexer_next(lx);
    lexer_accept(lx, '{');
    skip_block(lx);
    return 0;
}

/* Behind the } of the innermost block, a `for`: again, or on. */
static int next_turn(session_t *s, lexer_t *lx, session_block_t *b) {
    while (b) {
        int err = one_turn_more(s, lx);
        if (err) return err;
        b->range.now += b->range.step;
        if (!control_within(&b->range)) {
            control_restore(s, &b->range);
            session_top(s)->blocks--;
        } else {
            control_set(s, &b->range);
            if (!b->again) {
                go_to(lx, b->body);
                return 0;
            }
            go_to(lx, b->again);
            err = begin_for(s, lx);
            if (err) return err < 0 ? err : 0;
        }
        b = outer_for(s);
    }
    s->alternative = ALTERNATIVE_NONE;
    return session_expect_end(s, lx);
}

static int do_command(session_t *s, lexer_t *lx) {
    if (!lexer_is_name(lx, "for")) return lexer_unexpected(lx, &s->error, "`for` expected");
    const int err = begin_for(s, lx);
    if (err) return err < 0 ? err : 0;
    return next_turn(s, lx, outer_for(s));
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
    if (b->kind == BLOCK_FOR) return next_turn(s, lx, b);
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
    for (session_block_t *b; (b = outer_for(s)) != NULL; f->blocks--)
        control_restore(s, &b->range); /* of all of them */
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
