/* parts.h - the operands that straight stack code consists of; internal to share.c and hoist.c.
 *
 * In stack code an operand is a run of bytes that ends with the operation that completes it. Straight code has no
 * jumps, assignments or random numbers: every part is evaluated exactly once, in order, and could as well be elsewhere.
 */
#ifndef PARTS_H
#define PARTS_H

#include "config.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define PARTS_MAX CONFIG_PARTS /* longer code is left alone */

typedef struct parts {
    int n;
    uint16_t start[PARTS_MAX]; /* of the operand that operation i completes */
    uint16_t end[PARTS_MAX];
    bool leaf[PARTS_MAX]; /* it is a constant, a variable, an argument or a value kept */
} parts_t;

/* The parts of code, ended by OP_RET; an OP_FRAME in front belongs to none. calls: those of user functions are
 * operations like others. False if the code is not straight, or too long. */
bool parts_find(const uint8_t *code, bool calls, parts_t *parts);

#endif
