/* error.h - the one list of errors. Zero is success, a non-negative value may be a count, errors are negative
 * and travel up unchanged. error_text() gives the sentence a person reads (src/error.c, one table). */
#ifndef ERROR_H
#define ERROR_H

enum error {
    ERR_SYNTAX = -1,      /* the text is not of the language; line and column are in lang_error_t */
    ERR_NAME = -2,        /* unknown variable, function, command or option */
    ERR_VALUE = -3,       /* a value is out of range or undefined where one is needed */
    ERR_FULL = -4,        /* a configured capacity ran out; the message names it */
    ERR_EMPTY = -5,       /* nothing to draw: no defined point, empty range, no data */
    ERR_DATA = -6,        /* a data file or inline data is malformed */
    ERR_FILE = -7,        /* a file cannot be opened, read or written */
    ERR_UNSUPPORTED = -8, /* understood, but this program does not do it */
    ERR_MACHINE = -9,     /* outside the machine's limits, or the machine faulted */
    ERR_LIGHT = -11,      /* a point light stands where it cannot be used */
    ERR_STOPPED = -10,    /* the user stopped it */
};

const char *error_text(int err);

#endif
