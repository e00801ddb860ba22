/* create.h - a file of the report, opened for writing. */
#ifndef REPORT_CREATE_H
#define REPORT_CREATE_H

#include <stdio.h>

/* Ends the program with a message if it cannot be. */
FILE *report_create(const char *dir, const char *name);

#endif
