/* needs.c - is it true what a board says a scene would need? Its console, with the board's capacities, on the
 * simulator: the least memory that each scene is not refused with is looked for, and what is said with less is held
 * against that.
 *
 *     needs-BOARD          prints a line a scene, and fails if what is said is off by more than OFF_MOST percent
 *
 * A limit switch is closed, so a scene that fits is refused for that, and nothing is drawn. */
#undef MOTION_BYTES_HOST
#include "motion/motion.h"
#undef MOTION_BYTES_HOST
#define MOTION_BYTES_HOST MOTION_BYTES(CONFIG_MOTION_BLOCKS, CONFIG_MOTION_PIECES)
#include <stdarg.h>

#include "tests/unit/console_fixture.h"

#define OFF_MOST 30 /* what coincides, and crossings where not even the lines fit, is a guess */
#define OFF_MOSTLY 10
#define STEP 16 /* bytes, to which the least memory is found */

static char scene[1 << 18];
static size_t length;

__attribute__((format(printf, 1, 2))) static void add(const char *format, ...) {
    va_list list;
    va_start(list, format);
    length += (size_t)vsnprintf(scene + length, sizeof scene - length, format, list);
    va_end(list);
}

/* What the board says to the scene with so much memory for the picture: 0 if it fits, else the bytes that it would
 * need; -1 if it is refused for another reason, as that the rows do not fit. */
static long said(size_t memory, size_t *free_bytes) {
    fix_power_on(MOTION_BYTES_HOST + memory / 8 * 8);
    sim_inputs_set(0, HAL_IN_LIMIT_X, HAL_IN_LIMIT_X);
    fix_run(10 * MS);
    for (const char *from = scene; *from;) { /* as fast as it is taken */
        char line[1024];
        const size_t n = strcspn(from, "\r") + 1;
        memcpy(line, from, n);
        line[n] = '\0';
        fix_say(line, 5 * MS);
        from += n;
    }
    fix_run(100 * MS);
    if (fix_heard("emergency stop is closed")) return 0;
    const char *needs = strstr(fix.said, "may need ");
    if (!needs) needs = strstr(fix.said, "needs ");
    if (!needs || !strstr(fix.said, "Nothing was drawn")) return -1;
    *free_bytes = fix.console.picture_bytes;
    return strtol(strpbrk(needs, "0123456789"), NULL, 10);
}

static int wrong, near, told;
static double worst;

/* The scene at hand is refused by the board? Then what it says is held against what is true. True if it is refused. */
static bool hold(const char *name) {
    const size_t own = CONFIG_BOARD_BYTES - MOTION_BYTES_HOST;
    size_t free_bytes, unused;
    const long needs = said(own, &free_bytes);
    if (needs <= 0) return needs < 0;
    size_t lo = own, hi = own;
    do {
        if (hi > sizeof fix.memory - MOTION_BYTES_HOST) {
            printf("%-34s %7zu: %7ld\n", name, free_bytes, needs);
            return true;
        }
        lo = hi;
        hi += hi / 2;
    } while (said(hi, &unused));
    while (hi - lo > STEP) {
        const size_t mid = (lo + hi) / 2;
        if (said(mid, &unused) == 0)
            hi = mid;
        else
            lo = mid;
    }
    said(hi, &unused);
    const size_t least = fix.console.picture_bytes;
    const double off = 100.0 * (double)needs / (double)least - 100;
    printf("%-34s %7zu: %7ld of %7zu %+5.0f%s\n", name, free_bytes, needs, least, off,
           fabs(off) > OFF_MOSTLY ? "!" : "");
    fflush(stdout);
    wrong += fabs(off) > OFF_MOST;
    near += fabs(off) <= OFF_MOSTLY;
    if (fabs(off) > fabs(worst)) worst = off;
    told++;
    return true;
}

static void begin(const char *setup) {
    length = 0;
    add("set machine limits on; set paper 60,60 margin 5\r%s\r", setup);
}

static bool grid(const char *setup, const char *f, int n) {
    char name[80];
    begin(setup);
    add("set isosamples %d\rsplot %s\r", n, f);
    snprintf(name, sizeof name, "%.20s %.14s %d", setup, f, n);
    return hold(name);
}

static void cube(double x, double y, double z) {
    for (int k = 0; k < 8; k++) add("v %g %g %g\r", x + (k & 1), y + (k >> 1 & 1), z + (k >> 2));
    add("f -8 -6 -5 -7\rf -4 -3 -1 -2\rf -8 -7 -3 -4\rf -6 -2 -1 -5\rf -8 -4 -2 -6\rf -7 -5 -1 -3\r");
}

static bool cubes(const char *setup, int n) {
    char name[80];
    begin(setup);
    add("splot '-' solid\r");
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) cube(i * 1.5, j * 1.5, 0);
    add("e\r");
    snprintf(name, sizeof name, "%.20s %dx%d cubes", setup, n, n);
    return hold(name);
}

static bool torus(const char *setup, int u, int v) {
    char name[80];
    begin(setup);
    add("splot '-' solid\r");
    for (int i = 0; i < u; i++)
        for (int j = 0; j < v; j++) {
            const double a = 6.2831853 * i / u, b = 6.2831853 * j / v, r = 3 + cos(b);
            add("v %.3f %.3f %.3f\r", r * cos(a), r * sin(a), sin(b));
        }
    for (int i = 0; i < u; i++)
        for (int j = 0; j < v; j++) {
            const int k = (i + 1) % u, l = (j + 1) % v;
            add("f %d %d %d\rf %d %d %d\r", i * v + j + 1, k * v + j + 1, k * v + l + 1, i * v + j + 1, k * v + l + 1,
                i * v + l + 1);
        }
    add("e\r");
    snprintf(name, sizeof name, "%.20s torus %dx%d", setup, u, v);
    return hold(name);
}

static bool lattice(const char *setup, int n) {
    char name[80];
    begin(setup);
    add("splot '-' solid\rv 0 0 0\rv 1 0 0\r");
    for (int k = 1; k <= n; k++) add("v 0 %g %d\rv 1 0 %d\rl -4 -2\rl -3 -1\rl -2 -1\rl -4 -1\r", k % 2 / 4.0, k, k);
    add("e\r");
    snprintf(name, sizeof name, "%.20s lattice %d", setup, n);
    return hold(name);
}

/* Sizes from n on, as long as the rows have room, up to four that do not fit. */
#define SIZES(n, call)                                                                                                 \
    for (int n = 2, refused = 0; n < 400 && refused < 4; n += 1 + n / (refused ? 4 : 16)) refused += call

/* needs-BOARD BOARD: its name, for what is printed. */
int main(int argc, char **argv) {
    const char *board = argc > 1 ? argv[1] : "?";
    SIZES(n, grid("set view 60,30", "rand(0)", n));
    SIZES(n, grid("set view 60,30", "exp(-x**2-y**2)", n));
    SIZES(n, grid("set view from 6,8,3", "sin(x)*sin(y)", n));
    SIZES(n, grid("set view 60,30", "sqrt(x+y)*sin(x)", n));
    SIZES(n, grid("set view 60,30", "sqrt(rand(0)-.1)", n));
    SIZES(n, grid("set hidden3d halo", "sin(x)*y", n));
    SIZES(n, grid("set hidden3d halo", "rand(0)", n));
    SIZES(n, grid("set hidden3d horizon; set samples 100", "sin(x)*y", n));
    SIZES(n, grid("set hidden3d horizon; set samples 200", "rand(0)", n));
    static const char *const MODE[] = {"set hidden3d", "set hidden3d dashed", "unset hidden3d", "set hidden3d halo"};
    for (int k = 0; k < 4; k++) {
        SIZES(n, cubes(MODE[k], n));
        SIZES(n, torus(MODE[k], 5, n));
        SIZES(n, torus(MODE[k], n, 4));
        SIZES(n, lattice(MODE[k], n));
    }
    static const char *const AREA[] = {"set hidden3d area",
                                       "set hidden3d area; set hatch 45,1; set shadow on; set light 1,-2,3"};
    for (int k = 0; k < 2 * CONFIG_AREA; k++) {
        SIZES(n, cubes(AREA[k], n));
        SIZES(n, torus(AREA[k], 5, n));
    }
    printf("# %s: what %d scenes need that do not fit is told within %d %% for %d of them, the worst %+.0f %%\n", board,
           told, OFF_MOSTLY, near, worst);
    if (!wrong && told > 50)
        printf("[       OK ] %s tells what a scene would need\n", board);
    else
        printf("[  FAILED  ] %s: %d told wrong\n", board, wrong);
    return wrong || told <= 50;
}
