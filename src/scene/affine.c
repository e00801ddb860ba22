/* affine.c - see affine.h. Set-up, and once for each vertex read. */
#include "scene/affine.h"

#include "num/func.h"

void affine_identity(affine_t *a) {
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 4; c++) a->m[r][c] = num_from_i64(r == c);
}

void affine_translate(affine_t *a, const num_t by[3]) {
    for (int r = 0; r < 3; r++) a->m[r][3] = num_add(a->m[r][3], by[r]);
}

void affine_scale(affine_t *a, const num_t by[3]) {
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 4; c++) a->m[r][c] = num_mul(a->m[r][c], by[r]);
}

/* Rows p and q become (p cos - q sin, p sin + q cos). */
static void turn(affine_t *a, int p, int q, num_t degrees) {
    num_t sine = func_sin_degrees(degrees), cosine = func_sin_degrees(num_add(degrees, num_from_i64(90)));
    for (int c = 0; c < 4; c++) {
        num_t u = a->m[p][c], v = a->m[q][c];
        a->m[p][c] = num_sub(num_mul(u, cosine), num_mul(v, sine));
        a->m[q][c] = num_add(num_mul(u, sine), num_mul(v, cosine));
    }
}

void affine_rotate(affine_t *a, const num_t degrees[3]) {
    turn(a, 1, 2, degrees[0]);
    turn(a, 2, 0, degrees[1]);
    turn(a, 0, 1, degrees[2]);
}

void affine_apply(const affine_t *a, num_t p[3]) {
    num_t out[3];
    for (int r = 0; r < 3; r++) {
        out[r] = a->m[r][3];
        for (int c = 0; c < 3; c++) out[r] = num_add(out[r], num_mul(a->m[r][c], p[c]));
    }
    for (int r = 0; r < 3; r++) p[r] = out[r];
}
