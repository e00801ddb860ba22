/* lattice.h - a coarser lattice under the kernels, or simpler horizons, to see what its bits and their vertices are
 * worth.
 *
 * The kernels decide on integers of 2^30 units a side; lattice_shift bits are taken off whatever the chart (or, for
 * profiles, the horizon kernel) hands them. So crossings are rounded to the coarser lattice too, and the dead zone of
 * ENVELOPE_NOISE units grows with it: it is the same algorithm with shorter numbers. The linker puts these functions
 * before the kernels' own (report.mk, --wrap); src/ knows nothing of it. Not for charts that go round the eye, whose
 * upper bits are the sector. */
#ifndef LATTICE_H
#define LATTICE_H

/* Bits below a step of an A4 drawing that the shipped lattice has at least (DESIGN.md). */
#define LATTICE_SHIPPED 15

extern int lattice_shift;    /* bits to take off; 0: as shipped */
extern int lattice_simplify; /* vertices this near (units) to the line of their neighbours leave a horizon, and what is
                                left of a window is closed if it is no higher; 0: none */
extern int lattice_profiles; /* 1: the horizon kernel is being run, which has no chart */

/* The shift that leaves so many bits below a step. */
static inline int lattice_shift_for(int sub_step_bits) {
    return LATTICE_SHIPPED - sub_step_bits;
}

#endif
