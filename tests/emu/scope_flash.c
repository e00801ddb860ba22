/* scope_flash.c - see scope_flash.h. */
#include "scope_flash.h"

#include <stdio.h>
#include <string.h>

#include "qemu_inside.h"

#define CONTROLLER 0x400fd000u
#define USECRL 0x400fe140u
#define MHZ 50
#define PAGE 1024u
#define ERASE_NS 20000000
#define WRITE_NS 20000
enum { FMA = 0, FMD = 4, FMC = 8 };
enum { WRITE = 1, ERASE = 2 };

static struct {
    memory_region_t controller, clock;
    _Alignas(16) unsigned char timer[256]; /* a QEMUTimer, which is smaller */
    unsigned first, end;                   /* what may be written */
    uint32_t fma, fmd, usecrl;
    uint32_t command, at, word; /* what is being carried out */
} f;

static void wrong(const char *what) {
    fprintf(stderr, "flash: %s, FMA %08x\n", what, f.fma);
}

static void begin(uint32_t value) {
    uint32_t command = value & 0xffff, bytes = command == ERASE ? PAGE : 4;
    if (value >> 16 != 0xa442) {
        wrong("a command without the key");
    } else if (f.command) {
        wrong("a command before the last one is done");
    } else if (command != WRITE && command != ERASE) {
        wrong("an unknown command");
    } else if (f.usecrl != MHZ - 1) {
        wrong("timed for another clock");
    } else if (f.fma % bytes || f.fma < f.first || f.fma + bytes > f.end) {
        wrong("not a word or page of what is kept");
    } else {
        f.command = command;
        f.at = f.fma;
        f.word = f.fmd;
        timer_mod(f.timer, qemu_clock_get_ns(CLOCK_VIRTUAL) + (command == ERASE ? ERASE_NS : WRITE_NS));
    }
}

/* Does so much of it. */
static void carry_out(unsigned bytes) {
    uint8_t now[PAGE];
    if (f.command == ERASE) memset(now, 0xff, bytes);
    if (f.command == WRITE) {
        qemu_memory(f.at, now, bytes, false);
        for (unsigned i = 0; i < bytes; i++) {
            if (now[i] != 0xff) wrong("a word that is not erased");
            now[i] &= (uint8_t)(f.word >> 8 * i);
        }
    }
    if (f.command) qemu_memory(f.at, now, bytes, true);
}

static void done(void *unused) {
    (void)unused;
    carry_out(f.command == ERASE ? PAGE : 4);
    f.command = 0;
}

static uint64_t controller_read(void *unused, uint64_t at, unsigned bytes) {
    (void)unused, (void)bytes;
    return at == FMA ? f.fma : at == FMD ? f.fmd : at == FMC ? f.command : 0;
}

static void controller_write(void *unused, uint64_t at, uint64_t value, unsigned bytes) {
    (void)unused, (void)bytes;
    if (at == FMA) f.fma = (uint32_t)value;
    if (at == FMD) f.fmd = (uint32_t)value;
    if (at == FMC) begin((uint32_t)value);
    if (at > FMC) wrong("an unknown register");
}

static uint64_t clock_read(void *unused, uint64_t at, unsigned bytes) {
    (void)unused, (void)at, (void)bytes;
    return f.usecrl;
}

static void clock_write(void *unused, uint64_t at, uint64_t value, unsigned bytes) {
    (void)unused, (void)at, (void)bytes;
    f.usecrl = (uint32_t)value;
}

void flash_connect(unsigned at, unsigned bytes) {
    static const memory_ops_t CONTROLLER_OPS = {controller_read,     controller_write, {0}, 2,
                                                {4, 4, false, NULL}, {4, 4, false}};
    static const memory_ops_t CLOCK_OPS = {clock_read, clock_write, {0}, 2, {4, 4, false, NULL}, {4, 4, false}};
    f.first = at;
    f.end = at + bytes;
    timer_init_full(f.timer, NULL, CLOCK_VIRTUAL, 1, 0, done, NULL);
    memory_region_init_io(&f.controller, NULL, &CONTROLLER_OPS, NULL, "scope-flash", 0x1000);
    memory_region_add_subregion_overlap(get_system_memory(), CONTROLLER, &f.controller, 1);
    memory_region_init_io(&f.clock, NULL, &CLOCK_OPS, NULL, "scope-usecrl", 4);
    memory_region_add_subregion_overlap(get_system_memory(), USECRL, &f.clock, 1);
}

void flash_power_off(void) {
    carry_out(f.command == ERASE ? PAGE / 2 : 2);
}
