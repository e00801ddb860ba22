/* say.c - see say.h. */
#include "app/say.h"

#include <string.h>

#include "hal/hal.h"
#include "said.h"

void say_bytes(const char *text, size_t bytes) {
    while (bytes) {
        const char *lf = memchr(text, '\n', bytes);
        size_t n = lf ? (size_t)(lf - text) : bytes;
        if (n) hal_console_write(text, n);
        if (!lf) return;
        hal_console_write("\r\n", 2);
        text += n + 1;
        bytes -= n + 1;
    }
}

void say_line(const char *text) {
    say_bytes(text, strlen(text));
}

void say(const char *text) {
    said_t p = said_text(text);
    for (char c; (c = said_next(&p)) != '\0';) say_bytes(&c, 1);
}
