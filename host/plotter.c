/* plotter.c - motion/ on sim/, fed from memory. */
#include "host/plotter.h"

#include "error.h"
#include "host/out.h"
#include "host/play.h"
#include "host/progress.h"
#include "sim/sim.h"
#include "sim/vcd.h"

static uint64_t memory[(MOTION_BYTES_HOST + 7) / 8];

static void show(size_t stroke, size_t strokes) {
    progress_update("running the plotter", (int64_t)stroke, (int64_t)strokes);
}

int plotter_estimate(const drawing_t *d, const machine_t *machine, motion_stats_t *stats) {
    motion_t motion;
    int err = motion_init_estimate(&motion, machine, memory, sizeof memory);
    return err ? err : play(d, &motion, show, stats);
}

static int take_bytes(void *ctx, const char *data, size_t bytes) {
    out_bytes(ctx, data, bytes);
    return ((out_t *)ctx)->trouble ? ERR_FILE : 0;
}

int plotter_write_vcd(const drawing_t *d, const machine_t *machine, const char *path) {
    static vcd_t vcd;
    static out_t out; /* large */
    motion_t motion;
    int err = out_open(&out, path);
    if (err) return err;
    sim_reset();
    err = motion_init(&motion, machine, memory, sizeof memory);
    if (!err) {
        vcd_begin(&vcd, take_bytes, &out, machine, d->title[0] ? d->title : NULL, sim_pins());
        sim_record(vcd_record, &vcd);
        err = play(d, &motion, show, NULL);
        int written = vcd_end(&vcd, sim_now());
        sim_record(NULL, NULL);
        if (!err) err = written;
    }
    if (!err || err == ERR_FILE) return out_close(&out); /* which says what went wrong with the file */
    out_drop(&out);
    return err;
}
