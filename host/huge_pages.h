/* huge_pages.h - memory that is touched soon, and all of it, by pages of 2 MB instead of 4 KB: the system then clears
 * it in a tenth of the time. Only asked for; without them everything is the same, but later. */
#ifndef HUGE_PAGES_H
#define HUGE_PAGES_H

#include <stddef.h>
#include <sys/mman.h>

#define HUGE_PAGE ((size_t)2 << 20)

/* p: on a border between small pages at the least. */
static inline void huge_pages_ask(void *p, size_t bytes) {
#ifdef MADV_HUGEPAGE
    madvise(p, bytes, MADV_HUGEPAGE);
#else
    (void)p, (void)bytes;
#endif
}

#endif
