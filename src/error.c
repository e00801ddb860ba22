/* error.c - the sentences that go with the numbers of error.h. */
#include "error.h"

#include "config.h"
#include "said.h"

static const char *const TEXT[] = {
    [0] = SAID("no error"),
    [-ERR_SYNTAX] = SAID("syntax error"),
    [-ERR_NAME] = SAID("unknown name"),
    [-ERR_VALUE] = SAID("value out of range or undefined"),
    [-ERR_FULL] = SAID("a capacity is exhausted"),
    [-ERR_EMPTY] = SAID("nothing to draw: no point is defined and within the ranges"),
    [-ERR_DATA] = SAID("malformed data"),
    [-ERR_FILE] = SAID("cannot open, read or write the file"),
    [-ERR_UNSUPPORTED] = SAID("not supported"),
    [-ERR_MACHINE] = SAID("the machine could not do it"),
    [-ERR_STOPPED] = SAID("stopped"),
#if CONFIG_AREA
    [-ERR_LIGHT] = SAID("a point light must stand outside of the scene, and not close to it"),
#endif
};

const char *error_text(int err) {
    int n = err < 0 ? -err : 0;
    return n < (int)(sizeof TEXT / sizeof TEXT[0]) && TEXT[n] ? TEXT[n] : SAID("unknown error");
}
