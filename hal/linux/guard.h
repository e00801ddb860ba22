/* guard.h - a second process that outlives the one that steps.
 *
 * The parent has taken the lines and keeps them open; the child steps through the same request. However the child ends,
 * also by SIGKILL or a crash, the lines are not released and the parent makes them safe, within a millisecond. If the
 * parent is killed, the child is told (SIGTERM) and stops by itself. If both are killed at once, the lines are what the
 * chip makes of released ones: that is for the wiring to make safe (docs/LINUX.md).
 *
 * SIGINT, SIGTERM and SIGHUP reach the parent and are passed on. The first asks the child to brake and stop; a second
 * one stops it at once. A child that has not ended GUARD_GRACE_S later is killed. */
#ifndef GUARD_H
#define GUARD_H

#define GUARD_GRACE_S 10

/* Runs step(ctx) in a child; its return value is the exit status. The lines are safe when this returns. Returns the
 * child's exit status, 128 + signal when a signal ended the run, or 1. *killed: the signal that killed the child, or 0.
 */
int guard_run(int (*step)(void *ctx), void *ctx, int *killed);
/* In the child: how many signals have come. */
int guard_signals(void);

#endif
