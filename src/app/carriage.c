/* carriage.c - see carriage.h. */
#include "app/carriage.h"

#include "config.h"
#include "hal/hal.h"

#define LIMITS (HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y)

/* Homing: the way to a switch is at most the machine's length, or this where it is not set, and half as much again. */
#define SEEK_MM 1000
#define SEEK_SPEED_UM_S 25000
#define TOUCH_SPEED_UM_S 2000

enum carriage_alarm carriage_alarm(const carriage_t *c) {
    return (enum carriage_alarm)__atomic_load_n(&c->alarm, __ATOMIC_ACQUIRE);
}

/* A stop ends what is under way; the interrupt sees to that, if it runs. */
static void end_stop(const carriage_t *c) {
    if (c->stopping && stepgen_held()) stepgen_halt(true);
}

static void wait(void *ctx) {
    carriage_t *c = ctx;
    c->poll(c->ctx);
    end_stop(c);
    stepgen_wake(HAL_TICK_HZ / 1000);
    hal_idle();
}

static void wait_us(carriage_t *c, uint32_t us) {
    uint32_t from = hal_now(), ticks = us * (HAL_TICK_HZ / 1000000); /* 60 s at most */
    while (hal_now() - from < ticks) wait(c);
}

void carriage_init(carriage_t *c, void *mem, size_t bytes, void (*poll)(void *ctx), void *ctx) {
    *c = (carriage_t){.mem = mem, .bytes = bytes, .poll = poll, .ctx = ctx};
}

/* Motion from where the pen is. */
static int prepare(carriage_t *c, const machine_t *machine) {
    if (c->pen_down) carriage_pen_test(c, machine, false);
    int err = motion_init(&c->motion, machine, c->mem, c->bytes);
    if (err) return err;
    motion_start_at(&c->motion, c->place);
    motion_on_wait(&c->motion, wait, c);
    return 0;
}

/* Which limit switches stop a drawing. */
static uint32_t limits_of(const machine_t *machine) {
    return machine->limits == MACHINE_LIMITS_ON ? LIMITS : 0;
}

uint32_t carriage_closed(const machine_t *machine) {
    return hal_inputs() & (limits_of(machine) | HAL_IN_ESTOP);
}

int carriage_begin(carriage_t *c, const machine_t *machine) {
    if (carriage_alarm(c) || carriage_closed(machine)) return ERR_MACHINE;
    c->machine = machine;
    c->stopping = false;
    int err = prepare(c, machine);
    if (err) return err;
    c->state = CARRIAGE_RUN;
    hal_trip(limits_of(machine));
    return 0;
}

/* Before every line: what was typed? While it brakes it needs the lines that come. */
static int look(carriage_t *c) {
    c->poll(c->ctx);
    end_stop(c);
    return stepgen_halted() ? ERR_STOPPED : 0;
}

static int pen_move(void *ctx, page_point_t to) {
    carriage_t *c = ctx;
    pen_sink_t pen = motion_pen_sink(&c->motion);
    int err = look(c);
    return err ? err : pen.move(pen.ctx, to);
}

static int pen_draw(void *ctx, page_point_t to) {
    carriage_t *c = ctx;
    pen_sink_t pen = motion_pen_sink(&c->motion);
    int err = look(c);
    return err ? err : pen.draw(pen.ctx, to);
}

pen_sink_t carriage_pen(carriage_t *c) {
    return (pen_sink_t){c, pen_move, pen_draw};
}

bool carriage_ready(void *ctx) {
    carriage_t *c = ctx;
    return motion_ready(&c->motion);
}

int carriage_rest(void *ctx) {
    carriage_t *c = ctx;
    int err = look(c);
    return err ? err : motion_rest(&c->motion, CONFIG_OUTBOX == 0); /* nobody would serve it meanwhile */
}

int carriage_end(carriage_t *c, int err, motion_stats_t *stats) {
    int finish = 0;
    if (!c->stopping && !stepgen_halted()) finish = motion_finish(&c->motion, stats);
    if (c->stopping || stepgen_halted()) {
        while (!stepgen_halted()) wait(c); /* brakes */
        finish = motion_park(&c->motion, stats);
        if (!carriage_alarm(c)) wait_us(c, c->machine->lift_us);
        if (!finish) finish = ERR_STOPPED;
    }
    hal_trip(0);
    c->place = motion_place(&c->motion);
    c->state = CARRIAGE_IDLE;
    c->stopping = false;
    return carriage_alarm(c) ? ERR_MACHINE : err ? err : finish;
}

int carriage_change(carriage_t *c) {
    int err = motion_travel(&c->motion, (page_point_t){0, 0}), parked = motion_park(&c->motion, NULL);
    if (err || parked) return err ? err : parked;
    c->place = motion_place(&c->motion);
    c->changing = true;
    while (c->changing && !c->stopping && !carriage_alarm(c)) wait(c);
    c->changing = false;
    if (!c->stopping && !carriage_alarm(c)) return prepare(c, c->machine);
    stepgen_halt(true); /* nothing moves: it need not brake */
    return ERR_STOPPED;
}

/* One move of homing, until the switch closes if one is sought. Where it began is its own origin. */
static int leg(carriage_t *c, uint32_t speed_um_s, int axis, int64_t um, uint8_t seek) {
    machine_t m = *c->machine;
    if (m.travel_speed_um_s > speed_um_s) m.travel_speed_um_s = speed_um_s;
    m.width_um = m.height_um = 0;
    page_point_t to = {0, 0};
    *(axis ? &to.y_lat : &to.x_lat) = (int32_t)(um * LAT_PER_MM / 1000);
    c->place = (page_point_t){0, 0};
    if (seek & hal_inputs()) return 0;
    int err = prepare(c, &m);
    if (err) return err;
    __atomic_store_n(&c->seeking, seek, __ATOMIC_RELEASE);
    hal_trip(seek);
    err = motion_travel(&c->motion, to);
    int parked = motion_park(&c->motion, NULL);
    __atomic_store_n(&c->seeking, 0, __ATOMIC_RELEASE);
    hal_trip(0);
    if (c->stopping || carriage_alarm(c)) return ERR_STOPPED;
    if (!err) err = parked;
    return seek && err == ERR_STOPPED ? 0 : err;
}

static int home_axis(carriage_t *c, int axis) {
    const uint8_t pin = axis ? HAL_IN_LIMIT_Y : HAL_IN_LIMIT_X;
    const int32_t size_um = axis ? c->machine->height_um : c->machine->width_um;
    int64_t far = (int64_t)(size_um ? size_um : SEEK_MM * 1000) * 3 / 2;
    const int64_t reach = (PLANNER_REACH_LAT / LAT_PER_MM - 1) * 1000;
    if (far > reach) far = reach;
    int64_t off = c->machine->pull_off_um;
    if (c->machine->home_far >> axis & 1) {
        far = -far;
        off = -off;
    }
    /* Off the switch if it is closed, then to it fast, off, to it slowly, off. */
    const struct {
        uint32_t speed_um_s;
        bool seek;
        int64_t um;
    } way[] = {{TOUCH_SPEED_UM_S, false, off},
               {SEEK_SPEED_UM_S, true, -far},
               {TOUCH_SPEED_UM_S, false, off},
               {TOUCH_SPEED_UM_S, true, -2 * off},
               {TOUCH_SPEED_UM_S, false, off}};
    for (size_t i = hal_inputs() & pin ? 0 : 1; i < sizeof way / sizeof way[0]; i++) {
        int err = leg(c, way[i].speed_um_s, axis, way[i].um, way[i].seek ? pin : 0);
        if (err) return err;
        if (!(hal_inputs() & pin) == way[i].seek) return ERR_MACHINE;
    }
    return 0;
}

int carriage_home(carriage_t *c, const machine_t *machine) {
    if ((hal_inputs() & HAL_IN_ESTOP) || machine->limits == MACHINE_LIMITS_OFF) return ERR_MACHINE;
    c->machine = machine;
    c->alarm = CARRIAGE_NO_ALARM;
    c->stopping = false;
    c->state = CARRIAGE_HOME;
    int err = home_axis(c, 0);
    if (!err) err = home_axis(c, 1);
    c->place = (page_point_t){0, 0};
    if (machine->home_far & 1) c->place.x_lat = (int32_t)((int64_t)machine->width_um * LAT_PER_MM / 1000);
    if (machine->home_far & 2) c->place.y_lat = (int32_t)((int64_t)machine->height_um * LAT_PER_MM / 1000);
    c->state = CARRIAGE_IDLE;
    if (err && !carriage_alarm(c)) c->alarm = c->stopping ? CARRIAGE_BROKEN_OFF : CARRIAGE_NO_SWITCH;
    c->stopping = false;
    return err;
}

bool carriage_unlock(carriage_t *c) {
    if (hal_inputs() & HAL_IN_ESTOP) return false;
    c->alarm = CARRIAGE_NO_ALARM;
    c->place = (page_point_t){0, 0};
    return true;
}

static bool is_moving(const carriage_t *c) {
    return c->state == CARRIAGE_RUN || c->state == CARRIAGE_HOME;
}

void carriage_hold(carriage_t *c) {
    if (is_moving(c)) stepgen_hold();
}

void carriage_resume(carriage_t *c) {
    if (is_moving(c) && !c->stopping) stepgen_resume();
    c->changing = false;
}

void carriage_stop(carriage_t *c) {
    if (!is_moving(c)) return;
    c->stopping = true;
    stepgen_stop();
}

void carriage_pen_test(carriage_t *c, const machine_t *machine, bool down) {
    stepgen_set_pins(HAL_PEN, down ? HAL_PEN : 0);
    c->pen_down = down;
    wait_us(c, down ? machine->lower_us : machine->lift_us);
}

void carriage_motors(carriage_t *c, bool on) {
    stepgen_set_pins(HAL_ENABLE, on ? HAL_ENABLE : 0);
    if (!on) c->place = (page_point_t){0, 0};
}

enum carriage_state carriage_state(const carriage_t *c) {
    if (carriage_alarm(c)) return CARRIAGE_ALARM;
    return is_moving(c) && (c->changing || stepgen_holding()) ? CARRIAGE_HOLD : (enum carriage_state)c->state;
}

page_point_t carriage_place(const carriage_t *c) {
    return is_moving(c) ? motion_place(&c->motion) : c->place;
}

bool carriage_pen_is_down(const carriage_t *c) {
    return is_moving(c) ? stepgen_pen_down() : c->pen_down;
}

void carriage_input_isr(carriage_t *c, uint32_t inputs) {
    if (inputs & HAL_IN_ESTOP) {
        stepgen_halt(false);
        c->pen_down = false;
        __atomic_store_n(&c->alarm, CARRIAGE_ESTOP, __ATOMIC_RELEASE);
    } else if (c->state == CARRIAGE_HOME) {
        /* Bouncing while leaving a switch, and the other axis's switch, mean nothing. */
        if (inputs & c->seeking) stepgen_halt(true);
    } else if (c->state == CARRIAGE_RUN && (inputs & limits_of(c->machine))) {
        stepgen_halt(true);
        __atomic_store_n(&c->alarm, CARRIAGE_LIMIT, __ATOMIC_RELEASE);
    }
}
