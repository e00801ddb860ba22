/* atomic_file.c - an unnamed file gets a name by its place in /proc; where a file has the name already, another name
 * first, which then takes the place of the old one in one step. */
#define _GNU_SOURCE /* unnamed files, fallocate */
#include "host/atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "error.h"

#define AHEAD ((off_t)1 << 20)
#define TMPFS 0x01021994 /* linux/magic.h: gains nothing, and clears pages twice */
enum { NAMES_TRIED = 100 };

/* May a new file take its place, and nobody see a difference? */
static bool can_be_replaced(const char *path, const struct stat *s) {
    return S_ISREG(s->st_mode) && s->st_nlink == 1 && s->st_uid == geteuid() && access(path, W_OK) == 0 &&
           listxattr(path, NULL, 0) <= 0;
}

static int open_beside(const char *path) {
    char folder[PATH_MAX];
    const char *slash = strrchr(path, '/');
    const int n = slash ? (int)(slash - path) + 1 : 2;
    if ((size_t)n >= sizeof folder) return -1;
    snprintf(folder, sizeof folder, "%.*s", n, slash ? path : "./");
    return open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
}

static bool take_over_rights(int fd, const struct stat *old) {
    struct stat s;
    if (fstat(fd, &s) != 0) return false;
    if (s.st_gid != old->st_gid && fchown(fd, (uid_t)-1, old->st_gid) != 0) return false;
    return ((s.st_mode ^ old->st_mode) & 07777) == 0 || fchmod(fd, old->st_mode & 07777) == 0;
}

bool atomic_file_open_unnamed(atomic_file_t *t, const char *path) {
    struct stat old;
    const bool is_there = lstat(path, &old) == 0;
    if (is_there ? !can_be_replaced(path, &old) : errno != ENOENT) return false;
    *t = (atomic_file_t){.path = path, .fd = open_beside(path), .is_unnamed = true, .is_new = !is_there};
    if (t->fd < 0) return false;
    if (is_there && !take_over_rights(t->fd, &old)) {
        atomic_file_drop(t);
        return false;
    }
    t->asks_ahead = true;
    return true;
}

static int open_in_place(const char *path) {
    return open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

int atomic_file_open(atomic_file_t *t, const char *path) {
    if (atomic_file_open_unnamed(t, path)) return 0;
    struct stat old; /* a link counts, though what it leads to may be new */
    const bool is_there = lstat(path, &old) == 0;
    *t = (atomic_file_t){.path = path, .fd = open_in_place(path), .is_new = !is_there};
    return t->fd < 0 ? ERR_FILE : 0;
}

static bool is_tmpfs(int fd) {
    struct statfs system;
    return fstatfs(fd, &system) == 0 && system.f_type == TMPFS;
}

void atomic_file_ahead(atomic_file_t *t, off_t end) {
    if (!t->asks_ahead || end <= t->ahead) return;
    const off_t more = (end - t->ahead + AHEAD - 1) / AHEAD * AHEAD;
    t->asks_ahead = (t->ahead > 0 || !is_tmpfs(t->fd)) && fallocate(t->fd, 0, t->ahead, more) == 0;
    t->ahead += more; /* where it fails, the file may have become longer all the same, and writing may yet do */
}

bool atomic_file_restart(atomic_file_t *t) {
    t->ahead = 0;
    return lseek(t->fd, 0, SEEK_SET) == 0 && ftruncate(t->fd, 0) == 0;
}

static bool give_name(int fd, const char *name) {
    char itself[32];
    snprintf(itself, sizeof itself, "/proc/self/fd/%d", fd);
    return linkat(AT_FDCWD, itself, AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
}

/* Two files change their names, and the old one goes. ext4 takes that for less than a rename, which makes it write the
 * new file to the disk at once; where a file system cannot do it, a rename has to do. */
static bool change_places(const char *name, const char *path) {
    if (renameat2(AT_FDCWD, name, AT_FDCWD, path, RENAME_EXCHANGE) == 0) {
        unlink(name); /* if it stays, the new file is in its place all the same */
        return true;
    }
    if (rename(name, path) == 0) return true;
    unlink(name);
    return false;
}

static bool replace(const atomic_file_t *t) {
    char name[PATH_MAX];
    for (int k = 0; k < NAMES_TRIED; k++) {
        const int n = snprintf(name, sizeof name, "%s.%ld-%d", t->path, (long)getpid(), k);
        if (n < 0 || (size_t)n >= sizeof name) return false;
        if (give_name(t->fd, name)) return change_places(name, t->path);
        if (errno != EEXIST) return false;
    }
    return false;
}

/* There is no other way: what is mounted at a name of its own, for example, cannot be replaced. */
static bool copy_in_place(const atomic_file_t *t, off_t length) {
    off_t at = 0;
    const int to = open_in_place(t->path);
    if (to < 0) return false;
    while (at < length) {
        const ssize_t n = sendfile(to, t->fd, &at, (size_t)(length - at));
        if (n == 0 || (n < 0 && errno != EINTR)) break;
    }
    return close(to) == 0 && at == length;
}

int atomic_file_keep(atomic_file_t *t, off_t length) {
    bool good = true;
    if (t->is_unnamed) {
        good = t->ahead <= length || ftruncate(t->fd, length) == 0;
        good = good && ((t->is_new && give_name(t->fd, t->path)) || replace(t) || copy_in_place(t, length));
    }
    const int trouble = errno;
    if (close(t->fd) != 0) return ERR_FILE;
    errno = trouble;
    return good ? 0 : ERR_FILE;
}

void atomic_file_drop(atomic_file_t *t) {
    const int trouble = errno;
    if (!t->is_unnamed && ftruncate(t->fd, 0) == 0 && t->is_new) unlink(t->path);
    close(t->fd);
    errno = trouble;
}
