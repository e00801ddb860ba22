/* emu.c - the state of the emulated chips; see emu.h. */
#define _GNU_SOURCE
#include "tests/gpio/emu.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/gpio.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

emu_state_t *emu;
char emu_dir[EMU_PATH];

/* System calls by number: in the preload library the functions of these names are our own. */
static int sys_open(const char *path, int flags) {
    return (int)syscall(SYS_openat, AT_FDCWD, path, flags, 0666);
}
static void sys_close(int fd) {
    syscall(SYS_close, fd);
}

static uint64_t now_ns(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint64_t)t.tv_sec * 1000000000u + (uint64_t)t.tv_nsec;
}

sigset_t emu_lock(void) {
    sigset_t all, before;
    uint32_t me = (uint32_t)syscall(SYS_gettid), holder;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    for (unsigned spin = 0;; spin++) {
        holder = 0;
        if (__atomic_compare_exchange_n(&emu->lock, &holder, me, false, __ATOMIC_ACQUIRE, __ATOMIC_RELAXED)) break;
        bool gone = spin > 100 && syscall(SYS_tkill, holder, 0) != 0 && errno == ESRCH;
        if (gone && __atomic_compare_exchange_n(&emu->lock, &holder, me, false, __ATOMIC_ACQUIRE, __ATOMIC_RELAXED))
            break;
        sched_yield();
    }
    return before;
}

void emu_unlock(sigset_t before) {
    __atomic_store_n(&emu->lock, 0, __ATOMIC_RELEASE);
    sigprocmask(SIG_SETMASK, &before, NULL);
}

bool emu_map(const char *dir, bool create) {
    char path[EMU_PATH + 8];
    snprintf(emu_dir, sizeof emu_dir, "%s", dir);
    snprintf(path, sizeof path, "%s/state", emu_dir);
    int fd = sys_open(path, O_RDWR | O_CLOEXEC | (create ? O_CREAT | O_TRUNC : 0));
    if (fd < 0) return false;
    void *at = MAP_FAILED;
    if (!create || ftruncate(fd, sizeof *emu) == 0)
        at = mmap(NULL, sizeof *emu, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    sys_close(fd);
    if (at == MAP_FAILED) return false;
    if (!create && ((emu_state_t *)at)->magic != EMU_MAGIC) {
        munmap(at, sizeof *emu);
        return false;
    }
    emu = at;
    return true;
}

void emu_note(enum emu_kind kind, uint32_t chip, uint32_t request, uint64_t mask, uint64_t levels, int error) {
    uint64_t i = emu->records;
    if (i >= EMU_RECORDS) {
        emu->dropped++;
        return;
    }
    emu->record[i] = (emu_record_t){
        .time_ns = now_ns(),
        .mask = mask,
        .levels = levels,
        .pid = (uint32_t)getpid(),
        .request = request,
        .kind = (uint16_t)kind,
        .chip = (uint16_t)chip,
        .error = error,
    };
    __atomic_store_n(&emu->records, i + 1, __ATOMIC_RELEASE);
}

uint8_t emu_level(const emu_line_t *l) {
    if (l->flags & GPIO_V2_LINE_FLAG_OUTPUT) {
        bool floats = ((l->flags & GPIO_V2_LINE_FLAG_OPEN_DRAIN) && l->latch) ||
                      ((l->flags & GPIO_V2_LINE_FLAG_OPEN_SOURCE) && !l->latch);
        if (!floats) return l->latch;
    }
    if (l->outside >= 0) return (uint8_t)l->outside;
    return (l->flags & GPIO_V2_LINE_FLAG_BIAS_PULL_UP) != 0;
}

static int open_request(uint32_t request, int flags) {
    char path[EMU_PATH + 16];
    snprintf(path, sizeof path, "%s/req/%u", emu_dir, request);
    return sys_open(path, flags | O_NONBLOCK | O_CLOEXEC);
}

/* Edges are of the logical value. */
static void report_edge(uint32_t chip, uint32_t offset, bool rising) {
    emu_line_t *l = &emu->chip[chip].line[offset];
    uint32_t request = l->request - 1;
    emu_request_t *r = &emu->request[request];
    uint64_t level = (uint64_t)rising << offset;
    if (l->flags & GPIO_V2_LINE_FLAG_ACTIVE_LOW) rising = !rising;
    if (!(l->flags & (rising ? GPIO_V2_LINE_FLAG_EDGE_RISING : GPIO_V2_LINE_FLAG_EDGE_FALLING))) return;
    l->edges++;
    r->edges++;
    emu_note(EMU_EDGE, chip, request, 1ull << offset, level, 0);
    int fd = open_request(request, O_WRONLY);
    if (fd < 0) return;
    if (r->abi == EMU_V1_EVENT) {
        struct gpioevent_data e = {.timestamp = now_ns()};
        e.id = rising ? GPIOEVENT_EVENT_RISING_EDGE : GPIOEVENT_EVENT_FALLING_EDGE;
        syscall(SYS_write, fd, &e, sizeof e);
    } else {
        struct gpio_v2_line_event e = {.timestamp_ns = now_ns(), .offset = offset};
        e.id = rising ? GPIO_V2_LINE_EVENT_RISING_EDGE : GPIO_V2_LINE_EVENT_FALLING_EDGE;
        e.seqno = r->edges;
        e.line_seqno = l->edges;
        syscall(SYS_write, fd, &e, sizeof e);
    }
    sys_close(fd);
}

void emu_unplug(uint32_t chip) {
    char path[EMU_PATH + 64];
    if (emu->chip[chip].unplugged) return;
    emu->chip[chip].unplugged = 1;
    emu_note(EMU_UNPLUG, chip, 0, 0, 0, ENODEV);
    for (uint32_t i = 0; i < EMU_REQUESTS; i++) { /* wakes who waits for an edge */
        if (!emu->request[i].abi || emu->request[i].chip != chip) continue;
        int fd = open_request(i, O_WRONLY);
        if (fd < 0) continue;
        syscall(SYS_write, fd, "", 1);
        sys_close(fd);
    }
    snprintf(path, sizeof path, "%s/dev/%s", emu_dir, emu->chip[chip].name);
    unlink(path);
}

void emu_input(uint32_t chip, uint32_t offset, int level) {
    emu->chip[chip].line[offset].outside = (int8_t)level;
    emu_note(EMU_INPUT, chip, 0, 1ull << offset, (uint64_t)(level > 0) << offset, 0);
    emu_refresh(chip, offset);
}

static void stall(int32_t us) {
    uint64_t end = now_ns() + (uint64_t)us * 1000;
    while (now_ns() < end) continue;
}

static void fire(emu_rule_t *r) {
    r->live = 0;
    switch (r->action) {
    case EMU_DO_INPUT:
        emu_input(r->chip, r->action_line, r->value);
        break;
    case EMU_DO_SET_ERROR:
        emu->set_error = r->value;
        emu->set_errors = r->count;
        break;
    case EMU_DO_REQUEST_ERROR:
        emu->request_error = r->value;
        emu->request_errors = r->count;
        break;
    case EMU_DO_UNPLUG:
        emu_unplug(r->chip);
        break;
    case EMU_DO_SIGNAL:
        if (r->value == SIGKILL) __atomic_store_n(&emu->lock, 0, __ATOMIC_RELEASE);
        syscall(SYS_tgkill, getpid(), syscall(SYS_gettid), r->value);
        break;
    case EMU_DO_STALL:
        stall(r->value);
        break;
    }
}

void emu_rules(enum emu_trigger trigger, uint32_t chip, uint32_t line, uint64_t value) {
    for (uint32_t i = 0; i < emu->rules; i++) {
        emu_rule_t *r = &emu->rule[i];
        if (!r->live || r->trigger != trigger || r->chip != chip || value < r->n) continue;
        if (trigger != EMU_AT_RISES || r->line == line) fire(r);
    }
}

static void move_axes(uint32_t chip, uint32_t offset) {
    for (int i = 0; i < EMU_AXES; i++) {
        emu_axis_t *a = &emu->axis[i];
        if (!a->live || a->chip != chip || a->step != offset) continue;
        a->position += emu->chip[chip].line[a->dir].level ? 1 : -1;
        int level = (int)(a->position <= a->at ? a->active_level : !a->active_level);
        if (emu->chip[chip].line[a->limit].outside != level) emu_input(chip, a->limit, level);
    }
}

void emu_refresh(uint32_t chip, uint32_t offset) {
    emu_line_t *l = &emu->chip[chip].line[offset];
    uint8_t level = emu_level(l);
    if (level == l->level) return;
    l->level = level;
    if (l->request && (l->flags & GPIO_V2_LINE_FLAG_INPUT)) report_edge(chip, offset, level);
    if (!level) return;
    l->rises++;
    move_axes(chip, offset);
    emu_rules(EMU_AT_RISES, chip, offset, l->rises);
}

void emu_release(emu_line_t *l) {
    l->request = 0;
    l->consumer[0] = 0;
    if (emu->release_to_input)
        l->flags = GPIO_V2_LINE_FLAG_INPUT;
    else
        l->flags &= GPIO_V2_LINE_FLAG_INPUT | GPIO_V2_LINE_FLAG_OUTPUT;
}

bool emu_reap_one(uint32_t request) {
    emu_request_t *r = &emu->request[request];
    char path[EMU_PATH + 16];
    if (!r->abi) return false;
    int fd = open_request(request, O_RDWR);
    if (fd >= 0 && syscall(SYS_flock, fd, LOCK_EX | LOCK_NB) != 0) {
        sys_close(fd);
        return false;
    }
    uint64_t mask = 0, levels = 0;
    r->abi = EMU_FREE;
    for (uint32_t k = 0; k < r->count; k++) emu_release(&emu->chip[r->chip].line[r->offset[k]]);
    for (uint32_t k = 0; k < r->count; k++) {
        emu_refresh(r->chip, r->offset[k]);
        mask |= 1ull << r->offset[k];
        levels |= (uint64_t)emu->chip[r->chip].line[r->offset[k]].level << r->offset[k];
    }
    emu_note(EMU_RELEASE, r->chip, request, mask, levels, 0);
    if (fd >= 0) {
        snprintf(path, sizeof path, "%s/req/%u", emu_dir, request);
        unlink(path);
        sys_close(fd);
    }
    return true;
}

void emu_reap(void) {
    for (uint32_t i = 0; i < EMU_REQUESTS; i++) emu_reap_one(i);
}
