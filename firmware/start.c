/* start.c - from reset to main, the same for every part: memory as C wants it, the stack painted so that its deepest
 * point can be found later. */
#include "firmware/start.h"

#include "hal/hal.h"

extern uint32_t _data_load[], _data_start[], _data_end[], _bss_start[], _bss_end[], _stack_bottom[];

#define PAINT 0xa5a5a5a5u

int main(void);

void start_reset(void) {
    const uint32_t *from = _data_load;
    for (uint32_t *to = _data_start; to < _data_end;) *to++ = *from++;
    for (uint32_t *to = _bss_start; to < _bss_end;) *to++ = 0;
    uint32_t *here = __builtin_frame_address(0);
    for (volatile uint32_t *to = _stack_bottom; to < here - 16;) *to++ = PAINT;
    main();
    for (;;) continue;
}

bool hal_stack_ok(void) {
    return _stack_bottom[0] == PAINT;
}

uint32_t hal_stack_used(uint32_t *room) {
    const uint32_t *at = _stack_bottom;
    while (at < _stack_top && *at == PAINT) at++;
    *room = (uint32_t)((uint8_t *)_stack_top - (uint8_t *)_stack_bottom);
    return (uint32_t)((uint8_t *)_stack_top - (const uint8_t *)at);
}
