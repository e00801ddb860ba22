#include "hidden/convex.h"
#include "hidden/wires.h"
size_t convex_bytes(int32_t faces, int32_t corners, int32_t segments) {
    (void)faces, (void)corners, (void)segments;
    return 0;
}
int convex_draw(const solid_map_t *m, const hidden_job_t *job, hidden_stats_t *stats) {
    return wires_draw(m, job, stats);
}
