/* emu_tool.c - makes the emulated chips, drives inputs, plants faults, prints the recording; see emu.h. $GPIOEMU is the
 * folder.
 *
 *     init                                 an empty folder
 *     chip LABEL LINES                     the next chip
 *     name CHIP LINE NAME                  names a line
 *     hog CHIP LINE                        gives a line to the kernel
 *     in CHIP LINE LEVEL                   drives a line from outside
 *     axis I CHIP STEP DIR LIMIT POSITION AT LEVEL    a carriage with a switch
 *     when CHIP sets N|rises LINE N|requests N ACTION  ACTION: in LINE LEVEL, set-error ERRNO [COUNT],
 *                                          request-error ERRNO [COUNT], unplug, signal N, stall MICROSECONDS
 *     release-to-input                     released outputs become inputs
 *     level CHIP LINE                      prints the level
 *     rises CHIP LINE                      prints how often it rose
 *     position I                           prints where the carriage is
 *     log                                  prints the recording */
#include "tests/gpio/emu.h"

#include <inttypes.h>
#include <linux/gpio.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int argc;
static char **argv;
static int at = 2;

static const char *word(void) {
    if (at >= argc) {
        fprintf(stderr, "emu_tool: %s: something is missing\n", argv[1]);
        exit(2);
    }
    return argv[at++];
}
static int number(void) {
    return (int)strtol(word(), NULL, 0);
}
static uint32_t unsigned_number(void) {
    return (uint32_t)number();
}
static bool is(const char *name) {
    return strcmp(argv[1], name) == 0;
}

static void make_folder(const char *dir, const char *sub) {
    char path[EMU_PATH + 8];
    snprintf(path, sizeof path, "%s%s", dir, sub);
    mkdir(path, 0777);
}

static bool init(const char *dir) {
    make_folder(dir, "");
    make_folder(dir, "/dev");
    make_folder(dir, "/sys");
    make_folder(dir, "/req");
    if (!emu_map(dir, true)) return false;
    emu->magic = EMU_MAGIC;
    return true;
}

static void write_file(const char *folder, const char *name, const char *text, uint64_t *inode) {
    char path[EMU_PATH + 64];
    struct stat st;
    snprintf(path, sizeof path, "%s/%s/%s", emu_dir, folder, name);
    FILE *f = fopen(path, "w");
    if (!f) exit(1);
    fputs(text, f);
    fclose(f);
    if (inode && stat(path, &st) == 0) *inode = st.st_ino;
}

static void add_chip(void) {
    if (emu->chips == EMU_CHIPS) exit(1);
    uint32_t i = emu->chips;
    emu_chip_t *c = &emu->chip[i];
    char text[32];
    snprintf(c->name, sizeof c->name, "gpiochip%u", i);
    snprintf(c->label, sizeof c->label, "%.31s", word());
    c->count = unsigned_number();
    for (int k = 0; k < EMU_LINES; k++) {
        c->line[k].outside = -1;
        c->line[k].flags = GPIO_V2_LINE_FLAG_INPUT;
    }
    snprintf(text, sizeof text, "%d:%u\n", EMU_MAJOR, i);
    write_file("sys", c->name, text, NULL);
    write_file("dev", c->name, "", &c->inode);
    emu->chips++;
}

static emu_line_t *line(void) {
    uint32_t chip = unsigned_number(), offset = unsigned_number();
    if (chip >= emu->chips || offset >= emu->chip[chip].count) exit(1);
    return &emu->chip[chip].line[offset];
}

static void add_axis(void) {
    emu_axis_t *a = &emu->axis[unsigned_number() % EMU_AXES];
    a->chip = unsigned_number();
    a->step = unsigned_number();
    a->dir = unsigned_number();
    a->limit = unsigned_number();
    a->position = number();
    a->at = number();
    a->active_level = unsigned_number();
    a->live = 1;
    emu_input(a->chip, a->limit, (int)(a->position <= a->at ? a->active_level : !a->active_level));
}

static void add_rule(void) {
    if (emu->rules == EMU_RULES) exit(1);
    emu_rule_t r = {.live = 1, .chip = unsigned_number(), .count = 1};
    const char *trigger = word();
    r.trigger = trigger[0] == 's' ? EMU_AT_SETS : trigger[1] == 'i' ? EMU_AT_RISES : EMU_AT_REQUESTS;
    if (r.trigger == EMU_AT_RISES) r.line = unsigned_number();
    r.n = unsigned_number();
    const char *action = word();
    if (strcmp(action, "in") == 0) {
        r.action = EMU_DO_INPUT;
        r.action_line = unsigned_number();
        r.value = number();
    } else if (strcmp(action, "unplug") == 0) {
        r.action = EMU_DO_UNPLUG;
    } else {
        r.action = strcmp(action, "signal") == 0      ? EMU_DO_SIGNAL
                   : strcmp(action, "stall") == 0     ? EMU_DO_STALL
                   : strcmp(action, "set-error") == 0 ? EMU_DO_SET_ERROR
                                                      : EMU_DO_REQUEST_ERROR;
        r.value = number();
        if (at < argc) r.count = number();
    }
    emu->rule[emu->rules++] = r;
}

static void print_log(void) {
    static const char *const KIND[] = {"?", "request", "release", "set", "config", "input", "fault", "unplug", "edge"};
    for (uint64_t i = 0; i < emu->records; i++) {
        const emu_record_t *r = &emu->record[i];
        printf("%" PRIu64 " %-7s pid %u chip %u mask 0x%" PRIx64 " levels 0x%" PRIx64 " error %d\n", r->time_ns,
               KIND[r->kind], r->pid, r->chip, r->mask, r->levels, r->error);
    }
}

static bool carry_out(void) {
    if (is("chip"))
        add_chip();
    else if (is("name")) {
        emu_line_t *l = line();
        snprintf(l->name, sizeof l->name, "%.31s", word());
    } else if (is("hog"))
        line()->hog = 1;
    else if (is("in")) {
        uint32_t chip = unsigned_number(), offset = unsigned_number();
        emu_input(chip, offset, number());
    } else if (is("axis"))
        add_axis();
    else if (is("when"))
        add_rule();
    else if (is("release-to-input"))
        emu->release_to_input = 1;
    else if (is("level"))
        printf("%d\n", line()->level);
    else if (is("rises"))
        printf("%" PRIu64 "\n", line()->rises);
    else if (is("position"))
        printf("%" PRId64 "\n", emu->axis[unsigned_number() % EMU_AXES].position);
    else if (is("log"))
        print_log();
    else
        return false;
    return true;
}

int main(int count, char **words) {
    const char *dir = getenv("GPIOEMU");
    argc = count;
    argv = words;
    if (!dir || argc < 2) {
        fprintf(stderr, "emu_tool: a command, and GPIOEMU in the environment, are needed\n");
        return 2;
    }
    if (is("init")) return init(dir) ? 0 : 1;
    if (!emu_map(dir, false)) {
        fprintf(stderr, "emu_tool: nothing emulated in %s\n", dir);
        return 1;
    }
    sigset_t before = emu_lock();
    emu_reap();
    bool known = carry_out();
    emu_unlock(before);
    return known ? 0 : 2;
}
