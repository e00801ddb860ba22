/* said.h - reading a text that is meant for people and may lie packed in a board's flash.
 *
 *     said_t p = said_text(text);
 *     for (char c; (c = said_next(&p)) != 0;) ...
 *
 * With PACKED_PAIRS, a file that firmware/tools/pack_texts.c has made, some bytes stand for two, each of which may be
 * such a byte again; texts that have none of them are what they are. Without it every text is. */
#ifndef SAID_H
#define SAID_H

#include <stdint.h>

/* A message that comes to people by way of a table or a variable; what is said at once is known without. */
#define SAID(text) text

/* Bytes that stand for two: from 128 on, and control characters but for those of C's escapes. */
#define PACKED_STANDS(byte) ((byte) >= 128 || ((byte) > 0 && (byte) < 32 && ((byte) < 7 || (byte) > 13)))
#define PACKED_PLACE(byte) ((byte) >= 128 ? (byte)-96 : (byte) < 32 ? (byte) : -1) /* in the list of pairs */
#define PACKED_DEPTH 8

typedef struct said {
    const char *at;
#ifdef PACKED_PAIRS
    int top; /* of open, -1: it is empty */
    uint8_t open[PACKED_DEPTH + 1];
#endif
} said_t;

said_t said_text(const char *text);
/* The next character, 0 at the end. */
char said_next(said_t *p);

#endif
