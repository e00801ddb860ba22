/* set_page.c - set paper a3|a4|a5|letter|W,H [portrait|landscape] [margin M], in millimetres. */
#include "lang/session_parts.h"

#define SIDE_MIN_UM 10000   /* 10 mm */
#define SIDE_MAX_UM 5000000 /* 5 m: page coordinates reach 65 m */

typedef struct sheet {
    const char *name;
    int32_t long_um, short_um;
} sheet_t;
static const sheet_t sheets[] = {
    {"a5", 210000, 148000}, {"a4", 297000, 210000}, {"a3", 420000, 297000}, {"letter", 279400, 215900}};

static bool named_sheet(const lexer_t *lx, int32_t *w, int32_t *h) {
    for (size_t i = 0; i < sizeof sheets / sizeof sheets[0]; i++) {
        if (!lexer_is_name(lx, sheets[i].name)) continue;
        *w = sheets[i].long_um; /* landscape unless told otherwise */
        *h = sheets[i].short_um;
        return true;
    }
    return false;
}

static int side(session_t *s, lexer_t *lx, int32_t *out) {
    int64_t um;
    int err = set_scaled(s, lx, 3, SIDE_MIN_UM, SIDE_MAX_UM, &um, "a side of the paper must be between 10 and 5000 mm");
    if (!err) *out = (int32_t)um;
    return err;
}

int set_paper(session_t *s, lexer_t *lx) {
    int32_t w = s->settings.paper.width_um, h = s->settings.paper.height_um, margin = s->settings.paper.margin_um;
    lexer_t start = *lx, margin_at = *lx;
    if (session_at_end(lx)) return lexer_unexpected(lx, &s->error, "a3, a4, a5, letter or W,H expected");
    while (!session_at_end(lx)) {
        bool upright = lexer_is_almost(lx, "port$rait");
        if (upright || lexer_is_almost(lx, "land$scape")) {
            lexer_next(lx);
            if (upright != (h > w) && w != h) {
                int32_t swap = w;
                w = h;
                h = swap;
            }
        } else if (lexer_is_almost(lx, "mar$gin")) {
            int64_t um;
            lexer_next(lx);
            margin_at = *lx;
            int err = set_scaled(s, lx, 3, 0, SIDE_MAX_UM, &um, "the margin must be between 0 mm and half the paper");
            if (err) return err;
            margin = (int32_t)um;
        } else if (named_sheet(lx, &w, &h)) {
            lexer_next(lx);
        } else if (lx->tok.start == start.tok.start && lx->tok.kind != TOKEN_NAME) {
            int err = side(s, lx, &w);
            if (err) return err;
            if (!lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "',' and a height expected");
            err = side(s, lx, &h);
            if (err) return err;
        } else {
            return lexer_unexpected(lx, &s->error, "a3, a4, a5, letter, portrait, landscape or margin expected");
        }
    }
    int32_t room = (w < h ? w : h) - 2 * margin;
    if (margin > SIDE_MAX_UM / 2 || room < SIDE_MIN_UM / 2)
        return session_fail(s, &margin_at, ERR_VALUE, "the margins leave less than 5 mm of this paper");
    s->settings.paper.width_um = w;
    s->settings.paper.height_um = h;
    s->settings.paper.margin_um = margin;
    return 0;
}
