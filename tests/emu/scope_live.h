/* scope_live.h - a board that somebody sits at: scope.so tells on standard output what the pins do, beside the
 * console's bytes (-serial stdio), and stops every now and then to be told what happens to the board next
 * (board_qemu.mjs).
 *
 *     to standard output, each begun by a zero byte:    p NS PIN LEVEL     a change, 1 is active
 *                                                       t NS               time stands still until the next `go`
 *     from descriptor 3, lines:                         type HEX           bytes on the console, one after the other
 *                                                       input NUMBER 0|1   a switch (enum hal_input's bit)
 *                                                       go NS              until that time */
#ifndef SCOPE_LIVE_H
#define SCOPE_LIVE_H

#include <stdint.h>

#define BYTE_NS 86806 /* a byte at 115200 baud */

/* Before the first instruction, QEMU's lock held. */
void live_begin(void (*type)(uint8_t byte), void (*set_input)(int input, int level));
void live_pin(int64_t ns, int pin, int level);

#endif
