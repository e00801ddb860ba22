/* formats.h - an expression in each number format, at 256 points of [-2,2]^2: what an evaluation costs, not what it is
 * worth (report_formats.c). Written out, without an interpreter, but for the shipped one's arithmetic, num.h. */
#ifndef FORMATS_H
#define FORMATS_H

enum formats_format { FORMAT_Q16, FORMAT_Q32, FORMAT_FLOAT, FORMAT_DOUBLE, FORMAT_NUM, FORMATS };
enum formats_formula { FORMULA_SADDLE, FORMULA_POLE, FORMULA_HILL, FORMULAS };
extern const char *const formats_name[FORMATS];
extern const char *const formats_formula_name[FORMULAS];

/* Evaluates; returns at how many points. */
int formats_run(enum formats_format format, enum formats_formula formula);

#endif
