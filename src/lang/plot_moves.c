/* plot_moves.c - where a solid stands and which of its edges count: translate, rotate, scale, crease, translucent. */
#include "lang/plot_options.h"
#include "lang/session_parts.h"

#include "num/func.h"
#include "scene/affine.h"

int32_t plot_options_cosine(num_t degrees) {
    num_t cosine = func_sin_degrees(num_sub(num_from_i64(90), degrees));
    return num_sign(degrees) ? (int32_t)num_to_fixed(cosine, 30, NULL) : 0;
}

static int crease(session_t *s, lexer_t *lx, int32_t *smooth_q30) {
    lexer_t at = *lx;
    num_t degrees;
    int err = expr_number(&s->lang, lx, &degrees, &s->error);
    if (err) return err;
    if (num_sign(degrees) < 0 || num_cmp(degrees, num_from_i64(89)) > 0)
        return session_fail(s, &at, ERR_VALUE, "crease must be between 0 and 89 degrees");
    *smooth_q30 = plot_options_cosine(degrees);
    return 0;
}

#if CONFIG_AREA
/* translucent ['NAME' ...]: names go to `names`, unless that is NULL, a zero behind each and another behind all. */
static int translucent(session_t *s, lexer_t *lx, char *names) {
    size_t at = 0;
    while (lx->tok.kind == TOKEN_STRING) {
        char name[OBJ_WORD_MAX + 1];
        int len = lexer_string(lx, name, sizeof name);
        if (len == 0) return session_fail(s, lx, ERR_VALUE, "the name of a group, an object or a material expected");
        if (len < 0 || at + (size_t)len + 2 > PLOT_NAMES_MAX)
            return session_fail(s, lx, ERR_FULL, "too many or too long names");
        if (names) memcpy(names + at, name, (size_t)len + 1);
        at += (size_t)len + 1;
        lexer_next(lx);
    }
    if (names) names[at] = '\0';
    return 0;
}
#endif

int plot_options_moves(session_t *s, lexer_t *lx, affine_t *a, session_source_t *src, char *names) {
    static const char words[] = "translate\0"
                                "rotate\0"
                                "scale\0"
                                "crease\0"
#if CONFIG_AREA
                                "transl$ucent\0"
#endif
        ;
#if !CONFIG_AREA
    (void)names;
#endif
    static void (*const move[])(affine_t *, const num_t[3]) = {affine_translate, affine_rotate, affine_scale};
    for (int which; (which = words_find(words, lx)) >= 0;) {
        lexer_t word = *lx;
        lexer_next(lx);
        num_t by[3];
        if (which == 3) {
            int err = crease(s, lx, &src->smooth_q30);
            if (err) return err;
            continue;
        }
#if CONFIG_AREA
        if (which == 4) {
            src->clear = true;
            int err = translucent(s, lx, names);
            if (err) return err;
            continue;
        }
#endif
        for (int k = 0; k < 3; k++) {
            if (which == 2 && k == 1 && lx->tok.kind != ',') {
                by[1] = by[2] = by[0];
                break;
            }
            if (k > 0 && !lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "three numbers X,Y,Z expected");
            int err = expr_number(&s->lang, lx, &by[k], &s->error);
            if (err) return err;
        }
        if (which == 2 && (num_sign(by[0]) == 0 || num_sign(by[1]) == 0 || num_sign(by[2]) == 0))
            return session_fail(s, &word, ERR_VALUE, "a scale of 0 leaves nothing");
        move[which](a, by);
    }
    return 0;
}
