/* set_light.c - set hatch, light and shadow: tones of solids drawn with `set hidden3d area`. */
#include "lang/session_parts.h"

#include "hidden/hatch.h"

#if CONFIG_AREA

#define PITCH_MIN_UM 100
#define PITCH_MAX_UM 100000
_Static_assert((int64_t)PITCH_MIN_UM *LAT_PER_MM / 1000 >= HATCH_MIN_LAT, "in lat");

/* set hatch ANGLE[,PITCH]: degrees and mm; the pitch stays as it is, or is 1. */
int set_hatch(session_t *s, lexer_t *lx) {
    int64_t mdeg = s->settings.hatch_mdeg, um = s->settings.hatch_um ? s->settings.hatch_um : 1000;
    if (session_at_end(lx)) return lexer_unexpected(lx, &s->error, "an angle in degrees and a pitch in mm expected");
    int err = 0;
    if (lx->tok.kind != ',')
        err = set_scaled(s, lx, 3, -360000, 360000, &mdeg, "a hatch angle must be between -360 and 360 degrees");
    if (!err && lexer_accept(lx, ','))
        err = set_scaled(s, lx, 3, PITCH_MIN_UM, PITCH_MAX_UM, &um, "a hatch pitch must be between 0.1 and 100 mm");
    if (!err) err = session_expect_end(s, lx);
    if (err) return err;
    s->settings.hatch_mdeg = (int32_t)mdeg;
    s->settings.hatch_um = (int32_t)um;
    return 0;
}

/* set light X,Y,Z: the direction to a light far away, in the units of the data. */
int set_light(session_t *s, lexer_t *lx) {
    static const char *const range = "a light's direction must be between -1000000 and 1000000 in each coordinate";
    lexer_t at = *lx;
    int64_t v[3];
    for (int k = 0; k < 3; k++) {
        if (k && !lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "X,Y,Z expected");
        int err = set_scaled(s, lx, 3, -1000000000, 1000000000, &v[k], range);
        if (err) return err;
    }
    int err = session_expect_end(s, lx);
    if (err) return err;
    if (!v[0] && !v[1] && !v[2]) return session_fail(s, &at, ERR_VALUE, "a light needs a direction other than 0,0,0");
    for (int k = 0; k < 3; k++) s->settings.light_milli[k] = (int32_t)v[k];
    return 0;
}

/* set shadow [on|off] */
int set_shadow(session_t *s, lexer_t *lx) {
    bool off = lexer_is_name(lx, "off");
    if (off || lexer_is_name(lx, "on")) lexer_next(lx);
    if (!session_at_end(lx)) return lexer_unexpected(lx, &s->error, "on, off or the end of the command expected");
    s->settings.shadow = !off;
    return 0;
}

#endif
