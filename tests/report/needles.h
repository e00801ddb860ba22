/* needles.h - the area sort's limit: thinner and thinner needles, for the section on hard cases. */
#ifndef REPORT_NEEDLES_H
#define REPORT_NEEDLES_H

/* Writes needles.tsv into dir, and its part of the section on stdout. */
void needles_write(const char *dir);

#endif
