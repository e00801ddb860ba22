/* The boards' console driver, hal/port/console.c with pl011.h, on a UART made here: what comes damaged, what is lost,
 * and that nothing else is. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* The driver's functions beside the simulator's of the same name. */
#define hal_console_read driver_read
#define hal_console_write driver_write
#define hal_console_hold driver_hold
#define hal_console_errors driver_errors
#define hal_fault driver_fault
#define hal_idle driver_idle

/* In place of hal/port/cortex.h. */
#define CORTEX_H
static inline unsigned irq_lock(void) {
    return 0;
}
static inline void irq_unlock(unsigned state) {
    (void)state;
}
static inline unsigned exception(void) {
    return 0;
}

#include "hal/port/console.c"

enum { DR = 0x00, FR = 0x18, IMSC = 0x38 };
enum { FRAMING = 0x100, PARITY = 0x200, BREAK = 0x400, OVERRUN = 0x800 };
#define RX_EMPTY (1u << 4)
#define MARK 0x80000000u /* what was read is popped by the next access; what was written has no mark */

static struct {
    uint32_t received[1024];
    uint32_t head, tail;
    char sent[1024];
    uint32_t sent_bytes;
    uint32_t data, flags, mask, other;
    bool touched; /* DR */
} u;

static void settle(void) {
    if (!u.touched) return;
    u.touched = false;
    if (u.data & MARK)
        u.tail++;
    else
        u.sent[u.sent_bytes++] = (char)u.data;
}

uint32_t *fake_register(uint32_t address) {
    settle();
    if (address == FR) {
        u.flags = u.head == u.tail ? RX_EMPTY : 0;
        return &u.flags;
    }
    if (address == IMSC) return &u.mask;
    if (address != DR) return &u.other;
    u.touched = true;
    u.data = MARK | u.received[u.tail];
    return &u.data;
}

/* The other side takes what is sent while the driver waits. */
void driver_idle(void) {
    console_uart_isr();
    settle();
}

static void arrive(uint32_t word) {
    u.received[u.head++] = word;
}

static void arrive_text(const char *text) {
    while (*text) arrive((uint8_t)*text++);
}

static const char *taken(void) {
    static char text[512];
    size_t n = 0;
    for (int byte; (byte = driver_read()) >= 0;) text[n++] = (char)byte;
    text[n] = '\0';
    return text;
}

static int power_on(void **state) {
    (void)state;
    memset(&u, 0, sizeof u);
    memset(&c, 0, sizeof c);
    return 0;
}

/* A byte with a framing or parity error, or a break, is none; those around it are kept, and the errors counted. */
static void test_damaged(void **state) {
    (void)state;
    arrive_text("splot x");
    arrive(FRAMING | '*');
    arrive_text("*y");
    arrive(BREAK | FRAMING);
    arrive(PARITY | 'z');
    arrive_text("\r");
    console_uart_isr();
    assert_string_equal(taken(), "splot x*y\r");
    assert_int_equal(driver_errors(), 3);
    assert_int_equal(driver_errors(), 0);
}

/* The byte that comes after an overrun is good. */
static void test_overrun(void **state) {
    (void)state;
    arrive_text("ab");
    arrive(OVERRUN | 'd');
    console_uart_isr();
    assert_string_equal(taken(), "abd");
    assert_int_equal(driver_errors(), 1);
}

/* A queue that nobody empties keeps what came first, to the byte, and goes on when there is room again. */
static void test_full(void **state) {
    (void)state;
    for (uint32_t i = 0; i < IN_BYTES + 72; i++) arrive('0' + i % 64);
    console_uart_isr();
    const char *text = taken();
    assert_int_equal(strlen(text), IN_BYTES);
    for (uint32_t i = 0; i < IN_BYTES; i++) assert_int_equal(text[i], '0' + i % 64);
    assert_int_equal(driver_errors(), 72);
    arrive_text("again\r");
    console_uart_isr();
    assert_string_equal(taken(), "again\r");
    assert_int_equal(driver_errors(), 0);
}

/* Every value of a byte passes, flow control among them. */
static void test_all_bytes(void **state) {
    (void)state;
    for (uint32_t i = 0; i < 256; i++) {
        arrive(i);
        console_uart_isr();
        assert_true(console_waiting());
        assert_int_equal(driver_read(), i);
    }
    assert_int_equal(driver_read(), -1);
    assert_int_equal(driver_errors(), 0);
}

/* More than the queue holds is sent in order while bytes arrive, and the interrupt for room is off afterwards. */
static void test_sending(void **state) {
    (void)state;
    char text[401];
    for (size_t i = 0; i < sizeof text - 1; i++) text[i] = (char)('a' + i % 26);
    text[sizeof text - 1] = '\0';
    driver_write(text, 200);
    arrive_text("?!");
    driver_write(text + 200, 200);
    for (int i = 0; i < 400; i++) driver_idle();
    assert_int_equal(u.sent_bytes, 400);
    assert_memory_equal(u.sent, text, 400);
    assert_false(u.mask & UART_TX);
    assert_string_equal(taken(), "?!");
}

/* The other side is asked to stop before all that waits to be sent, and to go on when there is room again. */
static void test_flow(void **state) {
    (void)state;
    char text[OUT_BYTES];
    memset(text, 'x', sizeof text);
    driver_write(text, sizeof text);
    for (int i = 0; i < IN_BYTES / 2 + 1; i++) arrive('a');
    console_uart_isr();
    driver_idle();
    assert_int_equal(memchr(u.sent, XOFF, u.sent_bytes) ? 1 : 0, 1);
    assert_true((char *)memchr(u.sent, XOFF, u.sent_bytes) - u.sent <= 2);
    for (int i = 0; i < IN_BYTES / 2 - 1; i++) arrive('b');
    console_uart_isr();
    for (int i = 0; i < 100; i++) driver_idle();
    assert_int_equal(u.sent_bytes, OUT_BYTES + 1); /* once */
    driver_hold(true);
    assert_int_equal(strlen(taken()), IN_BYTES);
    driver_idle();
    assert_int_equal(u.sent_bytes, OUT_BYTES + 1);
    driver_hold(false);
    driver_idle();
    assert_int_equal(u.sent_bytes, OUT_BYTES + 2);
    assert_int_equal(u.sent[u.sent_bytes - 1], XON);
    driver_hold(true);
    driver_hold(false); /* the last word counts */
    for (int i = 0; i < 4; i++) driver_idle();
    assert_int_equal(u.sent[u.sent_bytes - 1], XON);
    assert_int_equal(driver_errors(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_damaged, power_on), cmocka_unit_test_setup(test_overrun, power_on),
        cmocka_unit_test_setup(test_full, power_on),    cmocka_unit_test_setup(test_all_bytes, power_on),
        cmocka_unit_test_setup(test_sending, power_on), cmocka_unit_test_setup(test_flow, power_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
