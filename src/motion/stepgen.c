/* stepgen.c - the interrupt's body; see stepgen.h.
 *
 *     stepgen_isr: serve -> take -> pulses -> next_deadline -+-> a port that plays edges by itself has room: go on
 *                    ^                                       |
 *                    +---------------------------------------+-> else: arm it
 *
 * `pulses` is the short way through steps and nothing else, a few dozen instructions an edge; whatever else happens
 * takes the long way round, edge by edge. Both come to the same edges. Where a port plays none ahead, and so on the
 * simulator, all go the long way.
 *
 * Time in the interrupt is `g.now`, the tick that was armed, not the tick at which the port got round to it: a latency
 * of less than g.slack moves single edges but never the plan. Times are compared by the sign of their difference, so
 * the clock may wrap; pieces are shorter than 2^30 ticks.
 *
 * Each motor has at most one deadline: the end of its pulse while it is high, else its next step, and before it the
 * change of DIR if the step is the first of another direction.
 *
 * What comes from the main loop takes effect on a grid of GRID_TICKS since the motion began, or since it was parked;
 * the next motion begins on it, too. What the pins do then depends on the plan alone, and not on when the main loop got
 * round to asking. */
#include "motion/stepgen.h"
#include "hal/hal.h"

#define LEAD_TICKS 2000 /* from starting to the first piece: longer than it takes to get there */
#define EARLY_TICKS 16  /* called earlier than this before the deadline: stepgen_hold() armed the timer */
#define SLICE_TICKS (HAL_TICK_HZ / 2000) /* the speed is constant so long while time is stretched */
#define SLICE (SLICE_TICKS / STEPGEN_SPEED_TICKS)
#define GRID_TICKS 32768u             /* 2 ms */
#define NEAR_TICKS (HAL_EDGE_GAP - 1) /* what is due so soon after an edge goes with it */
#define FAR_TICKS 0x40000000u
#define SETUP_MORE (HAL_TICK_HZ / 1000000) /* DIR is written so much earlier than it has to be */
#define ONE_Q16 (1u << 16)
#define NEVER INT32_MAX

/* What is used most comes first: a Cortex-M0 reaches bytes up to 31 and words up to 124 bytes into a structure. */
typedef struct motor {
    bool high;
    bool turn;         /* DIR must change before the next step */
    bool forward;      /* of the steps to come */
    uint32_t left;     /* pulses of this piece still to begin */
    uint64_t next_q32; /* tick of the next pulse */
    uint64_t interval_q32;
    int64_t add_q32;
    uint32_t fall; /* tick at which the pulse ends */
    int32_t goal;  /* position after this piece */
} motor_t;

static struct {
    bool next_known;
    bool set_pins; /* to be written at set_at */
    bool rest;
    bool running; /* written by the main loop only while it is false */
    bool halted;
    /* Hold and resume. */
    bool want_hold; /* written by the main loop only */
    bool stop;      /* when held, halt: written by the main loop only */
    bool hold;      /* the motion is being held */
    bool asked;     /* hold will follow want_hold at asked_at */
    bool stretched; /* time runs slower than planned */
    bool parked;    /* stretched for ever, and no deadline is armed */
    int8_t slope;
    uint8_t pins; /* pen and enable of the taken piece */
    uint32_t pulse, setup, slack;
    motor_t motor[2];
    /* Edges. */
    uint32_t now;   /* the armed deadline */
    uint32_t level; /* of all pins, after the newest */
    uint32_t edge;  /* when that was */
    hal_edges_t ahead;
    uint32_t made; /* of ahead.room */
    uint32_t first;
    uint32_t next; /* deadline, if known */
    stepgen_piece_t *queue;
    uint32_t mask;
    uint32_t head;  /* next slot to fill: written by the main loop only */
    uint32_t tail;  /* next slot to take: written by the interrupt only */
    uint32_t end;   /* where the taken piece ends and the next begins */
    uint32_t begun; /* when the motion, or the one before, began: the grid's origin */
    uint32_t set_at;
    uint32_t speed; /* of the taken piece at its end */
    uint32_t asked_at;
    uint32_t pace; /* speed at the end of the slice, as speed is */
    uint32_t slice_end;
    uint32_t rate_q16, stretch_q16; /* planned time per time, and its inverse */
    uint32_t starved, late;
} g;

static const uint8_t STEP_PIN[2] = {HAL_X_STEP, HAL_Y_STEP};
static const uint8_t DIR_PIN[2] = {HAL_X_DIR, HAL_Y_DIR};

/* All pins, from g.now on. */
static inline void put(uint32_t level) {
    if (g.made < g.ahead.room) {
        if (g.made == 0) g.first = g.now;
        g.ahead.word[g.made++] = hal_edge(level, g.now - g.edge);
    } else {
        hal_pins_write(level ^ g.level, level);
    }
    g.level = level;
    g.edge = g.now;
}

/* When the motor is next wanted, if it is. */
static inline bool motor_due(const motor_t *a, uint32_t *at) {
    if (a->high)
        *at = a->fall;
    else if (a->left)
        *at = (uint32_t)(a->next_q32 >> 32) - (a->turn ? g.setup : 0);
    return a->high || a->left;
}

static inline void begin_pulse(motor_t *a, uint32_t now) {
    a->high = true;
    a->fall = now + g.pulse;
    a->left--;
    a->next_q32 += a->interval_q32;
    a->interval_q32 += (uint64_t)a->add_q32;
}

/* Begins or ends the motor's pulse, or turns it round, if that is due by `near`; a turn by `turn`. */
static uint32_t run_motor(int m, uint32_t level, uint32_t near, uint32_t turn, uint32_t actual) {
    motor_t *a = &g.motor[m];
    uint32_t at = 0;
    if (!motor_due(a, &at) || hal_before(a->turn && !a->high ? turn : near, at)) return level;
    if (a->high) {
        a->high = false;
        return level & ~STEP_PIN[m];
    }
    if (a->turn) {
        a->turn = false;
        return a->forward ? level | DIR_PIN[m] : level & ~DIR_PIN[m];
    }
    begin_pulse(a, actual);
    return level | STEP_PIN[m];
}

/* What is due at g.now, and if there is something, what comes right after it. Motors that turn round at about the same
 * time do so together: what counts is that DIR stands before the step. */
static inline void serve(uint32_t actual) {
    uint32_t at = 0, level = g.level;
    bool due = g.set_pins && !hal_before(g.now, g.set_at), turns = false;
    for (int m = 0; m < 2; m++) {
        const motor_t *a = &g.motor[m];
        if (!motor_due(a, &at) || hal_before(g.now, at)) continue;
        due = true;
        turns |= a->turn && !a->high;
    }
    if (!due) return;
    const uint32_t near = g.now + NEAR_TICKS, turn = turns ? g.now + g.setup : near;
    level = run_motor(0, level, near, turn, actual);
    level = run_motor(1, level, near, turn, actual);
    if (g.set_pins && !hal_before(near, g.set_at)) {
        g.set_pins = false;
        level = (level & ~(uint32_t)(HAL_PEN | HAL_ENABLE)) | g.pins;
    }
    if (level != g.level) put(level);
}

static inline void take_axis(int m, const stepgen_axis_piece_t *p) {
    motor_t *a = &g.motor[m];
    if (p->count == 0) return;
    a->left = p->count;
    a->goal += p->forward ? (int32_t)p->count : -(int32_t)p->count;
    a->next_q32 = ((uint64_t)g.end << 32) + p->first_q32;
    a->interval_q32 = p->interval_q32;
    a->add_q32 = p->add_q32;
    a->turn = p->forward != (bool)(g.level & DIR_PIN[m]);
    a->forward = p->forward;
}

/* Takes the next piece, if there is one. */
static bool take(void) {
    uint32_t tail = g.tail;
    if (tail == __atomic_load_n(&g.head, __ATOMIC_ACQUIRE)) return false;
    const stepgen_piece_t *p = &g.queue[tail & g.mask];
    if (p->set_pins) {
        g.set_pins = true;
        g.set_at = g.end;
        g.pins = p->pins;
    }
    take_axis(0, &p->axis[0]);
    take_axis(1, &p->axis[1]);
    g.rest = p->rest;
    g.speed = p->speed;
    g.slope = p->slope;
    g.end += p->length;
    __atomic_store_n(&g.tail, tail + 1, __ATOMIC_RELEASE);
    return true;
}

static inline bool piece_done(void) {
    return !g.motor[0].left && !g.motor[1].left && !g.set_pins;
}

/* A piece is taken as soon as its predecessor has nothing more to do. */
static void take_due(void) {
    while (piece_done() && take()) continue;
}

static inline int32_t earlier(int32_t best, uint32_t at) {
    int32_t in = (int32_t)(at - g.now);
    return in < best ? in : best;
}

/* Puts off what the plan has still to come. */
static void put_off(uint32_t ticks) {
    g.motor[0].next_q32 += (uint64_t)ticks << 32;
    g.motor[1].next_q32 += (uint64_t)ticks << 32;
    g.set_at += ticks;
    g.end += ticks;
}

static void slip(uint32_t late) {
    put_off(late);
    g.motor[0].fall += late;
    g.motor[1].fall += late;
    g.slice_end += late;
    g.asked_at += late;
    g.begun += late;
    g.edge += late;
    g.now += late;
    g.late++;
}

/* How fast the plan is now. The taken piece may begin a little later: its law is then followed backwards. */
static uint32_t planned_speed(void) {
    int32_t left = (int32_t)(g.end - g.now) / STEPGEN_SPEED_TICKS;
    int32_t speed = (int32_t)g.speed - g.slope * left;
    return speed > 0 ? (uint32_t)speed : 0;
}

/* speed / planned, for speed < planned; both are cut to 16 bits first. */
static uint32_t ratio_q16(uint32_t speed, uint32_t planned) {
    while (planned >= ONE_Q16) {
        planned >>= 1;
        speed >>= 1;
    }
    uint32_t q16 = (speed << 16) / planned;
    return q16 ? q16 : 1;
}

/* The speed of the next slice: that of its middle. Ends stretching when the plan's speed has been reached; false when
 * it is standstill. */
static bool next_slice(void) {
    uint32_t planned = planned_speed();
    if (!g.stretched || g.pace > planned) g.pace = planned;
    g.stretched = true;
    g.slice_end = g.now + SLICE_TICKS;
    uint32_t middle = g.pace + SLICE / 2;
    if (g.hold) {
        if (g.pace <= SLICE / 2) {
            g.slice_end = g.now; /* and look again when the last pulse has ended */
            return false;
        }
        middle = g.pace - SLICE / 2;
        g.pace = g.pace > SLICE ? g.pace - SLICE : 0;
    } else {
        g.pace += SLICE;
        if (middle >= planned) g.stretched = false;
    }
    if (g.stretched) {
        g.rate_q16 = ratio_q16(middle, planned);
        g.stretch_q16 = UINT32_MAX / g.rate_q16;
    }
    return true;
}

/* Ticks until `g.hold` has to change, which is done here when they are over. */
static int32_t follow_hold(void) {
    if (__atomic_load_n(&g.want_hold, __ATOMIC_ACQUIRE) == g.hold) {
        g.asked = false;
        return NEVER;
    }
    if (!g.asked) {
        g.asked = true;
        g.asked_at = g.now + (GRID_TICKS - (g.now - g.begun)) % GRID_TICKS;
    }
    int32_t in = (int32_t)(g.asked_at - g.now);
    if (in > 0) return in;
    g.hold = !g.hold;
    g.asked = false;
    return NEVER;
}

/* When the interrupt is next wanted, if pulses end after `fall`, the plan goes on after `plan` ticks of its own, and it
 * is wanted after `ask` in any case. */
static int32_t stretched(int32_t fall, int32_t plan, int32_t ask) {
    if (!g.stretched || !hal_before(g.now, g.slice_end)) {
        if (!next_slice()) return fall;
        if (!g.stretched) return plan < fall ? plan : fall;
    }
    uint32_t in = g.slice_end - g.now;
    if (fall < (int32_t)in) in = fall < 0 ? 0 : (uint32_t)fall;
    if (ask < (int32_t)in) in = (uint32_t)ask;
    uint32_t planned = plan < 0 ? 0 : (uint32_t)plan;
    uint64_t then = ((uint64_t)planned * g.stretch_q16) >> 16;
    if (plan != NEVER && then <= in) {
        put_off((uint32_t)then - planned);
        return (int32_t)then;
    }
    put_off(in - (uint32_t)(((uint64_t)in * g.rate_q16) >> 16));
    return (int32_t)in;
}

static void stop_running(void) {
    __atomic_store_n(&g.running, false, __ATOMIC_RELEASE);
}

/* All that must not go on. */
static uint32_t halt(bool motors_on) {
    g.halted = true;
    g.set_pins = g.hold = g.want_hold = g.stop = g.asked = g.stretched = g.parked = false;
    g.pins = motors_on ? g.pins & HAL_ENABLE : 0;
    g.tail = g.head;
    stop_running();
    return g.level & ~(uint32_t)(HAL_X_STEP | HAL_Y_STEP | HAL_PEN | (motors_on ? 0 : HAL_ENABLE));
}

/* ---- the short way ---- */

/* Nothing but steps is under way, and time runs as planned. */
static inline bool is_plain(void) {
    const bool want = __atomic_load_n(&g.want_hold, __ATOMIC_ACQUIRE);
    if (want == g.hold) g.asked = false;
    return !g.hold && !g.stretched && !g.set_pins && (!want || g.asked);
}

static inline uint32_t earlier_of(uint32_t a, uint32_t b) {
    return hal_before(b, a) ? b : a;
}

static inline uint32_t pulse_at(const motor_t *a, uint32_t otherwise) {
    return a->high ? a->fall : a->left ? (uint32_t)(a->next_q32 >> 32) : otherwise;
}

/* The other end of the pulse; when the motor is wanted then. */
static inline uint32_t toggle(motor_t *a, uint32_t now, uint32_t far) {
    if (a->high) {
        a->high = false;
        return a->left ? (uint32_t)(a->next_q32 >> 32) : far;
    }
    begin_pulse(a, now);
    return a->fall;
}

/* Time is stretched, for the rest of the slice evenly, and nothing else but steps is under way. */
static inline bool is_slowed(void) {
    for (int m = 0; m < 2; m++)
        if (g.motor[m].left && g.motor[m].turn) return false;
    return g.stretched && !g.set_pins && g.now == g.edge && hal_before(g.now, g.slice_end) &&
           __atomic_load_n(&g.want_hold, __ATOMIC_ACQUIRE) == g.hold;
}

/* Ticks to the next deadline of pulses while time is stretched, plus one, as stretched() has it, and what the plan is
 * put off by. 0: it is not one of them, or beyond the slice. */
static inline uint32_t slowed(const motor_t *x, const motor_t *y, uint32_t now, uint32_t *off) {
    int32_t fall = NEVER, plan = NEVER;
    for (int m = 0; m < 2; m++) {
        const motor_t *a = m ? y : x;
        const int32_t in = (int32_t)((a->high ? a->fall : (uint32_t)(a->next_q32 >> 32)) - now);
        if (a->high)
            fall = in < fall ? in : fall;
        else if (a->left)
            plan = in < plan ? in : plan;
    }
    if (fall < 0 || plan < 0) return 0;
    const uint32_t slice = g.slice_end - now;
    uint32_t in = (uint32_t)fall < slice ? (uint32_t)fall : slice;
    const uint32_t planned = (uint32_t)plan;
    if (planned <= in) { /* stretching makes it no shorter; a slice has less than 2^13 ticks */
        const uint32_t then = g.stretch_q16 < 0x80000 ? (planned * g.stretch_q16) >> 16
                                                      : (uint32_t)(((uint64_t)planned * g.stretch_q16) >> 16);
        if (then <= in) {
            *off = then - planned;
            return then < slice ? then + 1 : 0;
        }
    }
    if (in == slice) return 0;
    *off = in - ((in * g.rate_q16) >> 16);
    return in + 1;
}

/* Up to when all deadlines are pulses, if there are others. */
static inline bool plain_until(const motor_t *a, uint32_t *until) {
    if (!a->turn || !a->left) return false;
    *until = earlier_of(*until, (uint32_t)(a->next_q32 >> 32) - g.setup - NEAR_TICKS);
    return true;
}

/* The other end of the motor's pulse: when it is wanted then. Whether a pulse is under way is seen in the level. */
static inline uint32_t toggle_plain(motor_t *a, bool high, uint32_t now, uint32_t far) {
    if (high) return a->left ? (uint32_t)(a->next_q32 >> 32) : far;
    a->left--;
    a->next_q32 += a->interval_q32;
    a->interval_q32 += (uint64_t)a->add_q32;
    return a->fall = now + g.pulse;
}

/* Pulses of the taken piece, to its last or as long as there is room for what they do to the pins. Both motors' next
 * deadlines stay in registers. The first comes after g.now, or is it: at_once. False: there was none. */
static bool plain_pulses(bool at_once) {
    motor_t *const x = &g.motor[0], *const y = &g.motor[1];
    const uint32_t far = g.now + FAR_TICKS;
    uint32_t x_at = pulse_at(x, far), y_at = pulse_at(y, far), edge = g.edge, level = g.level, until = g.ahead.until;
    const uint32_t first = earlier_of(x_at, y_at);
    if (at_once && first != g.now) return false;
    bool turns = plain_until(x, &until);
    turns |= plain_until(y, &until);
    if (g.asked) until = earlier_of(until, g.asked_at);
    uint32_t *const from = &g.ahead.word[g.made], *word = from;
    const uint32_t *end = x->left | y->left ? &g.ahead.word[g.ahead.room - 1] : word + 1;
    while (word < end) {
        const int32_t y_later = (int32_t)(y_at - x_at);
        const uint32_t now = y_later < 0 ? y_at : x_at, ticks = now - edge;
        if (!hal_before(now, until) || (int32_t)ticks < (int32_t)HAL_EDGE_GAP) break;
        edge = now;
        if (y_later >= -(int32_t)NEAR_TICKS) {
            x_at = toggle_plain(x, level & HAL_X_STEP, now, far);
            level ^= HAL_X_STEP;
        }
        if (y_later <= (int32_t)NEAR_TICKS) {
            y_at = toggle_plain(y, level & HAL_Y_STEP, now, far);
            level ^= HAL_Y_STEP;
        }
        *word++ = hal_edge(level, ticks);
        if (!(x->left | y->left)) break;
    }
    if (word == from) return false;
    x->high = level & HAL_X_STEP;
    y->high = level & HAL_Y_STEP;
    if (g.made == 0) g.first = first;
    g.made += (uint32_t)(word - from);
    g.now = g.edge = edge;
    g.level = level;
    g.next = earlier_of(x_at, y_at);
    g.next_known = !turns && (x->left | y->left);
    return true;
}

static inline void toggle_slowed(motor_t *a, uint32_t step, uint32_t now) {
    if (hal_before(now + NEAR_TICKS, pulse_at(a, now + FAR_TICKS))) return;
    g.level ^= step;
    (void)toggle(a, now, 0);
}

/* The same in a slice of stretched time. */
static bool slowed_pulses(void) {
    motor_t *const x = &g.motor[0], *const y = &g.motor[1];
    const uint32_t made = g.made;
    while (g.made + 1 < g.ahead.room && (x->left | y->left)) {
        uint32_t off, in = slowed(x, y, g.now, &off);
        if (in-- == 0) break;
        if (in < HAL_EDGE_GAP) in = HAL_EDGE_GAP;
        const uint32_t now = g.now + in;
        if (!hal_before(now, g.ahead.until)) break;
        put_off(off);
        toggle_slowed(x, HAL_X_STEP, now);
        toggle_slowed(y, HAL_Y_STEP, now);
        if (g.made == 0) g.first = now;
        g.ahead.word[g.made++] = hal_edge(g.level, in);
        g.now = g.edge = now;
    }
    return g.made != made;
}

/* From g.now on, through what is left of the piece and those behind it. at_once: what is due at g.now has not been
 * done. False: it led nowhere. */
static bool short_way(bool at_once) {
    bool any = false;
    g.next_known = false;
    while (g.made + 1 < g.ahead.room) {
        const bool plain = is_plain();
        if (!plain && (at_once || !is_slowed())) break;
        if (!(plain ? plain_pulses(at_once) : slowed_pulses())) break;
        at_once = false;
        any = true;
        if (!piece_done()) break;
        g.next_known = false;
        take_due();
    }
    return any;
}

/* The deadline that follows, where the short way came by it and nothing is asked for. */
static bool next_pulse(void) {
    if (!g.next_known || g.asked || __atomic_load_n(&g.want_hold, __ATOMIC_ACQUIRE) != g.hold) return false;
    if ((int32_t)(g.next - g.edge) < (int32_t)HAL_EDGE_GAP) return false;
    g.now = g.next;
    return true;
}

/* ---- the long way ---- */

/* The deadline that follows, in g.now. False if there is none: at the end, and when held. */
static bool next_deadline(void) {
    int32_t fall = NEVER, plan = NEVER, turn = NEVER;
    for (int m = 0; m < 2; m++) {
        const motor_t *a = &g.motor[m];
        if (a->high)
            fall = earlier(fall, a->fall);
        else if (a->left && a->turn)
            turn = earlier(turn, (uint32_t)(a->next_q32 >> 32) - g.setup);
        else if (a->left)
            plan = earlier(plan, (uint32_t)(a->next_q32 >> 32));
    }
    if (turn != NEVER) plan = earlier(plan, g.now + (uint32_t)(turn > 0 ? turn : 0)); /* taken late: at once */
    if (g.set_pins) plan = earlier(plan, g.set_at);
    if (fall == NEVER && plan == NEVER) {
        if (!hal_before(g.now, g.end)) { /* ran dry */
            if (!g.rest || (g.pins & HAL_PEN)) g.starved++;
            g.stretched = false;
            stop_running();
            return false;
        }
        plan = earlier(plan, g.end); /* look again when the piece is over */
    }
    int32_t in = plan < fall ? plan : fall, ask = follow_hold();
    if (g.hold || g.stretched) in = stretched(fall, plan, ask);
    if (in == NEVER) { /* held */
        if (g.stop)
            put(halt(true));
        else
            __atomic_store_n(&g.parked, true, __ATOMIC_RELEASE);
        return false;
    }
    if (ask < in) in = ask;
    if (in < 0) { /* planned for a time that had gone by when its piece was taken */
        g.late++;
        in = 0;
    }
    const int32_t since = (int32_t)(g.now - g.edge);
    if (since >= 0 && in < (int32_t)HAL_EDGE_GAP - since) in = (int32_t)HAL_EDGE_GAP - since;
    g.now += (uint32_t)in;
    return true;
}

void stepgen_isr(void) {
    uint32_t actual = hal_now();
    if (!g.running || g.parked) return; /* halted, or only woken */
    if ((int32_t)(actual - g.now) > (int32_t)g.slack) slip(actual - g.now);
    if ((int32_t)(g.now - actual) > EARLY_TICKS) {
        if (g.stretched) { /* it would have come soon enough, and the plan has been put off up to then */
            hal_timer_arm(g.now);
            return;
        }
        g.now = actual;
    }
    g.ahead = hal_edges();
    g.made = 0;
    bool more;
    do {
        if (actual != g.now || !short_way(true)) {
            serve(actual);
            take_due();
            (void)short_way(false);
        }
        more = next_pulse() || next_deadline();
        actual = g.now;
    } while (more && g.made + 1 < g.ahead.room && hal_before(g.now, g.ahead.until));
    if (g.made) hal_edges_put(g.made, g.first, g.edge);
    if (more) hal_timer_arm(g.now);
}

void stepgen_init(stepgen_piece_t *queue, uint32_t slots, uint32_t pulse_ticks, uint32_t setup_ticks) {
    hal_timer_cancel();
    /* Of motors that are on, DIR is as it was: a halt may have come between deciding and writing. */
    g.level = g.pins & HAL_ENABLE ? g.level & (HAL_X_DIR | HAL_Y_DIR | HAL_ENABLE) : 0;
    hal_pins_write(HAL_X_STEP | HAL_Y_STEP | HAL_X_DIR | HAL_Y_DIR | HAL_PEN, g.level);
    if (!(g.pins & HAL_ENABLE)) g.begun = 0;
    for (int m = 0; m < 2; m++) g.motor[m] = (motor_t){.forward = g.level & DIR_PIN[m]};
    g.queue = queue;
    g.mask = slots - 1;
    g.head = g.tail = 0;
    g.pulse = pulse_ticks + NEAR_TICKS; /* it may end so much sooner */
    g.setup = setup_ticks + SETUP_MORE;
    g.slack = pulse_ticks / 2;
    g.set_pins = g.running = g.halted = false;
    g.hold = g.want_hold = g.stop = g.asked = g.stretched = g.parked = false;
    g.speed = 0;
    g.slope = 0;
    g.pins = 0;
    g.rest = true;
    g.starved = g.late = 0;
}

stepgen_piece_t *stepgen_slot(void) {
    uint32_t head = g.head;
    if (g.halted) g.tail = head; /* nobody else writes it then */
    if (head - __atomic_load_n(&g.tail, __ATOMIC_ACQUIRE) > g.mask) return 0;
    return &g.queue[head & g.mask];
}

void stepgen_push(void) {
    __atomic_store_n(&g.head, g.head + 1, __ATOMIC_RELEASE);
}

void stepgen_start(void) {
    if (g.halted || g.want_hold || __atomic_load_n(&g.running, __ATOMIC_ACQUIRE) || g.head == g.tail) return;
    g.running = true;
    g.hold = g.asked = false;
    uint32_t now = hal_now() + LEAD_TICKS;
    now += (GRID_TICKS - (now - g.begun)) % GRID_TICKS;
    g.now = g.end = g.begun = now;
    g.edge = now - HAL_EDGE_GAP;
    hal_timer_arm(g.now);
}

void stepgen_wake(uint32_t ticks) {
    if (__atomic_load_n(&g.running, __ATOMIC_ACQUIRE) && !__atomic_load_n(&g.parked, __ATOMIC_ACQUIRE)) return;
    hal_timer_arm(hal_now() + ticks);
}

uint32_t stepgen_room(void) {
    uint32_t used = g.head - __atomic_load_n(&g.tail, __ATOMIC_ACQUIRE);
    return g.mask + 1 - (g.halted ? 0 : used);
}

bool stepgen_idle(void) {
    return g.halted || (!__atomic_load_n(&g.running, __ATOMIC_ACQUIRE) && g.head == g.tail && hal_edges_left());
}
/* The interrupt may take a piece in between: again, then. */
int32_t stepgen_position(int motor) {
    const motor_t *a = &g.motor[motor];
    for (;;) {
        const int32_t goal = __atomic_load_n(&a->goal, __ATOMIC_ACQUIRE);
        const int32_t left = (int32_t)__atomic_load_n(&a->left, __ATOMIC_ACQUIRE);
        const bool forward = __atomic_load_n(&a->forward, __ATOMIC_ACQUIRE);
        if (goal == __atomic_load_n(&a->goal, __ATOMIC_ACQUIRE)) return forward ? goal - left : goal + left;
    }
}
uint32_t stepgen_starved(void) {
    return g.starved;
}
uint32_t stepgen_late(void) {
    return g.late;
}

bool stepgen_pen_down(void) {
    return g.pins & HAL_PEN;
}

void stepgen_set_pins(uint32_t mask, uint32_t value) {
    g.level = (g.level & ~mask) | (value & mask);
    g.pins = (uint8_t)(g.level & (HAL_PEN | HAL_ENABLE));
    hal_pins_write(mask, value);
}

void stepgen_set_position(int motor, int32_t steps) {
    g.motor[motor].goal = steps;
}

/* A point of the grid that began when the machine was parked. */
static void unpark(void) {
    uint32_t now = hal_now() + LEAD_TICKS;
    now += (GRID_TICKS - (now - g.now)) % GRID_TICKS;
    g.parked = false;
    put_off(now - g.now);
    g.now = g.slice_end = g.begun = now;
    g.edge = now - HAL_EDGE_GAP;
    hal_timer_arm(now);
}

/* The interrupt sees what is wanted at its next deadline, and while time is stretched every half millisecond. A
 * deadline that is farther away than that is brought forward. */
static void want(bool hold) {
    if (g.want_hold == hold) return;
    __atomic_store_n(&g.want_hold, hold, __ATOMIC_SEQ_CST);
    uint32_t now = hal_now();
    if (__atomic_load_n(&g.running, __ATOMIC_ACQUIRE) && hal_before(now + SLICE_TICKS, g.now)) hal_timer_arm(now);
}

void stepgen_hold(void) {
    want(true);
}

void stepgen_stop(void) {
    g.stop = true;
    if (__atomic_load_n(&g.parked, __ATOMIC_ACQUIRE))
        unpark();
    else
        want(true);
}

void stepgen_resume(void) {
    if (g.stop) return;
    if (__atomic_load_n(&g.parked, __ATOMIC_ACQUIRE)) {
        g.hold = g.want_hold = g.asked = false;
        g.pace = 0;
        unpark();
    } else {
        want(false);
        stepgen_start();
    }
}

bool stepgen_holding(void) {
    return g.want_hold;
}
bool stepgen_held(void) {
    /* In this order: an interrupt in between that halts has taken the wish back before it says that it stands, or its
     * edge, which waits for its tick, would be cut and the pen lifted too soon. */
    const bool stands = __atomic_load_n(&g.parked, __ATOMIC_ACQUIRE) || !__atomic_load_n(&g.running, __ATOMIC_ACQUIRE);
    return stands && __atomic_load_n(&g.want_hold, __ATOMIC_ACQUIRE);
}

void stepgen_halt(bool motors_on) {
    hal_timer_cancel();
    g.level = halt(motors_on);
    hal_pins_write(HAL_X_STEP | HAL_Y_STEP | HAL_PEN | HAL_ENABLE, g.level);
}

bool stepgen_halted(void) {
    return g.halted;
}
