/* meet.h - pairs the ends that meet, as chain.h does, where very many are sorted by their places (places.h).
 *
 * Most ends of a rough surface meet nobody. Whoever may be near another is among the next few places, or beyond the
 * upper or right border of its cell: a few comparisons an end, most of them with what has just been looked at; only who
 * passes them is asked where exactly it is. */
#ifndef MEET_H
#define MEET_H

#include "path/places.h"

/* Pairs ends; then opens closed strokes as loop.h does. The chain's free ends know the far ends of their strokes, as
 * after chain_close, and p->strokes says how many there are. */
void meet_pair(places_t *p);

#endif
