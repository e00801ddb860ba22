/* Nanoseconds per facet of the ink stage alone, smooth and random, from 60x60 to 2000x2000: the kernel's pieces are
 * recorded beforehand, the pen does nothing. The map is the real one, and its part is shown by itself. */
#include "../unit/path_surface.h"
#include <stdio.h>
#include <time.h>

static double now_ns(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static double hill(double r) {
    return exp(-r * r);
}

/* A pen that only measures. */
typedef struct ruler {
    page_point_t at;
    double up_lat, down_lat;
} ruler_t;

static double go(ruler_t *r, page_point_t p) {
    const double dx = (double)p.x_lat - r->at.x_lat, dy = (double)p.y_lat - r->at.y_lat;
    r->at = p;
    return sqrt(dx * dx + dy * dy);
}
static int pen_move(void *ctx, page_point_t p) {
    ((ruler_t *)ctx)->up_lat += go(ctx, p);
    return 0;
}
static int pen_draw(void *ctx, page_point_t p) {
    ((ruler_t *)ctx)->down_lat += go(ctx, p);
    return 0;
}

/* The map's time for every vertex of every run, as often as the stage asks: ends three times, others once. */
static double map_ns(surface_ink_t *s) {
    int64_t sum = 0;
    double start = now_ns();
    for (int k = 0; k < s->pieces; k++) {
        const ink_piece_t *p = &s->piece[k];
        page_point_t q;
        for (int64_t t = p->from, last = -1; t != last; last = t, t = ink_next(p->family, t, p->to)) {
            if (surface_ink_point(s, p->family, 0, p->line, t, &q)) sum += q.x_lat;
        }
        for (int again = 0; again < 3; again++) {
            if (surface_ink_point(s, p->family, 0, p->line, again ? p->from : p->to, &q)) sum += q.x_lat;
        }
    }
    return now_ns() - start + (sum == 1);
}

static void measure(int32_t n, double (*f)(double)) {
    surface_ink_t ink;
    path_config_t c;
    path_stats_t stats;
    path_t path;
    if (surface_ink_make(&ink, n, 2, f, true)) return;
    const ink_map_t map = {&ink, surface_ink_point};
    ruler_t ruler = {0};
    const pen_sink_t pen = {&ruler, pen_move, pen_draw};
    size_t bytes = PATH_BYTES(ink.pieces + POOL_RUNS_MIN, 1);
    void *mem = malloc(bytes);
    double start, taken, finished, maps = map_ns(&ink);
    path_default(&c, 80 << 16);
    start = now_ns();
    if (path_init(&path, mem, bytes, &c, &map, &pen)) return;
    ink_sink_t s = path_sink(&path);
    for (int i = 0; i < ink.pieces; i++) {
        if (s.piece(s.ctx, &ink.piece[i])) return;
    }
    taken = now_ns();
    if (path_finish(&path, &stats)) return;
    finished = now_ns();
    double facets = (double)(n - 1) * (n - 1);
    printf("%-7s %5d %9d %9d %9.0f %9.0f %8.1f %8.1f %8.1f %8.0f\n", f ? "smooth" : "random", n, (int)stats.runs,
           (int)stats.strokes, ruler.down_lat / LAT_PER_MM, ruler.up_lat / LAT_PER_MM, (taken - start) / facets,
           (finished - taken) / facets, maps / facets, (finished - taken) / (double)stats.runs);
    free(mem);
    surface_ink_free(&ink);
}

int main(void) {
    const int32_t n[] = {60, 100, 200, 400, 1000, 2000};
    printf("%-7s %5s %9s %9s %9s %9s %8s %8s %8s %8s\n", "ink", "n", "runs", "strokes", "down mm", "up mm", "join ns",
           "rest ns", "of it map", "ns/run");
    for (int f = 0; f < 2; f++) {
        for (size_t k = 0; k < sizeof n / sizeof *n; k++) measure(n[k], f ? NULL : hill);
    }
    return 0;
}
