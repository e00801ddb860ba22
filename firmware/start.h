/* start.h - start-up of a bare chip, and what it knows about the stack. */
#ifndef START_H
#define START_H

#include <stdint.h>

/* The reset vector points here. */
void start_reset(void);
extern uint32_t _stack_top[]; /* first entry of the vector table */

#endif
