/* emu_uapi.c - see emu_uapi.h. v1 is translated to v2's flags and goes the same way. */
#define _GNU_SOURCE
#include "tests/gpio/emu_uapi.h"
#include "tests/gpio/emu.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/gpio.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#define IN GPIO_V2_LINE_FLAG_INPUT
#define OUT GPIO_V2_LINE_FLAG_OUTPUT
#define LOW GPIO_V2_LINE_FLAG_ACTIVE_LOW
#define KNOWN_FLAGS 0x0ffeull
#define BAD_FLAG (1ull << 63)

static uint64_t flags_of_v1(uint32_t f) {
    static const struct {
        uint32_t v1;
        uint64_t v2;
    } SAME[] = {
        {GPIOHANDLE_REQUEST_INPUT, IN},
        {GPIOHANDLE_REQUEST_OUTPUT, OUT},
        {GPIOHANDLE_REQUEST_ACTIVE_LOW, LOW},
        {GPIOHANDLE_REQUEST_OPEN_DRAIN, GPIO_V2_LINE_FLAG_OPEN_DRAIN},
        {GPIOHANDLE_REQUEST_OPEN_SOURCE, GPIO_V2_LINE_FLAG_OPEN_SOURCE},
        {GPIOHANDLE_REQUEST_BIAS_PULL_UP, GPIO_V2_LINE_FLAG_BIAS_PULL_UP},
        {GPIOHANDLE_REQUEST_BIAS_PULL_DOWN, GPIO_V2_LINE_FLAG_BIAS_PULL_DOWN},
        {GPIOHANDLE_REQUEST_BIAS_DISABLE, GPIO_V2_LINE_FLAG_BIAS_DISABLED},
    };
    uint64_t out = 0;
    for (unsigned i = 0; i < sizeof SAME / sizeof SAME[0]; i++) {
        if (f & SAME[i].v1) out |= SAME[i].v2;
        f &= ~SAME[i].v1;
    }
    return f ? out | BAD_FLAG : out;
}

/* What the kernel refuses. */
static bool flags_are_bad(uint64_t f) {
    uint64_t bias =
        f & (GPIO_V2_LINE_FLAG_BIAS_PULL_UP | GPIO_V2_LINE_FLAG_BIAS_PULL_DOWN | GPIO_V2_LINE_FLAG_BIAS_DISABLED);
    uint64_t edge = f & (GPIO_V2_LINE_FLAG_EDGE_RISING | GPIO_V2_LINE_FLAG_EDGE_FALLING);
    uint64_t drive = f & (GPIO_V2_LINE_FLAG_OPEN_DRAIN | GPIO_V2_LINE_FLAG_OPEN_SOURCE);
    return (f & ~KNOWN_FLAGS) || ((f & IN) && (f & OUT)) || (edge && !(f & IN)) || (drive && !(f & OUT)) ||
           (drive & (drive - 1)) || (bias && !(f & (IN | OUT))) || (bias & (bias - 1));
}

static void configure(uint32_t chip, uint32_t offset, uint64_t flags, bool value) {
    emu_line_t *l = &emu->chip[chip].line[offset];
    if (!(flags & (IN | OUT))) flags |= l->flags & (IN | OUT); /* "as is" keeps the direction */
    l->flags = flags;
    if (flags & OUT) l->latch = value != ((flags & LOW) != 0);
    emu_refresh(chip, offset);
}

static uint64_t lines_of(const emu_request_t *r, uint64_t *levels) {
    uint64_t mask = 0;
    *levels = 0;
    for (uint32_t k = 0; k < r->count; k++) {
        mask |= 1ull << r->offset[k];
        *levels |= (uint64_t)emu->chip[r->chip].line[r->offset[k]].level << r->offset[k];
    }
    return mask;
}

typedef struct wanted {
    uint32_t count;
    uint32_t offset[EMU_LINES];
    uint64_t flags[EMU_LINES];
    bool value[EMU_LINES];
    const char *consumer;
} wanted_t;

/* Line by line, as the kernel does it: those before a busy one have already been driven. */
static int take_lines(uint32_t chip, uint32_t request, const wanted_t *w) {
    emu_chip_t *c = &emu->chip[chip];
    emu_request_t *r = &emu->request[request];
    for (uint32_t k = 0; k < w->count; k++) {
        uint32_t offset = w->offset[k];
        if (offset >= c->count) return -EINVAL;
        emu_line_t *l = &c->line[offset];
        if (l->request || l->hog) return -EBUSY;
        r->offset[r->count++] = offset;
        l->request = request + 1;
        l->edges = 0;
        snprintf(l->consumer, sizeof l->consumer, "%.31s", w->consumer[0] ? w->consumer : "?");
        configure(chip, offset, w->flags[k], w->value[k]);
    }
    return 0;
}

static int make_fifo(uint32_t request, struct stat *st) {
    char path[EMU_PATH + 16];
    snprintf(path, sizeof path, "%s/req/%u", emu_dir, request);
    unlink(path);
    if (mkfifo(path, 0666)) return -errno;
    int fd = (int)syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC, 0);
    if (fd < 0) return -errno;
    if (syscall(SYS_flock, fd, LOCK_EX | LOCK_NB) == 0 && syscall(SYS_fstat, fd, st) == 0) return fd;
    int err = errno;
    syscall(SYS_close, fd);
    return -err;
}

static int request_lines(uint32_t chip, enum emu_abi abi, const wanted_t *w) {
    uint32_t i = 0;
    struct stat st;
    emu->requests++;
    emu_reap();
    emu_rules(EMU_AT_REQUESTS, chip, 0, emu->requests);
    if (emu->chip[chip].unplugged) return -ENODEV;
    for (uint32_t k = 0; k < w->count; k++)
        if (flags_are_bad(w->flags[k])) return -EINVAL;
    if (emu->request_errors) {
        if (emu->request_errors > 0) emu->request_errors--;
        emu_note(EMU_FAULT, chip, 0, 0, 0, emu->request_error);
        return -emu->request_error;
    }
    while (i < EMU_REQUESTS && emu->request[i].abi) i++;
    if (i == EMU_REQUESTS) return -ENOMEM;
    emu_request_t *r = &emu->request[i];
    memset(r, 0, sizeof *r);
    r->chip = chip;
    r->pid = (uint32_t)getpid();
    int fd = make_fifo(i, &st);
    if (fd < 0) return fd;
    int err = take_lines(chip, i, w);
    uint64_t levels, mask;
    if (err) {
        for (uint32_t k = 0; k < r->count; k++) emu_release(&emu->chip[chip].line[r->offset[k]]);
        mask = lines_of(r, &levels);
        syscall(SYS_close, fd);
        emu_note(EMU_FAULT, chip, i, mask, levels, -err);
        return err;
    }
    r->inode = st.st_ino;
    __atomic_store_n(&r->abi, (uint32_t)abi, __ATOMIC_RELEASE);
    mask = lines_of(r, &levels);
    emu_note(EMU_REQUEST, chip, i, mask, levels, 0);
    return fd;
}

/* ---- values ---- */

static int set_values(uint32_t request, uint64_t which, uint64_t values) {
    emu_request_t *r = &emu->request[request];
    emu_chip_t *c = &emu->chip[r->chip];
    uint64_t mask = 0, levels = 0;
    emu->sets++;
    emu_rules(EMU_AT_SETS, r->chip, 0, emu->sets);
    if (c->unplugged) return -ENODEV;
    if (r->count < 64) which &= (1ull << r->count) - 1;
    if (!which) return -EINVAL;
    for (uint32_t k = 0; k < r->count; k++)
        if ((which >> k & 1) && !(c->line[r->offset[k]].flags & OUT)) return -EPERM;
    if (emu->set_errors) {
        if (emu->set_errors > 0) emu->set_errors--;
        emu_note(EMU_FAULT, r->chip, request, 0, 0, emu->set_error);
        return -emu->set_error;
    }
    for (uint32_t k = 0; k < r->count; k++) {
        if (!(which >> k & 1)) continue;
        emu_line_t *l = &c->line[r->offset[k]];
        l->latch = (values >> k & 1) != ((l->flags & LOW) != 0);
        mask |= 1ull << r->offset[k];
        levels |= (uint64_t)emu_level(l) << r->offset[k];
    }
    emu_note(EMU_SET, r->chip, request, mask, levels, 0); /* first: a rule may kill us below */
    for (uint32_t k = 0; k < r->count; k++)
        if (which >> k & 1) emu_refresh(r->chip, r->offset[k]);
    return 0;
}

static uint64_t get_values(uint32_t request) {
    const emu_request_t *r = &emu->request[request];
    uint64_t values = 0;
    for (uint32_t k = 0; k < r->count; k++) {
        const emu_line_t *l = &emu->chip[r->chip].line[r->offset[k]];
        if (l->level != ((l->flags & LOW) != 0)) values |= 1ull << k;
    }
    return values;
}

/* ---- what is asked of a chip ---- */

static void line_info(uint32_t chip, struct gpio_v2_line_info *out) {
    const emu_line_t *l = &emu->chip[chip].line[out->offset];
    uint32_t offset = out->offset;
    if (l->request) emu_reap_one(l->request - 1);
    memset(out, 0, sizeof *out);
    out->offset = offset;
    memcpy(out->name, l->name, sizeof out->name);
    snprintf(out->consumer, sizeof out->consumer, "%s", l->hog ? "kernel" : l->consumer);
    out->flags = l->flags | (l->request || l->hog ? GPIO_V2_LINE_FLAG_USED : 0);
}

static void line_info_v1(uint32_t chip, struct gpioline_info *out) {
    static const struct {
        uint64_t v2;
        uint32_t v1;
    } SAME[] = {
        {GPIO_V2_LINE_FLAG_USED, GPIOLINE_FLAG_KERNEL},
        {OUT, GPIOLINE_FLAG_IS_OUT},
        {LOW, GPIOLINE_FLAG_ACTIVE_LOW},
        {GPIO_V2_LINE_FLAG_OPEN_DRAIN, GPIOLINE_FLAG_OPEN_DRAIN},
        {GPIO_V2_LINE_FLAG_OPEN_SOURCE, GPIOLINE_FLAG_OPEN_SOURCE},
        {GPIO_V2_LINE_FLAG_BIAS_PULL_UP, GPIOLINE_FLAG_BIAS_PULL_UP},
        {GPIO_V2_LINE_FLAG_BIAS_PULL_DOWN, GPIOLINE_FLAG_BIAS_PULL_DOWN},
        {GPIO_V2_LINE_FLAG_BIAS_DISABLED, GPIOLINE_FLAG_BIAS_DISABLE},
    };
    struct gpio_v2_line_info info = {.offset = out->line_offset};
    line_info(chip, &info);
    memset(out, 0, sizeof *out);
    out->line_offset = info.offset;
    memcpy(out->name, info.name, sizeof out->name);
    memcpy(out->consumer, info.consumer, sizeof out->consumer);
    for (unsigned i = 0; i < sizeof SAME / sizeof SAME[0]; i++)
        if (info.flags & SAME[i].v2) out->flags |= SAME[i].v1;
}

static int answer(int fd, int *into) {
    if (fd < 0) return fd;
    *into = fd;
    return 0;
}

static int handle_v1(uint32_t chip, struct gpiohandle_request *q) {
    wanted_t w = {.count = q->lines, .consumer = q->consumer_label};
    if (q->lines == 0 || q->lines > GPIOHANDLES_MAX) return -EINVAL;
    q->consumer_label[31] = 0;
    for (uint32_t k = 0; k < q->lines; k++) {
        w.offset[k] = q->lineoffsets[k];
        w.flags[k] = flags_of_v1(q->flags);
        w.value[k] = q->default_values[k] != 0;
    }
    return answer(request_lines(chip, EMU_V1_HANDLE, &w), &q->fd);
}

static int event_v1(uint32_t chip, struct gpioevent_request *q) {
    wanted_t w = {.count = 1, .consumer = q->consumer_label};
    if (q->handleflags & GPIOHANDLE_REQUEST_OUTPUT) return -EINVAL;
    q->consumer_label[31] = 0;
    w.offset[0] = q->lineoffset;
    w.flags[0] = flags_of_v1(q->handleflags) | IN;
    if (q->eventflags & GPIOEVENT_REQUEST_RISING_EDGE) w.flags[0] |= GPIO_V2_LINE_FLAG_EDGE_RISING;
    if (q->eventflags & GPIOEVENT_REQUEST_FALLING_EDGE) w.flags[0] |= GPIO_V2_LINE_FLAG_EDGE_FALLING;
    return answer(request_lines(chip, EMU_V1_EVENT, &w), &q->fd);
}

/* The last attribute that covers line k does not win, the first does. */
static uint64_t flags_v2(const struct gpio_v2_line_config *c, uint32_t k) {
    for (uint32_t a = 0; a < c->num_attrs; a++)
        if (c->attrs[a].attr.id == GPIO_V2_LINE_ATTR_ID_FLAGS && (c->attrs[a].mask >> k & 1))
            return c->attrs[a].attr.flags;
    return c->flags;
}

static bool value_v2(const struct gpio_v2_line_config *c, uint32_t k) {
    for (uint32_t a = 0; a < c->num_attrs; a++)
        if (c->attrs[a].attr.id == GPIO_V2_LINE_ATTR_ID_OUTPUT_VALUES && (c->attrs[a].mask >> k & 1))
            return c->attrs[a].attr.values >> k & 1;
    return false;
}

static int lines_v2(uint32_t chip, struct gpio_v2_line_request *q) {
    wanted_t w = {.count = q->num_lines, .consumer = q->consumer};
    if (q->num_lines == 0 || q->num_lines > GPIO_V2_LINES_MAX) return -EINVAL;
    if (q->config.num_attrs > GPIO_V2_LINE_NUM_ATTRS_MAX) return -EINVAL;
    for (uint32_t k = 0; k < 5; k++)
        if (q->padding[k] || q->config.padding[k]) return -EINVAL;
    q->consumer[31] = 0;
    for (uint32_t k = 0; k < q->num_lines; k++) {
        w.offset[k] = q->offsets[k];
        w.flags[k] = flags_v2(&q->config, k);
        w.value[k] = value_v2(&q->config, k);
    }
    return answer(request_lines(chip, EMU_V2, &w), &q->fd);
}

int emu_uapi_chip(uint32_t chip, unsigned long command, void *arg) {
    emu_chip_t *c = &emu->chip[chip];
    struct gpiochip_info *info = arg;
    struct gpio_v2_line_info *line = arg;
    struct gpioline_info *line_v1 = arg;
    if (c->unplugged) return -ENODEV;
    switch (command) {
    case GPIO_GET_CHIPINFO_IOCTL:
        memset(info, 0, sizeof *info);
        memcpy(info->name, c->name, sizeof info->name);
        memcpy(info->label, c->label, sizeof info->label);
        info->lines = c->count;
        return 0;
    case GPIO_V2_GET_LINEINFO_IOCTL:
    case GPIO_V2_GET_LINEINFO_WATCH_IOCTL:
        if (line->offset >= c->count) return -EINVAL;
        line_info(chip, line);
        return 0;
    case GPIO_GET_LINEINFO_IOCTL:
    case GPIO_GET_LINEINFO_WATCH_IOCTL:
        if (line_v1->line_offset >= c->count) return -EINVAL;
        line_info_v1(chip, line_v1);
        return 0;
    case GPIO_GET_LINEINFO_UNWATCH_IOCTL:
        return 0;
    case GPIO_GET_LINEHANDLE_IOCTL:
        return handle_v1(chip, arg);
    case GPIO_GET_LINEEVENT_IOCTL:
        return event_v1(chip, arg);
    case GPIO_V2_GET_LINE_IOCTL:
        return lines_v2(chip, arg);
    default:
        return -EINVAL;
    }
}

/* ---- what is asked of a request ---- */

static int request_v2(uint32_t request, unsigned long command, void *arg) {
    emu_request_t *r = &emu->request[request];
    struct gpio_v2_line_values *v = arg;
    struct gpio_v2_line_config *c = arg;
    uint64_t levels, mask;
    switch (command) {
    case GPIO_V2_LINE_SET_VALUES_IOCTL:
        return set_values(request, v->mask, v->bits);
    case GPIO_V2_LINE_GET_VALUES_IOCTL:
        v->bits = get_values(request) & v->mask;
        return 0;
    case GPIO_V2_LINE_SET_CONFIG_IOCTL:
        for (uint32_t k = 0; k < r->count; k++)
            if (flags_are_bad(flags_v2(c, k))) return -EINVAL;
        for (uint32_t k = 0; k < r->count; k++) configure(r->chip, r->offset[k], flags_v2(c, k), value_v2(c, k));
        mask = lines_of(r, &levels);
        emu_note(EMU_CONFIG, r->chip, request, mask, levels, 0);
        return 0;
    default:
        return -EINVAL;
    }
}

static int request_v1(uint32_t request, unsigned long command, struct gpiohandle_data *data) {
    const emu_request_t *r = &emu->request[request];
    uint64_t values = 0;
    switch (command) {
    case GPIOHANDLE_SET_LINE_VALUES_IOCTL:
        if (r->abi == EMU_V1_EVENT) return -EINVAL;
        for (uint32_t k = 0; k < r->count; k++) values |= (uint64_t)(data->values[k] != 0) << k;
        return set_values(request, ~0ull, values);
    case GPIOHANDLE_GET_LINE_VALUES_IOCTL:
        values = get_values(request);
        memset(data, 0, sizeof *data);
        for (uint32_t k = 0; k < r->count; k++) data->values[k] = values >> k & 1;
        return 0;
    default:
        return -EINVAL;
    }
}

int emu_uapi_request(uint32_t request, unsigned long command, void *arg) {
    const emu_request_t *r = &emu->request[request];
    if (emu->chip[r->chip].unplugged) {
        if (command == GPIO_V2_LINE_SET_VALUES_IOCTL || command == GPIOHANDLE_SET_LINE_VALUES_IOCTL) emu->sets++;
        return -ENODEV;
    }
    return r->abi == EMU_V2 ? request_v2(request, command, arg) : request_v1(request, command, arg);
}
