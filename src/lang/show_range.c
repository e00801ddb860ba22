/* show_range.c - a range as one would set it. */
#include "lang/session_parts.h"

static void show_end(text_t *t, const range_t *r, bool high) {
    if (!(high ? r->auto_hi : r->auto_lo)) {
        text_add_num(t, high ? r->hi : r->lo);
        return;
    }
#if CONFIG_BOUNDED
    const int bits = r->bounded >> 2 * high;
    if (bits & 1) {
        text_add_num(t, r->bound[2 * high]);
        text_add(t, "<");
    }
    text_add(t, "*");
    if (bits & 2) {
        text_add(t, "<");
        text_add_num(t, r->bound[2 * high + 1]);
    }
#else
    text_add(t, "*");
#endif
}

void show_range(text_t *t, const char *name, const range_t *r) {
    text_add(t, "set ");
    text_add(t, name);
    text_add(t, "range [");
    bool turned = r->reverse && !r->auto_lo && !r->auto_hi;
    show_end(t, r, turned);
    text_add(t, ":");
    show_end(t, r, !turned);
    text_add(t, r->reverse && !turned ? "] reverse\n" : "]\n");
}
