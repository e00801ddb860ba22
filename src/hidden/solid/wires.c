/* wires.c - see wires.h. */
#include "hidden/solid/wires.h"

int wires_draw(const solid_map_t *m, const hidden_job_t *job, hidden_stats_t *stats) {
    const solid_t *s = m->solid;
    *stats = (hidden_stats_t){.facets = s->nf};
    for (int32_t e = 0; e < s->ne; e++) {
        if (s->edge[e].first != e || solid_is_cut(s, &s->edge[e])) continue;
        const ink_piece_t piece = {INK_SEGMENT, 0, e, 0, INK_ONE};
        stats->edges++;
        stats->pieces++;
        int err = job->sink->piece(job->sink->ctx, &piece);
        if (err) return err;
    }
    return 0;
}
