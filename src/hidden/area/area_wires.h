/* area_wires.h - lines that no polygon of the area sort ends in: free segments, edges of faces seen edge-on or
 * nearly, and, where those are looked through, edges and details of translucent faces. */
#ifndef AREA_WIRES_H
#define AREA_WIRES_H

#include "hidden/area/area.h"
#include "hidden/area/area_face.h"

/* What became of a face of the scene. AREA_ROUGH: it takes part, but polygons do not say all of its edges. Rounding
 * moves their ends by a tenth of a step or more, or parts of it were lost: in sharp corners, where another face cuts
 * through it at a small angle, where it is seen in a strip of no more than AREA_THIN; or an edge of it lies in the
 * plane of what hides it. (Not one with holes: where a hole runs along an edge neither is drawn, which only polygons
 * know.) */
enum area_state { AREA_LEFT_OUT, AREA_TAKES_PART, AREA_TURNED_AWAY, AREA_ROUGH };

/* Gives the visible parts of all such lines to sink->wire, from faces and each scene face's state. mem: scratch.
 * Returns 0, ERR_FULL or the sink's error. Cost: lines times polygons. */
int area_wires(const area_faces_t *faces, const uint8_t *state, void *mem, size_t bytes, const area_sink_t *sink);

#endif
