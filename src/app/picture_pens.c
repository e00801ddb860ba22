/* picture_pens.c - see picture_pens.h. */
#include "app/picture_pens.h"

#include "app/picture_stages.h"

#if CONFIG_AREA

uint32_t pens_wanted(const plot_t *plot) {
    const settings_t *s = plot->settings;
    uint32_t wanted = 1u << s->pen[LINE_CREASE];
    if (picture_is_hatched(plot)) wanted |= 1u << s->pen[LINE_HATCH];
    if (!picture_wants_solids(plot)) return wanted;
    wanted |= 1u << s->pen[LINE_SILHOUETTE];
    if (s->shadow && s->shadow_outline && s->hidden == HIDDEN_AREA) wanted |= 1u << s->pen[LINE_SHADOW];
    bool dashed = s->dashed;
    for (int32_t k = 0; k < plot->n; k++) {
        if (!plot->item[k].solid) continue;
        if (plot->item[k].mesh.details) wanted |= 1u << s->pen[LINE_DETAIL];
        dashed |= plot->item[k].mesh.clear;
    }
    if (dashed) wanted |= 1u << s->pen[LINE_HIDDEN];
    return wanted;
}

static int take_ink(void *ctx, const ink_piece_t *piece) {
    const pens_t *p = ctx;
    return p->of_space[piece->surface] == p->now ? p->next_ink.piece(p->next_ink.ctx, piece) : 0;
}

ink_sink_t pens_ink(pens_t *p, ink_sink_t next) {
    p->next_ink = next;
    return (ink_sink_t){p, take_ink};
}

static int pens_move(void *ctx, page_point_t to) {
    pens_t *p = ctx;
    if (!p->announced) {
        p->announced = true;
        int err = p->announce ? p->announce(p->ctx, p->now) : 0;
        if (err) return err;
    }
    return p->next_pen.move(p->next_pen.ctx, to);
}

static int pens_draw(void *ctx, page_point_t to) {
    const pens_t *p = ctx;
    return p->next_pen.draw(p->next_pen.ctx, to);
}

pen_sink_t pens_sink(pens_t *p, const pen_sink_t *next) {
    p->next_pen = *next;
    return (pen_sink_t){p, pens_move, pens_draw};
}

void pens_add(picture_stats_t *sum, const picture_stats_t *pass) {
    path_stats_t path = sum->path;
    const path_stats_t *more = &pass->path;
    *sum = *pass;
    sum->path.pieces += path.pieces;
    sum->path.runs += path.runs;
    sum->path.strokes += path.strokes;
    sum->path.dots += path.dots;
    sum->path.lost += path.lost;
    sum->path.vertices += path.vertices;
    sum->path.draws += path.draws;
    sum->path.flushes += path.flushes;
    if (path.bytes > more->bytes) sum->path.bytes = path.bytes;
}

#endif
