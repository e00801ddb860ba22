/* vcd.c - see vcd.h. Cost is the decimal time of each tick. */
#include "sim/vcd.h"
#include "error.h"
#include "hal/hal.h"
#include <stdio.h>
#include <string.h>

static const struct {
    uint32_t pin;
    const char *name;
} SIGNAL[] = {
    {HAL_X_STEP, "x_step"}, {HAL_X_DIR, "x_dir"}, {HAL_Y_STEP, "y_step"},
    {HAL_Y_DIR, "y_dir"},   {HAL_PEN, "pen"},     {HAL_ENABLE, "enable"},
};
#define SIGNALS (sizeof SIGNAL / sizeof SIGNAL[0])
#define EIGHT 100000000u /* what eight digits count */
#define FIRST_ID 'a'     /* identifier of signal i is 'a' + i, and pin i is bit i */

_Static_assert(HAL_X_STEP == 1 && HAL_ENABLE == 1 << (SIGNALS - 1), "pin i is bit i");
_Static_assert(HAL_TICK_HZ == 16000000, "a tick is 125/2 ns");

static void flush(vcd_t *v) {
    if (!v->error && v->used) v->error = v->write(v->ctx, v->buffer, v->used);
    v->used = 0;
}

/* One record is at most '#', 20 digits, newline and 6 values of 3 characters: below the 128 spare bytes. */
static inline void make_room(vcd_t *v) {
    if (v->used > VCD_BUFFER) flush(v);
}

/* Eight decimal digits as text, all at once in the lanes of a 64-bit word: first 2 of 4 digits, then 4 of 2, then 8
 * of 1. 10486 / 2^20 is 1/100 for numbers below 10,000 and 103 / 2^10 is 1/10 for those below 100. */
static inline void put_eight(char *out, uint32_t n) {
    uint64_t x = n / 10000 | (uint64_t)(n % 10000) << 32;
    uint64_t high = (x * 10486 >> 20) & 0x0000007f0000007f;
    x = high | (x - 100 * high) << 16;
    high = (x * 103 >> 10) & 0x000f000f000f000f;
    x = (high | (x - 10 * high) << 8) + 0x3030303030303030;
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    x = __builtin_bswap64(x);
#endif
    memcpy(out, &x, 8);
}

/* The digits above the last eight change ten times a second of plotting: they are kept as text. */
static void put_time(vcd_t *v, uint64_t tick) {
    uint64_t ns = tick / 2 * 125 + (tick & 1) * 62, low = ns - v->high_ns;
    char *out = v->buffer + v->used;
    *out++ = '#';
    if (low >= EIGHT) {
        v->high_ns = ns / EIGHT * EIGHT;
        v->high_length = (unsigned)sprintf(v->high_text, "%llu", (unsigned long long)(ns / EIGHT));
        low = ns - v->high_ns;
    }
    if (v->high_ns == 0) {
        out += sprintf(out, "%u\n", (unsigned)low);
    } else {
        memcpy(out, v->high_text, sizeof v->high_text); /* all of it: a fixed size is one instruction */
        out += v->high_length;
        put_eight(out, (uint32_t)low);
        out[8] = '\n';
        out += 9;
    }
    v->used = (size_t)(out - v->buffer);
}

static void put_values(vcd_t *v, uint32_t pins, uint32_t which) {
    char *out = v->buffer + v->used;
    while (which) {
        int i = __builtin_ctz(which);
        which &= which - 1;
        *out++ = (char)('0' + (pins >> i & 1));
        *out++ = (char)(FIRST_ID + i);
        *out++ = '\n';
    }
    v->used = (size_t)(out - v->buffer);
}

static void put_machine(vcd_t *v, const machine_t *m) {
    v->used += (size_t)snprintf(
        v->buffer + v->used, 1024,
        "$comment ridgeline machine steps_per_mm_q16 %u %u kinematics %s swap %d invert %d %d draw_um_s %u travel_um_s "
        "%u "
        "accel_um_s2 %u junction_um %u lift_us %u lower_us %u dir_setup_ns %u pulse_ns %u $end\n",
        m->steps_per_mm_q16[0], m->steps_per_mm_q16[1], m->kinematics == MACHINE_COREXY ? "corexy" : "cartesian",
        m->swap_xy, m->invert[0], m->invert[1], m->draw_speed_um_s, m->travel_speed_um_s, m->accel_um_s2,
        m->junction_um, m->lift_us, m->lower_us, m->dir_setup_ns, m->pulse_ns);
}

void vcd_begin(vcd_t *v, vcd_write_t write, void *ctx, const machine_t *machine, const char *title, uint32_t pins) {
    v->write = write;
    v->ctx = ctx;
    v->error = 0;
    v->used = 0;
    v->last_tick = 0;
    v->high_ns = 0;
    v->used += (size_t)snprintf(v->buffer, 256, "$version ridgeline $end\n");
    if (title && !strchr(title, '$'))
        v->used += (size_t)snprintf(v->buffer + v->used, 512, "$comment %.400s $end\n", title);
    if (machine) put_machine(v, machine);
    v->used += (size_t)snprintf(v->buffer + v->used, 256, "$timescale 1 ns $end\n$scope module plotter $end\n");
    for (size_t i = 0; i < SIGNALS; i++)
        v->used += (size_t)snprintf(v->buffer + v->used, 64, "$var wire 1 %c %s $end\n", (char)(FIRST_ID + (int)i),
                                    SIGNAL[i].name);
    v->used += (size_t)snprintf(v->buffer + v->used, 256, "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n");
    put_values(v, pins, (1u << SIGNALS) - 1);
    v->used += (size_t)snprintf(v->buffer + v->used, 16, "$end\n");
}

void vcd_record(void *vcd, uint64_t tick, uint32_t pins, uint32_t changed) {
    vcd_t *v = vcd;
    if (tick != v->last_tick) put_time(v, tick);
    v->last_tick = tick;
    put_values(v, pins, changed);
    make_room(v);
}

int vcd_end(vcd_t *v, uint64_t tick) {
    if (tick != v->last_tick) put_time(v, tick);
    flush(v);
    return v->error;
}

int vcd_write_file(void *file, const char *text, size_t bytes) {
    return fwrite(text, 1, bytes, file) == bytes ? 0 : ERR_FILE;
}
