/* main.c - `ridgeline plot`, `ridgeline trace`, and the prompt. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host/gpio.h"
#include "host/job.h"
#include "host/options.h"
#include "host/prompt.h"
#include "host/script.h"
#include "host/trace.h"
#include "version.h"

static void configure(job_t *job, const options_t *o) {
    job_init(job);
    memcpy(job->output, o->output, sizeof job->output);
    job->outputs = o->outputs;
    job->gpio = o->gpio;
    if (o->verbose) job->table = stdout;
}

static int run_sets(const options_t *o) {
    int err = 0;
    script_source("--set");
    for (int i = 0; i < o->sets && !err; i++) err = script_line(o->set[i]);
    return err;
}

/* "dir/hill.gp" is called "hill". */
static const char *base_name(const char *scene, char *room, size_t size) {
    const char *slash = strrchr(scene, '/');
    snprintf(room, size, "%s", slash ? slash + 1 : scene);
    char *dot = strrchr(room, '.');
    if (dot && dot != room) *dot = 0;
    return room;
}

static int cannot(const char *name, int status) {
    fprintf(stderr, "ridgeline: %s: %s\n", name, strerror(errno));
    return status;
}

/* The output that is the scene itself, or NULL. */
static const char *output_that_is(FILE *scene, const options_t *o) {
    struct stat read, written;
    if (fstat(fileno(scene), &read) != 0 || !S_ISREG(read.st_mode)) return NULL;
    for (int i = 0; i < o->outputs; i++)
        if (stat(o->output[i], &written) == 0 && written.st_dev == read.st_dev && written.st_ino == read.st_ino)
            return o->output[i];
    return NULL;
}

/* Commands from a file or from stdin, to the end or the first error. */
static int run_scene(const options_t *o, FILE *scene, const char *name) {
    static job_t job;
    static char base[64]; /* job.name points to it */
    const char *itself = output_that_is(scene, o);
    if (itself) {
        fprintf(stderr, "ridgeline: %s: is the scene itself, which a drawing would replace; name another output\n",
                itself);
        return SCRIPT_BAD_INPUT;
    }
    configure(&job, o);
    job.name = base_name(name, base, sizeof base);
    if (o->stats) {
        job.stats = strcmp(o->stats, "-") == 0 ? stdout : fopen(o->stats, "w");
        if (!job.stats) return cannot(o->stats, SCRIPT_TROUBLE);
        report_json_begin(job.stats, name);
    }
    script_begin(&job, scene != stdin && isatty(STDIN_FILENO));
    int err = run_sets(o);
    if (!err && script_state() != SESSION_QUIT) err = script_file(scene, name);
    int status = script_status(err);
    if (job.stats) {
        report_json_end(job.stats);
        if (job.stats != stdout) { /* whether that could be written is asked in the end */
            int bad = fflush(job.stats) != 0 || ferror(job.stats);
            if (fclose(job.stats) != 0 || bad) status = cannot(o->stats, SCRIPT_TROUBLE);
        }
    }
    if (!err && !job.pages && job.outputs && o->scene)
        fprintf(stderr, "ridgeline: nothing was written; %s plots nothing\n", name);
    if (!err && job.pages && !job.outputs && !job.stats && !job.table && !job.gpio.pins)
        fprintf(stderr, "ridgeline: nothing was written; -o FILE says where a drawing goes\n");
    job_free(&job);
    return status;
}

/* What was printed may not have reached a full disk. */
static int end(int status) {
    if (fflush(stdout) == 0 && !ferror(stdout)) return status;
    cannot("standard output", 0);
    return status ? status : SCRIPT_TROUBLE;
}

static int plot_main(const options_t *o) {
    if (!o->scene) {
        fprintf(stderr, "ridgeline: plot what? Name a scene, or - for standard input.\nTry `ridgeline --help`.\n");
        return SCRIPT_BAD_INPUT;
    }
    if (strcmp(o->scene, "-") == 0) return run_scene(o, stdin, "stdin");
    FILE *scene = fopen(o->scene, "r");
    if (!scene) return cannot(o->scene, SCRIPT_BAD_INPUT);
    int status = run_scene(o, scene, o->scene);
    fclose(scene);
    return status;
}

static int prompt_main(options_t *o) {
    static job_t job;
    if (o->scene) {
        fprintf(stderr, "ridgeline: unknown command %s\nTry `ridgeline --help`.\n", o->scene);
        return SCRIPT_BAD_INPUT;
    }
    if (!o->outputs) o->output[o->outputs++] = "plot.svg";
    if (!isatty(STDIN_FILENO)) return run_scene(o, stdin, "stdin");
    configure(&job, o);
    job.overwrite = true;
    job.announce = stdout;
    script_begin(&job, true);
    if (run_sets(o) == 0) prompt_run();
    job_free(&job);
    return SCRIPT_DONE;
}

int main(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "trace") == 0) return trace_main(argc - 1, argv + 1);
    if (argc > 1 && gpio_is_command(argv[1])) return gpio_main(argc - 1, argv + 1);
    bool plot = argc > 1 && strcmp(argv[1], "plot") == 0;
    options_t options;
    if (!options_parse(&options, argc - plot, argv + plot)) return SCRIPT_BAD_INPUT;
    if (options.help || (!plot && options.scene && strcmp(options.scene, "help") == 0)) {
        options_help();
        return end(SCRIPT_DONE);
    }
    if (options.version) {
        puts("ridgeline " RIDGELINE_VERSION);
        return end(SCRIPT_DONE);
    }
    return end(plot ? plot_main(&options) : prompt_main(&options));
}
