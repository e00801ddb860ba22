/* scope.c - a logic analyser and a hand at the switches for qemu-system-arm: a plugin that records GPIO lines from
 * outside the firmware into a VCD file, with QEMU's virtual time, and plays stim.h into console and switches.
 *
 *     -plugin scope.so,vcd=out.vcd,stim=in.txt,pin=x_step:PATH@LINE,...,input=limit_x:PATH@LINE:low,...
 *
 * store=FILE,flash=ADDRESS+BYTES writes that part of the flash to the file when the run ends. cut=N: the power fails
 * when the processor has written to it N times. drawings=N ends the run 20 ms after `enable` has gone off for the N-th
 * time; it ends, too, when all has been played and no pin has moved for 30 s. A byte that the UART model cannot take is
 * written to stderr, where the test finds it. live=1, instead of vcd and stim: somebody sits at the board
 * (scope_live.h). stellaris=1 gives the board the flash controller that QEMU lacks (scope_flash.h). */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "qemu_inside.h"
#include "scope_flash.h"
#include "scope_live.h"
#include "stim.h"

#define EXPORT __attribute__((visibility("default")))
#define PINS 6
#define QUIET_NS 20000000
#define STILL_NS 30000000000

EXPORT int qemu_plugin_version = 1;

static const char *const PIN_NAME[PINS] = {"x_step", "x_dir", "y_step", "y_dir", "pen", "enable"};

typedef struct wire {
    char path[128];
    int line;
    bool low; /* active low */
    bool used;
    qemu_irq next; /* what the line was connected to before */
} wire_t;

static struct {
    FILE *vcd;
    wire_t pin[PINS], input[4];
    uint8_t level; /* of all pins, active is 1 */
    int64_t written_ns, first_ns;
    int drawings, to_draw;
    stim_t *stim;
    int stims, at, byte;
    bool started, ending, stellaris, live;
    char store[160];
    unsigned flash_at, flash_bytes, poked;
    unsigned cut, writes;
    void *kept; /* the flash when the power failed */
    uint8_t was[2];
    _Alignas(16) unsigned char timer[256]; /* a QEMUTimer, which is smaller */
    _Alignas(16) unsigned char quiet[256];
} g = {.written_ns = -1, .first_ns = -1};

static void write_change(int pin, int level) {
    int64_t now = qemu_clock_get_ns(CLOCK_VIRTUAL);
    if (now != g.written_ns) fprintf(g.vcd, "#%lld\n", (long long)now);
    g.written_ns = now;
    fprintf(g.vcd, "%d%c\n", level, '!' + pin);
}

static void quit(void *unused) {
    (void)unused;
    qemu_system_shutdown_request(3);
}

static void schedule(void) {
    const stim_t *s = &g.stim[g.at];
    if (g.at == g.stims || (s->relative && g.first_ns < 0)) { /* that waits for the first change */
        if (!g.ending) timer_mod(g.quiet, qemu_clock_get_ns(CLOCK_VIRTUAL) + STILL_NS);
        return;
    }
    int64_t at = s->ns + (s->relative ? g.first_ns : 0) + (int64_t)g.byte * BYTE_NS;
    int64_t now = qemu_clock_get_ns(CLOCK_VIRTUAL);
    if (!g.ending) timer_del(g.quiet); /* what is to come is waited for */
    timer_mod(g.timer, at > now ? at : now + 1);
}

static void type(uint8_t byte) {
    void *uart = qemu_chr_find("serial0");
    if (uart && qemu_chr_be_can_write(uart) > 0)
        qemu_chr_be_write(uart, &byte, 1);
    else
        fprintf(stderr, "scope: byte %d lost by the UART\n", byte);
}

static void set_input(int input, int level) {
    const wire_t *w = &g.input[input];
    void *dev = object_resolve_path(w->path, &(bool){false});
    if (dev) qemu_set_irq(qdev_get_gpio_in(dev, w->line), level != w->low);
}

/* Writes 16 bits, of flash as well; what was there is kept for heal(). */
static void poke(unsigned at, unsigned value) {
    uint8_t two[2] = {(uint8_t)value, (uint8_t)(value >> 8)};
    qemu_memory(at, g.was, 2, false);
    qemu_memory(at, two, 2, true);
    g.poked = at;
}

static void heal(void) {
    qemu_memory(g.poked, g.was, 2, true);
}

static void play(void *unused) {
    (void)unused;
    const stim_t *s = &g.stim[g.at];
    if (s->kind == STIM_TYPE) {
        type((uint8_t)s->text[g.byte++]);
        if (g.byte >= s->bytes) {
            g.at++;
            g.byte = 0;
        }
    } else {
        if (s->kind == STIM_QUIT) quit(NULL);
        if (s->kind == STIM_POKE) poke(s->at, s->value);
        if (s->kind == STIM_HEAL) heal();
        if (s->kind == STIM_INPUT) set_input(s->input, s->level);
        g.at++;
    }
    schedule();
}

static void record(int pin, bool active) {
    write_change(pin, active);
    if (g.at == g.stims && !g.ending) timer_mod(g.quiet, qemu_clock_get_ns(CLOCK_VIRTUAL) + STILL_NS);
    if (g.first_ns < 0) {
        g.first_ns = qemu_clock_get_ns(CLOCK_VIRTUAL);
        schedule();
    }
    if (pin == PINS - 1 && !active && ++g.drawings == g.to_draw) {
        g.ending = true;
        timer_mod(g.quiet, qemu_clock_get_ns(CLOCK_VIRTUAL) + QUIET_NS);
    }
}

static void edge(void *opaque, int n, int level) {
    wire_t *w = opaque;
    int pin = (int)(w - g.pin);
    bool active = level >= 0 && (level != 0) != w->low; /* not driven: the resistor's, at rest */
    if (active != (bool)(g.level >> pin & 1)) {
        g.level ^= (uint8_t)(1 << pin);
        if (g.live)
            live_pin(qemu_clock_get_ns(CLOCK_VIRTUAL), pin, active);
        else
            record(pin, active);
    }
    if (w->next) qemu_set_irq(w->next, level);
    (void)n;
}

static void connect(void) {
    bool locked = qemu_mutex_iothread_locked();
    if (!locked) qemu_mutex_lock_iothread_impl(__FILE__, __LINE__);
    for (int i = 0; i < PINS; i++) {
        wire_t *w = &g.pin[i];
        void *dev = w->used ? object_resolve_path(w->path, &(bool){false}) : NULL;
        if (!dev) {
            fprintf(stderr, "scope: no pin %s at %s\n", PIN_NAME[i], w->path);
            exit(2);
        }
        w->next = qdev_intercept_gpio_out(dev, qemu_allocate_irq(edge, w, w->line), NULL, w->line);
    }
    for (int i = 0; i < 4; i++) /* switches are open: lines at rest are otherwise low */
        if (g.input[i].used) set_input(i, 0);
    timer_init_full(g.timer, NULL, CLOCK_VIRTUAL, 1, 0, play, NULL);
    timer_init_full(g.quiet, NULL, CLOCK_VIRTUAL, 1, 0, quit, NULL);
    if (g.live)
        live_begin(type, set_input);
    else
        schedule();
    if (!locked) qemu_mutex_unlock_iothread();
}

static void on_cpu(qemu_plugin_id_t id, unsigned cpu) {
    (void)id, (void)cpu;
    if (g.stellaris) flash_connect(g.flash_at, g.flash_bytes);
}

static void *read_flash(void) {
    void *flash = malloc(g.flash_bytes);
    return qemu_memory(g.flash_at, flash, g.flash_bytes, false) ? flash : NULL;
}

static void on_write(unsigned cpu, uint32_t info, uint64_t at, void *unused) {
    (void)cpu, (void)unused;
    if (!qemu_plugin_mem_is_store(info) || at - g.flash_at >= g.flash_bytes || ++g.writes != g.cut) return;
    g.kept = read_flash(); /* the processor goes on for a moment */
    quit(NULL);
}

/* At the first translation all devices exist, and no instruction has run. */
static void on_translation(qemu_plugin_id_t id, struct qemu_plugin_tb *tb) {
    (void)id;
    for (size_t k = 0; g.cut && k < qemu_plugin_tb_n_insns(tb); k++)
        qemu_plugin_register_vcpu_mem_cb(qemu_plugin_tb_get_insn(tb, k), on_write, PLUGIN_NO_REGISTERS,
                                         PLUGIN_MEMORY_WRITTEN, NULL);
    if (g.started) return;
    g.started = true;
    connect();
}

static void at_exit(qemu_plugin_id_t id, void *unused) {
    (void)id, (void)unused;
    if (g.vcd) {
        fprintf(g.vcd, "#%lld\n", (long long)qemu_clock_get_ns(CLOCK_VIRTUAL));
        fclose(g.vcd);
    }
    FILE *f = g.store[0] ? fopen(g.store, "wb") : NULL;
    if (!f) return;
    if (g.stellaris) flash_power_off();
    void *flash = g.kept ? g.kept : read_flash();
    if (flash) fwrite(flash, 1, g.flash_bytes, f);
    free(flash);
    fclose(f);
}

static void parse_wire(wire_t *w, const char *text) {
    char low[8] = "";
    w->used = sscanf(text, "%127[^@]@%d:%7s", w->path, &w->line, low) >= 2;
    w->low = strcmp(low, "low") == 0;
}

/* pin=NAME:PATH@LINE[:low] */
static bool parse(const char *arg) {
    char name[16], rest[160];
    if (strncmp(arg, "vcd=", 4) == 0) return (g.vcd = fopen(arg + 4, "w")) != NULL;
    if (strncmp(arg, "stim=", 5) == 0) return (g.stims = stim_read(arg + 5, &g.stim)) >= 0;
    if (sscanf(arg, "store=%159s", g.store) == 1) return true;
    if (sscanf(arg, "flash=%i+%i", (int *)&g.flash_at, (int *)&g.flash_bytes) == 2) return true;
    if (sscanf(arg, "cut=%u", &g.cut) == 1) return true;
    if (sscanf(arg, "drawings=%d", &g.to_draw) == 1) return true;
    if (strcmp(arg, "live=1") == 0) return g.live = true;
    if (strcmp(arg, "stellaris=1") == 0) return g.stellaris = true;
    if (sscanf(arg, "input=%15[^:]:%159s", name, rest) == 2 && stim_input(name) >= 0) {
        parse_wire(&g.input[stim_input(name)], rest);
        return true;
    }
    if (sscanf(arg, "pin=%15[^:]:%159s", name, rest) != 2) return false;
    for (int i = 0; i < PINS; i++)
        if (strcmp(name, PIN_NAME[i]) == 0) {
            parse_wire(&g.pin[i], rest);
            return true;
        }
    return false;
}

static void begin_vcd(void) {
    fprintf(g.vcd, "$timescale 1 ns $end\n$scope module plotter $end\n");
    for (int i = 0; i < PINS; i++) fprintf(g.vcd, "$var wire 1 %c %s $end\n", '!' + i, PIN_NAME[i]);
    fprintf(g.vcd, "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n");
    for (int i = 0; i < PINS; i++) fprintf(g.vcd, "0%c\n", '!' + i);
    fprintf(g.vcd, "$end\n");
}

EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info, int argc, char **argv);
EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info, int argc, char **argv) {
    (void)info;
    for (int i = 0; i < argc; i++)
        if (!parse(argv[i])) {
            fprintf(stderr, "scope: %s?\n", argv[i]);
            return -1;
        }
    if (!g.vcd && !g.live) return -1;
    if (g.vcd) begin_vcd();
    qemu_plugin_register_vcpu_init_cb(id, on_cpu);
    qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
    qemu_plugin_register_atexit_cb(id, at_exit, NULL);
    return 0;
}
