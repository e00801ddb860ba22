/* pins.c - see pins.h. A line is split into at most WORDS_MAX words; each keeps its column for the messages. */
#include "hal/linux/pins.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define LINE_MAX_BYTES 256
#define WORDS_MAX 5

static const char *const NAME[PINS_COUNT] = {
    "enable", "pen", "x_dir", "y_dir", "x_step", "y_step", "limit_x", "limit_y", "estop",
};

typedef struct word {
    char *text;
    bool quoted;
    int column;
} word_t;

typedef struct reader {
    pins_t *pins;
    const char *file;
    FILE *out;
    int line, mistakes;
    int chip; /* the default, or -1 */
} reader_t;

const char *pins_name(enum pins_name pin) {
    return NAME[pin];
}

__attribute__((format(printf, 3, 4))) static void complain(reader_t *r, int column, const char *format, ...) {
    va_list args;
    fprintf(r->out, "%s:%d:%d: ", r->file, r->line, column);
    va_start(args, format);
    vfprintf(r->out, format, args);
    va_end(args);
    fputc('\n', r->out);
    r->mistakes++;
}

/* Splits in place; -1 after a complaint. */
static int split(reader_t *r, char *line, word_t *word) {
    int n = 0;
    for (char *p = line;;) {
        p += strspn(p, " \t\r\n");
        if (!*p || *p == '#') return n;
        if (n == WORDS_MAX) {
            complain(r, (int)(p - line) + 1, "too much on this line");
            return -1;
        }
        word[n] = (word_t){.text = p, .quoted = *p == '"', .column = (int)(p - line) + 1};
        if (word[n].quoted) {
            word[n].text = ++p;
            p += strcspn(p, "\"\r\n");
            if (*p != '"') {
                complain(r, word[n].column, "the quote is not closed");
                return -1;
            }
        } else {
            p += strcspn(p, " \t\r\n#\"");
        }
        n++;
        char end = *p;
        if (!end) return n;
        if (end == '#' || (end == '"' && !word[n - 1].quoted)) {
            if (end == '#') {
                *p = 0;
                return n;
            }
            complain(r, (int)(p - line) + 1, "a quote in the middle of a word");
            return -1;
        }
        *p++ = 0;
    }
}

/* A chip by name, path or label: its index, or -1. */
static int find_chip(const pins_t *p, const char *what) {
    for (int i = 0; i < PINS_CHIPS_MAX; i++) {
        if (!p->chip[i]) continue;
        const char *name = lines_chip_name(p->chip[i]);
        if (strcmp(what, name) == 0 || strcmp(what, lines_chip_label(p->chip[i])) == 0) return i;
        if (strncmp(what, "/dev/", 5) == 0 && strcmp(what + 5, name) == 0) return i;
    }
    return -1;
}

static void complain_chip(reader_t *r, int column, const char *what) {
    char path[64];
    snprintf(path, sizeof path, "%s%.40s", what[0] == '/' ? "" : "/dev/", what);
    if (access(path, F_OK) == 0 && access(path, R_OK | W_OK) != 0)
        complain(r, column, "%s may not be used by this user: %s (is the user in the group gpio?)", path,
                 strerror(errno));
    else
        complain(r, column, "there is no chip \"%s\" (gpiodetect lists them)", what);
}

static bool is_number(const char *s) {
    return *s && s[strspn(s, "0123456789")] == 0;
}

/* Where the word points to. The name of a chip may have been given before a colon. */
static bool resolve(reader_t *r, const word_t *w, pins_pin_t *pin) {
    const pins_t *p = r->pins;
    char *name = w->text, *colon = w->quoted ? NULL : strrchr(w->text, ':');
    int chip = r->chip, column = w->column;
    if (colon) {
        *colon = 0;
        chip = find_chip(p, w->text);
        if (chip < 0) {
            complain_chip(r, column, w->text);
            return false;
        }
        name = colon + 1;
        column += (int)(name - w->text);
    }
    if (!w->quoted && is_number(name)) {
        if (chip < 0) {
            complain(r, column, "line %s of which chip? Write chip:%s, or name a chip first: chip gpiochip0", name,
                     name);
            return false;
        }
        unsigned long offset = strtoul(name, NULL, 10);
        unsigned count = lines_chip_count(p->chip[chip]);
        if (offset >= count) {
            complain(r, column, "%s has no line %s; its last is %u", lines_chip_name(p->chip[chip]), name, count - 1);
            return false;
        }
        pin->chip = chip;
        pin->offset = (unsigned)offset;
        return true;
    }
    int offset = chip >= 0 ? lines_find(p->chip[chip], name) : -ENOENT;
    for (int i = 0; offset < 0 && !colon && i < PINS_CHIPS_MAX; i++) {
        if (!p->chip[i]) continue;
        offset = lines_find(p->chip[i], name);
        chip = i;
    }
    if (offset < 0) {
        complain(r, column, "there is no line named \"%s\" (gpioinfo lists them)", name);
        return false;
    }
    pin->chip = chip;
    pin->offset = (unsigned)offset;
    return true;
}

/* Is the line free: not another pin of ours, nobody else's? */
static void check_free(reader_t *r, enum pins_name which) {
    const pins_t *p = r->pins;
    const pins_pin_t *pin = &p->pin[which];
    const char *chip = lines_chip_name(p->chip[pin->chip]);
    for (int i = 0; i < PINS_COUNT; i++) {
        const pins_pin_t *other = &p->pin[i];
        if (i == (int)which || !other->given || other->chip != pin->chip || other->offset != pin->offset) continue;
        complain(r, pin->column, "line %u of %s is already %s, on line %d", pin->offset, chip, NAME[i], other->line);
        return;
    }
    lines_info_t info;
    int err = lines_info(p->chip[pin->chip], pin->offset, &info);
    if (err)
        complain(r, pin->column, "line %u of %s: %s", pin->offset, chip, strerror(-err));
    else if (info.used)
        complain(r, pin->column, "line %u of %s is in use by \"%s\"", pin->offset, chip,
                 info.consumer[0] ? info.consumer : "?");
}

static void read_options(reader_t *r, enum pins_name which, const word_t *word, int count) {
    static const char *const PULL[] = {"pull_up", "pull_down", "no_pull"};
    pins_pin_t *pin = &r->pins->pin[which];
    bool polar = false, pulled = false;
    for (int i = 0; i < count; i++) {
        const char *text = word[i].text;
        int pull = 0;
        while (pull < 3 && strcmp(text, PULL[pull]) != 0) pull++;
        if (strcmp(text, "active_low") == 0 || strcmp(text, "active_high") == 0) {
            if (polar) complain(r, word[i].column, "the polarity has been given already");
            polar = true;
            pin->active_low = text[7] == 'l';
        } else if (pull < 3 && which >= PINS_OUTPUTS) {
            if (pulled) complain(r, word[i].column, "the pull has been given already");
            pulled = true;
            pin->pull = (enum lines_pull)pull;
        } else if (pull < 3) {
            complain(r, word[i].column, "%s is an output: a pull is for inputs", NAME[which]);
        } else {
            complain(r, word[i].column, "unknown word \"%s\"; active_low, active_high%s", text,
                     which >= PINS_OUTPUTS ? ", pull_up, pull_down, no_pull" : "");
        }
    }
}

static void read_pin(reader_t *r, const word_t *word, int count) {
    int which = 0;
    while (which < PINS_COUNT && strcmp(word[0].text, NAME[which]) != 0) which++;
    if (which == PINS_COUNT) {
        complain(r, word[0].column,
                 "unknown name \"%s\"; the names are chip, x_step, x_dir, y_step, y_dir, pen, enable, limit_x, "
                 "limit_y, estop",
                 word[0].text);
        return;
    }
    pins_pin_t *pin = &r->pins->pin[which];
    if (pin->line) {
        complain(r, word[0].column, "%s has been given already, on line %d", NAME[which], pin->line);
        return;
    }
    *pin = (pins_pin_t){.active_low = which >= PINS_OUTPUTS, .line = r->line, .column = word[0].column};
    if (count < 2) {
        complain(r, word[0].column, "%s is on which line?", NAME[which]);
        return;
    }
    pin->column = word[1].column;
    read_options(r, (enum pins_name)which, word + 2, count - 2);
    if (!resolve(r, &word[1], pin)) return;
    check_free(r, (enum pins_name)which);
    pin->given = true;
}

static void read_chip(reader_t *r, const word_t *word, int count) {
    if (count != 2) {
        complain(r, word[0].column, "chip takes one name, path or label");
        return;
    }
    r->chip = find_chip(r->pins, word[1].text);
    if (r->chip < 0) complain_chip(r, word[1].column, word[1].text);
}

/* What only the whole file shows. */
static void check_whole(reader_t *r) {
    const pins_t *p = r->pins;
    const pins_pin_t *first = &p->pin[PINS_ENABLE];
    for (int i = 0; i < PINS_OUTPUTS; i++) {
        const pins_pin_t *pin = &p->pin[i];
        if (!pin->line) {
            fprintf(r->out, "%s: %s is missing\n", r->file, NAME[i]);
            r->mistakes++;
        } else if (pin->given && first->given && pin->chip != first->chip) {
            r->line = pin->line;
            complain(r, pin->column, "%s is on %s but enable on %s: outputs must be on one chip", NAME[i],
                     lines_chip_name(p->chip[pin->chip]), lines_chip_name(p->chip[first->chip]));
        }
    }
}

int pins_read(pins_t *p, FILE *file, const char *name, FILE *complaints) {
    memset(p, 0, sizeof *p);
    for (int i = 0; i < PINS_CHIPS_MAX; i++) {
        char path[32];
        snprintf(path, sizeof path, "/dev/gpiochip%d", i);
        p->chip[i] = lines_chip_open(path);
    }
    reader_t r = {.pins = p, .file = name, .out = complaints, .chip = -1};
    char line[LINE_MAX_BYTES];
    while (fgets(line, sizeof line, file)) {
        word_t word[WORDS_MAX];
        r.line++;
        if (!strchr(line, '\n') && !feof(file)) {
            complain(&r, LINE_MAX_BYTES - 1, "the line is too long");
            break;
        }
        int count = split(&r, line, word);
        if (count <= 0) continue;
        if (strcmp(word[0].text, "chip") == 0)
            read_chip(&r, word, count);
        else
            read_pin(&r, word, count);
    }
    check_whole(&r);
    return r.mistakes;
}

void pins_close(pins_t *p) {
    for (int i = 0; i < PINS_CHIPS_MAX; i++) {
        lines_chip_close(p->chip[i]);
        p->chip[i] = NULL;
    }
}

void pins_describe(const pins_t *p, enum pins_name which, char *text, size_t size) {
    const pins_pin_t *pin = &p->pin[which];
    lines_info_t info = {0};
    if (!pin->given) {
        snprintf(text, size, "none");
        return;
    }
    lines_info(p->chip[pin->chip], pin->offset, &info);
    snprintf(text, size, "%s line %u%s%s%s, active %s", lines_chip_name(p->chip[pin->chip]), pin->offset,
             info.name[0] ? " (" : "", info.name, info.name[0] ? ")" : "", pin->active_low ? "low" : "high");
}
