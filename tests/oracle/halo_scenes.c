/* halo_scenes.c - see halo_scenes.h. */
#include "tests/oracle/halo_scenes.h"

#include <math.h>

static double uniform(uint64_t *rng) {
    *rng = *rng * 6364136223846793005u + 1442695040888963407u;
    return (double)(*rng >> 11) * 0x1p-53;
}

void halo_scene_random(halo_edge_t *edge, int32_t n, double length) {
    uint64_t rng = 1987;
    for (int32_t i = 0; i < n; i++) {
        double x = uniform(&rng), y = uniform(&rng);
        double u = x + length * (2 * uniform(&rng) - 1), v = y + length * (2 * uniform(&rng) - 1);
        int32_t z0 = (int32_t)(uniform(&rng) * HALO_Z_MAX), z1 = (int32_t)(uniform(&rng) * HALO_Z_MAX);
        edge[i] = (halo_edge_t){{(int32_t)(x * HALO_SCENE_PAGE), (int32_t)(y * HALO_SCENE_PAGE), z0},
                                {(int32_t)(u * HALO_SCENE_PAGE), (int32_t)(v * HALO_SCENE_PAGE), z1},
                                i};
    }
}

double halo_scene_cubes(halo_edge_t *edge, int k) {
    const double up = 25 * M_PI / 180, turn = 30 * M_PI / 180, scale = HALO_SCENE_PAGE / (1.5 * k * 1.45);
    int32_t n = 0;
    for (int c = 0; c < k * k; c++) {
        halo_point_t corner[8];
        for (int v = 0; v < 8; v++) {
            double x = 1.5 * (c % k) + (v & 1), y = 1.5 * (c / k) + (v >> 1 & 1), z = v >> 2;
            double side = x * cos(turn) + y * sin(turn), away = -x * sin(turn) + y * cos(turn);
            corner[v] =
                (halo_point_t){(int32_t)lround(scale * side), (int32_t)lround(scale * (away * sin(up) + z * cos(up))),
                               (int32_t)lround(scale * (z * sin(up) - away * cos(up)))};
        }
        for (int v = 0; v < 8; v++)
            for (int bit = 1; bit < 8; bit *= 2)
                if (!(v & bit)) edge[n] = (halo_edge_t){corner[v], corner[v | bit], n}, n++;
    }
    return scale;
}
