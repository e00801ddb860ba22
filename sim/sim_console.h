/* sim_console.h - the simulated board's outer side: what is typed on its console at which tick, which switches are
 * pressed, what its memory keeps, and whether its watchdog would have bitten.
 *
 * sim_console_reset() is power-on: queues empty, switches open, watchdog off. The store keeps its contents, as its
 * purpose is; sim_store_erase() makes it new. Call sim_reset() first. */
#ifndef SIM_CONSOLE_H
#define SIM_CONSOLE_H

#include "hal/hal.h"
#include <stdint.h>

#define SIM_BYTE_TICKS (HAL_TICK_HZ * 10 / 115200) /* one byte on the wire */
#define SIM_RECEIVE_BYTES 256                      /* of the port's queue */

/* Called with everything the firmware sends. */
typedef void (*sim_listener_t)(void *ctx, const char *text, size_t bytes);

void sim_console_reset(void);
void sim_console_listen(sim_listener_t listener, void *ctx);
/* Types bytes: the first is received whole at `tick`, or as soon after all that was typed before as the wire allows.
 * Copied. Returns the tick of the last one. A fault when more than SIM_TYPED_BYTES are under way. */
#define SIM_TYPED_BYTES 65536
uint64_t sim_console_type(uint64_t tick, const char *bytes, size_t count);
/* At `tick`, not before that of an earlier call, the switches in mask become those of value. Calls console_input_isr as
 * a port does. */
void sim_inputs_set(uint64_t tick, uint32_t mask, uint32_t value);

void sim_store_erase(void);
/* Power fails in the middle of a later write: after `bytes` more bytes have been written, or when it has just erased
 * (0). That write and all after it return ERR_FILE until sim_console_reset(). */
void sim_store_cut(uint32_t bytes);
/* Longest time between two feedings so far (ticks), and whether it was too long. */
uint64_t sim_watchdog_longest(void);
bool sim_watchdog_bitten(void);

#endif
