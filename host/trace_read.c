/* trace_read.c - Value Change Dumps of any tool (IEEE 1364-2001 section 18): tokens, declarations, changes. */
#include "error.h"
#include "hal/hal.h"
#include "host/trace.h"
#include <stdlib.h>
#include <string.h>

#define TOKEN_MAX 128 /* longer tokens (vectors) are cut: none of ours is */
#define CHUNK 65536
#define ID_MAX 16
#define SIGNALS 6

static const char *const NAME[SIGNALS] = {"x_step", "x_dir", "y_step", "y_dir", "pen", "enable"};

typedef struct reader {
    FILE *file; /* NULL: text */
    const char *text;
    size_t at, used;
    unsigned long line;
    char token[TOKEN_MAX];
    size_t length;
    trace_error_t *error;
    int failed;

    trace_t *out;
    size_t room;
    char id[SIGNALS][ID_MAX];    /* identifier codes; empty: not declared */
    uint8_t by_char[128];        /* pins of identifiers of one character */
    uint64_t unit_num, unit_den; /* ps per unit */
    bool seen;                   /* a value of a pin was seen */
    bool first;                  /* still in the first instant: values are the initial ones */
    uint64_t now_ps;
    uint8_t pins, changed;
    char chunk[CHUNK];
} reader_t;

static int fail(reader_t *r, int code, const char *what) {
    if (!r->failed) {
        r->failed = code;
        r->error->line = r->line;
        snprintf(r->error->text, sizeof r->error->text, "%s", what);
    }
    return code;
}

static inline int next_char(reader_t *r) {
    if (r->at == r->used) {
        if (!r->file) return EOF;
        r->used = fread(r->chunk, 1, CHUNK, r->file);
        r->at = 0;
        r->text = r->chunk;
        if (r->used == 0) {
            if (ferror(r->file)) fail(r, ERR_FILE, "cannot read the file");
            return EOF;
        }
    }
    return (unsigned char)r->text[r->at++];
}

/* The next word; false at the end of the file. The newline after it is counted with the next word. */
static bool next_token(reader_t *r) {
    int c;
    while ((c = next_char(r)) == ' ' || (c >= '\t' && c <= '\r'))
        if (c == '\n') r->line++;
    if (c == EOF) return false;
    size_t n = 0;
    do {
        if (n < TOKEN_MAX - 1) r->token[n++] = (char)c;
        c = next_char(r);
    } while (c > ' ');
    if (c != EOF) r->at--; /* a chunk has at least the character just read */
    r->token[n] = 0;
    r->length = n;
    return true;
}

static bool is(const reader_t *r, const char *word) {
    return strcmp(r->token, word) == 0;
}

static int skip_section(reader_t *r) {
    while (next_token(r))
        if (is(r, "$end")) return 0;
    return fail(r, ERR_DATA, "the file ends inside a section: no $end");
}

static bool number(const char *s, uint64_t *out) {
    uint64_t v = 0;
    if (!*s) return false;
    for (; *s; s++) {
        unsigned digit = (unsigned)(*s - '0');
        if (digit > 9 || v > (UINT64_MAX - digit) / 10) return false;
        v = v * 10 + digit;
    }
    *out = v;
    return true;
}

static int read_timescale(reader_t *r) {
    static const struct {
        const char *unit;
        uint64_t num, den;
    } UNIT[] = {{"s", 1000000000000, 1}, {"ms", 1000000000, 1}, {"us", 1000000, 1},
                {"ns", 1000, 1},         {"ps", 1, 1},          {"fs", 1, 1000}};
    char text[TOKEN_MAX] = "";
    size_t n = 0;
    while (next_token(r) && !is(r, "$end")) {
        if (n + r->length >= sizeof text) return fail(r, ERR_DATA, "bad $timescale");
        memcpy(text + n, r->token, r->length + 1);
        n += r->length;
    }
    if (!is(r, "$end")) return fail(r, ERR_DATA, "the file ends inside $timescale");
    size_t digits = strspn(text, "0123456789");
    const char *unit = text + digits;
    uint64_t factor = digits == 1 ? 1 : digits == 2 ? 10 : digits == 3 ? 100 : 0;
    if (factor && memcmp(text, "100", digits) == 0)
        for (size_t i = 0; i < sizeof UNIT / sizeof UNIT[0]; i++)
            if (strcmp(unit, UNIT[i].unit) == 0) {
                r->unit_num = UNIT[i].num * factor;
                r->unit_den = UNIT[i].den;
                r->out->unit_ps = r->unit_num >= r->unit_den ? r->unit_num / r->unit_den : 1;
                return 0;
            }
    return fail(r, ERR_DATA, "bad $timescale: 1, 10 or 100 of s, ms, us, ns, ps, fs expected");
}

/* $var type width id name [index] $end */
static int read_var(reader_t *r) {
    char id[TOKEN_MAX] = "";
    uint64_t width = 0;
    int signal = -1;
    for (int field = 0;; field++) {
        if (!next_token(r)) return fail(r, ERR_DATA, "the file ends inside $var");
        if (is(r, "$end")) {
            if (field < 4) return fail(r, ERR_DATA, "incomplete $var");
            break;
        }
        if (field == 1 && !number(r->token, &width)) return fail(r, ERR_DATA, "bad width in $var");
        if (field == 2) memcpy(id, r->token, r->length + 1);
        if (field == 3)
            for (int i = 0; i < SIGNALS; i++)
                if (is(r, NAME[i])) signal = i;
    }
    if (signal < 0 || r->id[signal][0]) return 0;
    if (width != 1) return fail(r, ERR_DATA, "a pin must be one bit wide");
    if (strlen(id) >= ID_MAX) return fail(r, ERR_DATA, "identifier too long");
    memcpy(r->id[signal], id, strlen(id) + 1);
    if (!id[1] && (unsigned char)id[0] < 128) r->by_char[(unsigned char)id[0]] |= (uint8_t)(1u << signal);
    return 0;
}

static int end_definitions(reader_t *r) {
    if (skip_section(r)) return r->failed;
    if (!r->unit_num) return fail(r, ERR_DATA, "no $timescale");
    for (int i = 0; i < 4; i++)
        if (!r->id[i][0]) {
            char text[64];
            snprintf(text, sizeof text, "no signal named %s", NAME[i]);
            return fail(r, ERR_DATA, text);
        }
    r->out->has_pen = r->id[4][0] != 0;
    r->out->has_enable = r->id[5][0] != 0;
    return 0;
}

/* The words that sim/vcd.c leaves: name value [value]. */
static int read_machine(reader_t *r) {
    machine_t m;
    machine_default(&m);
    uint32_t *const plain[] = {&m.draw_speed_um_s, &m.travel_speed_um_s, &m.accel_um_s2,  &m.junction_um,
                               &m.lift_us,         &m.lower_us,          &m.dir_setup_ns, &m.pulse_ns};
    static const char *const word[] = {"draw_um_s", "travel_um_s", "accel_um_s2",  "junction_um",
                                       "lift_us",   "lower_us",    "dir_setup_ns", "pulse_ns"};
    while (next_token(r) && !is(r, "$end")) {
        bool pair = is(r, "steps_per_mm_q16"), turned = is(r, "invert"), swap = is(r, "swap"),
             kind = is(r, "kinematics");
        uint32_t *value = NULL;
        for (size_t i = 0; i < sizeof word / sizeof word[0]; i++)
            if (is(r, word[i])) value = plain[i];
        for (int i = 0; i < (pair || turned ? 2 : 1); i++) {
            uint64_t v = 0;
            if (!next_token(r) || is(r, "$end") || (!kind && (!number(r->token, &v) || v > UINT32_MAX)))
                return fail(r, ERR_DATA, "bad machine in a $comment");
            if (pair && v < 1) return fail(r, ERR_DATA, "bad machine in a $comment: no steps per mm");
            if (pair) m.steps_per_mm_q16[i] = (uint32_t)v;
            if (turned) m.invert[i] = v != 0;
            if (swap) m.swap_xy = v != 0;
            if (kind) m.kinematics = is(r, "corexy") ? MACHINE_COREXY : MACHINE_CARTESIAN;
            if (value) *value = (uint32_t)v;
        }
    }
    if (!is(r, "$end")) return fail(r, ERR_DATA, "the file ends inside a $comment");
    r->out->machine = m;
    r->out->has_machine = true;
    return 0;
}

static int read_comment(reader_t *r) {
    for (int i = 0; next_token(r); i++) {
        if (is(r, "$end")) return 0;
        if (i == 1 && is(r, "machine")) return read_machine(r);
        if (i > 1 || (i == 0 && !is(r, "ridgeline"))) return skip_section(r);
    }
    return fail(r, ERR_DATA, "the file ends inside a $comment");
}

static int read_header(reader_t *r) {
    for (;;) {
        if (!next_token(r)) return fail(r, ERR_DATA, "the file ends before $enddefinitions: not a VCD file");
        int e;
        if (is(r, "$timescale"))
            e = read_timescale(r);
        else if (is(r, "$var"))
            e = read_var(r);
        else if (is(r, "$comment"))
            e = read_comment(r);
        else if (is(r, "$enddefinitions"))
            return end_definitions(r);
        else if (r->token[0] == '$')
            e = skip_section(r);
        else
            return fail(r, ERR_DATA, "a $section expected: not a VCD file");
        if (e) return e;
    }
}

static int flush(reader_t *r) {
    if (r->first)
        r->out->initial = r->pins;
    else if (r->changed) {
        trace_t *t = r->out;
        if (t->count == r->room) {
            size_t room = r->room ? r->room * 2 : 4096;
            trace_event_t *more = realloc(t->events, room * sizeof *more);
            if (!more) return fail(r, ERR_FULL, "out of memory");
            t->events = more;
            r->room = room;
        }
        t->events[t->count++] = (trace_event_t){.time_ps = r->now_ps, .pins = r->pins, .changed = r->changed};
    }
    r->changed = 0;
    return 0;
}

static int read_time(reader_t *r) {
    uint64_t units;
    if (!number(r->token + 1, &units)) return fail(r, ERR_DATA, "bad time");
    if (units > (uint64_t)INT64_MAX / r->unit_num) return fail(r, ERR_DATA, "time out of range");
    uint64_t ps = units * r->unit_num / r->unit_den;
    if (ps < r->now_ps) return fail(r, ERR_DATA, "time goes backwards");
    if (ps > r->now_ps) {
        if (flush(r)) return r->failed;
        if (r->seen) r->first = false;
    }
    r->now_ps = ps;
    return 0;
}

static uint8_t pins_of(const reader_t *r, const char *id) {
    if (id[0] && !id[1] && (unsigned char)id[0] < 128) return r->by_char[(unsigned char)id[0]];
    uint8_t pins = 0;
    for (int i = 0; i < SIGNALS; i++)
        if (r->id[i][0] && strcmp(r->id[i], id) == 0) pins |= (uint8_t)(1u << i);
    return pins;
}

static int change(reader_t *r, const char *id, char value) {
    uint8_t which = pins_of(r, id);
    if (!which) return 0;
    r->seen = true;
    uint8_t pins = (uint8_t)(value == '1' ? r->pins | which : r->pins & ~which);
    uint8_t changed = pins ^ r->pins;
    if (!changed) return 0;
    if (!r->first && (r->changed & changed) && flush(r)) return r->failed; /* twice in one instant: keep both */
    r->pins = pins;
    r->changed |= changed;
    return 0;
}

static int read_value(reader_t *r) {
    char c = r->token[0];
    if (c == 'b' || c == 'B' || c == 'r' || c == 'R' || c == 's' || c == 'S') {
        bool one_bit = c == 'b' || c == 'B';
        char last = r->token[r->length - 1];
        if (r->length < 2) return fail(r, ERR_DATA, "empty value");
        if (!next_token(r)) return fail(r, ERR_DATA, "the file ends inside a value change");
        return one_bit ? change(r, r->token, last) : 0;
    }
    if (!c || !strchr("01xXzZuUwWlLhH-", c)) return fail(r, ERR_DATA, "a value change or #time expected");
    if (r->length < 2) return fail(r, ERR_DATA, "value without an identifier");
    if (c == 'h' || c == 'H') c = '1';
    return change(r, r->token + 1, c);
}

static int read_changes(reader_t *r) {
    bool dump_off = false;
    while (next_token(r)) {
        int e = 0;
        if (r->token[0] == '#')
            e = read_time(r);
        else if (r->token[0] != '$')
            e = dump_off ? 0 : read_value(r);
        else if (is(r, "$comment"))
            e = skip_section(r);
        else if (is(r, "$dumpoff"))
            dump_off = true;
        else if (is(r, "$end"))
            dump_off = false;
        else if (!is(r, "$dumpvars") && !is(r, "$dumpon") && !is(r, "$dumpall"))
            e = fail(r, ERR_DATA, "unknown $section");
        if (e) return e;
    }
    if (r->failed) return r->failed;
    r->out->end_ps = r->now_ps;
    return flush(r);
}

static int read_all(reader_t *r, trace_t *out, trace_error_t *error) {
    *out = (trace_t){0};
    machine_default(&out->machine);
    *error = (trace_error_t){0};
    r->out = out;
    r->error = error;
    r->line = 1;
    r->first = true;
    if (!read_header(r)) read_changes(r);
    if (r->failed) trace_free(out);
    return r->failed;
}

int trace_read(FILE *file, trace_t *out, trace_error_t *error) {
    reader_t *r = calloc(1, sizeof *r);
    if (!r) return ERR_FULL;
    r->file = file;
    int e = read_all(r, out, error);
    free(r);
    return e;
}

int trace_read_text(const char *text, size_t bytes, trace_t *out, trace_error_t *error) {
    reader_t *r = calloc(1, sizeof *r);
    if (!r) return ERR_FULL;
    r->text = text;
    r->used = bytes;
    int e = read_all(r, out, error);
    free(r);
    return e;
}

void trace_free(trace_t *t) {
    free(t->events);
    *t = (trace_t){0};
}
