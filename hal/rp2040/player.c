/* player.c - the player of ahead.h that is a state machine of PIO 0: edges leave at their ticks, to the tick, whatever
 * the processor does.
 *
 *     ring --DMA 0, as the queue has room--> queue of 8 words --> state machine 0, at 16 MHz:
 *
 *         wait:  out x, 26        what the word's ticks have above HAL_EDGE_GAP
 *         loop:  jmp x--, loop
 *                out pins, 6      x + 3 ticks after the edge before
 *
 * When the words run out it waits for the next, and all that follows is so much later: the plan slips. After a pause it
 * is started anew, by the clock (player_fed), so it counts from a known tick.
 *
 * State machine 1 never runs: it executes what the processor tells it, to write the pins by hand. Pins that are active
 * low are turned round behind the machines, at the pads. */
#include "hal/hal.h"
#include "hal/port/ahead.h"
#include "hal/port/cortex.h"
#include "port.h"

#define SLOT(i) ((i) % AHEAD_EDGES)
#define NEVER (1u << 28)      /* ticks: looks again, without need */
#define START_TICKS 64        /* from here to where the state machine is started, at most */
#define RUNNING (1u << 0)     /* of PIO_CTRL: state machine 0 */
#define RESTART (1u << 4)     /* it forgets the word under way */
#define CLOCK_AGAIN (1u << 8) /* its divider begins anew */
#define JOINED (1u << 30)     /* both queues are one, to the machine; changing it empties it */
#define LOOP 1u               /* address */
#define OP_OUT_X 0x6020u
#define OP_OUT_PINS 0x6000u
#define OP_OUT_DIRS 0x6080u
#define OP_JMP_X 0x0040u
#define OP_JMP 0x0000u
#define OP_PULL 0x80a0u
#define PINS 6u

static struct {
    uint32_t sent; /* index of the word behind those that were given to the DMA */
    bool starting; /* the state machine is to be started at: */
    uint32_t start;
} p;

void player_start(void) {
    PIO_INSTR_MEM(0) = OP_OUT_X | (32 - PINS);
    PIO_INSTR_MEM(LOOP) = OP_JMP_X | LOOP;
    PIO_INSTR_MEM(2) = OP_OUT_PINS | PINS;
    PIO_CLKDIV(0) = 8u << 16 | 80u << 8;  /* 8 + 5/16, as the clock */
    PIO_EXECCTRL(0) = 2u << 12;           /* after the third the first */
    PIO_SHIFTCTRL(0) = JOINED | 1u << 17; /* to the left; takes the next word by itself */
    PIO_PINCTRL(0) = PIO_PINCTRL(1) = PINS << 20 | FIRST_PIN;
    PIO_SHIFTCTRL(1) = 3u << 18;
    DMA_WRITE_ADDR = (uint32_t)&PIO_TXF(0);
    DMA_CTRL = 1u | 2u << 2 | 1u << 4 | 11u << 6; /* words, ring of 2 KB, paced by the queue of PIO 0, machine 0 */
    DMA_INTE0 = 1;
    port_write(port_word(PORT_ALL_PINS, 0));
}

void player_drive(void) {
    PIO_TXF(1) = PORT_ALL_PINS;
    PIO_INSTR(1) = OP_PULL;
    PIO_INSTR(1) = OP_OUT_DIRS | PINS;
}

void port_write(port_word_t word) {
    REG(PIO_CTRL + CLR) = RUNNING;
    PIO_TXF(1) = (PIO_PADOUT >> FIRST_PIN & ~word.mask) | (word.value & word.mask);
    PIO_INSTR(1) = OP_PULL;
    PIO_INSTR(1) = OP_OUT_PINS | PINS;
    if (port.inverted == port.invert) return;
    port.inverted = port.invert;
    for (uint32_t i = 0; i < PINS; i++)
        GPIO_CTRL(FIRST_PIN + i) = FUNC_PIO0 | (port.invert >> i & 1u ? OUT_INVERTED : 0);
}

/* Interrupts off. */
void player_refresh(void) {
    ahead.tail = p.sent - DMA_TRANS_COUNT;
}

static void feed(void) {
    if (DMA_CTRL & DMA_BUSY) return;
    const uint32_t n = ahead.head - p.sent;
    if (n == 0) return;
    p.sent += n;
    DMA_TRANS_COUNT_TRIG = n;
}

void player_dma_isr(void) {
    DMA_INTS0 = 1;
    feed();
    player_refresh();
}

/* How long the words last that are under way in the queue. */
static uint32_t left_ticks(void) {
    const uint32_t left = ahead.newest + ahead.skew - port_now();
    return left < 2 * AHEAD_WINDOW && !p.starting ? left : 0;
}

uint32_t player_begin(uint32_t at) {
    if (left_ticks() > START_TICKS) return ahead.newest + ahead.skew; /* goes on behind them */
    while (left_ticks()) continue;
    const uint32_t now = port_now();
    REG(PIO_CTRL + CLR) = RUNNING;
    REG(PIO_CTRL + SET) = RESTART;
    PIO_INSTR(0) = OP_JMP;
    DMA_READ_ADDR = (uint32_t)&ahead.ring[SLOT(ahead.head)];
    p.start = now + START_TICKS;
    p.starting = true;
    const uint32_t from = p.start + 1, late = from + HAL_EDGE_GAP - at;
    if ((int32_t)late > 0) {
        ahead.late++;
        if (late > ahead.latest) ahead.latest = late;
        ahead.skew += late;
    }
    return from;
}

void player_fed(void) {
    const uint32_t state = irq_lock();
    feed();
    if (p.starting) {
        p.starting = false;
        const int32_t late = (int32_t)(port_now() - p.start);
        if (late > 0) ahead.skew += (uint32_t)late;
        const uint32_t from = (p.start + port.phase) << 16;
        while ((int32_t)((PWM_CTR(CLOCK_SLICE) << 16) - from) < 0) continue;
        REG(PIO_CTRL + SET) = CLOCK_AGAIN | RUNNING;
    }
    player_refresh();
    irq_unlock(state);
}

void player_wake(void) {
    const uint32_t state = irq_lock();
    port_alarm(ahead.wake);
    irq_unlock(state);
}

/* The planner's time has come, or nearly. */
void player_isr(void) {
    const uint32_t now = port_now();
    player_refresh();
    if ((int32_t)(ahead.wake - now) <= 32) {
        ahead.wake = now + NEVER;
        pendsv_pend();
    }
    port_alarm(ahead.wake);
}

void player_cut(void) {
    REG(PIO_CTRL + CLR) = RUNNING;
    DMA_ABORT = 1;
    while (DMA_CTRL & DMA_BUSY) continue;
    DMA_INTS0 = 1;
    DMA_TRANS_COUNT = 0;
    PIO_SHIFTCTRL(0) ^= JOINED;
    PIO_SHIFTCTRL(0) ^= JOINED;
    p.sent = ahead.head;
    p.starting = false;
    ahead.newest = port_now() - ahead.skew;
}
