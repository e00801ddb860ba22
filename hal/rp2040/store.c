/* store.c - the last 16 KB of flash: 4 slots of one sector of 4 KB each. The boot ROM's routines erase and write;
 * meanwhile no code can be read from flash, so what calls them lies in RAM and interrupts are off. */
#include "hal/port/store.h"

#include "port.h"

#define PAGE 256u

typedef void (*rom_plain_t)(void);
typedef void (*rom_erase_t)(uint32_t from, uint32_t bytes, uint32_t block, uint32_t command);
typedef void (*rom_program_t)(uint32_t to, const uint8_t *data, uint32_t bytes);
typedef void *(*rom_lookup_t)(const uint16_t *table, uint32_t code);

typedef struct rom {
    rom_plain_t connect, leave_xip, flush, enter_xip;
    rom_erase_t erase;
    rom_program_t program;
} rom_t;

static uint8_t page[PAGE] __attribute__((aligned(4)));

static void *rom_function(char a, char b) {
    uintptr_t at = 0x14;  /* table and lookup, as 16-bit pointers */
    __asm("" : "+r"(at)); /* the compiler takes addresses this small for mistakes */
    const uint16_t *entry = (const uint16_t *)at;
    rom_lookup_t lookup = (rom_lookup_t)(uintptr_t)entry[2];
    return lookup((const uint16_t *)(uintptr_t)entry[0], (uint32_t)(uint8_t)a | (uint32_t)(uint8_t)b << 8);
}

/* Erases the slot at `at`, or writes `page` there. */
__attribute__((section(".ramcode"), noinline)) static void flash_do(const rom_t *rom, uint32_t at, bool erase) {
    rom->connect();
    rom->leave_xip();
    if (erase)
        rom->erase(at, HAL_STORE_BYTES, HAL_STORE_BYTES, 0x20);
    else
        rom->program(at, page, PAGE);
    rom->flush();
    rom->enter_xip();
    /* At the boot ROM's pace, which is slower: back to that of boot2.S, or all code would be until the next reset. */
    REG(XIP_SSI + 0x08u) = 0;
    REG(XIP_SSI + 0x14u) = 4;
    REG(XIP_SSI + 0x08u) = 1;
}

void port_store_write(uintptr_t to, const uint8_t *buf, size_t bytes) {
    const uint32_t at = to - XIP;
    const rom_t rom = {
        .connect = (rom_plain_t)rom_function('I', 'F'),
        .leave_xip = (rom_plain_t)rom_function('E', 'X'),
        .flush = (rom_plain_t)rom_function('F', 'C'),
        .enter_xip = (rom_plain_t)rom_function('C', 'X'),
        .erase = (rom_erase_t)rom_function('R', 'E'),
        .program = (rom_program_t)rom_function('R', 'P'),
    };
    void (*volatile run)(const rom_t *, uint32_t, bool) = flash_do; /* RAM is too far for a branch */
    uint32_t state = irq_lock();
    run(&rom, at, true);
    for (size_t i = 0; i < bytes; i += PAGE) {
        size_t n = bytes - i < PAGE ? bytes - i : PAGE;
        memset(page, 0xff, PAGE);
        memcpy(page, buf + i, n);
        run(&rom, at + (uint32_t)i, false);
    }
    irq_unlock(state);
}
