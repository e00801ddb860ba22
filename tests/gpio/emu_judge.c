/* emu_judge.c - is the recording of the emulated chip what the simulator's trace says?
 *
 *     emu_judge TRACE.vcd WORST_US MOVED_MS      the whole trace
 *     emu_judge TRACE.vcd prefix                 its beginning, and then nothing but switching off
 *     emu_judge rate                             prints the most steps in a tenth of a second, per axis and second
 *
 * The lines are those of tests/gpio/test_gpio.sh. Time: between two writes never passes less than planned but for
 * GRACE_US (the port's slack and a usual write), nor more than planned and WORST_US (its latest deadline and slowest
 * write), and the whole takes as much longer as MOVED_MS says. */
#include "hal/hal.h"
#include "host/trace.h"
#include "tests/gpio/emu.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#define GRACE_US 4.0
#define WINDOW_NS 100000000

typedef struct event {
    uint64_t ns;
    uint32_t pins;
} event_t;

static const struct {
    unsigned offset;
    uint32_t pin;
    bool active_low;
} LINE[] = {
    {17, HAL_X_STEP, false}, {27, HAL_X_DIR, false}, {22, HAL_Y_STEP, false},
    {23, HAL_Y_DIR, false},  {18, HAL_PEN, false},   {25, HAL_ENABLE, true},
};

static uint32_t pins_of(uint64_t levels) {
    uint32_t pins = 0;
    for (unsigned i = 0; i < sizeof LINE / sizeof LINE[0]; i++)
        if ((levels >> LINE[i].offset & 1) != LINE[i].active_low) pins |= LINE[i].pin;
    return pins;
}

/* What changed the pins after they were taken. */
static event_t *read_recording(size_t *count) {
    event_t *e = malloc((emu->records + 1) * sizeof *e);
    uint32_t before = 0;
    *count = 0;
    for (uint64_t i = 0; e && i < emu->records; i++) {
        const emu_record_t *r = &emu->record[i];
        if (r->kind != EMU_SET) continue;
        uint32_t pins = pins_of(r->levels);
        if (pins != before) e[(*count)++] = (event_t){r->time_ns, pins};
        before = pins;
    }
    return e;
}

static int compare(const trace_t *t, const event_t *e, size_t count, bool prefix, double worst_us, double moved_ms) {
    size_t same = 0;
    double least = 0, most = 0, sum = 0;
    while (same < count && same < t->count && e[same].pins == t->events[same].pins) same++;
    for (size_t i = 1; i < same; i++) {
        double planned = (double)(t->events[i].time_ps - t->events[i - 1].time_ps) * 1e-6;
        double excess = (double)(e[i].ns - e[i - 1].ns) * 1e-3 - planned;
        if (excess < least) least = excess;
        if (excess > most) most = excess;
        sum += excess;
    }
    if (!prefix)
        printf("# %zu writes as the simulator's; intervals %.1f us shorter to %.1f us longer than planned, %.3f ms in "
               "all\n",
               same, -least, most, sum * 1e-3);
    if (-least > GRACE_US) {
        printf("an interval is too short\n");
        return 1;
    }
    if (prefix) {
        /* At most a pulse is cut, then everything is off. */
        bool ends = count - same <= 3;
        for (size_t i = same; i + 1 < count; i++) ends = ends && !(e[i + 1].pins & ~e[i].pins);
        if (!ends) printf("the recording goes on after what is the same: %zu writes of %zu\n", same, count);
        return !ends;
    }
    if (same != count || same != t->count) {
        printf("recorded %zu writes, the trace has %zu, the first %zu are the same\n", count, t->count, same);
        return 1;
    }
    if (most > worst_us + GRACE_US || sum * 1e-3 > moved_ms * 1.01 + 0.01 + worst_us * 1e-3) {
        printf("later than was said: %.1f us, %.3f ms\n", worst_us, moved_ms);
        return 1;
    }
    return 0;
}

static void print_rate(const event_t *e, size_t count) {
    for (uint32_t pin = HAL_X_STEP; pin <= HAL_Y_STEP; pin <<= 2) {
        size_t best = 0, steps = 0, first = 0;
        for (size_t i = 1; i < count; i++) {
            steps += (e[i].pins & ~e[i - 1].pins & pin) != 0;
            while (e[i].ns - e[first].ns > WINDOW_NS) {
                first++;
                steps -= (e[first].pins & ~e[first - 1].pins & pin) != 0;
            }
            if (steps > best) best = steps;
        }
        printf("%zu\n", best * (1000000000u / WINDOW_NS));
    }
}

int main(int argc, char **argv) {
    trace_t trace;
    trace_error_t error;
    size_t count;
    if (argc < 2 || !getenv("GPIOEMU") || !emu_map(getenv("GPIOEMU"), false)) return 2;
    event_t *e = read_recording(&count);
    if (!e || emu->dropped) return 2;
    int status = 2;
    if (strcmp(argv[1], "rate") == 0) {
        print_rate(e, count);
        status = 0;
    } else {
        FILE *f = fopen(argv[1], "rb");
        if (!f || trace_read(f, &trace, &error) != 0) return 2;
        fclose(f);
        bool prefix = argc > 2 && strcmp(argv[2], "prefix") == 0;
        status = compare(&trace, e, count, prefix, prefix || argc < 4 ? 0 : atof(argv[2]),
                         prefix || argc < 4 ? 0 : atof(argv[3]));
        trace_free(&trace);
    }
    free(e);
    return status;
}
