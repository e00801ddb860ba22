/* collapse.h - how a horizon falls to pieces, and how few are needed (P. Greenspun and J. J. Little 1988). */
#ifndef COLLAPSE_H
#define COLLAPSE_H

typedef struct collapse {
    int fragments; /* segments of a horizon kept as they do, never joined */
    int collapsed; /* when neighbours cut from one segment are joined again */
    int ours;      /* pieces of the envelope of src/ */
} collapse_t;

/* The upper horizon of so many profiles of 60 points, cut from a random fractal terrain. */
collapse_t collapse_count(int profiles);

#endif
