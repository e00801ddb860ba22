/* plotter.c - motion/ on sim/, fed from memory. */
#include "host/plotter.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "error.h"
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

int plotter_write_vcd(const drawing_t *d, const machine_t *machine, const char *path) {
    static vcd_t vcd;
    motion_t motion;
    FILE *f = fopen(path, "wb");
    if (!f) return ERR_FILE;
    setvbuf(f, NULL, _IONBF, 0); /* vcd.h hands over blocks */
    sim_reset();
    int err = motion_init(&motion, machine, memory, sizeof memory);
    if (!err) {
        vcd_begin(&vcd, vcd_write_file, f, machine, d->title[0] ? d->title : NULL, sim_pins());
        sim_record(vcd_record, &vcd);
        err = play(d, &motion, show, NULL);
        int written = vcd_end(&vcd, sim_now());
        sim_record(NULL, NULL);
        if (!err) err = written;
    }
    struct stat about;
    bool is_file = fstat(fileno(f), &about) == 0 && S_ISREG(about.st_mode);
    if (fclose(f) != 0 && !err) err = ERR_FILE;
    /* The beginning of a trace would pass for a trace. What is no plain file, such as /dev/null, is not ours to remove.
     */
    if (err == ERR_MACHINE && is_file) remove(path);
    return err;
}
