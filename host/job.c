/* job.c - no file appears or changes before the whole picture is known to be right: a scene that fails leaves nothing
 * behind. */
#include "host/job.h"

#include <errno.h>
#include <limits.h>
#include <setjmp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "app/picture_pens.h"
#include "error.h"
#include "host/huge_pages.h"
#include "host/plotter.h"
#include "host/progress.h"
#include "host/stroke_file.h"
#include "host/writer.h"

void job_init(job_t *job) {
    memset(job, 0, sizeof *job);
    job->name = "";
    drawing_init(&job->drawing);
}

void job_free(job_t *job) {
    drawing_free(&job->drawing);
    free(job->lent);
    job->lent = NULL;
}

/* What the hooks need to time the stages: each runs from its own first call to the next stage's. */
typedef struct watch {
    job_t *job;
    double begun[PICTURE_DONE + 1]; /* [PICTURE_DONE]: when the picture was finished */
} watch_t;

/* Where a drawing that is stopped is left from: the core holds nothing that would have to be given back. */
static jmp_buf stopped;
static volatile sig_atomic_t is_drawing, is_to_stop;

bool job_stop(void) {
    if (!is_drawing || is_to_stop) return false;
    is_to_stop = 1;
    return true;
}

static void on_progress(void *ctx, enum picture_stage stage, int32_t done, int32_t of) {
    static const char *const WHAT[] = {"evaluating", "hiding lines", "ordering strokes"};
    watch_t *w = ctx;
    if (is_to_stop) longjmp(stopped, 1);
    if (stage >= PICTURE_DONE) return;
    if (w->begun[stage] <= 0) w->begun[stage] = progress_now();
    progress_update(WHAT[stage], done, of);
}

static void on_begin(void *ctx, const camera_t *cam) {
    watch_t *w = ctx;
    drawing_set_camera(&w->job->drawing, cam);
}

static int no_memory(job_t *job, size_t bytes) {
    progress_wipe();
    fprintf(stderr, "ridgeline: no memory for this drawing (%zu MB)\n", bytes >> 20);
    return job->trouble = ERR_FULL;
}

static bool lend(job_t *job, size_t bytes) {
    if (bytes <= job->lent_bytes) return true;
    free(job->lent);
    if (posix_memalign(&job->lent, HUGE_PAGE, bytes)) job->lent = NULL;
    /* Touching it page by page would take a tenth of a large drawing's time. */
    if (job->lent && bytes > 4 * HUGE_PAGE) huge_pages_ask(job->lent, bytes);
    job->lent_bytes = job->lent ? bytes : 0;
    return job->lent != NULL;
}

static void note_intersections(long long pairs) {
    progress_wipe();
    fprintf(stderr,
            "ridgeline: faces cut through each other in %lld place%s; the lines in which they do are not drawn\n",
            pairs, pairs == 1 ? "" : "s");
}

static int on_pen(void *ctx, int number) {
    watch_t *w = ctx;
    return drawing_take_pen(&w->job->drawing, number);
}

/* Written while it is drawn. */
static stroke_file_t stream;

/* A drawing that becomes one text file need not be in memory, if nobody wants to know more about it. */
static bool begin_stream(job_t *job, const plot_t *plot, const char *name) {
    const uint32_t first_pen = 1u << 1;
    if (job->outputs != 1 || job->table || job->stats || job->gpio.pins || pens_wanted(plot) != first_pen) return false;
    const stroke_format_t *format = writer_format(name);
    return format && stroke_file_begin(&stream, format, &job->drawing, &plot->settings->machine, name);
}

/* Draws into the drawing, with more memory until it is enough. */
static int draw(job_t *job, const plot_t *plot, picture_t *picture, watch_t *w) {
    picture_hooks_t hooks = {.ctx = w, .progress = on_progress, .begin = on_begin, .pen = on_pen};
    pen_sink_t pen = drawing_sink(&job->drawing);
    size_t bytes = picture_bytes(plot);
    for (;;) {
        if (!lend(job, bytes)) return no_memory(job, bytes);
        drawing_clear(&job->drawing);
        memset(w->begun, 0, sizeof w->begun);
        /* exactly this much, though an earlier page may have needed more: the order of strokes depends on it */
        int err = picture_draw(picture, plot, job->lent, bytes, &pen, &hooks);
        w->begun[PICTURE_DONE] = progress_now();
        bool solids = plot->kind == PLOT_SOLIDS || (plot->kind == PLOT_SURFACES && plot->settings->shadow);
        bool area = solids && plot->settings->hidden == HIDDEN_AREA;
        if (!err && area && picture->area.intersections) note_intersections(picture->area.intersections);
        if (err != ERR_FULL) return err;
        if (bytes >= JOB_LENT_MAX) return no_memory(job, bytes);
        bytes = bytes * 2 < JOB_LENT_MAX ? bytes * 2 : JOB_LENT_MAX;
        if (job->drawing.take) stroke_file_restart(&stream);
        hooks.generous = true;
    }
}

/* Stage times from the moments the stages began; a stage that was left out took none. */
static void read_watch(const watch_t *w, report_t *r) {
    double *into[PICTURE_DONE] = {&r->measure_s, &r->hide_s, &r->order_s}, end = w->begun[PICTURE_DONE];
    for (int s = PICTURE_DONE - 1; s >= 0; s--)
        if (w->begun[s] > 0) {
            *into[s] = end - w->begun[s];
            end = w->begun[s];
        }
}

static const char *what_is_wrong(int err, const machine_t *machine) {
    if (err != ERR_MACHINE) return error_text(err);
    return machine_is_possible(machine)
               ? "the paper reaches beyond the machine: set paper, or set machine size"
               : "so fast the steps leave no time for pulses and DIR set-up: set machine speed, steps, pulse or setup";
}

static int cannot_write(job_t *job, const machine_t *machine, const char *name, int err) {
    progress_wipe();
    if (err == ERR_FILE && errno)
        fprintf(stderr, "ridgeline: %s: %s\n", name, strerror(errno));
    else
        fprintf(stderr, "ridgeline: %s: %s\n", name, what_is_wrong(err, machine));
    return job->trouble = err;
}

static int write_outputs(job_t *job, const machine_t *machine, char *const *name) {
    for (int i = 0; i < job->outputs; i++) {
        errno = 0;
        int err = writer_write(&job->drawing, machine, name[i]);
        if (err) return cannot_write(job, machine, name[i], err);
    }
    return 0;
}

/* Is this name of a later page also that of another output's first one? */
static bool is_an_output(const job_t *job, const char *name) {
    for (int i = 0; i < job->outputs; i++)
        if (strcmp(job->output[i], name) == 0) return true;
    return false;
}

/* The page's file names, NULL at the end. */
static bool make_names(const job_t *job, int page, char **name) {
    for (int i = 0; i < job->outputs; i++) {
        char path[PATH_MAX];
        if (!writer_page_name(path, sizeof path, job->output[i], job->overwrite ? 1 : page)) {
            fprintf(stderr, "ridgeline: page %d: the name of an output is too long\n", page);
            return false;
        }
        if (page > 1 && !job->overwrite && is_an_output(job, path)) {
            fprintf(stderr, "ridgeline: page %d of %s would be %s, which is an output itself\n", page, job->output[i],
                    path);
            return false;
        }
        name[i] = strdup(path);
        if (!name[i]) return false;
    }
    return true;
}

/* The pool of runs takes what it is lent; this is what would have been enough. */
static size_t path_bytes_needed(const picture_t *picture) {
    const path_stats_t *stats = &picture->stats.path;
    int64_t cap = picture->path.pool.cap, unused = stats->flushes || stats->runs > cap ? 0 : cap - stats->runs;
    return stats->bytes - (stats->bytes ? POOL_BYTES(unused) : 0);
}

static int draw_page(job_t *job, const plot_t *plot, char **name) {
    const settings_t *settings = plot->settings;
    static picture_t picture; /* large, and there is one page at a time */
    watch_t watch = {.job = job};
    drawing_t *d = &job->drawing;
    d->width_um = settings->paper.width_um;
    d->height_um = settings->paper.height_um;
    drawing_set_title(d, settings->title);
    if (!make_names(job, job->pages + 1, name)) return job->trouble = ERR_FILE;
    const bool streams = begin_stream(job, plot, name[0]);
    is_to_stop = 0;
    if (setjmp(stopped)) {
        is_drawing = 0;
        if (streams) stroke_file_drop(&stream, d);
        progress_wipe();
        fprintf(stderr, "ridgeline: stopped; nothing was written\n");
        return job->trouble = ERR_STOPPED;
    }
    is_drawing = 1;
    int err = draw(job, plot, &picture, &watch);
    is_drawing = 0;
    if (err && streams) stroke_file_drop(&stream, d);
    if (err) return err;

    job->pages++;
    if (d->strokes == 0) {
        progress_wipe();
        fprintf(stderr, "ridgeline: page %d is empty: no part of a line is visible and on the paper\n", job->pages);
    }
    report_t r = {.page = job->pages, .name = job->name, .title = d->title, .file = (const char *const *)name};
    double start = progress_now();
    if (streams) {
        err = stroke_file_end(&stream, d);
        if (err) return cannot_write(job, &settings->machine, name[0], err);
    } else {
        err = write_outputs(job, &settings->machine, name);
        if (err) return err;
    }
    r.write_s = progress_now() - start;
    if (job->announce)
        for (int i = 0; i < job->outputs; i++) fprintf(job->announce, "%s\n", name[i]);
    if (job->gpio.pins) {
        progress_wipe();
        job->status = gpio_plot(&job->gpio, job->pages, &settings->machine, d);
        if (job->status) return job->trouble = ERR_STOPPED;
    }

    if (!job->table && !job->stats) return 0;
    read_watch(&watch, &r);
    r.picture = picture.stats;
    r.points = d->points;
    r.strokes = d->strokes;
    r.length = drawing_measure(d);
    r.lent_bytes = job->lent_bytes;
    r.data_bytes = job->data_bytes;
    r.path_bytes = path_bytes_needed(&picture);
    r.machine_error = plotter_estimate(d, &settings->machine, &r.motion);
    if (job->stats) report_json_page(job->stats, &r);
    progress_wipe();
    if (job->table) {
        if (job->pages == 1) report_table_head(job->table);
        report_table_row(job->table, &r);
    }
    return 0;
}

int job_draw(job_t *job, const plot_t *plot) {
    char *name[JOB_OUTPUTS_MAX + 1] = {0};
    progress_begin();
    int err = draw_page(job, plot, name);
    progress_wipe();
    for (char **n = name; *n; n++) free(*n);
    return err;
}
