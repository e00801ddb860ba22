/* unset.c - `unset`: an option as it was in the beginning. */
#include "lang/log_axes.h"
#include "lang/session_parts.h"

int set_unset_command(session_t *s, lexer_t *lx) {
    lexer_t word = *lx;
    int index = set_find_option(s, lx, "an option expected; try `help unset`");
    if (index < 0) return index;
    settings_t *set = &s->settings;
    settings_t fresh;
    lexer_next(lx);
    uint8_t id = words_set_id[index];
#if CONFIG_LOGSCALE
    if (id == SET_LOGSCALE) return log_axes_set(s, lx, false);
#endif
    if (set_axes(s, id, false)) {
        if (id != SET_NONLINEAR) return session_expect_end(s, lx);
        session_skip(lx);
        return 0;
    }
#if CONFIG_LOAD_DEPTH
    if (id == SET_PRINT) {
        s->print_to[0] = '\0';
        return session_expect_end(s, lx);
    }
#endif
    if (id == SET_IGNORED || (CONFIG_LOAD_DEPTH && id == SET_PALETTE) || id == SET_STYLE || id == SET_BORDER ||
        set_tics_of(id)) {
        set->tics &= (uint8_t)~set_tics_of(id);
        if (id == SET_BORDER) set->border_base = false;
        session_warn_once(s, s->warned_set, index, "unset ", &word, " is ignored");
        session_skip(lx);
        return 0;
    }
#if CONFIG_AREA
    if (id == SET_LIGHT) return set_no_light(s, lx);
#endif
    int err = session_expect_end(s, lx);
    if (err) return err;
    settings_default(&fresh);
    switch (id) {
    case SET_ANGLES:
        s->lang.degrees = false;
        return 0;
    case SET_AUTOSCALE:
        return 0; /* ranges that were set stay set */
    case SET_DATAFILE:
        s->separator = 0;
        return 0;
    case SET_DUMMY:
        memcpy(s->dummy[0], "x", 2);
        memcpy(s->dummy[1], "y", 2);
        return 0;
    case SET_HALO:
        set->halo_um = fresh.halo_um;
        set->halo_ends = fresh.halo_ends;
        return 0;
#if CONFIG_AREA
    case SET_CREASE:
        set->crease_mdeg = 0;
        return 0;
    case SET_PEN:
        memcpy(set->pen, fresh.pen, sizeof fresh.pen);
        return 0;
    case SET_HATCH:
        set->hatch_um = 0;
        return 0;
    case SET_SHADOW:
        set->shadow = set->shadow_outline = false;
        return 0;
#endif
    case SET_HIDDEN3D:
        set->hidden = HIDDEN_NONE;
        set->dashed = false;
#if CONFIG_AREA
        set->outline = set->seams = false;
#endif
        return 0;
    case SET_ISOSAMPLES:
        memcpy(set->isosamples, fresh.isosamples, sizeof fresh.isosamples);
        return 0;
    case SET_MACHINE:
        set->machine = fresh.machine;
        return 0;
    case SET_PAPER:
        set->paper = fresh.paper;
        return 0;
    case SET_SAMPLES:
        memcpy(set->samples, fresh.samples, sizeof fresh.samples);
        return 0;
    case SET_TITLE:
        set->title[0] = '\0';
        return 0;
    case SET_VIEW:
        set->view = fresh.view;
        return 0;
#if CONFIG_PARAMETRIC
    case SET_URANGE:
    case SET_VRANGE:
        s->uv[id == SET_VRANGE] = fresh.x;
        return 0;
#endif
#if CONFIG_SCATTERED
    case SET_DGRID:
        s->scattered.on = false;
        return 0;
#endif
#if CONFIG_SAMPLED
    case SET_TRANGE:
        s->t = fresh.x;
        return 0;
    case SET_MAPPING:
        s->mapping = DATA_CARTESIAN;
        return 0;
#endif
    case SET_XRANGE:
        set->x = fresh.x;
        return 0;
    case SET_YRANGE:
        set->y = fresh.y;
        return 0;
    case SET_ZRANGE:
        set->z = fresh.z;
        return 0;
    case SET_XYPLANE:
    case SET_TICSLEVEL:
        set->xyplane_at = fresh.xyplane_at;
        set->xyplane = fresh.xyplane;
        return 0;
    default:
        return set_unknown(s, &word);
    }
}
