/* said.c - see said.h. */
#include "said.h"

#ifdef PACKED_PAIRS
static const uint8_t pair[][2] = {
#include PACKED_PAIRS
};

said_t said_text(const char *text) {
    return (said_t){.at = text, .top = -1};
}

char said_next(said_t *p) {
    uint8_t c = p->top < 0 ? (uint8_t)*p->at++ : p->open[p->top--];
    while (PACKED_STANDS(c)) {
        const uint8_t *two = pair[PACKED_PLACE(c)];
        p->open[++p->top] = two[1];
        c = two[0];
    }
    return (char)c;
}
#else
said_t said_text(const char *text) {
    return (said_t){text};
}

char said_next(said_t *p) {
    return *p->at++;
}
#endif
