/* hard_list.h - surfaces and viewpoints that break hidden-line programs, by name. */
#ifndef HARD_LIST_H
#define HARD_LIST_H

#include "tests/oracle/scenes.h"

int hard_list_count(void);
const char *hard_list_name(int i);
/* Makes scene i, 0 <= i < hard_list_count(), to be freed by scene_free. */
void hard_list_build(int i, scene_t *s);

#endif
