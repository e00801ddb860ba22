/* console.c - the console of all ports: bytes in and out by interrupt, through two queues. */
#include "hal/port/console.h"

#include "config.h"
#include "hal/hal.h"
#include "hal/port/cortex.h"
#include "hal/port/ring.h"
#include "port.h"

#define IN_BYTES CONFIG_RECEIVED
#define OUT_BYTES 64
enum { XON = 17, XOFF = 19 };

static struct {
    ring_t in, out;
    volatile uint8_t in_byte[IN_BYTES], out_byte[OUT_BYTES];
    volatile bool sending; /* a byte is on its way: its end will interrupt */
    bool hold, off;        /* the program wants no more; the other side was told to stop */
    uint8_t flow;          /* XON or XOFF, to be sent before what is queued; 0: neither */
    volatile uint32_t errors;
} c;

/* In the interrupt, or with interrupts off. */
static void send_next(void) {
    int byte = c.flow ? c.flow : ring_get(&c.out, c.out_byte, OUT_BYTES);
    c.flow = 0;
    c.sending = byte >= 0;
    port_uart_sending(c.sending);
    if (c.sending) port_uart_send((uint8_t)byte);
}

/* As send_next. Bytes that are under way already find the other half of the queue. */
static void flow(void) {
    bool off = c.hold || c.in.head - c.in.tail > (c.off ? IN_BYTES / 4 : IN_BYTES / 2);
    if (off == c.off) return;
    c.off = off;
    c.flow = off ? XOFF : XON;
    if (!c.sending) send_next();
}

static void flow_now(void) {
    uint32_t state = irq_lock();
    flow();
    irq_unlock(state);
}

void hal_console_hold(bool hold) {
    c.hold = hold;
    flow_now();
}

int hal_console_read(void) {
    int byte = ring_get(&c.in, c.in_byte, IN_BYTES);
    if (c.off && !c.hold) flow_now();
    return byte;
}

bool console_waiting(void) {
    return !ring_empty(&c.in);
}

void hal_console_write(const char *text, size_t bytes) {
    for (size_t i = 0; i < bytes; i++) {
        while (!ring_put(&c.out, c.out_byte, OUT_BYTES, (uint8_t)text[i])) hal_idle();
        uint32_t state = irq_lock();
        if (!c.sending) send_next();
        irq_unlock(state);
    }
}

uint32_t hal_console_errors(void) {
    uint32_t state = irq_lock();
    uint32_t n = c.errors;
    c.errors = 0;
    irq_unlock(state);
    return n;
}

void console_lost(void) {
    c.errors++;
}

void console_uart_isr(void) {
    uint32_t got;
    while ((got = port_uart_take()) != PORT_UART_NONE) {
        if (got & (PORT_UART_LOST | PORT_UART_DAMAGED)) c.errors++;
        if (got & PORT_UART_DAMAGED) continue;
        if (!ring_put(&c.in, c.in_byte, IN_BYTES, (uint8_t)got)) c.errors++;
    }
    if (c.sending && port_uart_sent()) send_next();
    flow();
}

static void put_polled(const char *text) {
    for (; *text; text++) port_uart_put((uint8_t)*text);
}

static void put_hex(int32_t number) {
    char text[] = " 0x00000000";
    for (int k = 0; k < 8; k++) text[10 - k] = "0123456789abcdef"[(uint32_t)number >> 4 * k & 15];
    put_polled(text);
}

/* What was being sent is not waited for: it may be the interrupt that has gone wrong. */
void hal_fault(const char *what, int32_t a, int32_t b) {
    (void)irq_lock();
    port_write(port_word(PORT_ALL_PINS, 0));
    port_pen_up();
    put_polled("\r\nfault: ");
    put_polled(what);
    put_hex(a);
    put_hex(b);
    put_polled("\r\n");
    for (;;) continue; /* until the watchdog bites */
}

void console_panic(void) {
    hal_fault("exception", (int32_t)exception(), 0);
}
