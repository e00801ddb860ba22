/* start.h - start-up of a bare chip, and what it knows about the stack. */
#ifndef START_H
#define START_H

#include <stdint.h>

/* The reset vector points here. */
void start_reset(void);
/* Bytes between the last variable and the top of memory, and how many of them the stack has ever reached. */
uint32_t start_stack_bytes(void);
uint32_t start_stack_used(void);

extern uint32_t _stack_top[]; /* first entry of the vector table */

#endif
