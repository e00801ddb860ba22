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

/* Is the current token a light's number? `2 -1,2,3` names light 2, `2-1,2,3` and `2 - 1,2,3` are directions. */
static bool is_number_of_light(lexer_t lx) {
    if (lx.tok.kind != TOKEN_NUMBER || lx.tok.value.kind != VALUE_INT) return false;
    size_t end = lx.tok.start + lx.tok.len;
    lexer_next(&lx);
    if (session_at_end(&lx) || lx.tok.kind == TOKEN_NUMBER || lx.tok.kind == TOKEN_NAME || lx.tok.kind == '(')
        return true;
    if ((lx.tok.kind != '-' && lx.tok.kind != '+') || lx.tok.start == end) return false;
    end = lx.tok.start + lx.tok.len;
    lexer_next(&lx);
    return lx.tok.start == end;
}

/* The light's index if it is named, and the first if not. */
static int light_index(session_t *s, lexer_t *lx, int32_t *index) {
    *index = 0;
    if (!is_number_of_light(*lx)) return 0;
    static const char *const range = "lights are numbered from 1 to 4";
    _Static_assert(LIGHTS_MAX == 4, "the message");
    int64_t n = lx->tok.value.m;
    if (n < 1 || n > LIGHTS_MAX) return session_fail(s, lx, ERR_VALUE, range);
    lexer_next(lx);
    *index = (int32_t)n - 1;
    return 0;
}

/* set light [N] X,Y,Z: the direction to a light far away, in the units of the data; set light [N] from X,Y,Z: its
 * place. */
int set_light(session_t *s, lexer_t *lx) {
    static const char *const range = "a light's coordinates must be between -1000000 and 1000000";
    int32_t n;
    int err = light_index(s, lx, &n);
    if (err) return err;
    bool point = lexer_is_name(lx, "from");
    if (point) lexer_next(lx);
    lexer_t at = *lx;
    int64_t v[3];
    for (int k = 0; k < 3; k++) {
        if (k && !lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "X,Y,Z expected");
        err = set_scaled(s, lx, 3, -1000000000, 1000000000, &v[k], range);
        if (err) return err;
    }
    err = session_expect_end(s, lx);
    if (err) return err;
    if (!point && !v[0] && !v[1] && !v[2])
        return session_fail(s, &at, ERR_VALUE, "a light needs a direction other than 0,0,0");
    for (int k = 0; k < 3; k++) s->settings.light[n].milli[k] = (int32_t)v[k];
    s->settings.light[n].point = point;
    s->settings.light[n].on = true;
    return 0;
}

/* unset light N; unset light: the first alone, as at the start. */
int set_no_light(session_t *s, lexer_t *lx) {
    settings_t fresh;
    int32_t n;
    settings_default(&fresh);
    if (session_at_end(lx)) {
        memcpy(s->settings.light, fresh.light, sizeof fresh.light);
        return 0;
    }
    if (!is_number_of_light(*lx)) return lexer_unexpected(lx, &s->error, "a light's number expected");
    int err = light_index(s, lx, &n);
    if (!err) err = session_expect_end(s, lx);
    if (err) return err;
    s->settings.light[n].on = false;
    return 0;
}

/* set shadow [on|off|outline] */
int set_shadow(session_t *s, lexer_t *lx) {
    bool off = lexer_is_name(lx, "off"), outline = lexer_is_almost(lx, "out$line");
    if (off || outline || lexer_is_name(lx, "on")) lexer_next(lx);
    if (!session_at_end(lx))
        return lexer_unexpected(lx, &s->error, "on, off, outline or the end of the command expected");
    s->settings.shadow = !off;
    s->settings.shadow_outline = outline;
    return 0;
}

#endif
