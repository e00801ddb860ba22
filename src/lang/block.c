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
