/* hard_list.h - surfaces and viewpoints that break hidden-line programs, by name. */
#ifndef HARD_LIST_H
#define HARD_LIST_H

#include "tests/oracle/scenes.h"

int hard_list_count(void);
const char *hard_list_name(int i);
/* Makes a scene, 0 <= number < hard_list_count(), to be freed by scene_free. */
void hard_list_build(int number, scene_t *s);

#endif
