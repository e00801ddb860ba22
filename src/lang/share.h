/* share.h - common parts of an expression, computed once: sin(sqrt(x*x+y*y))/sqrt(x*x+y*y) takes one root.
 *
 * Only for straight code (parts.h) without calls of user functions; that is what surfaces mostly are. */
#ifndef SHARE_H
#define SHARE_H

#include <stddef.h>
#include <stdint.h>

#define SHARE_MAX 6 /* parts kept: that many values more on the stack */

/* Rewrites the len bytes of code, ended by OP_RET, in place, using up to `room` bytes. The values kept follow the
 * `params` arguments. *kept: how many there are. Returns the new length. Cost: a few thousand byte comparisons. */
uint16_t share_parts(uint8_t *code, uint16_t len, size_t room, uint8_t params, uint8_t *kept);

#endif
