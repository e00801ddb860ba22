/* player.h - what the interrupt in player_isr.S shares with player.c; for the assembler, too. */
#ifndef PLAYER_H
#define PLAYER_H

#define PLAYER_RING 32 /* edges: the shifts that make an index of a count */

/* Ticks from an alarm to its edge: to enter, others having interrupts off for a microsecond or so. */
#define PLAYER_ENTRY 32
#define PLAYER_SOON 64  /* ticks to an edge that leaving the interrupt is not worth for */
#define PLAYER_CLOSE 20 /* ticks that pass between two edges if the clock is not looked at */
#define PLAYER_SLACK 96 /* ticks */

/* Offsets, which player.c checks. */
#define AHEAD_HEAD 132
#define HEAD_TAIL 4
#define HEAD_SKEW 20
#define HEAD_LATE 28
#define HEAD_LATEST 32
#define P_AT 0
#define P_LEVEL 4
#define P_LOW 8
#define P_TURNED 12

#endif
