/* plot_parametric.c - splot x(u,v), y(u,v), z(u,v) as a mesh: a facet for each cell of the grid of u and v, or without
 * hidden lines the isolines alone, as finely as samples says. */
#include "lang/session_parts.h"

#if CONFIG_PARAMETRIC
typedef struct build {
    session_t *s;
    const session_source_t *src;
    isolines_t iso;
    int error; /* of an expression */
} build_t;

/* The ends of u (k = 0) or v. */
static void ends(const session_t *s, int k, num_t out[2]) {
    const range_t *r = &s->plot.uv[k];
    out[0] = r->auto_lo ? num_from_i64(-5) : r->reverse ? r->hi : r->lo;
    out[1] = r->auto_hi ? num_from_i64(5) : r->reverse ? r->lo : r->hi;
}

void plot_limits(const session_t *s, isolines_t *iso) {
    for (int k = 0; k < 3; k++) {
        const range_t *r = &s->plot.range[k];
        if (!r->auto_lo) iso->lo[k] = r->lo;
        if (!r->auto_hi) iso->hi[k] = r->hi;
    }
}

/* A line of n points: of u where along is 0, of v where it is 1; the other one stays at `at`. */
static int add_line(build_t *b, const num_t end[2][2], int along, num_t at, int32_t n) {
    num_t uv[2] = {at, at}, p[3];
    for (int32_t i = 0; i < n; i++) {
        uv[along] = num_between(end[along], i, n);
        for (int k = 0; k < 3; k++) { /* the first error stays where expr_fault() finds it */
            value_t value = value_undef();
            if (!b->error) b->error = expr_eval(&b->s->lang, &b->src->part[k], uv, &value);
            p[k] = value_num(value);
        }
        int err = isolines_point(&b->iso, p[0], p[1], p[2]);
        if (err) return err;
    }
    return isolines_break(&b->iso);
}

static int lines(build_t *b, const num_t end[2][2]) {
    const int32_t *iso = b->s->settings.isosamples, *along = b->s->settings.samples;
    int err = 0;
    for (int32_t i = 0; i < iso[0] && !err; i++) err = add_line(b, end, 1, num_between(end[0], i, iso[0]), along[1]);
    for (int32_t j = 0; j < iso[1] && !err; j++) err = add_line(b, end, 0, num_between(end[1], j, iso[1]), along[0]);
    return err ? err : isolines_end_set(&b->iso, false);
}

static int facets(build_t *b, const num_t end[2][2]) {
    const int32_t nu = b->s->settings.isosamples[0], nv = b->s->settings.isosamples[1];
    int err = 0;
    for (int32_t j = 0; j < nv && !err; j++) err = add_line(b, end, 0, num_between(end[1], j, nv), nu);
    return err ? err : isolines_end_set(&b->iso, true);
}

int plot_parametric(session_t *s, session_source_t *src) {
    build_t b = {.s = s, .src = src};
    num_t end[2][2];
    const int32_t seed[2] = {s->lang.seed[0], s->lang.seed[1]};
    isolines_init(&b.iso);
    plot_limits(s, &b.iso);
    isolines_start(&b.iso, &s->pool);
    ends(s, 0, end[0]);
    ends(s, 1, end[1]);
    int err = s->settings.hidden == HIDDEN_NONE ? lines(&b, end) : facets(&b, end);
    s->lang.seed[0] = seed[0];
    s->lang.seed[1] = seed[1];
    if (b.error) {
        err = expr_fault(&s->lang, &src->name, &s->error);
        if (s->error.column == 0) s->error.column = src->column;
        return err;
    }
    if (err) return plot_fail(s, src, err, "more points than the memory for data holds; try fewer isosamples");
    if (isolines_finish(&b.iso, &s->plot.mesh[s->plot.next])) return plot_fail(s, src, ERR_EMPTY, "nothing to draw");
    memcpy(src->extent, b.iso.extent, sizeof src->extent);
    src->grids = 0;
    s->plot.next++;
    return 0;
}
#endif
