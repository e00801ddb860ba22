/* set_view.c - where the surface is seen from, which lines are hidden, and how high it floats above its base plane. */
#include "lang/session_parts.h"
#include <string.h>

static int three(session_t *s, lexer_t *lx, num_t out[3]) {
    for (int k = 0; k < 3; k++) {
        if (k > 0 && !lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "three numbers X,Y,Z expected");
        int err = expr_number(&s->lang, lx, &out[k], &s->error);
        if (err) return err;
    }
    return 0;
}

/* set view from X,Y,Z [to X,Y,Z]. */
static int view_from(session_t *s, lexer_t *lx) {
    lexer_t at = *lx;
    num_t eye[3], to[3];
    bool has_to = false;
    int err = three(s, lx, eye);
    if (err) return err;
    if (lexer_is_name(lx, "to")) {
        lexer_next(lx);
        err = three(s, lx, to);
        if (err) return err;
        has_to = true;
    }
    err = session_expect_end(s, lx);
    if (err) return err;
    if (has_to) {
        int k = 0;
        while (k < 3 && num_cmp(eye[k], to[k]) == 0) k++;
        if (k == 3) return session_fail(s, &at, ERR_VALUE, "one cannot look from a point to the same point");
        memcpy(s->settings.view.to, to, sizeof to);
    }
    memcpy(s->settings.view.eye, eye, sizeof eye);
    s->settings.view.from = true;
    s->settings.view.has_to = has_to;
    return 0;
}

/* set view [rx][,[rz][,[scale][,[zscale]]]]: what is left out stays as it is. */
static int view_rotation(session_t *s, lexer_t *lx) {
    static const char *const message[4] = {"rot_x must be between 0 and 360", "rot_z must be between 0 and 360",
                                           "scale must be between 0.001 and 1000",
                                           "zscale must be between 0.001 and 1000"};
    num_t *const field[4] = {&s->settings.view.rot_x, &s->settings.view.rot_z, &s->settings.view.scale,
                             &s->settings.view.zscale};
    num_t value[4];
    for (int k = 0; k < 4; k++) value[k] = *field[k];
    for (int k = 0; k < 4; k++) {
        if (lx->tok.kind != ',' && !session_at_end(lx)) {
            lexer_t at = *lx;
            int err = expr_number(&s->lang, lx, &value[k], &s->error);
            if (err) return err;
            num_t lo = k < 2 ? num_from_i64(0) : num_from_decimal(1, -3), hi = num_from_i64(k < 2 ? 360 : 1000);
            if (num_cmp(value[k], lo) < 0 || num_cmp(value[k], hi) > 0)
                return session_fail(s, &at, ERR_VALUE, message[k]);
        }
        if (!lexer_accept(lx, ',')) break;
    }
    int err = session_expect_end(s, lx);
    if (err) return err;
    for (int k = 0; k < 4; k++) *field[k] = value[k];
    s->settings.view.from = false;
    return 0;
}

/* set view equal xy | xyz, set view noequal. */
static int view_equal(session_t *s, lexer_t *lx) {
    uint8_t equal = 0;
    if (lexer_is_name(lx, "equal")) {
        lexer_next(lx);
        equal = lexer_is_name(lx, "xy") ? 2 : 3;
        if (!session_at_end(lx) && equal == 3 && !lexer_is_name(lx, "xyz"))
            return lexer_unexpected(lx, &s->error, "xy or xyz expected");
        if (!session_at_end(lx)) lexer_next(lx);
    } else {
        lexer_next(lx);
    }
    int err = session_expect_end(s, lx);
    if (!err) s->settings.view.equal = equal;
    return err;
}

int set_view(session_t *s, lexer_t *lx) {
    static const char ignored[] = "azi$muth\0proj$ection\0";
    if (lexer_is_name(lx, "from")) {
        lexer_next(lx);
        return view_from(s, lx);
    }
    if (lexer_is_name(lx, "map")) { /* straight from above */
        s->settings.view.rot_x = s->settings.view.rot_z = num_from_i64(0);
        s->settings.view.from = false;
        lexer_next(lx);
        session_skip(lx); /* scale */
        return 0;
    }
    if (lexer_is_name(lx, "equal") || lexer_is_almost(lx, "noequal$_axes")) return view_equal(s, lx);
    if (words_find(ignored, lx) >= 0) {
        session_warn(s, "set view ", lexer_text(lx), lx->tok.len, " is ignored");
        session_skip(lx);
        return 0;
    }
    return view_rotation(s, lx);
}

/* A word that changes nothing in the mode at hand. */
static void warn_ignored(session_t *s, const char *word) {
    session_warn(s, "set hidden3d: ", word, strlen(word), " is ignored in this mode");
}

int set_hidden3d(session_t *s, lexer_t *lx) {
    /* gnuplot's own options choose colours, triangle diagonals and undefined points; the last four take a number. */
    static const char taken[] = "def$aults\0fr$ont\0ba$ck\0nooff$set\0altdiagonal\0noalt$diagonal\0bentover\0nobent$"
                                "over\0noundef$ined\0offset\0off$set\0tri$anglepattern\0undef$ined\0";
    static const uint8_t taken_id[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1};
    enum hidden_mode mode = HIDDEN_PERIMETER;
    static const char solids[] = "conv$ex\0halo\0area\0";
    static const uint8_t solids_id[] = {HIDDEN_CONVEX, HIDDEN_HALO, HIDDEN_AREA};
    bool infinite = false;
    int word;
    if (lexer_is_almost(lx, "peri$meter")) {
        lexer_next(lx);
    } else if (lexer_is_almost(lx, "hor$izon")) {
        lexer_next(lx);
        mode = HIDDEN_HORIZON;
        infinite = lexer_is_almost(lx, "inf$inite");
        if (infinite) lexer_next(lx);
    } else if (lexer_is_name(lx, "none")) {
        lexer_next(lx);
        mode = HIDDEN_NONE;
    } else if ((word = words_find(solids, lx)) >= 0) {
        lexer_next(lx);
        mode = (enum hidden_mode)solids_id[word];
    } else if (!lexer_is_almost(lx, "dash$ed") && !lexer_is_almost(lx, "out$line") &&
               !lexer_is_almost(lx, "silh$ouette") && !lexer_is_almost(lx, "seam$s")) {
        for (int i; (i = words_find(taken, lx)) >= 0;) {
            lexer_next(lx);
            if (taken_id[i] == 0) continue;
            num_t number;
            int err = expr_number(&s->lang, lx, &number, &s->error);
            if (err) return err;
        }
    }
    bool dashed = lexer_is_almost(lx, "dash$ed");
    if (dashed) lexer_next(lx);
#if CONFIG_AREA
    bool outline = lexer_is_almost(lx, "out$line") || lexer_is_almost(lx, "silh$ouette");
    if (outline) lexer_next(lx);
    bool seams = lexer_is_almost(lx, "seam$s");
    if (seams) lexer_next(lx);
#endif
    if (!session_at_end(lx))
        return lexer_unexpected(lx, &s->error,
                                "perimeter, horizon, convex, halo, area, none, dashed"
#if CONFIG_AREA
                                ", outline, seams"
#endif
                                " expected");
#if CONFIG_AREA
    s->settings.outline = outline;
    s->settings.seams = seams;
    if (seams && mode != HIDDEN_PERIMETER && mode != HIDDEN_CONVEX) warn_ignored(s, "seams");
#endif
    if (dashed && (mode == HIDDEN_HALO || mode == HIDDEN_NONE)) warn_ignored(s, "dashed");
    s->settings.hidden = mode;
    s->settings.dashed = dashed;
    s->settings.horizon_infinite = infinite;
    return 0;
}

/* set xyplane at Z | [relative] FRACTION; set ticslevel FRACTION is the same. */
int set_xyplane(session_t *s, lexer_t *lx) {
    bool at = lexer_is_name(lx, "at");
    if (at || lexer_is_almost(lx, "rel$ative")) lexer_next(lx);
    num_t value;
    int err = expr_number(&s->lang, lx, &value, &s->error);
    if (!err) err = session_expect_end(s, lx);
    if (err) return err;
    s->settings.xyplane_at = at;
    s->settings.xyplane = value;
    return 0;
}
