/* pack_help.c - the texts of src/lang/help.c for the board that the CONFIG_ definitions describe, as a C header on
 * stdout.
 *
 * Again and again the two bytes that most often stand side by side become one, from 128 on, until there is none left or
 * nothing is won: half of the flash, and some twenty lines to read it (tell_topic in help.c). */
#define HELP_TEXTS_ONLY
#include "lang/help.c"

#include <stdio.h>
#include <string.h>

#define TOPICS (sizeof topics / sizeof topics[0])
#define FIRST 128
#define LAST 255
#define DEPTH_MOST 8 /* of bytes that stand for others: the reader's stack */
#define WORTH 4      /* times: an entry takes two bytes itself */

static unsigned char text[1 << 16], pair[LAST - FIRST + 1][2];
static size_t length;
static int pairs, depth[LAST + 1];
static int count[LAST + 1][LAST + 1];

/* The pair that is met most often, the first of several; 0 if none is worth it. */
static int most(int *a, int *b) {
    int best = 0;
    memset(count, 0, sizeof count);
    for (size_t k = 1; k < length; k++) {
        const int p = text[k - 1], q = text[k];
        if (p == 0 || q == 0 || depth[p] >= DEPTH_MOST || depth[q] >= DEPTH_MOST) continue;
        if (++count[p][q] <= best) continue;
        best = count[p][q];
        *a = p;
        *b = q;
    }
    return best >= WORTH ? best : 0;
}

static void replace(int a, int b, int by) {
    size_t to = 0;
    for (size_t k = 0; k < length; k++) {
        const int met = text[k] == a && k + 1 < length && text[k + 1] == b;
        text[to++] = met ? (unsigned char)by : text[k];
        k += (size_t)met;
    }
    length = to;
}

int main(void) {
    int a = 0, b = 0, deepest = 0;
    for (size_t k = 0; k < TOPICS; k++) {
        const size_t n = strlen(topics[k].text) + 1;
        memcpy(text + length, topics[k].text, n);
        length += n;
    }
    while (pairs <= LAST - FIRST && most(&a, &b)) {
        const int by = FIRST + pairs;
        pair[pairs][0] = (unsigned char)a;
        pair[pairs++][1] = (unsigned char)b;
        depth[by] = 1 + (depth[a] > depth[b] ? depth[a] : depth[b]);
        if (depth[by] > deepest) deepest = depth[by];
        replace(a, b, by);
    }
    printf("/* By firmware/tools/pack_help.c from src/lang/help.c. */\n#define PACKED_DEPTH %d\n", deepest);
    printf("static const struct {\n    const char *pattern;\n} topics[] = {\n");
    for (size_t k = 0; k < TOPICS; k++) printf("    {\"%s\"},\n", topics[k].pattern);
    printf("};\n");
    printf("static const uint8_t pair[][2] = {");
    for (int k = 0; k < pairs; k++) printf("%s{%d, %d},", k % 12 ? " " : "\n    ", pair[k][0], pair[k][1]);
    printf("\n};\n");
    printf("static const uint8_t packed[] = {");
    for (size_t k = 0; k < length; k++) printf("%s%d,", k % 24 ? "" : "\n    ", text[k]);
    printf("\n};\n");
    return 0;
}
