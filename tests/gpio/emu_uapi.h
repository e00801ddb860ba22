/* emu_uapi.h - the gpiochip's ioctls, v1 and v2, on the emulated chips. */
#ifndef EMU_UAPI_H
#define EMU_UAPI_H

#include <stdint.h>

/* With emu_lock held. Return 0 or -errno as the kernel would. */
int emu_uapi_chip(uint32_t chip, unsigned long command, void *arg);
int emu_uapi_request(uint32_t request, unsigned long command, void *arg);

#endif
