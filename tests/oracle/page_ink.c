/* page_ink.c - see page_ink.h. */
#include "tests/oracle/page_ink.h"

#include "config.h"

#define LAT_MM (1.0 / LAT_PER_MM)

int page_ink_take(void *ctx, const ink_piece_t *p) {
    page_ink_t *i = ctx;
    double at[2][2];
    for (int k = 0; k < 2; k++) {
        page_h_t h;
        if (!i->space->at(i->space->ctx, p->family, p->line, k ? p->to : p->from, &h) || h.e <= 0) return 0;
        at[k][0] = (double)h.x / (double)h.e * LAT_MM;
        at[k][1] = (double)h.y / (double)h.e * LAT_MM;
    }
    page_lines_add(&i->lines, (page_line_t){at[0][0], at[0][1], at[1][0], at[1][1]});
    return 0;
}
