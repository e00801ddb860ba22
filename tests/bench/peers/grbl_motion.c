/* grbl_motion.c - when a Grbl 1.1 would step: G-code on standard input, its pins as VCD on standard output. Written
 * from what is published about it (its wiki; the comments on its planner and stepper), for `make bench-grbl`:
 *
 *   - vertices are rounded to steps; 15 blocks of look-ahead; junction deviation; every axis has the acceleration by
 * itself (with the argument `vector` the pen has it, as ours);
 *   - every block is a trapezoid, cut into segments of 10 ms that end at a whole step and have one step rate each, in
 * whole cycles of 16 MHz;
 *   - a Bresenham line over the axes at that rate, sampled 2, 4 or 8 times as often below 8, 4 and 2 kHz (AMASS).
 *
 * The sender is always ahead, and an interrupt takes no time: both better than it is. M3, M5 and G4 wait until all has
 * been drawn. 80 steps/mm, 1000 mm/s^2, 0.01 mm, as our default machine. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HZ 16e6
#define STEPS_PER_MM 80.0
#define ACCEL 1000.0
#define RATE 100.0
#define DEVIATION 0.01
#define BLOCKS 15
#define SEGMENT_S 0.01
#define PULSE 160 /* cycles */
#define SETUP 16
enum { OVERSAMPLE_MAX = 3 };

typedef struct block {
    int32_t steps[2]; /* magnitudes */
    bool back[2];
    double mm, unit[2], accel, top; /* mm, mm/s^2, mm/s */
    double entry_most_2, entry_2;   /* squares of speeds */
} block_t;

static struct {
    block_t block[BLOCKS];
    int first, count;
    int32_t at[2]; /* steps, planned */
    double unit[2], top;
    bool moving;        /* unit is of the block before */
    uint64_t now, told; /* cycles */
    uint64_t falls[2];  /* when a pulse ends */
    bool dir[2];
    bool vector;
} g;

static void tell(uint64_t cycles, char pin, int level) {
    if (cycles != g.told) printf("#%llu\n", (unsigned long long)cycles * 62500);
    g.told = cycles;
    printf("%d%c\n", level, pin);
}

/* Pulses that end before then. */
static void end_pulses(uint64_t before) {
    for (;;) {
        int k = g.falls[0] && (!g.falls[1] || g.falls[0] <= g.falls[1]) ? 0 : 1;
        if (!g.falls[k] || g.falls[k] > before) return;
        tell(g.falls[k], k ? '#' : '!', 0);
        g.falls[k] = 0;
    }
}

/* What no axis exceeds its own limit with. */
static double along(const double unit[2], double limit) {
    double least = 1e9;
    if (g.vector) return limit;
    for (int k = 0; k < 2; k++)
        if (unit[k] != 0) least = fmin(least, limit / fabs(unit[k]));
    return least;
}

static block_t *block_at(int i) {
    return &g.block[(g.first + i) % BLOCKS];
}

/* The speeds at which blocks begin: back from a standstill at the last, then forth. */
static void plan(void) {
    double next_2 = 0;
    for (int i = g.count - 1; i > 0; i--) {
        block_t *b = block_at(i);
        b->entry_2 = fmin(b->entry_most_2, next_2 + 2 * b->accel * b->mm);
        next_2 = b->entry_2;
    }
    for (int i = 0; i + 1 < g.count; i++) {
        block_t *b = block_at(i), *next = block_at(i + 1);
        next->entry_2 = fmin(next->entry_2, b->entry_2 + 2 * b->accel * b->mm);
    }
}

static void step_block(const block_t *b, double exit_2);

static void run_first(void) {
    plan();
    const block_t b = *block_at(0);
    double exit_2 = g.count > 1 ? block_at(1)->entry_2 : 0;
    g.first = (g.first + 1) % BLOCKS;
    g.count--;
    step_block(&b, exit_2);
}

static void run_all(void) {
    while (g.count) run_first();
    g.moving = false;
}

static double junction_2(const double a[2], const double b[2]) {
    double cosine = -(a[0] * b[0] + a[1] * b[1]);
    if (cosine > 0.999999) return 0;
    if (cosine < -0.999999) return 1e18;
    double turn[2] = {b[0] - a[0], b[1] - a[1]}, length = hypot(turn[0], turn[1]);
    turn[0] /= length, turn[1] /= length;
    double half = sqrt(0.5 * (1 - cosine));
    return along(turn, ACCEL) * DEVIATION * half / (1 - half);
}

static void line_to(const double mm[2], double feed) {
    int32_t to[2], steps[2];
    for (int k = 0; k < 2; k++) {
        to[k] = (int32_t)lround(mm[k] * STEPS_PER_MM);
        steps[k] = to[k] - g.at[k];
        g.at[k] = to[k];
    }
    if (!steps[0] && !steps[1]) return;
    if (g.count == BLOCKS) run_first();
    block_t *b = block_at(g.count++);
    b->mm = hypot(steps[0], steps[1]) / STEPS_PER_MM;
    for (int k = 0; k < 2; k++) {
        b->steps[k] = abs(steps[k]);
        b->back[k] = steps[k] < 0;
        b->unit[k] = steps[k] / STEPS_PER_MM / b->mm;
    }
    b->accel = along(b->unit, ACCEL);
    b->top = fmin(feed, along(b->unit, RATE));
    b->entry_most_2 = b->entry_2 = 0;
    if (g.moving) b->entry_most_2 = fmin(junction_2(g.unit, b->unit), fmin(g.top * g.top, b->top * b->top));
    memcpy(g.unit, b->unit, sizeof g.unit);
    g.top = b->top;
    g.moving = true;
}

typedef struct ramp {
    double accel, top, exit, mm, faster_until, slower_after; /* mm left of the block */
} ramp_t;

static ramp_t ramp_of(const block_t *b, double exit_2) {
    double braking = (b->top * b->top - exit_2) / (2 * b->accel);
    double gaining = (b->top * b->top - b->entry_2) / (2 * b->accel);
    ramp_t r = {b->accel, b->top, sqrt(exit_2), b->mm, b->mm - gaining, braking};
    if (r.faster_until < r.slower_after) { /* no time at full speed */
        double meet =
            fmax(0, fmin(b->mm, (b->mm + (exit_2 - b->entry_2) / (2 * b->accel)) / 2)); /* from the beginning */
        r.faster_until = r.slower_after = b->mm - meet;
        r.top = sqrt(b->entry_2 + 2 * b->accel * meet);
    }
    return r;
}

/* Goes on for at most dt; how long it did. */
static double advance(const ramp_t *r, double *left, double *speed, double dt) {
    double mm, change = r->accel * dt;
    if (*left > r->faster_until + 1e-12) {
        mm = *left - dt * (*speed + 0.5 * change);
        if (mm > r->faster_until) {
            *left = mm, *speed += change;
            return dt;
        }
        dt = 2 * (*left - r->faster_until) / (*speed + r->top);
        *left = r->faster_until, *speed = r->top;
        return dt;
    }
    if (*left > r->slower_after + 1e-12) {
        mm = *left - r->top * dt;
        if (mm >= r->slower_after) {
            *left = mm;
            return dt;
        }
        dt = (*left - r->slower_after) / r->top;
        *left = r->slower_after;
        return dt;
    }
    if (*speed > change) {
        mm = *left - dt * (*speed - 0.5 * change);
        if (mm > 0) {
            *left = mm, *speed -= change;
            return dt;
        }
    }
    dt = *speed + r->exit > 0 ? 2 * *left / (*speed + r->exit) : 0;
    *left = 0, *speed = r->exit;
    return dt;
}

/* So many steps of the longer axis, at one rate. */
static void step_segment(const block_t *b, int32_t events, int32_t counter[2], uint32_t cycles, int32_t count) {
    int level = cycles < HZ / 8000 ? 0 : cycles < HZ / 4000 ? 1 : cycles < HZ / 2000 ? 2 : OVERSAMPLE_MAX;
    cycles >>= level;
    count <<= level;
    if (cycles > 0xffff) cycles = 0xffff;
    for (int32_t i = 0; i < count; i++) {
        g.now += cycles;
        for (int k = 0; k < 2; k++) {
            counter[k] += (b->steps[k] << OVERSAMPLE_MAX) >> level;
            if (counter[k] <= events) continue;
            counter[k] -= events;
            end_pulses(g.now);
            tell(g.now, k ? '#' : '!', 1);
            g.falls[k] = g.now + PULSE;
        }
    }
}

static void step_block(const block_t *b, double exit_2) {
    const int32_t longer = b->steps[0] > b->steps[1] ? b->steps[0] : b->steps[1];
    const int32_t events = longer << OVERSAMPLE_MAX;
    const double steps_per_mm = longer / b->mm, least = 1.25 / steps_per_mm;
    const ramp_t r = ramp_of(b, exit_2);
    double left = b->mm, speed = sqrt(b->entry_2), carried_s = 0;
    int32_t counter[2] = {events >> 1, events >> 1}, to_go = longer;
    end_pulses(g.now + PULSE);
    for (int k = 0; k < 2; k++)
        if (b->back[k] != g.dir[k] && b->steps[k]) tell(g.now + PULSE, k ? '$' : '"', !(g.dir[k] = b->back[k]));
    while (to_go > 0) {
        double most = SEGMENT_S, dt = 0, enough = fmax(0, left - least);
        do { /* 10 ms, or longer where that is not a step */
            dt += advance(&r, &left, &speed, most - dt);
            if (dt >= most - 1e-12 && left > enough) most += SEGMENT_S;
        } while (left > 0 && dt < most - 1e-12);
        double part = left * steps_per_mm;
        int32_t still = (int32_t)ceil(part - 1e-9);
        if (left <= 0) part = still = 0;
        dt += carried_s;
        double s_per_step = dt / (to_go - part);
        step_segment(b, events, counter, (uint32_t)ceil(HZ * s_per_step), to_go - still);
        carried_s = (still - part) * s_per_step;
        to_go = still;
    }
}

int main(int argc, char **argv) {
    static const char *const NAME[] = {"x_step", "x_dir", "y_step", "y_dir", "pen", "enable"};
    char line[256];
    double mm[2] = {0, 0}, feed = RATE;
    bool travels = true;
    g.vector = argc > 1 && strcmp(argv[1], "vector") == 0;
    printf("$timescale 1 ps $end\n$scope module plotter $end\n");
    for (int i = 0; i < 6; i++) printf("$var wire 1 %c %s $end\n", '!' + i, NAME[i]);
    printf("$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n0!\n1\"\n0#\n1$\n0%%\n0&\n$end\n");
    g.now = 1000;
    tell(g.now, '&', 1);
    while (fgets(line, sizeof line, stdin)) {
        const char *x = strchr(line, 'X'), *y = strchr(line, 'Y'), *f = strchr(line, 'F'), *p = strchr(line, 'P');
        if (line[0] == ';') continue;
        if (f) feed = atof(f + 1) / 60;
        if (line[0] == 'M' || strncmp(line, "G4", 2) == 0) {
            run_all();
            end_pulses(g.now + PULSE);
            g.now += PULSE + SETUP;
            if (line[0] == 'M' && (line[1] == '3' || line[1] == '5')) tell(g.now, '%', line[1] == '3');
            if (p) g.now += (uint64_t)(atof(p + 1) * HZ);
        } else if (x || y) {
            if (line[0] == 'G') travels = line[1] == '0';
            if (x) mm[0] = atof(x + 1);
            if (y) mm[1] = atof(y + 1);
            line_to(mm, travels ? RATE : feed);
        }
    }
    run_all();
    end_pulses(g.now + PULSE);
    tell(g.now + 2 * PULSE, '&', 0);
    return 0;
}
