/* console.c - see console.h. */
#include "app/console.h"

#include <string.h>

#include "app/console_parts.h"
#include "app/say.h"
#include "error.h"
#include "hal/hal.h"
#include "version.h"

#define BUTTON_TICKS (HAL_TICK_HZ / 50) /* it must stay as it is for so long */

static carriage_t *active; /* for the interrupt */

void console_input_isr(uint32_t inputs) {
    if (active) carriage_input_isr(active, inputs);
}

static void poll(void *ctx) {
    console_t *c = ctx;
    realtime_poll(&c->realtime);
}

void *console_free_memory(console_t *c, size_t *bytes) {
    const data_pool_t *pool = &c->session.pool;
    *bytes = (pool->high - pool->low) * sizeof *pool->base;
    return pool->base + pool->low;
}

static void port_print(void *ctx, const char *text) {
    console_t *c = ctx;
    if (c->capture.on)
        keep_print(&c->capture, text);
    else
        say_line(text);
}

static void port_warn(void *ctx, const char *text) {
    (void)ctx;
    say_line(text);
}

/* There are no files. */
static int port_open(void *ctx, const char *name) {
    (void)ctx, (void)name;
    return ERR_FILE;
}
static int port_read(void *ctx, int handle, char *buf, int size) {
    (void)ctx, (void)handle, (void)buf, (void)size;
    return ERR_FILE;
}
static void port_close(void *ctx, int handle) {
    (void)ctx, (void)handle;
}

static void idle(console_t *c) {
    realtime_poll(&c->realtime);
    stepgen_wake(HAL_TICK_HZ / 1000);
    hal_idle();
}

/* A second at a time, as the clock wraps around. */
int console_pause(console_t *c, int32_t ms) {
    while (ms > 0 && !c->realtime.cancelled) {
        int32_t part = ms < 1000 ? ms : 1000;
        uint32_t from = hal_now();
        while (hal_now() - from < (uint32_t)part * (HAL_TICK_HZ / 1000) && !c->realtime.cancelled) idle(c);
        ms -= part;
    }
    return c->realtime.cancelled ? ERR_STOPPED : 0;
}

static int port_pause(void *ctx, const char *prompt, int32_t ms) {
    console_t *c = ctx;
    say_line(prompt);
    c->realtime.cancelled = false;
    if (ms >= 0) {
        say("\n");
        return console_pause(c, ms);
    }
    for (;;) {
        int byte = realtime_read(&c->realtime);
        if (c->realtime.cancelled) return ERR_STOPPED;
        bool rest_of_line = byte == '\n' && c->edit.was_cr;
        if (byte >= 0) c->edit.was_cr = byte == '\r';
        if (byte == '\r' || (byte == '\n' && !rest_of_line)) break;
        if (byte < 0) idle(c);
    }
    say("\n");
    return 0;
}

#if CONFIG_CONTROL
static int port_turn(void *ctx) {
    console_t *c = ctx;
    realtime_poll(&c->realtime);
    return c->realtime.cancelled ? ERR_STOPPED : 0;
}
#endif

static int port_plot(void *ctx, const plot_t *plot) {
    return console_draw(ctx, plot);
}

/* The machine's numbers are kept when a command sets them; `reset` is about pictures and leaves them. Not while the
 * command goes on: what is asked of the session then would be taken for its next line, or for inline data. */
static void after_command(console_t *c) {
    if (c->loading || session_state(&c->session) != SESSION_READY) return;
    if (!c->machine_line)
        c->session.settings.machine = c->kept_machine;
    else if (console_keep_settings(c))
        say("error: the machine's settings could not be kept: they hold until the power goes\n");
    c->machine_line = false;
}

void console_wire(console_t *c) {
    const hal_wiring_t *w = &c->session.settings.machine.wiring;
    if (c->wired && memcmp(w, &c->kept_machine.wiring, sizeof *w) == 0) return;
    hal_wire(w);
    c->wired = true;
}

static void after_line(console_t *c, const char *line, int err) {
    int32_t column = c->session.error.column; /* counted from 1; what stands before it has been done */
    keep_line(&c->keep, line, !err ? SIZE_MAX : column > 0 ? (size_t)column - 1 : 0);
    if (c->session.lang.symbols <= c->own_symbols) keep_clear(&c->keep);
    if (strstr(line, "mach")) c->machine_line = true;
}

int console_line(console_t *c, const char *line) {
    const bool was_data = session_state(&c->session) == SESSION_DATA;
    const int err = session_line(&c->session, line);
    c->session.quit = false; /* there is nowhere to go */
    if (!was_data) after_line(c, line, err);
    after_command(c);
    return err;
}

/* What has been done becomes blanks, so that columns are those of the line. */
int console_execute(console_t *c, char *line) {
    int err = 0;
    for (char *from = line, *end; session_state(&c->session) == SESSION_READY; from = end + 1) {
        end = from + (keep_command_end(from) - from);
        const int number = console_command_find(from, end);
        if (number >= 0) {
            if (from > line) { /* first what stands before */
                from[-1] = '\0';
                err = console_line(c, line);
                if (!err && session_state(&c->session) != SESSION_READY) {
                    say("rows come first: say it when they are over\n");
                    return 0;
                }
            }
            if (!err) err = console_command(c, number);
            if (err || *end != ';') return err;
            memset(line, ' ', (size_t)(end + 1 - line));
        } else if (*end != ';') {
            break;
        }
    }
    return console_line(c, line);
}

static void prompt(console_t *c) {
    c->realtime.data = session_state(&c->session) == SESSION_DATA;
    if (session_state(&c->session) == SESSION_READY) say("> ");
}

static void refuse(const console_t *c, const char *why) {
    say("error: the line ");
    say(why);
    say(c->realtime.data ? " and was not taken; the rows before it were. Send it again.\n"
                         : " and was not taken. Send it again.\n");
}

static void take_byte(console_t *c, uint8_t byte) {
    switch (line_edit_byte(&c->edit, byte, hal_console_write)) {
    case LINE_EDIT_MORE:
        return;
    case LINE_EDIT_READY:
        if (session_state(&c->session) != SESSION_DATA) line_edit_remember(&c->edit);
        console_execute(c, c->edit.text);
        break;
    case LINE_EDIT_LONG:
        refuse(c, "is too long");
        break;
    case LINE_EDIT_DAMAGED:
        refuse(c, "was damaged on its way");
        break;
    }
    prompt(c);
}

/* Pressed and kept so for a moment. */
static bool button_pressed(console_t *c) {
    bool down = hal_inputs() & HAL_IN_BUTTON;
    if (down == c->button_down) {
        c->button_at = hal_now();
        return false;
    }
    if (hal_now() - c->button_at < BUTTON_TICKS) return false;
    c->button_down = down;
    return down;
}

static void run_saved(console_t *c, const char *why) {
    if (session_state(&c->session) != SESSION_READY) return;
    line_edit_clear(&c->edit);
    say(why);
    console_load(c);
    prompt(c);
}

void console_begin(console_t *c, const console_config_t *config) {
    memset(c, 0, sizeof *c);
    size_t motion_bytes = (config->motion_bytes + 7) / 8 * 8;
    uint8_t *memory = config->memory;
    c->port = (session_port_t) {
        .ctx = c, .print = port_print, .warn = port_warn, .open = port_open, .read = port_read, .close = port_close,
        .pause = port_pause,
#if CONFIG_CONTROL
        .turn = port_turn,
#endif
        .plot = port_plot
    };
    carriage_init(&c->carriage, memory, motion_bytes, poll, c);
    realtime_init(&c->realtime, &c->carriage);
    session_start(&c->session, &c->port, memory + motion_bytes, config->bytes - motion_bytes);
    c->kept_machine = c->session.settings.machine;
    c->own_symbols = c->session.lang.symbols;
    active = &c->carriage;
    hal_watchdog_start(CONSOLE_WATCHDOG_MS);
    console_load_settings(c); /* before anything is said: until then the pins are not driven */
    say("\nRidgeline " RIDGELINE_VERSION " on ");
    say(hal_board_name());
    say("; help, help board\n");
    if (c->autorun)
        run_saved(c, "autorun\n");
    else
        prompt(c);
}

void console_step(console_t *c) {
    realtime_poll(&c->realtime);
    if (c->realtime.cancelled) {
        c->realtime.cancelled = false;
        line_edit_clear(&c->edit);
        say("^X\n");
        prompt(c);
    }
    int byte = realtime_read(&c->realtime);
    if (byte < 0 && line_edit_is_empty(&c->edit)) c->realtime.line_start = true;
    if (byte >= 0)
        take_byte(c, (uint8_t)byte);
    else if (button_pressed(c))
        run_saved(c, "start\n");
    else
        idle(c);
}

void console_run(console_t *c, const console_config_t *config) {
    console_begin(c, config);
    for (;;) console_step(c);
}
