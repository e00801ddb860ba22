/* set_machine.c - set machine: any number of options, each a word and its values, in any order.
 *
 *     steps A[,B]    80       steps per mm of both motors
 *     speed V        100      mm/s with the pen down
 *     travel V       100      mm/s with the pen up
 *     accel A        1000     mm/s^2
 *     junction D     0.01     mm a corner may be cut by, for its speed; 0 stops at every corner
 *     lift S         0.1      s the pen takes to rise
 *     lower S        0.1      s it takes to come down
 *     enable S                s from motors on to the first step
 *     pulse US       2        us a step pulse lasts
 *     setup US       1        us DIR stands before a step
 *     swap, noswap, corexy, cartesian
 *     size W,H|none           mm of reach
 *     pen, limits, home, pulloff, invert: set_wiring.c
 *
 * The whole command is checked before anything changes. */
#include "lang/session_parts.h"

enum kind { NUMBER, STEPS, INVERT, PEN, LIMITS, HOME, PULL_OFF, SWAP, NOSWAP, COREXY, CARTESIAN, SIZE };

typedef struct option {
    const char *pattern;
    enum kind kind;
    int8_t decimals;    /* value * 10^decimals is stored */
    uint32_t lo, hi;    /* limits of what is stored */
    size_t field;       /* in machine_t */
    const char *limits; /* for the message */
} option_t;

#define FIELD(name) offsetof(machine_t, name)
static const option_t options[] = {
    {"st$eps", STEPS, 0, 0, 0, 0, SAID("steps must be between 1 and 10000 per mm")},
    {"sp$eed", NUMBER, 3, 1000, 2000000, FIELD(draw_speed_um_s), SAID("speed must be between 1 and 2000 mm/s")},
    {"tr$avel", NUMBER, 3, 1000, 2000000, FIELD(travel_speed_um_s), SAID("travel must be between 1 and 2000 mm/s")},
    {"acc$el", NUMBER, 3, 1000, 100000000, FIELD(accel_um_s2), SAID("accel must be between 1 and 100000 mm/s^2")},
    {"ju$nction", NUMBER, 3, 0, 10000, FIELD(junction_um), SAID("junction must be between 0 and 10 mm")},
    {"lif$t", NUMBER, 6, 0, 10000000, FIELD(lift_us), SAID("lift must be between 0 and 10 s")},
    {"low$er", NUMBER, 6, 0, 10000000, FIELD(lower_us), SAID("lower must be between 0 and 10 s")},
    {"en$able", NUMBER, 6, 0, 10000000, FIELD(enable_us), SAID("enable must be between 0 and 10 s")},
    {"pu$lse", NUMBER, 3, 100, 1000000, FIELD(pulse_ns), SAID("pulse must be between 0.1 and 1000 us")},
    {"se$tup", NUMBER, 3, 0, 1000000, FIELD(dir_setup_ns), SAID("setup must be between 0 and 1000 us")},
    {"pull$off", PULL_OFF, 3, 500, 50000, 0, SAID("pulloff must be between 0.5 and 50 mm")},
    {"pen", PEN, 0, 0, 0, 0, NULL},
    {"lim$its", LIMITS, 0, 0, 0, 0, NULL},
    {"home", HOME, 0, 0, 0, 0, NULL},
    {"inv$ert", INVERT, 0, 0, 0, 0, NULL},
    {"swap", SWAP, 0, 0, 0, 0, NULL},
    {"noswap", NOSWAP, 0, 0, 0, 0, NULL},
    {"core$xy", COREXY, 0, 0, 0, 0, NULL},
    {"cart$esian", CARTESIAN, 0, 0, 0, 0, NULL},
    {"si$ze", SIZE, 0, 0, 0, 0, SAID("size must be between 10 and 5000 mm")},
};

/* Steps per mm of both motors: 16 fractional bits, so 80.1254 is meant as typed. */
static int steps(session_t *s, lexer_t *lx, machine_t *m, const option_t *o) {
    for (int k = 0; k < 2; k++) {
        lexer_t at = *lx;
        num_t v;
        int err = expr_number(&s->lang, lx, &v, &s->error);
        if (err) return err;
        if (num_cmp(v, num_from_i64(1)) < 0 || num_cmp(v, num_from_i64(10000)) > 0)
            return session_fail(s, &at, ERR_VALUE, o->limits);
        m->steps_per_mm_q16[k] = (uint32_t)num_to_fixed(v, 16, NULL);
        if (k == 0) m->steps_per_mm_q16[1] = m->steps_per_mm_q16[0];
        if (!lexer_accept(lx, ',')) break;
    }
    return 0;
}

static int size(session_t *s, lexer_t *lx, machine_t *m, const option_t *o) {
    if (lexer_is_name(lx, "none")) {
        lexer_next(lx);
        m->width_um = m->height_um = 0;
        return 0;
    }
    int64_t w, h;
    int err = set_scaled(s, lx, 3, 10000, 5000000, &w, o->limits);
    if (err) return err;
    if (!lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "',' and a height expected");
    err = set_scaled(s, lx, 3, 10000, 5000000, &h, o->limits);
    if (err) return err;
    m->width_um = (int32_t)w;
    m->height_um = (int32_t)h;
    return 0;
}

static int apply(session_t *s, lexer_t *lx, machine_t *m, const option_t *o) {
    int64_t v;
    switch (o->kind) {
    case NUMBER: {
        int err = set_scaled(s, lx, o->decimals, o->lo, o->hi, &v, o->limits);
        if (err) return err;
        uint32_t stored = (uint32_t)v;
        memcpy((char *)m + o->field, &stored, sizeof stored);
        return 0;
    }
    case STEPS:
        return steps(s, lx, m, o);
    case INVERT:
        return set_machine_invert(s, lx, m);
    case PULL_OFF: {
        int err = set_scaled(s, lx, o->decimals, o->lo, o->hi, &v, o->limits);
        if (!err) m->pull_off_um = (uint16_t)v;
        return err;
    }
    case PEN:
        return set_machine_pen(s, lx, m);
    case LIMITS:
        return set_machine_limits(s, lx, m);
    case HOME:
        return set_machine_home(s, lx, m);
    case SWAP:
        m->swap_xy = true;
        return 0;
    case NOSWAP:
        m->swap_xy = false;
        return 0;
    case COREXY:
        m->kinematics = MACHINE_COREXY;
        return 0;
    case CARTESIAN:
        m->kinematics = MACHINE_CARTESIAN;
        return 0;
    default:
        return size(s, lx, m, o);
    }
}

/* A board that cannot keep up makes every step, but later, and stands in the midst of a line: what it cannot keep is
 * refused. It is limited by the steps of both motors together. */
static int check_rate(session_t *s, const machine_t *m, int32_t column) {
    if (CONFIG_STEP_ACCEL == 0 && CONFIG_STEP_RATE == 0) return 0;
    uint32_t fine = m->steps_per_mm_q16[0] > m->steps_per_mm_q16[1] ? m->steps_per_mm_q16[0] : m->steps_per_mm_q16[1];
    uint64_t um_s2 = ((uint64_t)CONFIG_STEP_ACCEL * 1000 << 16) / fine;
    if (CONFIG_STEP_ACCEL != 0 && m->accel_um_s2 > um_s2)
        return lang_error_set_number(&s->error, ERR_MACHINE, column,
                                     "accel too high for this board at these steps per mm; most mm/s^2",
                                     (int32_t)(um_s2 / 1000));
    if (CONFIG_STEP_RATE == 0) return 0;
    uint32_t speed = m->draw_speed_um_s > m->travel_speed_um_s ? m->draw_speed_um_s : m->travel_speed_um_s;
    uint64_t um_s = ((uint64_t)CONFIG_STEP_RATE * 1000 << 16) / fine;
    if (m->kinematics == MACHINE_CARTESIAN) um_s = um_s * 1414 / 1000; /* both motors do that only when it goes askew */
    if (speed <= um_s) return 0;
    return lang_error_set_number(&s->error, ERR_MACHINE, column,
                                 "too fast for this board at these steps per mm; most mm/s", (int32_t)(um_s / 1000));
}

int set_machine(session_t *s, lexer_t *lx) {
    int32_t column = lexer_column(lx);
    machine_t m = s->settings.machine;
    if (session_at_end(lx)) return lexer_unexpected(lx, &s->error, "steps, speed, ... expected; try `help machine`");
    while (!session_at_end(lx)) {
        size_t i = 0;
        while (i < sizeof options / sizeof options[0] && !lexer_is_almost(lx, options[i].pattern)) i++;
        if (i == sizeof options / sizeof options[0]) {
            if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "steps, speed, ... expected");
            return lang_error_set_name(&s->error, ERR_NAME, lexer_column(lx), "unknown machine option", lexer_text(lx),
                                       lx->tok.len);
        }
        lexer_next(lx);
        int err = apply(s, lx, &m, &options[i]);
        if (err) return err;
        lexer_accept(lx, ',');
    }
    if (m.home_far && !m.width_um)
        return lang_error_set(&s->error, ERR_MACHINE, column, "home right and home top need the machine's size");
    int err = check_rate(s, &m, column);
    if (!err) s->settings.machine = m;
    return err;
}
