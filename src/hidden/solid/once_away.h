/* once_away.h - which faces of bodies are turned from the eye, told from their pictures.
 *
 * Cheaper than the determinants that kernels decide by, and only for what may be mistaken: faces so thin on the page
 * that rounded places do not tell are not called away. Cost: two products a corner. */
#ifndef ONCE_AWAY_H
#define ONCE_AWAY_H

#include "view/solid_map.h"

/* Sets away[face] to 1 if the face is of a closed object and surely turned away, otherwise to 0. False, and nothing is
 * set, where vertices are behind the eye. */
bool once_find_away(const solid_map_t *m, uint8_t *away);

#endif
