/* block.c - data blocks: `$name << END`, then lines up to END, which the port keeps as a file called $name. */
#include "lang/session_parts.h"

#if CONFIG_LOAD_DEPTH
int block_name(session_t *s, lexer_t *lx, char *out, size_t size) {
    lexer_t at = *lx;
    lexer_next(lx);
    if (lx->tok.kind != TOKEN_NAME || lx->tok.start != at.tok.start + 1)
        return session_fail(s, &at, ERR_SYNTAX, "the name of a data block expected, such as $data");
    if (lx->tok.len + 2 > size) return session_fail(s, &at, ERR_FULL, "this name is too long");
    memcpy(out, lexer_text(&at), lx->tok.len + 1);
    out[lx->tok.len + 1] = '\0';
    lexer_next(lx);
    return 0;
}

int block_command(session_t *s, lexer_t *lx) {
    lexer_t at = *lx;
    int err = block_name(s, lx, s->block, sizeof s->block);
    if (err) return err;
    if (lx->tok.kind != TOKEN_SHL) return lexer_unexpected(lx, &s->error, "<< and a word that ends the data expected");
#if CONFIG_CONTROL
    if (session_top(s)->blocks > 0) /* its lines have been joined with those of the block */
        return session_fail(s, &at, ERR_SYNTAX, "a data block cannot begin within { }");
#endif
    lexer_next(lx);
    if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "a word that ends the data expected");
    if (lx->tok.len >= sizeof s->block_end) return session_fail(s, lx, ERR_FULL, "this word is too long");
    if (!s->port->keep) return session_fail(s, &at, ERR_UNSUPPORTED, "there is no place for data blocks here");
    memcpy(s->block_end, lexer_text(lx), lx->tok.len);
    s->block_end[lx->tok.len] = '\0';
    lexer_next(lx);
    err = session_expect_end(s, lx);
    if (!err) err = s->port->keep(s->port->ctx, s->block, NULL, 0);
    s->in_block = !err;
    return err;
}

/* set print $name: what is printed goes there, from an empty block on; set print: to where it always does. */
int block_print(session_t *s, lexer_t *lx) {
    const lexer_t at = *lx;
    char name[sizeof s->print_to] = "";
    int err = lx->tok.kind == '$' ? block_name(s, lx, name, sizeof name) : 0;
    if (!err) err = session_expect_end(s, lx);
    if (!err && name[0] && !s->port->keep)
        err = session_fail(s, &at, ERR_UNSUPPORTED, "there is no place for data blocks here");
    if (!err && name[0]) err = s->port->keep(s->port->ctx, name, NULL, 0);
    if (!err) memcpy(s->print_to, name, sizeof name);
    return err;
}

/* set palette file '-': rows follow, up to `e`, and are nobody's. */
void block_of_palette(session_t *s, lexer_t lx) {
    bool rows = false;
    for (; !session_at_end(&lx); lexer_next(&lx))
        rows |= lx.tok.kind == TOKEN_STRING && lx.tok.len == 3 && lexer_text(&lx)[1] == '-';
    if (!rows || !s->port->keep) return;
    memcpy(s->block, "$-", 3);
    memcpy(s->block_end, "e", 2);
    s->in_block = s->port->keep(s->port->ctx, s->block, NULL, 0) == 0;
}

/* evaluate text: the text is executed as a file would be. */
int block_evaluate(session_t *s, lexer_t *lx) {
    static const char name[] = "$ evaluated";
    const session_port_t *port = s->port;
    const lexer_t at = *lx;
    char *text = s->frame_name[0]; /* lent: no data file is open now */
    int err = session_string(s, lx, text, CONFIG_NAME_MAX + 1, "a text in quotes expected");
    if (!err) err = session_expect_end(s, lx);
    if (err) return err;
    if (!port->keep) return session_fail(s, &at, ERR_UNSUPPORTED, "there is no place for data blocks here");
    err = port->keep(port->ctx, name, NULL, 0);
    if (!err) err = port->keep(port->ctx, name, text, strlen(text));
    return err ? err : session_load(s, name, &at);
}

int block_line(session_t *s, const char *text, size_t n) {
    const session_port_t *port = s->port;
    if (n > 0 && text[n - 1] == '\r') n--;
    if (n == strlen(s->block_end) && memcmp(text, s->block_end, n) == 0) {
        s->in_block = false;
        return 0;
    }
    int err = port->keep(port->ctx, s->block, text, n);
    return err ? err : port->keep(port->ctx, s->block, "\n", 1);
}
#endif
