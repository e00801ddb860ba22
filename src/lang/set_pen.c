/* set_pen.c - set pen and set crease: which lines of solids are drawn, and with which pen. */
#include "lang/session_parts.h"

#if CONFIG_AREA

#define TEXT_OF(n) #n
#define DIGITS_OF(n) TEXT_OF(n)

static const char classes[] = "crease$s\0silhouette$s\0hid$den\0hatch$ing\0shadow$s\0detail$s\0";
static const uint8_t classes_id[] = {LINE_CREASE, LINE_SILHOUETTE, LINE_HIDDEN, LINE_HATCH, LINE_SHADOW, LINE_DETAIL};

const char *set_pen_class(int k) {
    static const char *const name[LINE_CLASSES] = {"crease", "silhouette", "hidden", "hatch", "shadow", "detail"};
    return name[k];
}

/* set pen N: one pen for everything; set pen CLASS N [CLASS N ...] */
int set_pen(session_t *s, lexer_t *lx) {
    static const char *const range = "pens have numbers from 1 to " DIGITS_OF(PENS_MAX);
    uint8_t pen[LINE_CLASSES];
    int32_t n;
    memcpy(pen, s->settings.pen, sizeof pen);
    if (lx->tok.kind == TOKEN_NUMBER || lx->tok.kind == '(' || lx->tok.kind == '-') {
        int err = set_integer(s, lx, 1, PENS_MAX, &n, range);
        if (!err) err = session_expect_end(s, lx);
        if (err) return err;
        memset(pen, (int)n, sizeof pen);
    } else {
        do {
            int which = words_find(classes, lx);
            if (which < 0)
                return lexer_unexpected(
                    lx, &s->error, "a pen's number, or silhouette, crease, hidden, hatch, shadow, detail expected");
            lexer_next(lx);
            int err = set_integer(s, lx, 1, PENS_MAX, &n, range);
            if (err) return err;
            pen[classes_id[which]] = (uint8_t)n;
            lexer_accept(lx, ',');
        } while (!session_at_end(lx));
    }
    memcpy(s->settings.pen, pen, sizeof pen);
    return 0;
}

/* set crease DEGREES */
int set_crease(session_t *s, lexer_t *lx) {
    int64_t mdeg;
    int err = set_scaled(s, lx, 3, 0, 89000, &mdeg, "crease must be between 0 and 89 degrees");
    if (!err) err = session_expect_end(s, lx);
    if (err) return err;
    s->settings.crease_mdeg = (int32_t)mdeg;
    return 0;
}

#endif
