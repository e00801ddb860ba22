/* line_class.c - see line_class.h. */
#include "hidden/line_class.h"

#include "hidden/area/area_face.h"
#include "view/solid_map.h"

bool line_is_silhouette(const solid_map_t *m, int32_t edge) {
    const solid_t *s = m->solid;
    for (int32_t k = edge; k >= 0; k = s->edge[k].twin) {
        const solid_edge_t *e = &s->edge[k];
        if (e->face[0] < 0 && e->face[1] < 0) continue;
        if (e->face[0] < 0 || e->face[1] < 0) return true;
        if (area_looks_at_eye(m, e->face[0]) != area_looks_at_eye(m, e->face[1])) return true;
    }
    return false;
}

static bool is_free(const solid_t *s, int32_t edge) {
    for (int32_t k = edge; k >= 0; k = s->edge[k].twin)
        if (s->edge[k].face[0] >= 0 || s->edge[k].face[1] >= 0) return false;
    return true;
}

/* Smooth for every body at it, as for a mesh that is there twice. */
static bool is_smooth(const solid_t *s, int32_t edge) {
    for (int32_t k = edge; k >= 0; k = s->edge[k].twin)
        if (!solid_is_smooth(s, &s->edge[k])) return false;
    return true;
}

/* Creases that `outline` or the object's `crease` leaves out. */
static bool is_left_out(const line_sorter_t *l, int32_t edge) {
    const solid_t *s = l->map->solid;
    const solid_edge_t *e = &s->edge[edge];
    if (is_smooth(s, edge)) return true;
    if (e->twin >= 0 || e->face[0] < 0 || e->face[1] < 0) return l->outline && e->twin >= 0 && !is_free(s, edge);
    return l->outline && s->object[s->face[e->face[0]].object].smooth_q30 <= 0;
}

static int sort_piece(void *ctx, const ink_piece_t *p) {
    const line_sorter_t *l = ctx;
    if (p->family != INK_SEGMENT || p->surface != 0) return l->next.piece(l->next.ctx, p);
    ink_piece_t piece = *p;
    bool silhouette = line_is_silhouette(l->map, p->line);
    if (!silhouette && is_left_out(l, p->line)) return 0;
    piece.surface = l->hidden ? LINE_HIDDEN : silhouette ? LINE_SILHOUETTE : LINE_CREASE;
    return l->next.piece(l->next.ctx, &piece);
}

ink_sink_t line_class_sink(line_sorter_t *s) {
    return (ink_sink_t){s, sort_piece};
}
