/* scope_live.c - see scope_live.h. */
#include "scope_live.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "qemu_inside.h"

static struct {
    _Alignas(16) unsigned char stop[256], typing[256]; /* QEMUTimers, which are smaller */
    FILE *orders;
    void (*type)(uint8_t byte);
    void (*set_input)(int input, int level);
    uint8_t typed[64];
    unsigned to_type, at;
    char told[4096];
    size_t bytes;
} l;

static void flush(void) {
    for (size_t done = 0; done < l.bytes;) {
        ssize_t n = write(STDOUT_FILENO, l.told + done, l.bytes - done);
        if (n > 0)
            done += (size_t)n;
        else if (errno == EAGAIN)
            usleep(200); /* the reader is behind */
        else
            exit(1); /* or gone */
    }
    l.bytes = 0;
}

static void tell(const char *record) {
    size_t n = strlen(record);
    if (l.bytes + n + 1 > sizeof l.told) flush();
    l.told[l.bytes] = '\0';
    memcpy(l.told + l.bytes + 1, record, n);
    l.bytes += n + 1;
}

void live_pin(int64_t ns, int pin, int level) {
    char record[48];
    snprintf(record, sizeof record, "p %lld %d %d\n", (long long)ns, pin, level);
    tell(record);
    if (pin == 5) flush(); /* motors off: before the console says more */
}

static void type_next(void *unused) {
    (void)unused;
    if (l.at == l.to_type) return;
    l.type(l.typed[l.at++]);
    timer_mod(l.typing, qemu_clock_get_ns(CLOCK_VIRTUAL) + BYTE_NS);
}

static void type_all(const char *hex) {
    unsigned byte;
    if (l.at == l.to_type) l.at = l.to_type = 0;
    for (; sscanf(hex, "%2x", &byte) == 1 && l.to_type < sizeof l.typed; hex += 2) l.typed[l.to_type++] = (uint8_t)byte;
    if (l.at == 0) type_next(NULL);
}

/* Nothing happens to the board unless somebody says so; without anybody its power is off. */
static void stand_still(void *unused) {
    (void)unused;
    char line[256];
    long long until;
    snprintf(line, sizeof line, "t %lld\n", (long long)qemu_clock_get_ns(CLOCK_VIRTUAL));
    tell(line);
    flush();
    while (fgets(line, sizeof line, l.orders)) {
        int input, level;
        if (strncmp(line, "type ", 5) == 0) type_all(line + 5);
        if (sscanf(line, "input %d %d", &input, &level) == 2) l.set_input(input, level);
        if (sscanf(line, "go %lld", &until) == 1) {
            timer_mod(l.stop, until);
            return;
        }
    }
    qemu_system_shutdown_request(3);
}

void live_begin(void (*type)(uint8_t byte), void (*set_input)(int input, int level)) {
    l.type = type;
    l.set_input = set_input;
    l.orders = fdopen(3, "r");
    if (!l.orders) {
        fprintf(stderr, "scope: nobody at descriptor 3\n");
        exit(2);
    }
    timer_init_full(l.stop, NULL, CLOCK_VIRTUAL, 1, 0, stand_still, NULL);
    timer_init_full(l.typing, NULL, CLOCK_VIRTUAL, 1, 0, type_next, NULL);
    timer_mod(l.stop, 1);
}
