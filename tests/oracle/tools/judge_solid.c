/* judge_solid - judges a drawing of solids by the whole program (.seg) at random places, by rays.
 *
 *     judge_solid DRAWING.seg BODY.obj... [-n PLACES] [-s SEED] [-p X0,Y0,X1,Y1]
 *
 * Places on edges of the files, which must not be moved by the plot: one that is visible must be drawn. Places on drawn
 * segments: some edge must run there that is not hidden. A place counts only where rays from it and from eight places
 * a step (0.0125 mm) around it agree. The rays are tested against every face whose picture is there (its plane, and
 * even-odd in the polygon): nothing here knows of bodies, outlines, convexity or a lattice, and scenes of a hundred
 * thousand faces take seconds. For scenes in front of the eye, and all on the page, or with the
 * corners of its drawing area (-p 10,10,287,200), beyond which nothing is asked. A quadrilateral that is not flat may
 * be cut along either diagonal: what one of the two would hide is not judged. Other polygons that are not flat are
 * named, and not judged at all.
 *
 * Prints what it counted; exit status 0 when nothing is missing or false, 1 when something is, 2 when it cannot judge.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/oracle/judge_seg.h"

#define STEP 0.0125
#define CELLS 512 /* a side */
#define SHOWN 10

typedef struct vec {
    double x, y, z;
} vec_t;

typedef struct face {
    int first, n;
    vec_t normal; /* of length 1; 0 without an area */
    double size;
    int line; /* of its file */
    int bent; /* not 0: four corners that are not in a plane; s.part[bent - 1 ..]: two triangles for each diagonal */
} face_t;

typedef struct bins {
    int *head, *next, *item, n, cap;
} bins_t;

static struct {
    vec_t *vertex;
    double (*page)[2];
    int *corner, (*edge)[2];
    face_t *face, *part;
    int nv, nc, nf, ne, np;
    double size, lo[2], hi[2]; /* lo, hi: of the page */
    page_view_t view;
    page_seg_t *seg;
    size_t segs;
    bins_t faces, edges, drawn;
    double area[4]; /* of the page: x0, y0, x1, y1 */
    uint64_t rng;
} s;

static int complain(const char *what, const char *arg) {
    fprintf(stderr, "judge_solid: %s%s%s\n", what, arg ? ": " : "", arg ? arg : "");
    return 2;
}

static void *grow(void *p, int n, size_t size) {
    if (n & (n - 1)) return p; /* at powers of two */
    p = realloc(p, (n ? 2 * (size_t)n : 1) * size);
    if (!p) exit(complain("out of memory", NULL));
    return p;
}

static vec_t add(vec_t a, double t, vec_t b) {
    return (vec_t){a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
}
static vec_t sub(vec_t a, vec_t b) {
    return add(a, -1, b);
}
static vec_t cross(vec_t a, vec_t b) {
    return (vec_t){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static double dot(vec_t a, vec_t b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static vec_t unit(vec_t a) {
    double n = sqrt(dot(a, a));
    return n > 0 ? (vec_t){a.x / n, a.y / n, a.z / n} : a;
}
static double uniform(void) {
    s.rng ^= s.rng << 13, s.rng ^= s.rng >> 7, s.rng ^= s.rng << 17;
    return (double)(s.rng >> 11) * 0x1p-53;
}

static bool on_page(vec_t p, double at[2]) {
    return page_view_point(&s.view, (exact_point_t){p.x, p.y, p.z}, &at[0], &at[1]);
}

/* The files. */

static void add_edge(int a, int b) {
    if (a == b) return;
    s.edge = grow(s.edge, s.ne, sizeof *s.edge);
    s.edge[s.ne][0] = a < b ? a : b;
    s.edge[s.ne++][1] = a < b ? b : a;
}

static int read_obj(const char *name) {
    FILE *f = fopen(name, "r");
    static char line[1 << 20];
    const int before = s.nv;
    int number = 0;
    if (!f) return complain("cannot open", name);
    while (fgets(line, sizeof line, f)) {
        double x, y, z;
        number++;
        if (sscanf(line, " v %lf %lf %lf", &x, &y, &z) == 3) {
            s.vertex = grow(s.vertex, s.nv, sizeof *s.vertex);
            s.vertex[s.nv++] = (vec_t){x, y, z};
        }
        if ((line[0] != 'f' && line[0] != 'l') || line[1] != ' ') continue;
        const int first = s.nc;
        for (char *word = strtok(line + 1, " \t\r\n"); word; word = strtok(NULL, " \t\r\n")) {
            const int v = atoi(word);
            s.corner = grow(s.corner, s.nc, sizeof *s.corner);
            s.corner[s.nc++] = v > 0 ? before + v - 1 : s.nv + v;
        }
        const int n = s.nc - first;
        for (int k = 0; k + (line[0] == 'l') < n; k++) add_edge(s.corner[first + k], s.corner[first + (k + 1) % n]);
        if (line[0] == 'l' || n < 3) {
            s.nc = first;
            continue;
        }
        s.face = grow(s.face, s.nf, sizeof *s.face);
        s.face[s.nf++] = (face_t){.first = first, .n = n, .line = number};
    }
    fclose(f);
    return 0;
}

static int by_ends(const void *p, const void *q) {
    return memcmp(p, q, 2 * sizeof(int));
}

static void find_normal(face_t *f) {
    vec_t n = {0, 0, 0};
    const int *c = s.corner + f->first;
    const vec_t o = s.vertex[c[0]];
    for (int k = 1; k + 1 < f->n; k++) n = add(n, 1, cross(sub(s.vertex[c[k]], o), sub(s.vertex[c[k + 1]], o)));
    f->size = sqrt(dot(n, n));
    f->normal = f->size > 1e-14 * s.size * s.size ? unit(n) : (vec_t){0, 0, 0};
}

/* Are all corners in a plane, as the program has it: within 2^-26 of the scene? Otherwise both ways to cut it in two.
 */
static int find_bend(face_t *f) {
    static const int cut[4][3] = {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {1, 3, 0}};
    double off = 0;
    for (int k = 1; k < f->n; k++) {
        const vec_t d = sub(s.vertex[s.corner[f->first + k]], s.vertex[s.corner[f->first]]);
        off = fmax(off, fabs(dot(f->normal, d)));
    }
    if (off <= 1.5e-8 * s.size) return 0;
    if (f->n > 4) {
        char what[64];
        snprintf(what, sizeof what, "line %d", f->line);
        return complain("this polygon has more than four corners, and they are not in a plane", what);
    }
    f->bent = s.np + 1;
    for (int k = 0; k < 4; k++) {
        s.part = grow(s.part, s.np, sizeof *s.part);
        s.part[s.np] = (face_t){.first = s.nc, .n = 3};
        for (int i = 0; i < 3; i++) {
            s.corner = grow(s.corner, s.nc, sizeof *s.corner);
            s.corner[s.nc++] = s.corner[f->first + cut[k][i]];
        }
        find_normal(&s.part[s.np++]);
    }
    return 0;
}

/* Planes, pictures, and every edge once. */
static int prepare(void) {
    vec_t lo = s.vertex[0], hi = lo;
    s.page = malloc((size_t)s.nv * sizeof *s.page);
    for (int v = 0; v < s.nv; v++) {
        const vec_t p = s.vertex[v];
        lo = (vec_t){fmin(lo.x, p.x), fmin(lo.y, p.y), fmin(lo.z, p.z)};
        hi = (vec_t){fmax(hi.x, p.x), fmax(hi.y, p.y), fmax(hi.z, p.z)};
        if (!on_page(p, s.page[v])) return complain("something is behind the eye", NULL);
        for (int k = 0; k < 2; k++) {
            s.lo[k] = v ? fmin(s.lo[k], s.page[v][k]) : s.page[v][k];
            s.hi[k] = v ? fmax(s.hi[k], s.page[v][k]) : s.page[v][k];
        }
    }
    const vec_t side = sub(hi, lo);
    s.size = fmax(side.x, fmax(side.y, side.z));
    for (int f = 0; f < s.nf; f++) {
        find_normal(&s.face[f]);
        if (find_bend(&s.face[f])) return 2;
    }
    qsort(s.edge, (size_t)s.ne, sizeof *s.edge, by_ends);
    int kept = 0;
    for (int e = 0; e < s.ne; e++)
        if (e == 0 || by_ends(s.edge[e], s.edge[kept - 1])) memmove(s.edge[kept++], s.edge[e], sizeof *s.edge);
    s.ne = kept;
    return 0;
}

/* What is where on the page. */

static int cell_of(int axis, double at) {
    const double c = (at - s.lo[axis]) / (s.hi[axis] - s.lo[axis] + 1e-9) * CELLS;
    return c < 0 ? 0 : c >= CELLS ? CELLS - 1 : (int)c;
}

static void put(bins_t *b, int cx, int cy, int item) {
    const int cell = cy * CELLS + cx;
    if (b->head[cell] >= 0 && b->item[b->head[cell]] == item) return;
    if (b->n == b->cap) {
        b->cap = b->cap ? 2 * b->cap : 4096;
        b->next = realloc(b->next, (size_t)b->cap * sizeof(int));
        b->item = realloc(b->item, (size_t)b->cap * sizeof(int));
        if (!b->next || !b->item) exit(complain("out of memory", NULL));
    }
    b->item[b->n] = item;
    b->next[b->n] = b->head[cell];
    b->head[cell] = b->n++;
}

static void open_bins(bins_t *b) {
    b->head = malloc(sizeof(int) * CELLS * CELLS);
    memset(b->head, -1, sizeof(int) * CELLS * CELLS);
}

static void put_line(bins_t *b, const double a[2], const double e[2], int item) {
    const int n = 32 * (abs(cell_of(0, a[0]) - cell_of(0, e[0])) + abs(cell_of(1, a[1]) - cell_of(1, e[1]))) + 1;
    for (int k = 0; k <= n; k++) {
        const double t = (double)k / n, x = a[0] + t * (e[0] - a[0]), y = a[1] + t * (e[1] - a[1]);
        const double m = 2 * STEP;
        for (int cy = cell_of(1, y - m); cy <= cell_of(1, y + m); cy++)
            for (int cx = cell_of(0, x - m); cx <= cell_of(0, x + m); cx++) put(b, cx, cy, item);
    }
}

static void sort_into_bins(void) {
    open_bins(&s.faces);
    open_bins(&s.edges);
    open_bins(&s.drawn);
    for (int f = 0; f < s.nf; f++) {
        double lo[2] = {1e30, 1e30}, hi[2] = {-1e30, -1e30};
        for (int k = 0; k < s.face[f].n; k++)
            for (int i = 0; i < 2; i++) {
                const double at = s.page[s.corner[s.face[f].first + k]][i];
                lo[i] = fmin(lo[i], at - 4 * STEP), hi[i] = fmax(hi[i], at + 4 * STEP);
            }
        for (int y = cell_of(1, lo[1]); y <= cell_of(1, hi[1]); y++)
            for (int x = cell_of(0, lo[0]); x <= cell_of(0, hi[0]); x++) put(&s.faces, x, y, f);
    }
    for (int e = 0; e < s.ne; e++) put_line(&s.edges, s.page[s.edge[e][0]], s.page[s.edge[e][1]], e);
    for (size_t k = 0; k < s.segs; k++)
        put_line(&s.drawn, (double[]){s.seg[k].x0, s.seg[k].y0}, (double[]){s.seg[k].x1, s.seg[k].y1}, (int)k);
}

/* Rays. */

static bool is_within(const face_t *f, vec_t p) {
    const vec_t n = f->normal;
    const int drop = fabs(n.x) > fabs(n.y) ? (fabs(n.x) > fabs(n.z) ? 0 : 2) : (fabs(n.y) > fabs(n.z) ? 1 : 2);
    const double pu = drop == 0 ? p.y : p.x, pv = drop == 2 ? p.y : p.z;
    bool inside = false;
    for (int k = 0; k < f->n; k++) {
        const vec_t a = s.vertex[s.corner[f->first + k]], b = s.vertex[s.corner[f->first + (k + 1) % f->n]];
        const double au = drop == 0 ? a.y : a.x, av = drop == 2 ? a.y : a.z, bu = drop == 0 ? b.y : b.x,
                     bv = drop == 2 ? b.y : b.z;
        if ((av > pv) != (bv > pv) && pu < au + (pv - av) / (bv - av) * (bu - au)) inside = !inside;
    }
    return inside;
}

static bool is_in_plane(const face_t *f, vec_t p) {
    return fabs(dot(f->normal, sub(p, s.vertex[s.corner[f->first]]))) < 1e-6 * s.size;
}

/* Is p, a place of the edge e, behind the flat face f? d: to the eye. */
static bool is_behind(const face_t *f, vec_t p, vec_t d, int e) {
    const double slope = dot(f->normal, d);
    if (fabs(slope) < 1e-12 * sqrt(dot(d, d))) return false;
    const double t = dot(f->normal, sub(s.vertex[s.corner[f->first]], p)) / slope;
    if (t * sqrt(dot(d, d)) < 1e-7 * s.size || (s.view.eye.h && t >= 1) || !is_within(f, add(p, t, d))) return false;
    return !is_in_plane(f, s.vertex[s.edge[e][0]]) || !is_in_plane(f, s.vertex[s.edge[e][1]]);
}

/* Is p, a place of the edge e, hidden? 1, 0; -1: that depends on how faces are cut. */
static int is_hidden(vec_t p, int e) {
    const vec_t eye = {s.view.eye.x, s.view.eye.y, s.view.eye.z}, d = s.view.eye.h ? sub(eye, p) : eye;
    double at[2];
    int hidden = 0;
    if (!on_page(p, at)) return false;
    for (int k = s.faces.head[cell_of(1, at[1]) * CELLS + cell_of(0, at[0])]; k >= 0; k = s.faces.next[k]) {
        const face_t *f = &s.face[s.faces.item[k]];
        if (!f->bent) {
            if (is_behind(f, p, d, e)) return 1;
            continue;
        }
        const face_t *t = &s.part[f->bent - 1];
        const bool one = is_behind(&t[0], p, d, e) || is_behind(&t[1], p, d, e),
                   other = is_behind(&t[2], p, d, e) || is_behind(&t[3], p, d, e);
        if (one && other) return 1;
        if (one || other) hidden = -1;
    }
    return hidden;
}

/* 1: p is visible, 0: it is hidden, and so is all around it; -1: that differs. */
static int state(vec_t p, int e) {
    const vec_t eye = {s.view.eye.x, s.view.eye.y, s.view.eye.z}, d = unit(s.view.eye.h ? sub(eye, p) : eye);
    const vec_t along = sub(s.vertex[s.edge[e][1]], s.vertex[s.edge[e][0]]);
    const vec_t u = unit(cross(d, fabs(d.z) < .9 ? (vec_t){0, 0, 1} : (vec_t){1, 0, 0})), v = cross(d, u);
    double at[2], moved[2], end[2][2];
    const double small = 1e-5 * s.size;
    if (!on_page(p, at) || !on_page(add(p, small, u), moved)) return -1;
    const double r = STEP * small / hypot(moved[0] - at[0], moved[1] - at[1]);
    const int hidden = is_hidden(p, e);
    if (hidden < 0) return -1;
    for (int k = 0; k < 8; k++) {
        const double a = k * 0.78539816339744831;
        if (is_hidden(add(add(p, r * cos(a), u), r * sin(a), v), e) != hidden) return -1;
    }
    for (int k = 0; k < 2; k++) memcpy(end[k], s.page[s.edge[e][k]], sizeof end[k]);
    const double t = STEP / (hypot(end[1][0] - end[0][0], end[1][1] - end[0][1]) + 1e-12);
    if (is_hidden(add(p, t, along), e) != hidden || is_hidden(add(p, -t, along), e) != hidden) return -1;
    return !hidden;
}

static double off_line(const double a[2], const double b[2], const double p[2], double *t) {
    const double dx = b[0] - a[0], dy = b[1] - a[1], dd = dx * dx + dy * dy;
    *t = dd > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / dd : 0;
    const double c = fmin(fmax(*t, 0), 1);
    return hypot(p[0] - a[0] - c * dx, p[1] - a[1] - c * dy);
}

static bool is_drawn(const double at[2]) {
    for (int k = s.drawn.head[cell_of(1, at[1]) * CELLS + cell_of(0, at[0])]; k >= 0; k = s.drawn.next[k]) {
        const page_seg_t *g = &s.seg[s.drawn.item[k]];
        double t;
        if (off_line((double[]){g->x0, g->y0}, (double[]){g->x1, g->y1}, at, &t) < 0.75 * STEP) return true;
    }
    return false;
}

/* Could a line of the drawing be there? Ends count as long as a step more. */
static bool may_be_drawn(const double at[2]) {
    for (int k = s.edges.head[cell_of(1, at[1]) * CELLS + cell_of(0, at[0])]; k >= 0; k = s.edges.next[k]) {
        const int e = s.edges.item[k];
        const double *a = s.page[s.edge[e][0]], *b = s.page[s.edge[e][1]];
        double u;
        if (off_line(a, b, at, &u) > STEP) continue;
        u = fmin(fmax(u, 0), 1);
        const vec_t p = s.vertex[s.edge[e][0]], q = s.vertex[s.edge[e][1]];
        const double *m = s.view.m[2];
        const double e0 = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], e1 = m[0] * q.x + m[1] * q.y + m[2] * q.z + m[3];
        const double t = u * e0 / (u * e0 + (1 - u) * e1);
        if (state(add(p, t, sub(q, p)), e) != 0) return true;
    }
    return false;
}

int main(int argc, char **argv) {
    long places = 20000, missing = 0, falsely = 0, judged = 0, seen = 0;
    const char *drawing = argc > 1 ? argv[1] : "";
    s.rng = 88172645463325252u;
    memcpy(s.area, (double[]){-1e30, -1e30, 1e30, 1e30}, sizeof s.area);
    s.seg = judge_seg_read(drawing, &s.view, &s.segs);
    if (!s.seg) return complain("no drawing with a camera", drawing);
    for (int i = 2; i < argc; i++) {
        if (strcmp(argv[i], "-n") == 0 && i + 1 < argc) {
            places = atol(argv[++i]);
        } else if (strcmp(argv[i], "-s") == 0 && i + 1 < argc) {
            s.rng += (uint64_t)atol(argv[++i]) * 0x9e3779b97f4a7c15u;
        } else if (strcmp(argv[i], "-p") == 0 && i + 1 < argc) {
            double *a = s.area;
            if (sscanf(argv[++i], "%lf,%lf,%lf,%lf", &a[0], &a[1], &a[2], &a[3]) != 4)
                return complain("four numbers expected", argv[i]);
        } else if (read_obj(argv[i])) {
            return 2;
        }
    }
    if (s.ne == 0) return complain("no edges", NULL);
    if (prepare()) return 2;
    sort_into_bins();
    for (long k = 0; k < places; k++) {
        const int e = (int)(uniform() * s.ne);
        const vec_t a = s.vertex[s.edge[e][0]], p = add(a, uniform(), sub(s.vertex[s.edge[e][1]], a));
        double at[2];
        const bool asked = on_page(p, at) && at[0] > s.area[0] + STEP && at[0] < s.area[2] - STEP &&
                           at[1] > s.area[1] + STEP && at[1] < s.area[3] - STEP;
        const int is = asked ? state(p, e) : -1;
        judged += is >= 0;
        seen += is == 1;
        if (is != 1 || is_drawn(at)) continue;
        if (missing++ < SHOWN) printf("missing at %.4f %.4f, edge %d %d\n", at[0], at[1], s.edge[e][0], s.edge[e][1]);
    }
    for (long k = 0; k < places && s.segs > 0; k++) {
        const page_seg_t *g = &s.seg[(size_t)(uniform() * (double)s.segs)];
        const double t = uniform(), at[2] = {g->x0 + t * (g->x1 - g->x0), g->y0 + t * (g->y1 - g->y0)};
        if (may_be_drawn(at)) continue;
        if (falsely++ < SHOWN) printf("false at %.4f %.4f\n", at[0], at[1]);
    }
    printf("faces %d\nedges %d\nsegments %zu\nplaces %ld\njudged %ld\nvisible %ld\nmissing %ld\nfalse %ld\n", s.nf,
           s.ne, s.segs, places, judged, seen, missing, falsely);
    return missing || falsely;
}
