/* set_halo.c - set halo [W] [ends|noends]: how wide the gaps of `set hidden3d halo` are, in millimetres. */
#include "lang/session_parts.h"

#include "hidden/halo/halo.h"
#include "view/page.h"

#define WIDTH_MIN_UM 10
#define WIDTH_MAX_UM 100000
_Static_assert((int64_t)WIDTH_MIN_UM *LAT_PER_MM / 1000 >= HALO_WIDTH_MIN, "in lat");
_Static_assert((int64_t)WIDTH_MAX_UM *LAT_PER_MM / 1000 <= HALO_WIDTH_MAX, "in lat");

int set_halo(session_t *s, lexer_t *lx) {
    static const char *const range = SAID("a halo must be 0 or between 0.01 and 100 mm wide");
    lexer_t at = *lx;
    int64_t um = s->settings.halo_um;
    bool ends = false;
    if (session_at_end(lx)) return lexer_unexpected(lx, &s->error, "a width in mm, or ends, expected");
    if (!lexer_is_almost(lx, "end$s") && !lexer_is_almost(lx, "noend$s")) {
        int err = set_scaled(s, lx, 3, 0, WIDTH_MAX_UM, &um, range);
        if (err) return err;
        if (um != 0 && um < WIDTH_MIN_UM) return session_fail(s, &at, ERR_VALUE, range);
    } else {
        ends = s->settings.halo_ends;
    }
    if (lexer_is_almost(lx, "end$s") || lexer_is_almost(lx, "noend$s")) {
        ends = lexer_is_almost(lx, "end$s");
        lexer_next(lx);
    }
    if (!session_at_end(lx)) return lexer_unexpected(lx, &s->error, "ends, noends or the end of the command expected");
    s->settings.halo_um = (int32_t)um;
    s->settings.halo_ends = ends;
    return 0;
}
