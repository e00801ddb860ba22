/* motion.c - strokes to runs: when the pen moves, what it waits for, and the way from and to home. */
#include "motion/motion.h"
#include "error.h"
#include "hal/hal.h"
#include "motion/root.h"

#define PIECES_MAX 64
#define ROOM 6 /* pieces in the queue, for a line: its three parts, and what parts them */

static int32_t lat_from_um(int32_t um) {
    return (int32_t)((int64_t)um * LAT_PER_MM / 1000);
}

static int init(motion_t *m, const machine_t *machine, void *mem, size_t bytes, bool estimate) {
    *m = (motion_t){.machine = *machine, .estimate = estimate};
    const machine_t *mc = &m->machine;
    if (!machine_is_possible(mc)) return m->error = ERR_MACHINE;

    uint32_t pieces = 0;
    if (!estimate) {
        pieces = 8;
        while (pieces < PIECES_MAX && pieces * 2 * sizeof(stepgen_piece_t) <= bytes / 4) pieces *= 2;
    }
    size_t queue_bytes = pieces * sizeof(stepgen_piece_t);
    if (bytes < queue_bytes + 8 * sizeof(planner_block_t)) return m->error = ERR_FULL;
    uint32_t blocks = (uint32_t)((bytes - queue_bytes) / sizeof(planner_block_t));
    stepgen_piece_t *queue = mem;
    planner_block_t *ring = (planner_block_t *)(void *)((uint8_t *)mem + queue_bytes);

    m->draw_top_q3 = planner_height_q3(mc->draw_speed_um_s, mc->accel_um_s2);
    m->travel_top_q3 = planner_height_q3(mc->travel_speed_um_s, mc->accel_um_s2);
    m->reach_lat[0] = lat_from_um(mc->width_um);
    m->reach_lat[1] = lat_from_um(mc->height_um);
    uint32_t finest =
        mc->steps_per_mm_q16[0] > mc->steps_per_mm_q16[1] ? mc->steps_per_mm_q16[0] : mc->steps_per_mm_q16[1];
    m->near_lat = (int32_t)(((uint64_t)LAT_PER_MM << 14) / finest); /* 2^16 / 4 = 2^14: a quarter step */
    kinematics_init(&m->kin, mc);
    planner_init(&m->planner, ring, blocks, mc->junction_um);
    tracer_init(&m->tracer, &m->kin, mc->accel_um_s2, machine_gap_ticks(mc), estimate);
    if (!estimate)
        stepgen_init(queue, pieces, machine_ticks_from_ns(mc->pulse_ns), machine_ticks_from_ns(mc->dir_setup_ns));
    m->stats.memory_bytes = (uint32_t)(queue_bytes + blocks * sizeof(planner_block_t));
    return 0;
}

int motion_init(motion_t *m, const machine_t *machine, void *mem, size_t bytes) {
    return init(m, machine, mem, bytes, false);
}

int motion_init_estimate(motion_t *m, const machine_t *machine, void *mem, size_t bytes) {
    return init(m, machine, mem, bytes, true);
}

void motion_start_at(motion_t *m, page_point_t at) {
    m->at = at;
    kinematics_motors(&m->kin, at, m->tracer.pos);
    for (int i = 0; i < 2; i++) {
        m->tracer.steps[i] = kinematics_round(m->tracer.pos[i]);
        if (!m->estimate) stepgen_set_position(i, m->tracer.steps[i]);
    }
}

page_point_t motion_place(const motion_t *m) {
    const int32_t steps[2] = {stepgen_position(0), stepgen_position(1)};
    return kinematics_page(&m->kin, steps);
}

void motion_on_wait(motion_t *m, void (*wait)(void *ctx), void *ctx) {
    m->tracer.wait = wait;
    m->tracer.wait_ctx = ctx;
}

static bool trace_one(motion_t *m, bool ending) {
    planner_move_t mv;
    if (!planner_take(&m->planner, ending, &mv)) return false;
    tracer_move(&m->tracer, &mv);
    return true;
}

static void trace(motion_t *m, bool ending) {
    while (trace_one(m, ending)) continue;
}

static void add_line(motion_t *m, page_point_t to) {
    if (planner_full(&m->planner)) trace_one(m, false);
    uint32_t length_q3 = planner_add(&m->planner, to);
    if (m->down)
        m->down_q3 += length_q3;
    else
        m->up_q3 += length_q3;
    m->at = to;
    m->pending_vertex = false;
}

static void begin_run(motion_t *m) {
    uint32_t top_q3 = m->down ? m->draw_top_q3 : m->travel_top_q3;
    tracer_speed(&m->tracer, m->down ? m->machine.draw_speed_um_s : m->machine.travel_speed_um_s, top_q3);
    planner_begin(&m->planner, m->at, top_q3);
}

/* To a stop at the last point that was given. */
static void end_run(motion_t *m) {
    if (m->pending_vertex) add_line(m, m->vertex);
    trace(m, true);
}

static void lift(motion_t *m) {
    if (!m->down) return;
    end_run(m);
    m->down = m->resting = false;
    m->stats.lifts++;
    tracer_wait(&m->tracer, m->machine.lift_us, HAL_ENABLE);
}

static void lower(motion_t *m) {
    m->down = true;
    m->stats.strokes++;
    tracer_wait(&m->tracer, m->machine.lower_us, HAL_ENABLE | HAL_PEN);
    begin_run(m);
}

/* Pen up, straight to a point. */
static void travel(motion_t *m, page_point_t to) {
    lift(m);
    if (!m->started) {
        m->started = true;
        tracer_wait(&m->tracer, m->machine.enable_us, HAL_ENABLE);
    }
    begin_run(m);
    add_line(m, to);
    end_run(m);
}

static bool same(page_point_t a, page_point_t b) {
    return a.x_lat == b.x_lat && a.y_lat == b.y_lat;
}

static bool inside(const motion_t *m, page_point_t p) {
    if (p.x_lat <= -PLANNER_REACH_LAT || p.x_lat >= PLANNER_REACH_LAT || p.y_lat <= -PLANNER_REACH_LAT ||
        p.y_lat >= PLANNER_REACH_LAT)
        return false;
    if (m->reach_lat[0] && (p.x_lat < 0 || p.x_lat > m->reach_lat[0])) return false;
    return !(m->reach_lat[1] && (p.y_lat < 0 || p.y_lat > m->reach_lat[1]));
}

static int check(motion_t *m, page_point_t to) {
    if (!m->error && !m->estimate && stepgen_halted()) m->error = ERR_STOPPED;
    if (!m->error && !inside(m, to)) m->error = ERR_MACHINE;
    return m->error;
}

static int motion_move(void *ctx, page_point_t to) {
    motion_t *m = ctx;
    if (check(m, to)) return m->error;
    if (m->resting) lift(m);
    page_point_t here = m->pending_vertex ? m->vertex : m->at;
    m->pending_move = !(m->down && same(here, to));
    m->move_to = to;
    return 0;
}

static int motion_draw(void *ctx, page_point_t to) {
    motion_t *m = ctx;
    if (check(m, to)) return m->error;
    if (m->pending_move || !m->started) travel(m, m->pending_move ? m->move_to : m->at);
    m->pending_move = false;
    if (!m->down) lower(m);
    m->vertex = to;
    m->pending_vertex = true;
    int32_t dx = to.x_lat - m->at.x_lat, dy = to.y_lat - m->at.y_lat;
    if (dx >= m->near_lat || dx <= -m->near_lat || dy >= m->near_lat || dy <= -m->near_lat) add_line(m, to);
    return 0;
}

pen_sink_t motion_pen_sink(motion_t *m) {
    return (pen_sink_t){.ctx = m, .move = motion_move, .draw = motion_draw};
}

/* sqrt(2 a h): h in q16 lat is h * 1000 / 2^31 um. */
static uint32_t speed_um_s(const motion_t *m) {
    uint64_t peak_um_q8 = (uint64_t)(m->tracer.peak_q16 >> 13) * 1000 >> 10;
    return root_u64((2 * peak_um_q8 * m->machine.accel_um_s2) >> 8);
}

int motion_travel(motion_t *m, page_point_t to) {
    if (check(m, to)) return m->error;
    m->pending_move = false;
    travel(m, to);
    return 0;
}

/* Lines whose speeds are settled, as far as the queue has room: tracer_move rarely makes more pieces than that. */
static void serve(motion_t *m) {
    while ((m->resting || m->planner.final > 0) && stepgen_room() >= ROOM && trace_one(m, m->resting)) continue;
    if (m->resting && m->planner.count == 0) lift(m);
}

bool motion_ready(motion_t *m) {
    if (m->error || m->estimate || stepgen_halted()) return true;
    serve(m);
    stepgen_start();
    return !m->resting && stepgen_room() >= ROOM;
}

int motion_rest(motion_t *m, bool wait) {
    if (check(m, m->at)) return m->error;
    if (!m->down || m->resting) return 0;
    if (m->pending_vertex) add_line(m, m->vertex);
    m->resting = true;
    if (m->estimate || wait)
        lift(m);
    else
        serve(m);
    if (!m->estimate) stepgen_start();
    return 0;
}

/* Until everything is stepped. */
static void run_dry(motion_t *m) {
    while (!stepgen_idle()) {
        stepgen_start();
        if (m->tracer.wait)
            m->tracer.wait(m->tracer.wait_ctx);
        else
            hal_idle();
    }
    for (int i = 0; i < 2; i++) {
        m->stats.steps[i] = m->tracer.pulses[i];
        m->stats.position_steps[i] = stepgen_position(i);
    }
    m->stats.starved = stepgen_starved();
    m->stats.late = stepgen_late();
    if (stepgen_halted() && !m->error) m->error = ERR_STOPPED;
}

static int end(motion_t *m, motion_stats_t *stats) {
    motion_stats_t *st = &m->stats;
    if (m->started && !m->estimate) run_dry(m);
    m->started = false;
    st->down_lat = m->down_q3 / PLANNER_Q3_PER_LAT;
    st->up_lat = m->up_q3 / PLANNER_Q3_PER_LAT;
    st->ticks = (uint64_t)(m->tracer.clock_q16 >> 16);
    st->max_speed_um_s = speed_um_s(m);
    st->forced = m->planner.forced;
    if (stats) *stats = *st;
    return m->error;
}

int motion_park(motion_t *m, motion_stats_t *stats) {
    if (m->started) lift(m);
    return end(m, stats);
}

int motion_finish(motion_t *m, motion_stats_t *stats) {
    if (m->started) {
        travel(m, (page_point_t){0, 0});
        tracer_wait(&m->tracer, 0, 0);
    }
    return end(m, stats);
}
