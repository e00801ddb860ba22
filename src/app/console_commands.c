/* console_commands.c - the commands that only a board has. They are whole commands, so that `home = 3` stays a
 * variable.
 *
 *     home, unlock, pen up|down, motors on|off        the machine
 *     save, load, autorun on|off                      the saved scene
 *     status, memory, help board */
#include <string.h>

#include "app/console_parts.h"
#include "app/say.h"
#include "app/store.h"
#include "error.h"
#include "hal/hal.h"

#define STOPS_MS 20 /* after it was asked to, the other side has: nothing is received while some chips write */

static const char AUTORUN[] = "autorun on\n";

static int refused(const char *why) {
    say(why);
    return ERR_MACHINE;
}

static int home(console_t *c) {
    if (hal_inputs() & HAL_IN_ESTOP) return refused("The emergency stop is pressed.\n");
    if (c->session.settings.machine.limits == MACHINE_LIMITS_OFF)
        return refused("There are no limit switches to home to: set machine limits on, or homing.\n");
    realtime_busy(&c->realtime, true);
    int err = carriage_home(&c->carriage, &c->session.settings.machine);
    realtime_busy(&c->realtime, false);
    c->realtime.cancelled = false;
    if (!err) say("home\n");
    return err;
}

static int unlock(console_t *c) {
    if (!carriage_unlock(&c->carriage)) return refused("The emergency stop is pressed.\n");
    say("unlocked: the pen is taken to be at its origin\n");
    return 0;
}

static int pen_up(console_t *c) {
    carriage_pen_test(&c->carriage, &c->session.settings.machine, false);
    return 0;
}

static int pen_down(console_t *c) {
    carriage_pen_test(&c->carriage, &c->session.settings.machine, true);
    return 0;
}

static int motors_on(console_t *c) {
    carriage_motors(&c->carriage, true);
    return 0;
}

static int motors_off(console_t *c) {
    carriage_motors(&c->carriage, false);
    return 0;
}

/* Free memory as a record, and how much text it can hold so that store_save has room, too. */
static store_record_t *borrow(console_t *c, size_t *room, size_t *text) {
    store_record_t *r = console_free_memory(c, room);
    size_t half = *room / 8 * 4;
    *text = half < sizeof *r + 4 ? 0 : half - sizeof *r;
    if (*text > STORE_TEXT_MAX) *text = STORE_TEXT_MAX;
    return r;
}

static int keep_text(console_t *c, enum store_kind kind, store_record_t *r, int len, size_t room) {
    if (len < 0) return len;
    realtime_busy(&c->realtime, true);
    console_pause(c, STOPS_MS);
    int err = store_save(kind, r, (size_t)len, room);
    realtime_busy(&c->realtime, false);
    return err;
}

static int save(console_t *c) {
    size_t room, text;
    store_record_t *r = borrow(c, &room, &text);
    if (!text) return ERR_FULL;
    int len = keep_scene(&c->keep, &c->session, &c->capture, r->text, text);
    if (len == ERR_EMPTY) say("There is no plot to save yet.\n");
    if (len == ERR_DATA) say("A scene with inline data cannot be saved.\n");
    if (len == ERR_FULL) say("The scene's text is too long to be saved.\n");
    int err = keep_text(c, STORE_SCENE, r, len, room);
    if (!err) say("saved\n");
    return err;
}

int console_keep_settings(console_t *c) {
    if (c->loading) return 0;
    console_wire(c); /* until the power goes, even if it cannot be kept */
    c->kept_machine = c->session.settings.machine;
    size_t room, text;
    store_record_t *r = borrow(c, &room, &text);
    if (text < sizeof AUTORUN) return ERR_FULL;
    int len = keep_machine(&c->session, &c->capture, r->text, text - sizeof AUTORUN);
    if (len >= 0 && c->autorun) {
        memcpy(r->text + len, AUTORUN, sizeof AUTORUN);
        len += (int)sizeof AUTORUN - 1;
    }
    return keep_text(c, STORE_SETTINGS, r, len, room);
}

/* Line by line, none with a command of the board. A plot may use the memory that the text lies in: it is the last line.
 */
static int run_text(console_t *c, char *text, int len) {
    char *end = text + len;
    int err = 0;
    c->loading = true;
    while (text < end && !err) {
        char *lf = memchr(text, '\n', (size_t)(end - text));
        if (!lf) break;
        *lf = '\0';
        err = console_line(c, text);
        text = lf + 1;
    }
    c->loading = false;
    return err;
}

void console_load_settings(console_t *c) {
    size_t room, text;
    store_record_t *r = borrow(c, &room, &text);
    int len = store_load(STORE_SETTINGS, r, room);
    const int before = len - (int)(sizeof AUTORUN - 1);
    c->autorun = before >= 0 && memcmp(r->text + before, AUTORUN, sizeof AUTORUN - 1) == 0;
    if (len >= 0) run_text(c, r->text, c->autorun ? before : len);
    console_wire(c);
    c->kept_machine = c->session.settings.machine;
}

int console_load(console_t *c) {
    size_t room, text;
    store_record_t *r = borrow(c, &room, &text);
    int len = store_load(STORE_SCENE, r, room);
    if (len == ERR_EMPTY) say("There is no saved scene.\n");
    if (len < 0) return len;
    session_line(&c->session, "reset session"); /* the same picture, whatever was typed before */
    c->session.settings.machine = c->kept_machine;
    keep_clear(&c->keep);
    return run_text(c, r->text, len);
}

static int set_autorun(console_t *c, bool on) {
    c->autorun = on;
    return console_keep_settings(c);
}
static int autorun_on(console_t *c) {
    return set_autorun(c, true);
}
static int autorun_off(console_t *c) {
    return set_autorun(c, false);
}

static int status(console_t *c) {
    char line[REALTIME_STATUS_MAX];
    text_t t = text_start(line, sizeof line);
    realtime_status(&c->realtime, &t);
    say_line(line);
    say("\n");
    return 0;
}

static void tell(const char *what, int64_t used, int64_t of) {
    char line[80];
    text_t t = text_start(line, sizeof line);
    text_add(&t, what);
    text_add(&t, " ");
    text_add_int(&t, used);
    if (of) {
        text_add(&t, " of ");
        text_add_int(&t, of);
    }
    text_add(&t, "\n");
    say_line(line);
}

/* High-water marks in bytes, those of the picture from the last drawing, and how the machine was fed. */
static int memory(console_t *c) {
    const picture_stats_t *p = &c->picture.stats;
    const lang_t *l = &c->session.lang;
    const data_pool_t *pool = &c->session.pool;
    size_t pool_used = pool->low + c->session.pool_size - pool->high;
    tell("console", sizeof *c, 0);
    tell("machine's queue", c->stats.memory_bytes, (int64_t)c->carriage.bytes);
    tell("data", (int64_t)(pool_used * sizeof *pool->base), (int64_t)(c->session.pool_size * sizeof *pool->base));
    tell("picture: hiding", (int64_t)p->kernel_bytes, (int64_t)c->picture_bytes);
    tell("picture: ordering", (int64_t)p->path_bytes, (int64_t)c->picture_bytes);
    tell("picture: tables", (int64_t)(p->cache_bytes + p->map_bytes), (int64_t)c->picture_bytes);
    tell("names", l->symbols, CONFIG_SYMBOLS);
    tell("names' text", l->bodies_end + CONFIG_POOL - l->names_start, CONFIG_POOL);
    tell("definitions", c->keep.len, CONFIG_JOURNAL);
    tell("typed ahead", c->realtime.most, CONFIG_TYPED);
    uint32_t room, stack = hal_stack_used(&room);
    if (room) tell("stack", stack, room);
    tell("machine waited for the drawing:", c->stats.starved, 0);
    tell("late deadlines:", c->stats.late, 0);
    return 0;
}

/* What typed solids take, as towers of cubes and lattices of struts do that fill a board (docs/BOARD.md). */
#define CUBE_BYTES 1350
#define STRUT_BYTES 110
#define STRUTS_BYTES (600 + (int)HIDDEN_LENT(uint8_t[290])) /* and once for all of them */

static void tell_room(const console_t *c) {
    const int64_t bytes = (int64_t)(c->session.pool_size * sizeof *c->session.pool.base);
    char line[96];
    text_t t = text_start(line, sizeof line);
    text_add(&t, "Room for a scene: ");
    text_add_int(&t, bytes);
    text_add(&t, " bytes, about ");
    text_add_int(&t, bytes / CUBE_BYTES);
    text_add(&t, " cubes");
    if (CONFIG_HALO) {
        text_add(&t, " or ");
        text_add_int(&t, (bytes - STRUTS_BYTES) / STRUT_BYTES);
        text_add(&t, " struts with haloes");
    }
    text_add(&t, "\n");
    say_line(line);
}

static int help_board(console_t *c) {
    session_line(&c->session, "help board");
    tell_room(c);
    return 0;
}

static const struct {
    const char *line;
    int (*run)(console_t *c);
    bool at_rest; /* refused in alarm */
} COMMAND[] = {
    {"home", home, false},
    {"unlock", unlock, false},
    {"pen up", pen_up, false},
    {"pen down", pen_down, true},
    {"motors on", motors_on, true},
    {"motors off", motors_off, false},
    {"save", save, false},
    {"load", console_load, false},
    {"autorun on", autorun_on, false},
    {"autorun off", autorun_off, false},
    {"status", status, false},
    {"memory", memory, false},
    {"help board", help_board, false},
};

static bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

/* Equal but for blanks around and between words? */
static bool is_command(const char *p, const char *end, const char *command) {
    while (p < end && is_blank(*p)) p++;
    for (; *command; command++, p++) {
        if (p == end || (*command == ' ' ? !is_blank(*p) : *p != *command)) return false;
        while (*command == ' ' && p + 1 < end && is_blank(p[1])) p++;
    }
    while (p < end && is_blank(*p)) p++;
    return p == end;
}

int console_command_find(const char *from, const char *end) {
    int i = (int)(sizeof COMMAND / sizeof COMMAND[0]);
    while (--i >= 0 && !is_command(from, end, COMMAND[i].line)) continue;
    return i;
}

int console_command(console_t *c, int number) {
    const bool locked = COMMAND[number].at_rest && carriage_alarm(&c->carriage);
    const int err = locked ? refused("error: locked: home or unlock first\n") : COMMAND[number].run(c);
    if (err && err != ERR_MACHINE && err != ERR_EMPTY && err != ERR_DATA) { /* of these was spoken already */
        say("error: ");
        say(error_text(err));
        say("\n");
    }
    return err;
}
