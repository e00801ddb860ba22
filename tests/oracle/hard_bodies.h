/* hard_bodies.h - the bodies of the hard lists of solids (hard_solids.c, tests/hard/test_hard_area.c). */
#ifndef HARD_BODIES_H
#define HARD_BODIES_H

#include "tests/oracle/solid_scenes.h"

/* n <= 32 */
void hard_polygon(solid_ref_t *r, const double (*p)[3], int n);
void hard_box(solid_ref_t *r, double x, double y, double z, double a, double b, double c);

void hard_cubes(solid_ref_t *r);
void hard_many_cubes(solid_ref_t *r);
void hard_one_box(solid_ref_t *r);
void hard_flush(solid_ref_t *r);
void hard_lattice(solid_ref_t *r);
void hard_one_plane(solid_ref_t *r);
void hard_brackets(solid_ref_t *r);
void hard_bars(solid_ref_t *r);
void hard_circle(solid_ref_t *r, int n);
void hard_cut(solid_ref_t *r);
void hard_penetrating(solid_ref_t *r);
void hard_slivers(solid_ref_t *r);
void hard_needles(solid_ref_t *r);
void hard_needle(solid_ref_t *r);
void hard_plates(solid_ref_t *r);
void hard_billionth(solid_ref_t *r);
void hard_twisted(solid_ref_t *r);
void hard_window(solid_ref_t *r);
void hard_angles(solid_ref_t *r);
void hard_large_and_small(solid_ref_t *r);
void hard_millionth(solid_ref_t *r);
void hard_broken(solid_ref_t *r);
void hard_open_sides(solid_ref_t *r);
void hard_fan(solid_ref_t *r);
void hard_segment(solid_ref_t *r);

#endif
