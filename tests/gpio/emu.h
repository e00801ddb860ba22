/* emu.h - an emulated gpiochip for tests: what the preload library (emu_preload.c), the control tool (emu_tool.c) and
 * the judge (emu_judge.c) share.
 *
 * The preload library serves the gpiochip character device, uAPI v1 and v2, to unmodified programs: libgpiod of both
 * versions and its tools. Everything is in one file, $GPIOEMU/state, which each process maps; so the recording is
 * seen from outside, and is there after SIGKILL. $GPIOEMU/dev holds a file for each chip, /sys one for each as
 * libgpiod looks there, /req a FIFO for each request of lines.
 *
 * A request is a FIFO under flock(): the lock goes exactly when the last copy of its open file goes - closed, exited,
 * killed - as a request's lines are released by the kernel. */
#ifndef EMU_H
#define EMU_H

#include <signal.h>
#include <stdbool.h>
#include <stdint.h>

#define EMU_MAGIC 0x454d5531u
#define EMU_MAJOR 254 /* of the device numbers */
#define EMU_CHIPS 4
#define EMU_LINES 64
#define EMU_REQUESTS 48
#define EMU_RULES 16
#define EMU_AXES 2
#define EMU_RECORDS (1u << 21) /* the file is sparse */
#define EMU_PATH 256

enum emu_abi { EMU_FREE, EMU_V1_HANDLE, EMU_V1_EVENT, EMU_V2 };
enum emu_kind { EMU_REQUEST = 1, EMU_RELEASE, EMU_SET, EMU_CONFIG, EMU_INPUT, EMU_FAULT, EMU_UNPLUG, EMU_EDGE };

/* One thing that happened. */
typedef struct emu_record {
    uint64_t time_ns;      /* CLOCK_MONOTONIC */
    uint64_t mask, levels; /* lines concerned, by offset, and their electrical levels */
    uint32_t pid, request;
    uint16_t kind, chip;
    int32_t error;
} emu_record_t;

typedef struct emu_line {
    char name[32], consumer[32];
    uint64_t flags;       /* GPIO_V2_LINE_FLAG_*, without USED */
    uint32_t request;     /* index + 1 of the owner, 0 = free */
    uint32_t edges;       /* reported to this owner */
    int8_t outside;       /* driven from outside: -1 = floating, 0, 1 */
    uint8_t latch, level; /* of an output; as seen on the pin */
    uint8_t hog;          /* taken by the kernel */
    uint64_t rises;
} emu_line_t;

typedef struct emu_chip {
    char name[32], label[32];
    uint32_t count, unplugged;
    uint64_t inode;
    emu_line_t line[EMU_LINES];
} emu_chip_t;

typedef struct emu_request {
    uint32_t abi, chip, count, edges, pid;
    uint64_t inode;
    uint32_t offset[EMU_LINES];
} emu_request_t;

/* Once `trigger` has reached n, `action` happens. */
enum emu_trigger { EMU_AT_SETS = 1, EMU_AT_RISES, EMU_AT_REQUESTS };
enum emu_action {
    EMU_DO_INPUT = 1,
    EMU_DO_SET_ERROR,
    EMU_DO_REQUEST_ERROR,
    EMU_DO_UNPLUG,
    EMU_DO_SIGNAL,
    EMU_DO_STALL
};
typedef struct emu_rule {
    uint32_t live, trigger, chip, line;
    uint64_t n;
    uint32_t action, action_line;
    int32_t value, count; /* count: errors in a row, -1 = for ever */
} emu_rule_t;

/* A carriage: counts the pulses of a STEP line with the sign of a DIR line, and moves a switch. */
typedef struct emu_axis {
    uint32_t live, chip, step, dir, limit;
    uint32_t active_level; /* of the switch, when the position is at most `at` */
    int64_t position, at;
} emu_axis_t;

typedef struct emu_state {
    uint32_t magic, lock; /* lock: thread id of the holder, 0 = free */
    uint32_t chips, rules;
    uint32_t release_to_input; /* what becomes of a released output: 0 it goes on driving, 1 it becomes an input */
    uint64_t sets, requests, records, dropped;
    int32_t set_error, set_errors, request_error, request_errors;
    emu_chip_t chip[EMU_CHIPS];
    emu_request_t request[EMU_REQUESTS];
    emu_rule_t rule[EMU_RULES];
    emu_axis_t axis[EMU_AXES];
    emu_record_t record[EMU_RECORDS];
} emu_state_t;

extern emu_state_t *emu; /* NULL until mapped */
extern char emu_dir[EMU_PATH];

bool emu_map(const char *dir, bool create);
/* No signal handler runs while the lock is held, as none does within a system call. A holder that was killed loses it.
 */
sigset_t emu_lock(void);
void emu_unlock(sigset_t before);

/* With the lock held: */
void emu_note(enum emu_kind kind, uint32_t chip, uint32_t request, uint64_t mask, uint64_t levels, int error);
/* The electrical level that the line's settings make. */
uint8_t emu_level(const emu_line_t *l);
/* Works out a pin again: edges, axes and rules follow. */
void emu_refresh(uint32_t chip, uint32_t offset);
/* Drives a pin from outside. */
void emu_input(uint32_t chip, uint32_t offset, int level);
void emu_unplug(uint32_t chip);
void emu_rules(enum emu_trigger trigger, uint32_t chip, uint32_t line, uint64_t value);
void emu_release(emu_line_t *l);
/* Releases the lines of requests whose file is gone. */
void emu_reap(void);
bool emu_reap_one(uint32_t request);

#endif
