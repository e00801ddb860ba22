/* set_dgrid.c - set dgrid3d [ROWS[,COLUMNS]] [splines | qnorm Q | gauss|exp|cauchy|box|hann [kdensity2d] [SX[,SY]]]:
 * scattered points of data become a grid. */
#include "lang/session_parts.h"

#if CONFIG_SCATTERED
static const char weights[] = "qnorm\0gauss\0exp\0cauchy\0box\0hann\0"; /* enum scattered_weight */

/* Numbers between commas, each of which may be left out: rows, columns, and of old q. */
static int sizes(session_t *s, lexer_t *lx, scattered_spec_t *d) {
    int32_t *const value[3] = {&d->ny, &d->nx, &d->q};
    for (int k = 0; k < 3; k++) {
        if (lx->tok.kind == TOKEN_NUMBER || lx->tok.kind == '(') {
            int err = set_integer(s, lx, k < 2 ? 2 : 1, k < 2 ? SCATTERED_SIDE_MAX : 64, value[k],
                                  "dgrid3d wants 2 to 1000 rows and columns, and a norm from 1 to 64");
            if (err) return err;
            if (k == 0) d->nx = d->ny;
        }
        if (!lexer_accept(lx, ',')) break;
    }
    return 0;
}

static int scales(session_t *s, lexer_t *lx, scattered_spec_t *d) {
    if (lexer_is_almost(lx, "kdens$ity2d")) {
        d->density = true;
        lexer_next(lx);
    }
    for (int k = 0; k < 2 && !session_at_end(lx); k++) {
        const lexer_t at = *lx;
        int err = expr_number(&s->lang, lx, &d->scale[k], &s->error);
        if (err) return err;
        if (num_sign(d->scale[k]) <= 0) return session_fail(s, &at, ERR_VALUE, "a scale above 0 expected");
        if (k == 0) d->scale[1] = d->scale[0];
        if (!lexer_accept(lx, ',')) break;
    }
    return 0;
}

int set_dgrid(session_t *s, lexer_t *lx) {
    scattered_spec_t d;
    scattered_default(&d);
    d.on = true;
    int err = sizes(s, lx, &d);
    const lexer_t word = *lx;
    int weight;
    if (!err && lexer_is_almost(lx, "spl$ines")) {
        session_warn(s, "set dgrid3d ", lexer_text(lx), lx->tok.len, " is taken for qnorm 1");
        lexer_next(lx);
    } else if (!err && (weight = words_find(weights, lx)) >= 0) {
        d.weight = (enum scattered_weight)weight;
        lexer_next(lx);
        if (d.weight != SCATTERED_QNORM)
            err = scales(s, lx, &d);
        else if (!session_at_end(lx))
            err = set_integer(s, lx, 1, 64, &d.q, "a norm from 1 to 64 expected");
    } else if (!err && !session_at_end(lx)) {
        return lexer_unexpected(&word, &s->error, "qnorm, gauss, exp, cauchy, box or hann expected");
    }
    if (!err) err = session_expect_end(s, lx);
    if (!err) s->scattered = d;
    return err;
}

void show_dgrid(const session_t *s, text_t *t) {
    const scattered_spec_t *d = &s->scattered;
    if (!d->on) {
        text_add(t, "unset dgrid3d\n");
        return;
    }
    const char *word = weights;
    for (int k = 0; k < (int)d->weight; k++) word += strlen(word) + 1;
    text_add(t, "set dgrid3d ");
    text_add_int(t, d->ny);
    text_add(t, ",");
    text_add_int(t, d->nx);
    text_add(t, " ");
    text_add(t, word);
    if (d->density) text_add(t, " kdensity2d");
    for (int k = 0; k < 2; k++) {
        char buf[VALUE_TEXT_MAX];
        const bool qnorm = d->weight == SCATTERED_QNORM;
        if (qnorm && k > 0) break;
        text_add(t, k ? "," : " ");
        value_format(qnorm ? value_int(d->q) : value_real(d->scale[k]), buf);
        text_add(t, buf);
    }
    text_add(t, "\n");
}
#endif
