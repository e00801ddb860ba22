/* player_isr.S - player_isr, the interrupt of TIMER0: see player.c. In assembly, as every instruction counts: some 70 for an
 * edge that comes alone, 21 from one to the next that follows at once.
 *
 *      r0 scratch, left   r1 at   r2 level   r3 scratch   r4 player   r5 &ahead.head   r6 tail   r7 TIMER0_CAPTURE1 */
#include "player.h"

        .syntax unified
        .cpu cortex-m0
        .thumb
        .section .text.player_isr, "ax"
        .global player_isr
        .type player_isr, %function
        .thumb_func
        .align 2

/* The word at r6: its level, and when it leaves; r0: ticks since the edge before. */
        .macro fetch
        lsls    r3, r6, #27             /* 32 words of 4 bytes */
        lsrs    r3, r3, #25
        ldr     r2, =ahead
        ldr     r3, [r2, r3]
        lsls    r2, r3, #26             /* 64 words of 4 bytes */
        lsrs    r2, r2, #24
        ldr     r0, =port_spread
        ldr     r2, [r0, r2]
        ldr     r0, [r4, #P_TURNED]
        eors    r2, r0
        lsrs    r0, r3, #6
        adds    r0, #3                  /* HAL_EDGE_GAP */
        adds    r1, r1, r0
        .endm

player_isr:
        push    {r4, r5, r6, r7, lr}
        ldr     r4, =player
        ldr     r5, =ahead + AHEAD_HEAD
        ldr     r7, =0x40008044
        ldr     r1, [r4, #P_AT]
        ldr     r6, [r5, #HEAD_TAIL]
        ldr     r2, [r4, #P_LEVEL]
        cmp     r2, #0
        beq     .Lfirst
.Llook:
        movs    r0, #1
        ldr     r3, =0x40008540         /* CC[0], CC[1] */
        str     r0, [r7]
        ldr     r0, [r3, #4]
        lsls    r0, r0, #1
        subs    r0, r1, r0
        cmp     r0, #PLAYER_SOON
        bgt     .Lalarm
        cmp     r0, #0
        ble     .Ldue
        movs    r0, #1
.Lwait:
        str     r0, [r7]
        ldr     r6, [r3, #4]
        lsls    r6, r6, #1
        subs    r6, r1, r6
        bgt     .Lwait
        ldr     r6, [r5, #HEAD_TAIL]
.Lwrite:
        ldr     r3, =0x50000504         /* OUT */
        str     r2, [r3]
        adds    r6, #1
        ldr     r3, [r5]
        cmp     r3, r6
        beq     .Lempty
        fetch
        cmp     r0, #PLAYER_CLOSE
        blo     .Lwrite
        str     r6, [r5, #HEAD_TAIL]
        b       .Llook

.Lfirst:
        ldr     r3, [r5]
        cmp     r3, r6
        beq     .Lempty
        fetch
        b       .Llook

/* Not before nine minutes have gone by. */
.Lempty:
        movs    r2, #0
        str     r6, [r5, #HEAD_TAIL]
        movs    r0, #1
        str     r0, [r7]
        ldr     r3, =0x40008540
        ldr     r0, [r3, #4]
        subs    r0, #1
        b       .Lset

/* The new compare value before the old event is cleared: in 32-bit mode QEMU would raise it again at once. */
.Lalarm:
        ldr     r7, [r3, #4]
        subs    r0, #PLAYER_ENTRY
        lsrs    r0, r0, #1
        adds    r0, r0, r7
.Lset:
        str     r0, [r3]
        movs    r0, #0
        ldr     r3, =0x40008140         /* EVENTS_COMPARE[0] */
        str     r0, [r3]
        str     r1, [r4, #P_AT]
        str     r2, [r4, #P_LEVEL]
        ldr     r3, [r4, #P_LOW]
        subs    r3, r6, r3
        bpl     .Llow
        pop     {r4, r5, r6, r7, pc}

/* There is room for a batch: PendSV, once. */
.Llow:
        ldr     r0, [r5]
        movs    r3, #1
        lsls    r2, r3, #30
        adds    r0, r0, r2
        str     r0, [r4, #P_LOW]
        lsls    r3, r3, #28
        ldr     r0, =0xe000ed04         /* ICSR */
        str     r3, [r0]
        pop     {r4, r5, r6, r7, pc}

/* All that follows is so much later. */
.Ldue:
        movs    r3, r0
        adds    r3, #PLAYER_SLACK
        bge     .Lwrite
        negs    r0, r0
        adds    r1, r1, r0
        ldr     r3, [r5, #HEAD_SKEW]
        adds    r3, r3, r0
        str     r3, [r5, #HEAD_SKEW]
        ldr     r3, [r5, #HEAD_LATE]
        adds    r3, #1
        str     r3, [r5, #HEAD_LATE]
        ldr     r3, [r5, #HEAD_LATEST]
        cmp     r3, r0
        bhs     .Lwrite
        str     r0, [r5, #HEAD_LATEST]
        b       .Lwrite

        .pool
        .size player_isr, . - player_isr
