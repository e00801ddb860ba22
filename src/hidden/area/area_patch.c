/* area_patch.c - see area_patch.h. */
#include "hidden/area/area_patch.h"

#include "config.h"
#include "error.h"
#include "hidden/area/area_detail.h"

#if CONFIG_AREA

static bool is_toned(const solid_edge_t *e) {
    return e->face[1] < 0;
}

bool area_patch_any(const solid_t *s) {
    for (int32_t k = s->ne; k < s->ne + s->nd; k++)
        if (is_toned(&s->edge[k])) return true;
    return false;
}

static uint8_t *lay_out(clip_out_t *out, uint8_t *at, size_t bytes) {
    const int32_t most = (int32_t)(bytes / (sizeof(poly_vertex_t) + sizeof(int32_t)));
    *out = (clip_out_t){.v = (poly_vertex_t *)(void *)at, .n_max = most, .contours_max = most};
    out->end = (int32_t *)(void *)(out->v + most);
    return at + bytes;
}

void area_patches_init(area_patches_t *a, const area_lattice_t *l, void *mem, size_t bytes) {
    const size_t share = bytes / 6 & ~(size_t)7;
    uint8_t *at = mem;
    *a = (area_patches_t){.lattice = l};
    at = lay_out(&a->patch, at, share);
    at = lay_out(&a->inside, at, share);
    for (int k = 0; k < 2; k++) at = lay_out(&a->rest[k], at, share);
    a->scratch = at;
    a->scratch_bytes = 2 * share;
}

/* The polygon of edges [from, to), clipped to what can be drawn, into a->patch. */
static int place(area_patches_t *a, int32_t from, int32_t to) {
    const solid_edge_t *edge = a->lattice->m->solid->edge;
    const bool clips = a->lattice->clips;
    clip_out_t *out = &a->patch;
    out->n = out->contours = 0;
    for (int32_t k = from, next; k < to; k = next) {
        for (next = k + 1; next < to && !solid_tone(&edge[next]).contour;) next++;
        const int32_t most = AREA_CORNERS(clips, next - k);
        if (AREA_SCRATCH(clips, next - k) > a->scratch_bytes || out->n + most > out->n_max ||
            out->contours == out->contours_max)
            return ERR_FULL;
        const int32_t n =
            area_contour_place(a->lattice, k, next - k, out->v + out->n, (area_corner_t *)(void *)a->scratch, most);
        if (n < 0) return n;
        out->n += n;
        if (n > 0) out->end[out->contours++] = out->n;
    }
    return 0;
}

int area_patches_cut(area_patches_t *a, int32_t face, const poly_t *p, void *clip_mem, size_t clip_bytes,
                     const area_patch_sink_t *sink) {
    const solid_t *s = a->lattice->m->solid;
    const int32_t first = area_detail_first(s, face);
    int32_t to = first;
    poly_t rest = *p;
    int which = 0;
    while (to < s->ne + s->nd && s->edge[to].face[0] == face) to++;
    for (int32_t from; to > first && rest.contours; to = from) {
        from = to - 1;
        if (!is_toned(&s->edge[from])) continue;
        while (!solid_tone(&s->edge[from]).polygon) from--;
        int err = place(a, from, to);
        if (err) return err;
        if (a->patch.contours == 0) continue;
        const clip_job_t job = {
            rest, {a->patch.v, a->patch.end, a->patch.contours}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_OUTSIDE}};
        clip_out_t *in = &a->inside, *out = &a->rest[which];
        clip_t clip;
        in->n = in->contours = out->n = out->contours = 0;
        err = clip_run(&clip, &job, clip_mem, clip_bytes);
        if (!err) err = clip_trace(&clip, 0, in);
        if (!err) err = clip_trace(&clip, 1, out);
        rest = (poly_t){out->v, out->end, out->contours};
        which = !which;
        const poly_t inside = {in->v, in->end, in->contours};
        if (!err && inside.contours) err = sink->part(sink->ctx, &inside, solid_tone(&s->edge[from]).percent);
        if (err) return err;
    }
    return rest.contours ? sink->part(sink->ctx, &rest, 100) : 0;
}

#endif
