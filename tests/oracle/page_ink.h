/* page_ink.h - what a kernel draws, as lines on the page: a sink for it. */
#ifndef PAGE_INK_H
#define PAGE_INK_H

#include "hidden/ink.h"
#include "tests/oracle/page_lines.h"
#include "view/line_space.h"

typedef struct page_ink {
    const line_space_t *space;
    page_lines_t lines;
} page_ink_t;

/* For ink_sink_t; ctx is a page_ink_t. */
int page_ink_take(void *ctx, const ink_piece_t *p);

#endif
