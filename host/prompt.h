/* prompt.h - `ridgeline` alone: commands typed by a person, with line editing and a history across sessions. */
#ifndef PROMPT_H
#define PROMPT_H

/* Reads commands until `quit` or the end of input, through script.h, which has begun. History is kept in
 * ~/.ridgeline_history, the last PROMPT_HISTORY lines. Errors do not end it. */
#define PROMPT_HISTORY 1000
void prompt_run(void);

#endif
