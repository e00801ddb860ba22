/* hal.h - the boundary to hardware. The core calls down through these functions; each build links exactly one folder
 * that defines them (sim/ on the desktop, hal/<port>/ elsewhere). hal/README.md is the contract line by line.
 *
 * Time is hal_now(): 32-bit ticks of HAL_TICK_HZ that wrap around; compare with hal_before() only. */
#ifndef HAL_H
#define HAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HAL_TICK_HZ 16000000u /* the tick of traces and plans; a port scales to its own timer */

/* Pin word. A set bit means: stepping pulse active, direction positive, pen down, motors on - the port applies
 * the board's polarity. */
enum hal_pin {
    HAL_X_STEP = 1 << 0,
    HAL_X_DIR = 1 << 1,
    HAL_Y_STEP = 1 << 2,
    HAL_Y_DIR = 1 << 3,
    HAL_PEN = 1 << 4,
    HAL_ENABLE = 1 << 5,
};

/* Sets the pins in mask to the bits of value, all at once where the hardware can. */
void hal_pins_write(uint32_t mask, uint32_t value);

/* What lifts the pen. Its pin follows HAL_PEN within 1 ms, a servo's with its next pulse, 20 ms later at most. */
enum hal_pen_kind {
    HAL_PEN_LEVEL,    /* the pin is active while the pen is down */
    HAL_PEN_SERVO,    /* 50 pulses a second, whose width is the servo's place, also while the motors are off */
    HAL_PEN_SOLENOID, /* power to pull, then a part of it to hold, by pulses of 25 kHz (without PWM 1 kHz) */
};

/* How a machine is wired, where that differs from the board's own way. */
typedef struct hal_wiring {
    uint8_t invert_pins;     /* enum hal_pin: these are turned round */
    uint8_t invert_inputs;   /* enum hal_input */
    uint8_t pen;             /* enum hal_pen_kind; a board without PWM has no servo (CONFIG_PEN_SERVO) */
    uint8_t hold_percent;    /* solenoid: 1 .. 100 */
    uint16_t up_us, down_us; /* servo: width of the pulses, below 20,000 */
    uint16_t glide_ms;       /* servo: the width changes evenly in so long; 0: at once */
    uint16_t pull_ms;        /* solenoid: all of the power so long */
} hal_wiring_t;
/* The machine is wired so from now on; the pins are written anew. At rest only. Before the first call they are
 * not driven: which level is rest is not known, and resistors keep them there. */
void hal_wire(const hal_wiring_t *wiring);

uint32_t hal_now(void);

/* A port may play edges by itself, so that stepgen_isr can make many in one go: hal_edges() tells how many it takes now
 * (none, or at least 2), up to which tick, and where to put them; hal_edges_put() hands them over, with the ticks of
 * the first and the last. They follow those put before. Context: stepgen_isr. */
typedef struct hal_edges {
    uint32_t *word; /* hal_edge(all pins, ticks since the edge before); the ticks of the first are put in by the port */
    uint32_t room;
    uint32_t until;
} hal_edges_t;
#define HAL_EDGE_GAP 3 /* ticks from one to the next, at least */
#define HAL_EDGE_PINS 0x3fu
/* Ticks less the gap, above the pins: what a state machine of the RP2040 counts down. */
static inline uint32_t hal_edge(uint32_t pins, uint32_t ticks) {
    return (ticks - HAL_EDGE_GAP) << 6 | pins;
}
static inline uint32_t hal_edge_ticks(uint32_t word) {
    return (word >> 6) + HAL_EDGE_GAP;
}
hal_edges_t hal_edges(void);
void hal_edges_put(uint32_t edges, uint32_t first_at, uint32_t last_at);
/* True when all that were put have left. Context: main loop. */
bool hal_edges_left(void);

/* Calls stepgen_isr() at absolute tick `at`; a tick in the past is served at once and counted as late. */
void hal_timer_arm(uint32_t at);
void hal_timer_cancel(void);
/* Waits for something to happen: lets the interrupt run. The simulator moves its virtual clock here. */
void hal_idle(void);
/* Stops everything: pen up, motors off, message out. Does not return on a board. */
void hal_fault(const char *what, int32_t a, int32_t b);

/* Brings the chip up: first the pins safe, then clocks, timer, console, inputs. Interrupts are on afterwards. Called
 * once, by main. */
void hal_start(void);
/* For the banner: "rp2040", "lm3s6965", "nrf51", "sim". */
const char *hal_board_name(void);

/* The console, 115200 8N1. The next byte received, or -1. */
int hal_console_read(void);
/* Queues text to be sent by interrupt; waits while the queue is full, and the machine goes on. Main loop only. */
void hal_console_write(const char *text, size_t bytes);
/* Asks the other side to stop sending (XOFF), or to go on (XON), before all that is queued. The port does so by itself
 * while what it has received fills more than half of its queue. Main loop only. */
void hal_console_hold(bool hold);
/* Bytes lost since last asked: overruns of the receiver or of its queue, framing errors. */
uint32_t hal_console_errors(void);

/* Switches. A set bit means active; the port applies the board's polarity. */
enum hal_input {
    HAL_IN_LIMIT_X = 1 << 0,
    HAL_IN_LIMIT_Y = 1 << 1,
    HAL_IN_BUTTON = 1 << 2, /* start */
    HAL_IN_ESTOP = 1 << 3,
};
uint32_t hal_inputs(void);
/* These limit switches stop what is under way: when one closes, the port itself ends pulses and lifts the pen, at once,
 * before it calls console_input_isr. The emergency stop always does, and switches the motors off. 0: none. */
void hal_trip(uint32_t limits);

/* Memory that keeps its contents without power: slots that are erased and written as a whole. A write that loses its
 * power leaves its own slot undefined and all others alone; checksums and taking turns are the caller's. Not while
 * the machine steps: some chips stand still meanwhile. Both return 0 or ERR_FILE (write: what was read back differs).
 * bytes up to HAL_STORE_BYTES; buf of a write aligned to 4. A slot never written reads as 0xff. */
#define HAL_STORE_SLOTS 4
#ifndef HAL_STORE_BYTES
#define HAL_STORE_BYTES 4096u /* boards.mk may say less where pages of flash are smaller */
#endif
int hal_store_read(int slot, void *buf, size_t bytes);
int hal_store_write(int slot, const void *buf, size_t bytes);

/* Resets the chip when it is not fed for ms milliseconds (1 .. 8000). Cannot be stopped again. */
void hal_watchdog_start(uint32_t ms);
void hal_watchdog_feed(void);

/* Bytes of the stack that were ever in use, of *room; both 0 where that is not known. */
uint32_t hal_stack_used(uint32_t *room);
/* Is the word below the stack still what it was at the start? If not, the stack has grown into other data. */
bool hal_stack_ok(void);

/* Upward, both in interrupt context and the only functions a port calls. stepgen_isr: the armed deadline. The body
 * lives in src/motion. console_input_isr may interrupt it, but it not that. */
void stepgen_isr(void);
/* A limit or the emergency stop has become active; inputs as of hal_inputs(). The body lives in src/app. */
void console_input_isr(uint32_t inputs);

static inline bool hal_before(uint32_t a, uint32_t b) {
    return (int32_t)(a - b) < 0;
}

#endif
