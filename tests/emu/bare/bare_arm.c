/* bare.h on a Cortex-M: vectors, the start, and semihosting as Arm's "Semihosting for AArch32 and AArch64" has it. */
#include "tests/emu/bare/bare.h"

#define SYS_WRITE0 4
#define SYS_GET_CMDLINE 0x15
#define SYS_EXIT 0x18
#define EXIT_DONE 0x20026
#define EXIT_FAULT 0x20023

extern uint32_t bare_stack_top[], bare_data[], bare_data_end[], bare_data_load[], bare_bss[], bare_bss_end[];
void bare_start(void);

static uint32_t call(uint32_t what, uint32_t with) {
    register uint32_t r0 __asm__("r0") = what;
    register uint32_t r1 __asm__("r1") = with;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void fault(void) {
    bare_text("fault\n");
    call(SYS_EXIT, EXIT_FAULT);
    for (;;) continue;
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    bare_stack_top,
    (const void *)bare_start,
    (const void *)fault,
    (const void *)fault,
};

/* One instruction, so that one is seen each time. */
__attribute__((naked, noinline)) void bare_mark(void) {
    __asm__ volatile("bx lr");
}

void bare_text(const char *s) {
    call(SYS_WRITE0, (uint32_t)(uintptr_t)s);
}

void bare_number(int64_t v) {
    char text[24], *p = text + sizeof text;
    uint64_t left = v < 0 ? (uint64_t)0 - (uint64_t)v : (uint64_t)v;
    *--p = 0;
    do {
        *--p = (char)('0' + left % 10);
        left /= 10;
    } while (left);
    if (v < 0) *--p = '-';
    bare_text(p);
}

void bare_hex(uint64_t v) {
    char text[17];
    for (int i = 0; i < 16; i++) text[i] = "0123456789abcdef"[v >> (60 - 4 * i) & 15];
    text[16] = 0;
    bare_text(text);
}

/* What the emulator was told: the program's name and its arguments. One that has no command line leaves it empty. */
static int arguments(char **argv, int most) {
    static char text[80];
    struct {
        char *at;
        int32_t bytes;
    } block = {text, (int32_t)sizeof text};
    int argc = 0;
    call(SYS_GET_CMDLINE, (uint32_t)(uintptr_t)&block);
    for (char *p = text; *p && argc < most;) {
        argv[argc++] = p;
        while (*p && *p != ' ') p++;
        while (*p == ' ') *p++ = 0;
    }
    return argc;
}

void bare_start(void) {
    static char *argv[5];
    for (uint32_t *to = bare_data, *from = bare_data_load; to < bare_data_end;) *to++ = *from++;
    for (uint32_t *to = bare_bss; to < bare_bss_end;) *to++ = 0;
    const int argc = arguments(argv, 4);
    bare_main(argc, argv);
    call(SYS_EXIT, EXIT_DONE);
    for (;;) continue;
}
