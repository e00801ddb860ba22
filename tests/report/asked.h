/* asked.h - which rows of a table of hard cases are the ones that were asked for. */
#ifndef REPORT_ASKED_H
#define REPORT_ASKED_H

#include <stdio.h>

#define ASKED_NAMES 6

/* A case, and the beginnings of the names of rows that are it. */
typedef struct asked {
    const char *what, *rows[ASKED_NAMES];
} asked_t;

typedef struct asked_row {
    char label[16];
    const char *name;
    double off, end, naive; /* steps: missing or false; ends; what the naive drawing misses or invents */
} asked_row_t;

/* Writes the table of n cases. Ends the program if one has no row. */
void asked_write(FILE *md, const asked_t *asked, int n, const asked_row_t *row, int rows);

#endif
