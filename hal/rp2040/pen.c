/* pen.c - a pen that is lifted by a servo or a solenoid: PWM at its pin.
 *
 * Once a millisecond the pen's bit of the pin word, which the step generator and the switches write, is looked at; so
 * neither has to know, and their edges take no longer. The servo's next pulse has the new width: the slice takes it
 * when it wraps around. */
#include "hal/rp2040/port.h"

#define PEN_PIN (FIRST_PIN + 4)
#define SERVO_TOP (20000u - 1)   /* us: 50 pulses a second */
#define SOLENOID_TOP (5320u - 1) /* of 133 MHz: 25 kHz, which nobody hears */
#define TICK_US 1000u
#define INVERT_A (1u << 2)

static struct {
    uint8_t kind;      /* enum hal_pen_kind */
    uint32_t at[2];    /* servo: counts for up and down, q16; solenoid: 0, and to hold */
    uint32_t step_q16; /* servo: counts a tick; 0: all at once */
    uint32_t now_q16;
    uint32_t pull, pulled; /* solenoid: ticks */
} p;

static bool is_down(void) {
    return (port_pins() ^ port.invert) & HAL_PEN;
}

static void servo(bool down) {
    const uint32_t to = p.at[down], now = p.now_q16;
    if (now < to)
        p.now_q16 = p.step_q16 && to - now > p.step_q16 ? now + p.step_q16 : to;
    else
        p.now_q16 = p.step_q16 && now - to > p.step_q16 ? now - p.step_q16 : to;
    PWM_CC(PEN_SLICE) = p.now_q16 >> 16;
}

static void solenoid(bool down) {
    if (!down) p.pulled = 0;
    const bool pulls = down && p.pulled < p.pull;
    if (pulls) p.pulled++;
    PWM_CC(PEN_SLICE) = pulls ? SOLENOID_TOP + 1 : p.at[down];
}

void port_pen_isr(void) {
    TIMER_INTR = PEN_ALARM;
    if (p.kind == HAL_PEN_LEVEL) return;
    TIMER_ALARM2 = TIMER_RAWL + TICK_US;
    if (p.kind == HAL_PEN_SERVO)
        servo(is_down());
    else
        solenoid(is_down());
}

void port_pen_up(void) {
    PWM_CC(PEN_SLICE) = p.kind == HAL_PEN_SERVO ? p.at[false] >> 16 : 0;
}

void port_wire(const hal_wiring_t *w) {
    p.kind = w->pen;
    const bool is_servo = p.kind == HAL_PEN_SERVO;
    p.at[false] = is_servo ? (uint32_t)w->up_us << 16 : 0;
    p.at[true] = is_servo ? (uint32_t)w->down_us << 16 : (SOLENOID_TOP + 1) * w->hold_percent / 100;
    const uint32_t way = p.at[false] < p.at[true] ? p.at[true] - p.at[false] : p.at[false] - p.at[true];
    p.step_q16 = w->glide_ms ? (way + w->glide_ms - 1) / w->glide_ms : 0;
    p.now_q16 = p.at[is_down()];
    p.pull = w->pull_ms;
    p.pulled = 0;
    PWM_CSR(PEN_SLICE) = 0;
    if (p.kind == HAL_PEN_LEVEL) {
        GPIO_CTRL(PEN_PIN) = FUNC_PIO0 | (port.invert & HAL_PEN ? OUT_INVERTED : 0);
    } else {
        PWM_DIV(PEN_SLICE) = (is_servo ? 133u : 1u) << 4;
        PWM_TOP(PEN_SLICE) = is_servo ? SERVO_TOP : SOLENOID_TOP;
        PWM_CTR(PEN_SLICE) = 0;
        PWM_CC(PEN_SLICE) = is_servo ? p.now_q16 >> 16 : 0;
        PWM_CSR(PEN_SLICE) = 1 | (port.invert & HAL_PEN ? INVERT_A : 0);
        GPIO_CTRL(PEN_PIN) = FUNC_PWM;
        irq_enable(PORT_IRQ_PEN);
        TIMER_ALARM2 = TIMER_RAWL + TICK_US;
    }
    player_drive();
}
