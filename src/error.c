/* error.c - the sentences that go with the numbers of error.h. */
#include "error.h"

#include "config.h"

static const char *const TEXT[] = {
    [0] = "no error",
    [-ERR_SYNTAX] = "syntax error",
    [-ERR_NAME] = "unknown name",
    [-ERR_VALUE] = "value out of range or undefined",
    [-ERR_FULL] = "a capacity is exhausted",
    [-ERR_EMPTY] = "nothing to draw",
    [-ERR_DATA] = "malformed data",
    [-ERR_FILE] = "cannot open, read or write the file",
    [-ERR_UNSUPPORTED] = "not supported",
    [-ERR_MACHINE] = "the machine could not do it",
    [-ERR_STOPPED] = "stopped",
#if CONFIG_AREA
    [-ERR_LIGHT] = "a point light must stand outside of the scene, and not close to it",
#endif
};

const char *error_text(int err) {
    int n = err < 0 ? -err : 0;
    return n < (int)(sizeof TEXT / sizeof TEXT[0]) && TEXT[n] ? TEXT[n] : "unknown error";
}
