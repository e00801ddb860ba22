/* bare.h - programs that run alike on the host and, without any board's port, on an emulated core: they print lines and
 * end.
 *
 * On a core both go through semihosting (a breakpoint that the emulator answers), so that a program is the part of src/
 * that it tests and nothing else. bare_arm.c and bare_host.c implement it. */
#ifndef BARE_H
#define BARE_H

#include <stdint.h>

void bare_text(const char *s);
void bare_number(int64_t v);
void bare_hex(uint64_t v);
/* The program of one file. Returning ends it. On a core the emulator gives the arguments, up to three. */
int bare_main(int argc, char **argv);
/* A place in time: the emulators write down how many instructions (cycles) have passed. Nothing on the host. */
void bare_mark(void);

#endif
