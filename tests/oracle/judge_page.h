/* judge_page.h - the judge's second look: is there ink in that place, whichever line it is of?
 *
 * Where grid lines are nearer to each other than the program's lattice tells apart, which of them hides the other is
 * rounded, and ink may be given to the wrong one. Nobody sees that: the page has a line there, and has to. So what is
 * missing (false) line by line is held against all ink that is drawn (that may be seen): what runs along it, within
 * JUDGE_ONE_LINE_MM all the way, is one line with it. */
#ifndef JUDGE_PAGE_H
#define JUDGE_PAGE_H

#include "tests/oracle/judge.h"
#include "tests/oracle/page_lines.h"

#define JUDGE_ONE_LINE_MM (JUDGE_STEP_MM / 64)

/* All ink of a drawing and of an exact one, what may be drawn or not included. */
typedef struct judge_page {
    page_lines_t drawn, seen;
    bool known;
} judge_page_t;

/* Does nothing the second time. */
void judge_page_fill(judge_page_t *p, const judge_subject_t *what, const page_view_t *v, const judge_piece_t *piece,
                     size_t n);
void judge_page_free(judge_page_t *p);
/* What of `part` of a line, counted in vertices, has nothing of `by` along it. */
void judge_page_alone(const judge_subject_t *what, const page_view_t *v, int family, int line, const spans_t *part,
                      const page_lines_t *by, spans_t *out);

#endif
