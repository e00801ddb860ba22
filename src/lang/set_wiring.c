/* set_wiring.c - the words of `set machine` that tell how the machine is wired.
 *
 *     pen level                       its pin is active while the pen is down
 *     pen servo [UP,DOWN[,S]]         1000,2000,0   us of its pulses; s that the way from one to the other takes
 *     pen solenoid [S[,HOLD]]         0.05,30       s of full power, then percent of it
 *     limits on|homing|off            limit switches stop the machine; are for homing only; there are none
 *     home left|right|bottom|top,...  where the switches are
 *     invert LIST|none                x y xy: which way a motor turns; step enable pen limits estop start: levels
 *
 * `invert` sets the whole list. */
#include "lang/session_parts.h"

/* Which of the words, divided by blanks, the current token is, as a bit; goes on. 0: none of them. */
static uint32_t take_word(lexer_t *lx, const char *words) {
    if (lx->tok.kind != TOKEN_NAME) return 0;
    const char *text = lexer_text(lx);
    for (uint32_t bit = 1; *words; bit <<= 1) {
        size_t n = 0;
        while (words[n] && words[n] != ' ') n++;
        if (n == lx->tok.len && memcmp(words, text, n) == 0) {
            lexer_next(lx);
            return bit;
        }
        words += n + (words[n] == ' ');
    }
    return 0;
}

static void add_words(text_t *t, uint32_t bits, const char *words) {
    for (bool first = true; *words; bits >>= 1) {
        size_t n = 0;
        while (words[n] && words[n] != ' ') n++;
        if (bits & 1) {
            if (!first) text_add(t, ",");
            text_add_bytes(t, words, n);
            first = false;
        }
        words += n + (words[n] == ' ');
    }
}

#define PENS "level servo solenoid"
#define LIMITS "on homing off"
#define CORNERS "left right bottom top"
#define INVERTED "x y step enable pen limits estop start xy none"
enum {
    INV_X = 1,
    INV_Y = 2,
    INV_STEP = 4,
    INV_ENABLE = 8,
    INV_PEN = 16,
    INV_LIMITS = 32,
    INV_ESTOP = 64,
    INV_START = 128
};
enum { INV_XY = 256, INV_NONE = 512 };

/* A number follows, and not the next option. */
static bool has_number(const lexer_t *lx) {
    return !session_at_end(lx) && lx->tok.kind != TOKEN_NAME;
}

#if CONFIG_PEN_SERVO
static int servo(session_t *s, lexer_t *lx, hal_wiring_t *w) {
    static const char range[] = "servo pulses must be between 500 and 2500 us";
    if (!has_number(lx)) return 0;
    int64_t up, down, glide = 0;
    int err = set_scaled(s, lx, 0, 500, 2500, &up, range);
    if (err) return err;
    if (!lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "',' and the width for down expected");
    err = set_scaled(s, lx, 0, 500, 2500, &down, range);
    if (!err && lexer_accept(lx, ',') && has_number(lx))
        err = set_scaled(s, lx, 3, 0, 10000, &glide, "the servo's time must be between 0 and 10 s");
    w->up_us = (uint16_t)up;
    w->down_us = (uint16_t)down;
    w->glide_ms = (uint16_t)glide;
    return err;
}
#endif

static int solenoid(session_t *s, lexer_t *lx, hal_wiring_t *w) {
    if (!has_number(lx)) return 0;
    int64_t pull, hold = w->hold_percent;
    int err = set_scaled(s, lx, 3, 1, 10000, &pull, "a solenoid pulls between 0.001 and 10 s");
    if (!err && lexer_accept(lx, ',') && has_number(lx))
        err = set_scaled(s, lx, 0, 1, 100, &hold, "a solenoid holds with 1 to 100 percent");
    w->pull_ms = (uint16_t)pull;
    w->hold_percent = (uint8_t)hold;
    return err;
}

int set_machine_pen(session_t *s, lexer_t *lx, machine_t *m) {
    lexer_t at = *lx;
    uint32_t kind = take_word(lx, PENS) >> 1;
    if (kind == 0 && !lexer_is_name(&at, "level"))
        return lexer_unexpected(&at, &s->error,
                                CONFIG_PEN_SERVO ? "level, servo or solenoid expected" : "level or solenoid expected");
    m->wiring.pen = (uint8_t)kind;
    if (kind == HAL_PEN_LEVEL) return 0;
    if (kind == HAL_PEN_SOLENOID) return solenoid(s, lx, &m->wiring);
#if CONFIG_PEN_SERVO
    return servo(s, lx, &m->wiring);
#else
    return session_fail(s, &at, ERR_MACHINE, "this board has no PWM for a servo");
#endif
}

int set_machine_limits(session_t *s, lexer_t *lx, machine_t *m) {
    uint32_t word = take_word(lx, LIMITS);
    if (!word) return lexer_unexpected(lx, &s->error, "on, homing or off expected");
    m->limits = (uint8_t)(word >> 1);
    return 0;
}

int set_machine_home(session_t *s, lexer_t *lx, machine_t *m) {
    uint32_t word = take_word(lx, CORNERS);
    if (!word) return lexer_unexpected(lx, &s->error, "left, right, bottom or top expected");
    for (;;) {
        const uint32_t axis = word >= 4 ? 2 : 1;
        m->home_far = (uint8_t)((m->home_far & ~axis) | (word & 10 ? axis : 0));
        lexer_t at = *lx;
        if (!lexer_accept(lx, ',') || !(word = take_word(lx, CORNERS))) {
            *lx = at;
            return 0;
        }
    }
}

/* After a comma `enable` and `pen` may as well be the next option. */
static bool is_option(const lexer_t *lx) {
    lexer_t next = *lx;
    lexer_next(&next);
    if (lexer_is_name(lx, "pen")) return take_word(&next, PENS);
    return lexer_is_name(lx, "enable") && has_number(&next) && next.tok.kind != ',';
}

int set_machine_invert(session_t *s, lexer_t *lx, machine_t *m) {
    uint32_t all = 0, word = take_word(lx, INVERTED);
    if (!word) return lexer_unexpected(lx, &s->error, "x, y, step, enable, pen, limits, estop, start or none expected");
    while (word) {
        all |= word;
        lexer_t at = *lx;
        word = lexer_accept(lx, ',') && !is_option(lx) ? take_word(lx, INVERTED) : 0;
        if (!word) *lx = at;
    }
    hal_wiring_t *w = &m->wiring;
    m->invert[0] = all & (INV_X | INV_XY);
    m->invert[1] = all & (INV_Y | INV_XY);
    w->invert_pins = (uint8_t)((all & INV_STEP ? HAL_X_STEP | HAL_Y_STEP : 0) | (all & INV_ENABLE ? HAL_ENABLE : 0) |
                               (all & INV_PEN ? HAL_PEN : 0));
    w->invert_inputs = (uint8_t)((all & INV_LIMITS ? HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y : 0) |
                                 (all & INV_ESTOP ? HAL_IN_ESTOP : 0) | (all & INV_START ? HAL_IN_BUTTON : 0));
    return 0;
}

static void add_scaled(text_t *t, const char *before, int64_t v, int decimals) {
    text_add(t, before);
    text_add_scaled(t, v, decimals);
}

void show_wiring(const machine_t *m, text_t *t) {
    const hal_wiring_t *w = &m->wiring;
    uint32_t turned = (m->invert[0] ? INV_X : 0u) | (m->invert[1] ? INV_Y : 0u);
    if (w->invert_pins & HAL_X_STEP) turned |= INV_STEP;
    if (w->invert_pins & HAL_ENABLE) turned |= INV_ENABLE;
    if (w->invert_pins & HAL_PEN) turned |= INV_PEN;
    if (w->invert_inputs & HAL_IN_LIMIT_X) turned |= INV_LIMITS;
    if (w->invert_inputs & HAL_IN_ESTOP) turned |= INV_ESTOP;
    if (w->invert_inputs & HAL_IN_BUTTON) turned |= INV_START;
    text_add(t, "set machine pen ");
    add_words(t, 1u << w->pen, PENS);
    if (w->pen == HAL_PEN_SERVO) {
        add_scaled(t, " ", w->up_us, 0);
        add_scaled(t, ",", w->down_us, 0);
        add_scaled(t, ",", w->glide_ms, 3);
    }
    if (w->pen == HAL_PEN_SOLENOID) {
        add_scaled(t, " ", w->pull_ms, 3);
        add_scaled(t, ",", w->hold_percent, 0);
    }
    text_add(t, " limits ");
    add_words(t, 1u << m->limits, LIMITS);
    text_add(t, m->home_far & 1 ? " home right" : " home left");
    text_add(t, m->home_far & 2 ? ",top" : ",bottom");
    add_scaled(t, " pulloff ", m->pull_off_um, 3);
    text_add(t, " invert ");
    add_words(t, turned ? turned : INV_NONE, INVERTED);
    text_add(t, "\n");
}
