/* plot_ranges.c - the ranges in front of a plot command, and the variables of its expressions.
 *
 * Parameters come first, where there are any, then the axes: splot [u] [v] [x] [y] [z], plot [t] [x] [y]. Names in
 * them, as in [r=0:1], become the variables. */
#include "lang/session_parts.h"

#if CONFIG_PARAMETRIC
/* Parametric surfaces have parameters of their own, and so have curves. Returns how many; *own: their ranges. */
static int parameters(session_t *s, enum plot_kind kind, expr_params_t *params, range_t **own) {
    static const char uvt[] = "uvt";
    memcpy(s->plot.uv, s->uv, sizeof s->uv);
    *own = s->plot.uv;
    int n = kind == PLOT_SURFACES && s->axes == AXES_PARAMETRIC ? 2 : 0;
#if CONFIG_SAMPLED
    s->plot.t = s->t;
    if (kind == PLOT_CURVES) *own = &s->plot.t;
    if (kind == PLOT_CURVES && s->axes != AXES_XY) n = 1;
#endif
    for (int k = 0; k < n; k++) {
        if (strcmp(s->dummy[k], k ? "y" : "x") != 0) continue; /* set dummy */
        params->name[k].text = &uvt[n == 1 ? 2 : k];
        params->name[k].len = 1;
    }
    return n;
}
#endif

int plot_ranges(session_t *s, lexer_t *lx, enum plot_kind kind, expr_params_t *params) {
    const range_t *set[3] = {&s->settings.x, &s->settings.y, &s->settings.z};
    range_t *own = NULL;
    int parameter = 0;
    params->count = kind == PLOT_CURVES ? 1 : 2;
    for (int k = 0; k < params->count; k++) {
        params->name[k].text = s->dummy[k];
        params->name[k].len = (uint8_t)strlen(s->dummy[k]);
    }
    for (int k = 0; k < 3; k++) s->plot.range[k] = *set[k];
#if CONFIG_PARAMETRIC
    parameter = parameters(s, kind, params, &own);
#endif
    const int n = parameter + (kind == PLOT_CURVES ? 2 : 3);
    for (int k = 0; k < n && lx->tok.kind == '['; k++) {
        lexer_t name = *lx;
        int err = set_range(s, lx, k < parameter ? &own[k] : &s->plot.range[k - parameter], &name, NULL);
        if (err) return err;
        if (name.tok.kind != TOKEN_NAME) continue;
        if (k >= params->count) return session_fail(s, &name, ERR_SYNTAX, "this axis has no variable");
        if (name.tok.len >= sizeof s->dummy[0]) return session_fail(s, &name, ERR_FULL, "this name is too long");
        params->name[k].text = lexer_text(&name);
        params->name[k].len = (uint8_t)name.tok.len;
    }
    return 0;
}
