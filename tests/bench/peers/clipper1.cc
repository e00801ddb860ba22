// Clipper 6 (libpolyclipping) on the stars of bench_clip.
#include "tests/bench/stars.h"
#include <cstdio>
#include <ctime>
#include <polyclipping/clipper.hpp>

static double now_ms() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

static void measure(int spiky, int n) {
    {
        ClipperLib::Paths p[2], out;
        for (int k = 0; k < 2; k++)
            for (int c = 0; c < 2; c++) {
                ClipperLib::Path path;
                for (int i = 0; i < n; i++) {
                    int32_t x, y;
                    star_point(spiky, k, c, i, n, &x, &y);
                    path.push_back(ClipperLib::IntPoint(x, y));
                }
                p[k].push_back(path);
            }
        const int at_once = n < 1000 ? 1000 / n : 1; /* as in bench_clip.c */
        double best = 1e9, started = now_ms();
        for (int k = 0; k < 5 || (k < 20000 && now_ms() - started < 300); k++) {
            double start = now_ms();
            for (int i = 0; i < at_once; i++) {
                ClipperLib::Clipper c;
                c.AddPaths(p[0], ClipperLib::ptSubject, true);
                c.AddPaths(p[1], ClipperLib::ptClip, true);
                c.Execute(ClipperLib::ctIntersection, out, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
            }
            double took = (now_ms() - start) / at_once;
            if (took < best) best = took;
        }
        double area = 0;
        for (auto &path : out) area += ClipperLib::Area(path);
        std::printf("clipper1 %s %d %.4f %.0f\n", STARS_NAME[spiky], n, best, area);
    }
}

int main() {
    for (int spiky = 0; spiky < 2; spiky++)
        for (int k = 0; k < 4 && STARS_N[spiky][k]; k++) measure(spiky, STARS_N[spiky][k]);
}
