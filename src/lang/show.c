/* show.c - what is set, in the words one would set it with. */
#include "lang/session_parts.h"

static void show_pair(text_t *t, const char *what, const int32_t pair[2]) {
    text_add(t, what);
    text_add_int(t, pair[0]);
    text_add(t, ",");
    text_add_int(t, pair[1]);
    text_add(t, "\n");
}

static void show_point(text_t *t, const char *what, const num_t p[3]) {
    text_add(t, what);
    for (int k = 0; k < 3; k++) {
        if (k) text_add(t, ",");
        text_add_num(t, p[k]);
    }
}

static void show_view(text_t *t, const settings_t *set) {
    if (set->view.from) {
        show_point(t, "set view from ", set->view.eye);
        if (set->view.has_to) show_point(t, " to ", set->view.to);
    } else {
        const num_t v[3] = {set->view.rot_x, set->view.rot_z, set->view.scale};
        show_point(t, "set view ", v);
        text_add(t, ",");
        text_add_num(t, set->view.zscale);
        if (set->view.equal) text_add(t, set->view.equal == 2 ? "\nset view equal xy" : "\nset view equal xyz");
    }
    text_add(t, "\n");
}

static void show_hidden(text_t *t, const settings_t *set) {
    static const char *const name[] = {[HIDDEN_PERIMETER] = "set hidden3d perimeter",
                                       [HIDDEN_HORIZON] = "set hidden3d horizon",
                                       [HIDDEN_NONE] = "unset hidden3d",
                                       [HIDDEN_CONVEX] = "set hidden3d convex",
                                       [HIDDEN_HALO] = "set hidden3d halo",
                                       [HIDDEN_AREA] = "set hidden3d area"};
    text_add(t, name[set->hidden]);
    if (set->hidden == HIDDEN_HORIZON && set->horizon_infinite) text_add(t, " infinite");
    if (set->dashed) text_add(t, " dashed");
#if CONFIG_AREA
    if (set->outline) text_add(t, " outline");
    if (set->seams) text_add(t, " seams");
#endif
    text_add(t, "\n");
}

static void show_paper(text_t *t, const settings_t *set) {
    text_add(t, "set paper ");
    text_add_scaled(t, set->paper.width_um, 3);
    text_add(t, ",");
    text_add_scaled(t, set->paper.height_um, 3);
    text_add(t, " margin ");
    text_add_scaled(t, set->paper.margin_um, 3);
    text_add(t, "\n");
}

static void show_xyplane(text_t *t, const settings_t *set) {
    text_add(t, set->xyplane_at ? "set xyplane at " : "set xyplane relative ");
    text_add_num(t, set->xyplane);
    text_add(t, "\n");
}

static void show_title(text_t *t, const settings_t *set) {
    text_add(t, "set title '");
    for (const char *c = set->title; *c; c++) text_add_bytes(t, *c == '\'' ? "''" : c, *c == '\'' ? 2 : 1);
    text_add(t, "'\n");
}

static void show_datafile(const session_t *s, text_t *t) {
    text_add(t, "set datafile separator ");
    if (s->separator == '\t') {
        text_add(t, "tab\n");
    } else if (s->separator) {
        text_add(t, "'");
        text_add_bytes(t, &s->separator, 1);
        text_add(t, "'\n");
    } else {
        text_add(t, "whitespace\n");
    }
}

#if CONFIG_LOGSCALE
static void show_logscale(const session_t *s, text_t *t) {
    for (int k = 0; k < 3; k++) {
        if (s->log_base[k].m == 0) continue;
        char buf[VALUE_TEXT_MAX], word[] = "set logscale x ";
        word[sizeof word - 3] = (char)('x' + k);
        text_add(t, word);
        value_format(value_real(s->log_base[k]), buf);
        text_add(t, buf);
        text_add(t, "\n");
    }
}
#endif

/* One option; false if there is nothing to tell. */
static bool show_option(session_t *s, uint8_t id) {
    char buf[320];
    text_t t = text_start(buf, sizeof buf);
    const settings_t *set = &s->settings;
    switch (id) {
#if CONFIG_LOGSCALE
    case SET_LOGSCALE:
        show_logscale(s, &t);
        break;
#endif
#if CONFIG_SCATTERED
    case SET_DGRID:
        show_dgrid(s, &t);
        break;
#endif
#if CONFIG_SAMPLED
    case SET_TRANGE:
        show_range(&t, "t", &s->t);
        break;
    case SET_MAPPING: {
        static const char *const word[] = {"cartesian", "polar", "cylindrical", "spherical"};
        text_add(&t, "set mapping ");
        text_add(&t, word[s->mapping]);
        text_add(&t, "\n");
        break;
    }
#endif
#if CONFIG_PARAMETRIC
    case SET_PARAMETRIC:
    case SET_POLAR: /* one excludes the other */
        text_add(&t, s->axes == AXES_POLAR        ? "set polar\n"
                     : s->axes == AXES_PARAMETRIC ? "set parametric\n"
                     : id == SET_POLAR            ? "unset polar\n"
                                                  : "unset parametric\n");
        break;
    case SET_URANGE:
    case SET_VRANGE:
        show_range(&t, id == SET_URANGE ? "u" : "v", &s->uv[id == SET_VRANGE]);
        break;
#endif
    case SET_XRANGE:
        show_range(&t, "x", &set->x);
        break;
    case SET_YRANGE:
        show_range(&t, "y", &set->y);
        break;
    case SET_ZRANGE:
        show_range(&t, "z", &set->z);
        break;
    case SET_AUTOSCALE:
        show_range(&t, "x", &set->x);
        show_range(&t, "y", &set->y);
        show_range(&t, "z", &set->z);
        break;
    case SET_SAMPLES:
        show_pair(&t, "set samples ", set->samples);
        break;
    case SET_ISOSAMPLES:
        show_pair(&t, "set isosamples ", set->isosamples);
        break;
    case SET_HIDDEN3D:
        show_hidden(&t, set);
        break;
    case SET_HALO:
        show_value(&t, "set halo ", set->halo_um, 3);
        text_add(&t, set->halo_ends ? " ends\n" : "\n");
        break;
#if CONFIG_AREA
    case SET_PEN:
        show_pens(&t, set);
        break;
    case SET_CREASE:
        show_value(&t, "set crease ", set->crease_mdeg, 3);
        text_add(&t, "\n");
        break;
    case SET_HATCH:
        if (!set->hatch_um) {
            text_add(&t, "unset hatch\n");
            break;
        }
        show_value(&t, "set hatch ", set->hatch_mdeg, 3);
        show_value(&t, ",", set->hatch_um, 3);
        text_add(&t, "\n");
        break;
    case SET_LIGHT:
        show_lights(&t, set);
        break;
    case SET_SHADOW:
        text_add(&t, set->shadow_outline ? "set shadow outline\n" : set->shadow ? "set shadow\n" : "unset shadow\n");
        break;
#endif
    case SET_VIEW:
        show_view(&t, set);
        break;
    case SET_TITLE:
        show_title(&t, set);
        break;
    case SET_XYPLANE:
    case SET_TICSLEVEL:
        show_xyplane(&t, set);
        break;
    case SET_PAPER:
        show_paper(&t, set);
        break;
    case SET_MACHINE:
        show_machine(s, &t);
        s->port->print(s->port->ctx, buf);
        t = text_start(buf, sizeof buf);
        show_wiring(&set->machine, &t);
        break;
    case SET_DATAFILE:
        show_datafile(s, &t);
        break;
    case SET_ANGLES:
        text_add(&t, s->lang.degrees ? "set angles degrees\n" : "set angles radians\n");
        break;
    case SET_DUMMY:
        text_add(&t, "set dummy ");
        text_add(&t, s->dummy[0]);
        text_add(&t, ",");
        text_add(&t, s->dummy[1]);
        text_add(&t, "\n");
        break;
    case SET_STYLE:
        text_add(&t, "set style data lines\n");
        break;
    case SET_VERSION:
        text_add(&t, "Ridgeline; its language is a subset of gnuplot 5.4's\n");
        break;
    case SET_VARIABLES:
        show_symbols(s, SYMBOL_VARIABLE);
        return true;
    case SET_FUNCTIONS:
        show_symbols(s, SYMBOL_FUNCTION);
        return true;
    default:
        return false;
    }
    s->port->print(s->port->ctx, buf);
    return true;
}

int show_command(session_t *s, lexer_t *lx) {
    static const uint8_t all[] = {
        SET_TITLE,    SET_XRANGE, SET_YRANGE,   SET_ZRANGE,    SET_XYPLANE,    SET_SAMPLES, SET_ISOSAMPLES, SET_VIEW,
        SET_HIDDEN3D, SET_HALO,   SET_HATCH,    SET_LIGHT,     SET_SHADOW,     SET_CREASE,  SET_PEN,        SET_PAPER,
        SET_MACHINE,  SET_ANGLES, SET_DUMMY,    SET_DATAFILE,  SET_PARAMETRIC, SET_URANGE,  SET_VRANGE,     SET_TRANGE,
        SET_MAPPING,  SET_DGRID,  SET_LOGSCALE, SET_VARIABLES, SET_FUNCTIONS};
    if (session_at_end(lx)) return lexer_unexpected(lx, &s->error, "an option expected; try `show all`");
    lexer_t word = *lx;
    bool plot = lexer_is_almost(lx, "p$lot");
    int index = plot ? 0 : words_find(words_set, lx);
    if (index < 0) {
        if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "an option expected; try `show all`");
        return lang_error_set_name(&s->error, ERR_NAME, lexer_column(lx), "unknown option", lexer_text(lx),
                                   lx->tok.len);
    }
    lexer_next(lx);
    uint8_t id = words_set_id[index];
    if (id == SET_IGNORED || (CONFIG_LOAD_DEPTH && (id == SET_PRINT || id == SET_PALETTE)) || id == SET_NONLINEAR ||
        (!CONFIG_SAMPLED && id == SET_POLAR) || (!CONFIG_PARAMETRIC && id == SET_PARAMETRIC)) {
        session_warn_once(s, s->warned_set, index, "show ", &word, ": this option is ignored here");
        session_skip(lx);
        return 0;
    }
    if (id == SET_STYLE || id == SET_DATAFILE) session_skip(lx); /* show style line: all there is to tell */
    int err = session_expect_end(s, lx);
    if (err) return err;
    if (plot) {
        s->port->print(s->port->ctx, s->last);
        s->port->print(s->port->ctx, "\n");
    } else if (id == SET_ALL) {
        for (size_t i = 0; i < sizeof all; i++) show_option(s, all[i]);
    } else {
        show_option(s, id);
    }
    return 0;
}
