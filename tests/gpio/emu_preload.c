/* emu_preload.c - the preload library: the C library's calls on /dev/gpiochipN and on its requests go to the emulated
 * chips, all others to the kernel. See emu.h. Without $GPIOEMU it changes nothing. */
#define _GNU_SOURCE
#include "tests/gpio/emu.h"
#include "tests/gpio/emu_uapi.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/gpio.h>
#include <poll.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#define SYS_PREFIX "/sys/bus/gpio/devices/"

static bool on(void) {
    static bool tried;
    if (emu) return true;
    if (tried) return false;
    tried = true;
    const char *dir = getenv("GPIOEMU");
    return dir && emu_map(dir, false);
}

static void *next(const char *name) {
    return dlsym(RTLD_NEXT, name);
}

/* ---- paths ---- */

/* "/dev/gpiochipN": its index, or -1. An unplugged chip keeps its index; its file is gone. */
static int chip_of_path(const char *path) {
    if (!path || strncmp(path, "/dev/gpiochip", 13) != 0 || !on()) return -1;
    for (uint32_t i = 0; i < emu->chips; i++)
        if (strcmp(path + 5, emu->chip[i].name) == 0) return (int)i;
    return -1;
}

static const char *map_path(const char *path, char *room, size_t size) {
    char name[64];
    int chip = chip_of_path(path);
    if (chip >= 0) {
        snprintf(room, size, "%s/dev/%s", emu_dir, emu->chip[chip].name);
        return room;
    }
    bool ours = path && strncmp(path, SYS_PREFIX, sizeof SYS_PREFIX - 1) == 0 && on();
    if (!ours || sscanf(path + sizeof SYS_PREFIX - 1, "%63[^/]/dev", name) != 1) return path;
    snprintf(room, size, "%s/sys/%s", emu_dir, name);
    return room;
}

static int open_mapped(int dir, const char *path, int flags, va_list args) {
    char room[EMU_PATH + 80];
    unsigned mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(args, unsigned) : 0;
    return (int)syscall(SYS_openat, dir, map_path(path, room, sizeof room), flags, mode);
}

int open(const char *path, int flags, ...) {
    va_list args;
    va_start(args, flags);
    int fd = open_mapped(AT_FDCWD, path, flags, args);
    va_end(args);
    return fd;
}

int open64(const char *path, int flags, ...) {
    va_list args;
    va_start(args, flags);
    int fd = open_mapped(AT_FDCWD, path, flags, args);
    va_end(args);
    return fd;
}

int openat(int dir, const char *path, int flags, ...) {
    va_list args;
    va_start(args, flags);
    int fd = open_mapped(dir, path, flags, args);
    va_end(args);
    return fd;
}

/* What fortified programs call. */
int __open_2(const char *path, int flags);
int __open64_2(const char *path, int flags);
int __open_2(const char *path, int flags) {
    return open(path, flags);
}
int __open64_2(const char *path, int flags) {
    return open(path, flags);
}

int access(const char *path, int mode) {
    char room[EMU_PATH + 80];
    return (int)syscall(SYS_faccessat, AT_FDCWD, map_path(path, room, sizeof room), mode);
}

static int stat_chip(int chip, struct stat *st) {
    char path[EMU_PATH + 80];
    snprintf(path, sizeof path, "%s/dev/%s", emu_dir, emu->chip[chip].name);
    if (syscall(SYS_newfstatat, AT_FDCWD, path, st, 0)) return -1; /* ENOENT: unplugged */
    st->st_mode = S_IFCHR | 0660;
    st->st_rdev = makedev(EMU_MAJOR, (unsigned)chip);
    return 0;
}

int stat(const char *restrict path, struct stat *restrict st) {
    int chip = chip_of_path(path);
    return chip >= 0 ? stat_chip(chip, st) : (int)syscall(SYS_newfstatat, AT_FDCWD, path, st, 0);
}

int lstat(const char *restrict path, struct stat *restrict st) {
    int chip = chip_of_path(path);
    return chip >= 0 ? stat_chip(chip, st) : (int)syscall(SYS_newfstatat, AT_FDCWD, path, st, AT_SYMLINK_NOFOLLOW);
}

int stat64(const char *restrict path, struct stat64 *restrict st) {
    return stat(path, (struct stat *)st);
}
int lstat64(const char *restrict path, struct stat64 *restrict st) {
    return lstat(path, (struct stat *)st);
}

/* libgpiod makes sure that the device's subsystem is gpio. */
char *realpath(const char *restrict path, char *restrict out) {
    char *(*real)(const char *, char *) = (char *(*)(const char *, char *))next("realpath");
    unsigned major, minor;
    const char *is = NULL;
    if (chip_of_path(path) >= 0)
        is = path;
    else if (path && sscanf(path, "/sys/dev/char/%u:%u/subsystem", &major, &minor) == 2 && major == EMU_MAJOR && on())
        is = "/sys/bus/gpio";
    if (!is) return real(path, out);
    return out ? strcpy(out, is) : strdup(is);
}

typedef int (*filter_t)(const struct dirent *);
typedef int (*order_t)(const struct dirent **, const struct dirent **);
int scandir(const char *restrict dir, struct dirent ***restrict list, filter_t filter, order_t order) {
    int (*real)(const char *, struct dirent ***, filter_t, order_t) =
        (int (*)(const char *, struct dirent ***, filter_t, order_t))next("scandir");
    char room[EMU_PATH + 8];
    if ((strcmp(dir, "/dev") == 0 || strcmp(dir, "/dev/") == 0) && on()) {
        snprintf(room, sizeof room, "%s/dev", emu_dir);
        dir = room;
    }
    return real(dir, list, filter, order);
}

/* ---- files ---- */

enum file { OTHER, CHIP, REQUEST };

/* Which of ours is it? The kernel is asked each time, so dup, fork and exec need no care. */
static enum file file_of(int fd, uint32_t *index) {
    struct stat st;
    if (!on() || syscall(SYS_fstat, fd, &st)) return OTHER;
    if (S_ISFIFO(st.st_mode)) {
        for (uint32_t i = 0; i < EMU_REQUESTS; i++) {
            if (!emu->request[i].abi || emu->request[i].inode != st.st_ino) continue;
            *index = i;
            return REQUEST;
        }
    } else if (S_ISREG(st.st_mode)) {
        for (uint32_t i = 0; i < emu->chips; i++) {
            if (emu->chip[i].inode != st.st_ino) continue;
            *index = i;
            return CHIP;
        }
    }
    return OTHER;
}

static bool unplugged(uint32_t request) {
    return emu->chip[emu->request[request].chip].unplugged;
}

int ioctl(int fd, unsigned long command, ...) {
    va_list args;
    uint32_t index;
    enum file file;
    va_start(args, command);
    void *arg = va_arg(args, void *);
    va_end(args);
    command &= 0xffffffffu;
    if (_IOC_TYPE(command) != 0xb4 || (file = file_of(fd, &index)) == OTHER)
        return (int)syscall(SYS_ioctl, fd, command, arg);
    sigset_t before = emu_lock();
    int result = file == CHIP ? emu_uapi_chip(index, command, arg) : emu_uapi_request(index, command, arg);
    emu_unlock(before);
    if (result >= 0) return result;
    errno = -result;
    return -1;
}

/* Whole events only, and ENODEV instead of the byte that wakes readers of an unplugged chip. */
ssize_t read(int fd, void *buffer, size_t size) {
    uint32_t i;
    if (!emu || file_of(fd, &i) != REQUEST) return syscall(SYS_read, fd, buffer, size);
    size_t event = emu->request[i].abi == EMU_V2 ? sizeof(struct gpio_v2_line_event) : sizeof(struct gpioevent_data);
    if (!unplugged(i)) {
        if (size < event) {
            errno = EINVAL;
            return -1;
        }
        ssize_t n = syscall(SYS_read, fd, buffer, size - size % event);
        if (!unplugged(i)) return n;
    }
    errno = ENODEV;
    return -1;
}

/* A request of an unplugged chip polls as hung up. */
static int hang_up(struct pollfd *file, nfds_t count, int ready) {
    uint32_t request;
    for (nfds_t k = 0; emu && ready > 0 && k < count; k++)
        if (file[k].revents && file_of(file[k].fd, &request) == REQUEST && unplugged(request))
            file[k].revents = POLLHUP | POLLERR;
    return ready;
}

int ppoll(struct pollfd *file, nfds_t count, const struct timespec *timeout, const sigset_t *mask) {
    struct timespec left;
    if (timeout) left = *timeout; /* the system call writes the remaining time */
    return hang_up(file, count, (int)syscall(SYS_ppoll, file, count, timeout ? &left : NULL, mask, 8));
}

int poll(struct pollfd *file, nfds_t count, int ms) {
    struct timespec timeout = {.tv_sec = ms / 1000, .tv_nsec = ms % 1000 * 1000000L};
    return ppoll(file, count, ms < 0 ? NULL : &timeout, NULL);
}

/* So that a release is recorded at once. */
int close(int fd) {
    uint32_t i = 0;
    enum file file = emu ? file_of(fd, &i) : OTHER;
    int result = (int)syscall(SYS_close, fd);
    if (file != REQUEST) return result;
    int err = errno;
    sigset_t before = emu_lock();
    emu_reap_one(i);
    emu_unlock(before);
    errno = err;
    return result;
}
