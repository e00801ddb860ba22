/* port.c - see port.h. */
#define _GNU_SOURCE /* prctl */
#include "hal/linux/port.h"

#include <errno.h>
#include <poll.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

#define INPUTS (PINS_COUNT - PINS_OUTPUTS)
#define PRIORITY 50
#define REST_WINDOW_NS 100000000
#define STEPS (HAL_X_STEP | HAL_Y_STEP)
#define PIN_WORDS 64

_Static_assert(HAL_ENABLE << 1 == PIN_WORDS, "a pin word indexes the table of levels");
_Static_assert(HAL_TICK_HZ == 16000000, "a tick is 125/2 ns");

typedef struct input {
    lines_in_t *line;
    bool active_low;
    uint32_t bit; /* enum hal_input */
} input_t;

static struct {
    lines_out_t *out;
    uint8_t levels[PIN_WORDS]; /* of the request's lines, for each pin word */
    input_t input[INPUTS];
    struct pollfd poll[INPUTS];
    nfds_t inputs;
    port_counts_t *counts;
    int64_t base_ns;  /* CLOCK_MONOTONIC at tick 0 */
    int64_t deadline; /* in ticks that do not wrap */
    bool armed, serving;
    enum port_trouble trouble;
    int error;
    uint32_t hits, expected;
    bool throttled; /* the kernel limits real-time processes */
    int64_t window_ns, slept_ns;
} s;

static int64_t now_ns(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

static int64_t ticks_at(int64_t ns) {
    return (ns - s.base_ns) * 2 / 125;
}

/* When the armed deadline is. */
static int64_t due_ns(void) {
    return s.base_ns + s.deadline * 125 / 2;
}

static void trouble(enum port_trouble what, int error) {
    if (s.trouble) return;
    s.trouble = what;
    s.error = error;
}

/* ---- taking the lines ---- */

static void make_levels(const pins_t *pins) {
    static const struct {
        enum pins_name name;
        uint32_t pin;
    } MAP[PINS_OUTPUTS] = {
        {PINS_ENABLE, HAL_ENABLE}, {PINS_PEN, HAL_PEN},       {PINS_X_DIR, HAL_X_DIR},
        {PINS_Y_DIR, HAL_Y_DIR},   {PINS_X_STEP, HAL_X_STEP}, {PINS_Y_STEP, HAL_Y_STEP},
    };
    for (uint32_t word = 0; word < PIN_WORDS; word++) {
        unsigned levels = 0;
        for (int i = 0; i < PINS_OUTPUTS; i++) {
            bool active = (word & MAP[i].pin) != 0;
            if (active != pins->pin[MAP[i].name].active_low) levels |= 1u << MAP[i].name;
        }
        s.levels[word] = (uint8_t)levels;
    }
}

static int taking_failed(const pins_t *pins, enum pins_name name, FILE *complaints) {
    int err = errno ? errno : EIO;
    const pins_pin_t *pin = &pins->pin[name];
    if (name >= PINS_OUTPUTS)
        fprintf(complaints, "ridgeline: taking %s (line %u of %s): %s\n", pins_name(name), pin->offset,
                lines_chip_name(pins->chip[pin->chip]), strerror(err));
    else
        fprintf(complaints, "ridgeline: taking the output lines of %s: %s\n", lines_chip_name(pins->chip[pin->chip]),
                strerror(err));
    return -err;
}

int port_open(const pins_t *pins, FILE *complaints) {
    static const uint32_t BIT[INPUTS] = {HAL_IN_LIMIT_X, HAL_IN_LIMIT_Y, HAL_IN_ESTOP};
    unsigned offset[PINS_OUTPUTS];
    memset(&s, 0, sizeof s);
    s.counts = mmap(NULL, sizeof *s.counts, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (s.counts == MAP_FAILED) return -errno;
    make_levels(pins);
    for (int i = 0; i < PINS_OUTPUTS; i++) offset[i] = pins->pin[i].offset;
    s.out = lines_out_request(pins->chip[pins->pin[0].chip], offset, PINS_OUTPUTS, s.levels[0]);
    if (!s.out) return taking_failed(pins, PINS_ENABLE, complaints);
    for (int i = 0; i < INPUTS; i++) {
        const pins_pin_t *pin = &pins->pin[PINS_OUTPUTS + i];
        if (!pin->given) continue;
        lines_in_t *line = lines_in_request(pins->chip[pin->chip], pin->offset, pin->pull);
        if (!line) return taking_failed(pins, (enum pins_name)(PINS_OUTPUTS + i), complaints);
        s.input[s.inputs] = (input_t){line, pin->active_low, BIT[i]};
        s.poll[s.inputs] = (struct pollfd){.fd = lines_in_fd(line), .events = POLLIN};
        s.inputs++;
    }
    return 0;
}

void port_close(void) {
    for (nfds_t i = 0; i < s.inputs; i++) lines_in_release(s.input[i].line);
    lines_out_release(s.out);
    s.inputs = 0;
    s.out = NULL;
}

int port_safe(void) {
    if (!s.out) return 0;
    lines_out_write(s.out, s.levels[s.counts->pins & HAL_ENABLE]);
    int err = lines_out_write(s.out, s.levels[0]);
    if (!err) s.counts->pins = 0;
    return err;
}

static bool is_throttled(void) {
    FILE *f = fopen("/proc/sys/kernel/sched_rt_runtime_us", "r");
    long runtime_us = 0;
    if (!f) return true;
    bool read = fscanf(f, "%ld", &runtime_us) == 1;
    fclose(f);
    return !read || runtime_us >= 0;
}

void port_start(FILE *warnings) {
    struct sched_param priority = {.sched_priority = PRIORITY};
    prctl(PR_SET_TIMERSLACK, 1UL);
    if (sched_setscheduler(0, SCHED_FIFO, &priority) == 0)
        s.throttled = is_throttled();
    else
        fprintf(warnings, "ridgeline: no real-time scheduling (%s): under load steps will come late\n",
                strerror(errno));
    if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
        fprintf(warnings, "ridgeline: memory is not locked (%s): steps can come late when memory is short\n",
                strerror(errno));
    s.base_ns = s.window_ns = now_ns();
}

/* ---- hal.h: pins and inputs ---- */

static void move_base(int64_t by_ns) {
    s.base_ns += by_ns;
    s.counts->shifted_ns += by_ns;
}

static void count_steps(uint32_t pins, uint32_t rising) {
    if (rising & HAL_X_STEP) s.counts->steps[0] += pins & HAL_X_DIR ? 1 : -1;
    if (rising & HAL_Y_STEP) s.counts->steps[1] += pins & HAL_Y_DIR ? 1 : -1;
}

void hal_pins_write(uint32_t mask, uint32_t value) {
    uint32_t was = s.counts->pins, pins = (was & ~mask) | (value & mask);
    if (pins == was) return;
    /* Counted from the deadline: the process may have been stopped between that and the write too. */
    int64_t begin = s.serving ? due_ns() : now_ns();
    int err = lines_out_write(s.out, s.levels[pins]);
    int64_t took = now_ns() - begin;
    if (err) {
        trouble(PORT_WRITE, -err);
        return;
    }
    s.counts->pins = pins;
    s.counts->writes++;
    if (took > s.counts->worst_write_ns) s.counts->worst_write_ns = took;
    if (took > PORT_WRITE_NS) move_base(took);
    count_steps(pins, pins & ~was & STEPS);
}

/* Edges that came since the last call. A switch that bounced and is open again stops too. */
static void look_at_switches(void) {
    if (!s.inputs || poll(s.poll, s.inputs, 0) <= 0) return;
    for (nfds_t i = 0; i < s.inputs; i++) {
        if (!s.poll[i].revents) continue;
        const input_t *in = &s.input[i];
        int rising = s.poll[i].revents & POLLIN ? lines_in_edge(in->line) : -ENODEV;
        if (rising < 0) {
            trouble(PORT_READ, -rising);
        } else if ((rising == 1) != in->active_low) {
            s.hits |= in->bit;
            if (!(s.expected & in->bit)) trouble(PORT_SWITCH, 0);
        }
    }
}

uint32_t hal_inputs(void) {
    uint32_t active = 0;
    for (nfds_t i = 0; i < s.inputs; i++) {
        int level = lines_in_level(s.input[i].line);
        if (level < 0)
            trouble(PORT_READ, -level);
        else if ((level == 1) != s.input[i].active_low)
            active |= s.input[i].bit;
    }
    return active;
}

uint32_t port_hits(void) {
    uint32_t hits = s.hits;
    s.hits = 0;
    return hits;
}

void port_expect(uint32_t expected) {
    s.expected = expected;
}
enum port_trouble port_trouble(void) {
    return s.trouble;
}
int port_error(void) {
    return s.error;
}
const port_counts_t *port_counts(void) {
    return s.counts;
}

/* Every edge is one write that may come late: none is made ahead. */
hal_edges_t hal_edges(void) {
    return (hal_edges_t){0};
}
void hal_edges_put(uint32_t edges, uint32_t first_at, uint32_t last_at) {
    (void)edges, (void)first_at, (void)last_at;
}

bool hal_edges_left(void) {
    return true;
}

/* ---- hal.h: time ---- */

/* The interrupt's body runs at its deadline, by this clock: what it does then is what it does on the simulator. */
uint32_t hal_now(void) {
    if (s.serving) return (uint32_t)s.deadline;
    return (uint32_t)ticks_at(now_ns());
}

void hal_timer_arm(uint32_t at) {
    int64_t now = ticks_at(now_ns());
    if (s.serving) now = s.deadline;
    s.deadline = now + (int32_t)(at - (uint32_t)now);
    s.armed = true;
}

void hal_timer_cancel(void) {
    s.armed = false;
}

/* False when a signal came first. */
static bool sleep_until(int64_t ns) {
    struct timespec t = {.tv_sec = ns / 1000000000, .tv_nsec = ns % 1000000000};
    int64_t begin = now_ns();
    int err = clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, NULL);
    s.slept_ns += now_ns() - begin;
    return err == 0;
}

static void rest_if_due(int64_t now) {
    int64_t elapsed = now - s.window_ns;
    if (elapsed > REST_WINDOW_NS) {
        s.window_ns = now;
        s.slept_ns = 0;
    } else if (s.slept_ns * 100 < elapsed * PORT_REST_PERCENT - PORT_REST_NS * 100) {
        s.counts->rests++;
        sleep_until(now + PORT_REST_NS);
    }
}

/* Until shortly before the deadline asleep, with a look at the switches now and then; the rest spinning. False when
 * something else must be seen to first. */
static bool wait_until(int64_t due) {
    for (int64_t now = now_ns(); due - now > PORT_TAIL_NS; now = now_ns()) {
        int64_t wake = due - PORT_TAIL_NS;
        if (!sleep_until(wake - now > PORT_SLICE_NS ? now + PORT_SLICE_NS : wake)) return false;
        look_at_switches();
        if (s.trouble || s.hits) return false;
    }
    if (s.throttled && !(s.counts->pins & STEPS)) rest_if_due(now_ns());
    look_at_switches();
    if (s.trouble || s.hits) return false;
    while (now_ns() < due) continue;
    return true;
}

static void count_late(int64_t late_ns) {
    s.counts->served++;
    if (late_ns > s.counts->worst_ns) s.counts->worst_ns = late_ns;
    if (late_ns > PORT_LATE_NS) s.counts->late++;
    if (late_ns > PORT_SLACK_NS) move_base(late_ns);
}

void hal_idle(void) {
    if (s.trouble) return;
    if (!s.armed) {
        sleep_until(now_ns() + PORT_SLICE_NS);
        look_at_switches();
        return;
    }
    if (!wait_until(due_ns())) return;
    count_late(now_ns() - due_ns());
    s.armed = false;
    s.serving = true;
    stepgen_isr();
    s.serving = false;
}

void hal_fault(const char *what, int32_t a, int32_t b) {
    port_safe();
    fprintf(stderr, "ridgeline: fault: %s %d %d\n", what, (int)a, (int)b);
    _exit(1);
}
