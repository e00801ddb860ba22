/* judge.h - how wrong is a drawing? Lengths on the page, against a reference.
 *
 * Missing ink is visible and not drawn; false ink is drawn and hidden (or on an edge that does not exist). `raw`
 * figures compare with the reference point by point. The others forgive what one motor step could hide: ink is missing
 * only where the line is visible also when moved by a step (or 1/8, 1/64 ... 1/4096) to either side on the page, false
 * only where it is hidden also then. Runs that are left longer than a step, and ends more than a quarter of one off,
 * are held against the page: where other ink runs along the line the page is right (judge_page.h). Each figure is the
 * longest unbroken run along a grid line, in mm. */
#ifndef JUDGE_H
#define JUDGE_H

#include <stddef.h>

#include "tests/oracle/horizon_ref.h"
#include "tests/oracle/page_view.h"
#include "tests/oracle/surface_ref.h"

#define JUDGE_STEP_MM 0.0125

/* What is judged: lines made of edges, and a reference that knows what of an edge is hidden. */
typedef struct judge_subject {
    const void *ref;
    int every; /* judge every so-manieth line only, for surfaces too large for the whole; 0: all */
    int (*lines)(const void *ref, int family); /* families 0 and 1 */
    int (*edges)(const void *ref, int family, int line);
    bool (*exists)(const void *ref, int family, int line, int k);
    void (*ends)(const void *ref, int family, int line, int k, exact_point_t end[2]);
    void (*look)(const void *ref, int family, int line, int k, spans_t *hidden, spans_t *either);
    void (*moved)(const void *ref, int family, int line, int k, const exact_point_t at[2], spans_t *hidden);
    void (*doubled)(const void *ref, int family, int line, int k, const exact_point_t at[2],
                    const exact_point_t other[2], spans_t *out);
} judge_subject_t;

judge_subject_t judge_surface(const surface_ref_t *r);
judge_subject_t judge_horizon(const horizon_ref_t *r);

/* A drawn part of a grid line: from and to count its vertices, the fraction is the position in space. */
typedef struct judge_piece {
    int family, line; /* REF_ROW or REF_COL */
    double from, to;
} judge_piece_t;

typedef struct judge_spot {
    int family, line;
    double from, to;
} judge_spot_t;

typedef struct judge_report {
    double missing_mm, false_mm;
    double raw_missing_mm, raw_false_mm;
    double beside_mm;   /* longest run that only the page explained: its ink is another line's */
    double twice_mm;    /* longest run drawn more than once */
    double end_steps;   /* largest displacement of an end of ink, along the line or by what move across explains it */
    double moved_steps; /* not judged: how far the rounding of vertices moves an end on the page, if measured */
    double ink_mm, visible_mm;          /* sums */
    judge_spot_t missing, falsely, end; /* where the worst is (to: not used for end) */
} judge_report_t;

/* Judges n pieces. Returns 0, or -1 when a piece is not on the grid. */
int judge_pieces(const judge_subject_t *what, const page_view_t *v, const judge_piece_t *piece, size_t n,
                 judge_report_t *out);
/* What of one edge is surely visible and surely hidden, in [0, 1]: also when moved across by `steps` on the page. */
void judge_edge(const judge_subject_t *what, const page_view_t *v, int family, int line, int k, double steps,
                spans_t *visible, spans_t *hidden);
/* Takes the worse of both. */
void judge_worst(judge_report_t *all, const judge_report_t *one);

#endif
