/* vcd.c - see vcd.h. Cost is the decimal time of each tick: two digits per table look-up, and only for a new tick. */
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
#define FIRST_ID 'a' /* identifier of signal i is 'a' + i, and pin i is bit i */

_Static_assert(HAL_X_STEP == 1 && HAL_ENABLE == 1 << (SIGNALS - 1), "pin i is bit i");
_Static_assert(HAL_TICK_HZ == 16000000, "a tick is 125/2 ns");

static const char DIGITS[201] = "00010203040506070809101112131415161718192021222324252627282930313233343536373839"
                                "40414243444546474849505152535455565758596061626364656667686970717273747576777879"
                                "8081828384858687888990919293949596979899";

static void flush(vcd_t *v) {
    if (!v->error && v->used) v->error = v->write(v->ctx, v->buffer, v->used);
    v->used = 0;
}

/* One record is at most '#', 20 digits, newline and 6 values of 3 characters: below the 128 spare bytes. */
static inline void make_room(vcd_t *v) {
    if (v->used > VCD_BUFFER) flush(v);
}

static void put_time(vcd_t *v, uint64_t tick) {
    char text[24];
    int at = sizeof text;
    uint64_t ns = tick / 2 * 125 + (tick & 1) * 62;
    text[--at] = '\n';
    while (ns >= 100) {
        memcpy(text + (at -= 2), DIGITS + ns % 100 * 2, 2);
        ns /= 100;
    }
    if (ns >= 10)
        memcpy(text + (at -= 2), DIGITS + ns * 2, 2);
    else
        text[--at] = (char)('0' + ns);
    text[--at] = '#';
    memcpy(v->buffer + v->used, text + at, sizeof text - (size_t)at);
    v->used += sizeof text - (size_t)at;
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
