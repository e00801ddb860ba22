// Boost.Geometry on the stars of bench_clip, integer coordinates.
#include "tests/bench/stars.h"
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cstdio>
#include <ctime>

namespace bg = boost::geometry;
typedef bg::model::polygon<bg::model::d2::point_xy<long long>> polygon;

static double now_ms() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

static void measure(int spiky, int n) {
    {
        polygon p[2];
        for (int k = 0; k < 2; k++) {
            p[k].inners().resize(1);
            for (int c = 0; c < 2; c++)
                for (int i = 0; i < n; i++) {
                    int32_t x, y;
                    star_point(spiky, k, c, i, n, &x, &y);
                    bg::model::d2::point_xy<long long> at(x, y);
                    if (c)
                        p[k].inners()[0].push_back(at);
                    else
                        p[k].outer().push_back(at);
                }
            bg::correct(p[k]);
        }
        const int at_once = n < 1000 ? 1000 / n : 1; /* as in bench_clip.c */
        double best = 1e9, started = now_ms(), area = 0;
        for (int k = 0; k < 5 || (k < 20000 && now_ms() - started < 300); k++) {
            bg::model::multi_polygon<polygon> out;
            double start = now_ms();
            for (int i = 0; i < at_once; i++) {
                out.clear();
                bg::intersection(p[0], p[1], out);
            }
            double took = (now_ms() - start) / at_once;
            if (took < best) best = took;
            area = double(bg::area(out));
        }
        std::printf("boost %s %d %.4f %.0f\n", STARS_NAME[spiky], n, best, area);
    }
}

int main() {
    for (int spiky = 0; spiky < 2; spiky++)
        for (int k = 0; k < 4 && STARS_N[spiky][k]; k++) measure(spiky, STARS_N[spiky][k]);
}
