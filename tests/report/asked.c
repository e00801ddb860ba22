/* asked.c - see asked.h. */
#include "tests/report/asked.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static bool is_of(const asked_t *a, const char *name) {
    for (int k = 0; k < ASKED_NAMES && a->rows[k]; k++)
        if (strncmp(name, a->rows[k], strlen(a->rows[k])) == 0) return true;
    return false;
}

void asked_write(FILE *md, const asked_t *asked, int n, const asked_row_t *row, int rows) {
    fputs("\n## What was asked for, and where it is\n\n"
          "| case | rows | missing or false | end off | naive: at worst |\n|---|---|--:|--:|--:|\n",
          md);
    for (const asked_t *a = asked; a < asked + n; a++) {
        double off = 0, end = 0, naive = 0;
        int found = 0;
        fprintf(md, "| %s |", a->what);
        for (const asked_row_t *r = row; r < row + rows; r++) {
            if (!is_of(a, r->name)) continue;
            fprintf(md, "%s %s", found++ ? "," : "", r->label);
            off = fmax(off, r->off);
            end = fmax(end, r->end);
            naive = fmax(naive, r->naive);
        }
        fprintf(md, " | %.2f | %.2f | %.0f |\n", off, end, naive);
        if (found) continue;
        fprintf(stderr, "asked_write: no row is `%s`\n", a->what);
        exit(1);
    }
}
