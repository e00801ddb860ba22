/* console.c - the console of all ports: bytes in and out by interrupt, through two queues. */
#include "hal/port/console.h"

#include "hal/hal.h"
#include "hal/port/cortex.h"
#include "hal/port/ring.h"
#include "port.h"

#define IN_BYTES 128
#define OUT_BYTES 64

static struct {
    ring_t in, out;
    volatile uint8_t in_byte[IN_BYTES], out_byte[OUT_BYTES];
    volatile bool sending; /* a byte is on its way: its end will interrupt */
    volatile uint32_t errors;
} c;

int hal_console_read(void) {
    return ring_get(&c.in, c.in_byte, IN_BYTES);
}

bool console_waiting(void) {
    return !ring_empty(&c.in);
}

/* In the interrupt, or with interrupts off. */
static void send_next(void) {
    int byte = ring_get(&c.out, c.out_byte, OUT_BYTES);
    c.sending = byte >= 0;
    port_uart_sending(c.sending);
    if (c.sending) port_uart_send((uint8_t)byte);
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
