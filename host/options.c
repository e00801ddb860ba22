/* options.c - getopt_long, and every name checked before any work is done. */
#include "host/options.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "host/writer.h"

void options_help(void) {
    fputs("Usage: ridgeline plot SCENE|- [-o FILE]... [--set 'COMMAND']... [--stats FILE.json] [-v]\n"
          "       ridgeline trace A.vcd [B.vcd]\n"
          "       ridgeline [-o FILE]... [--set 'COMMAND']...\n"
          "\n"
          "plot draws the scene, a file of commands (- reads them from standard input).\n"
          "  -o, --output FILE   write the drawing there; the suffix decides what:\n"
          "                        .svg .png .pdf   a picture at true size\n"
          "                        .vcd             the step trace of the simulated plotter\n"
          "                        .seg             camera and segments as text\n"
          "                        .hpgl .plt       for an HP plotter\n"
          "                        .gcode           for a Grbl plotter (M3 lowers the pen, M5 lifts it)\n"
          "                      Further pages of a scene go to FILE-2, FILE-3, ...\n"
          "  --set 'COMMAND'     run a command before the scene, for example --set 'set paper a3'\n"
          "  --stats FILE.json   write what each page took: times, lengths, memory\n"
          "  -v, --verbose       print the same as a table\n"
          "  --hal gpio --pins FILE\n"
          "                      draw it: on the machine at this board's gpio lines (docs/LINUX.md)\n"
          "  --dry-run           with --hal: check the pins, say what would happen and how long it takes\n"
          "\n"
          "jog, home, pen and off set up a machine at gpio lines; `ridgeline off --help` tells more.\n"
          "trace judges a step trace, or compares two; see ridgeline trace --help.\n"
          "\n"
          "Without a command, ridgeline prompts for commands. Plots go to plot.svg, or to the files of -o,\n"
          "each replacing the one before. `help` lists the commands, `quit` or Ctrl-D ends.\n"
          "\n"
          "Exit status: 0 done, 2 bad input, 1 anything else.\n",
          stdout);
}

static bool complain(const char *what, const char *which) {
    fprintf(stderr, "ridgeline: %s%s\nTry `ridgeline --help`.\n", what, which);
    return false;
}

static bool add_output(options_t *o, const char *name) {
    if (!writer_knows(name)) {
        fprintf(stderr, "ridgeline: %s: unknown format; the name must end in one of %s\n", name, WRITER_SUFFIXES);
        return false;
    }
    if (o->outputs == JOB_OUTPUTS_MAX) return complain("too many outputs", "");
    o->output[o->outputs++] = name;
    return true;
}

bool options_parse(options_t *o, int argc, char **argv) {
    static const struct option LONG[] = {
        {"output", required_argument, NULL, 'o'}, {"set", required_argument, NULL, 's'},
        {"stats", required_argument, NULL, 'j'},  {"hal", required_argument, NULL, 'H'},
        {"pins", required_argument, NULL, 'p'},   {"dry-run", no_argument, NULL, 'n'},
        {"verbose", no_argument, NULL, 'v'},      {"help", no_argument, NULL, 'h'},
        {"version", no_argument, NULL, 'V'},      {NULL, 0, NULL, 0},
    };
    memset(o, 0, sizeof *o);
    opterr = 0;
    const char *hal = NULL;
    int c;
    while ((c = getopt_long(argc, argv, ":o:vh", LONG, NULL)) != -1) {
        switch (c) {
        case 'o':
            if (!add_output(o, optarg)) return false;
            break;
        case 's':
            if (o->sets == OPTIONS_SETS_MAX) return complain("too many --set", "");
            o->set[o->sets++] = optarg;
            break;
        case 'j':
            o->stats = optarg;
            break;
        case 'H':
            hal = optarg;
            break;
        case 'p':
            o->gpio.pins = optarg;
            break;
        case 'n':
            o->gpio.dry_run = true;
            break;
        case 'v':
            o->verbose = true;
            break;
        case 'h':
            o->help = true;
            break;
        case 'V':
            o->version = true;
            break;
        case ':':
            return complain("a value is missing after ", argv[optind - 1]);
        default:
            return complain("unknown option ", argv[optind - 1]);
        }
    }
    if (hal && strcmp(hal, "gpio") != 0) return complain("--hal can only be gpio, not ", hal);
    if (hal && !o->gpio.pins) return complain("--hal gpio needs a pin file: --pins FILE", "");
    if (!hal && (o->gpio.pins || o->gpio.dry_run)) return complain("--pins and --dry-run go with --hal gpio", "");
    if (optind < argc) o->scene = argv[optind++];
    if (optind < argc) return complain("one scene at a time, please: ", argv[optind]);
    return true;
}
