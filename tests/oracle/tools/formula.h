/* formula.h - z(x, y) from text in floating point, for the judge's command line only: + - * / % ** with gnuplot's
 * precedence, < <= > >= and ?:, parentheses, numbers (all real), x, y, pi and the usual functions of libm. */
#ifndef FORMULA_H
#define FORMULA_H

/* NaN where undefined or where the text is not understood; *bad is then the place, otherwise NULL. */
double formula(const char *text, double x, double y, const char **bad);

#endif
