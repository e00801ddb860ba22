/* profile_map.c - see profile_map.h. */
#include "view/profile_map.h"

#include "error.h"

int profile_map_measure(profile_map_t *m, const profiles_t *src, void (*tick)(void *ctx, int32_t done, int32_t of),
                        void *tick_ctx) {
    *m = (profile_map_t){.src = src};
    bool any = false;
    for (int32_t k = 0; k < src->count; k++) {
        int32_t n = src->points(src->ctx, k);
        if (tick) tick(tick_ctx, k, src->count);
        for (int32_t v = 0; v < n; v++) {
            num_t p[3];
            src->point(src->ctx, k, v, p);
            if (p[2].undef) continue;
            for (int axis = 0; axis < 3; axis++) {
                if (!any || num_cmp(p[axis], m->lo[axis]) < 0) m->lo[axis] = p[axis];
                if (!any || num_cmp(p[axis], m->hi[axis]) > 0) m->hi[axis] = p[axis];
            }
            any = true;
        }
    }
    return any ? 0 : ERR_EMPTY;
}

static bool vertex_h(const profile_map_t *m, int32_t profile, int32_t v, page_h_t *h) {
    num_t p[3];
    m->src->point(m->src->ctx, profile, v, p);
    if (p[2].undef) return false;
    *h = camera_point(m->cam, &m->lines, p);
    return true;
}

static bool lines_at(void *ctx, uint8_t family, int32_t line, int64_t t_q30, page_h_t *h) {
    (void)family;
    const profile_map_t *m = ctx;
    int32_t at = (int32_t)(t_q30 >> 30), s = (int32_t)(t_q30 & (INK_ONE - 1));
    if (!vertex_h(m, line, at, h)) return false;
    if (s == 0) return true;
    page_h_t next;
    if (!vertex_h(m, line, at + 1, &next)) return false;
    *h = line_space_mix(h, &next, s);
    return true;
}

int profile_map_setup(profile_map_t *m, const camera_t *cam) {
    m->cam = cam;
    m->lines = (line_space_t){.ctx = m, .at = lines_at};
    return camera_scale(cam, m->lo, m->hi, &m->lines);
}
