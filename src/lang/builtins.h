/* builtins.h - the functions that need no definition. */
#ifndef BUILTINS_H
#define BUILTINS_H

#include "lang/arith.h"
#include "lang/names.h"

enum builtin_flags {
    BUILTIN_IMPURE = 1,  /* not the same result for the same arguments: rand */
    BUILTIN_COLUMNS = 2, /* reads the data line at hand */
    BUILTIN_OURS = 4,    /* gnuplot has none: a user's function of that name comes first */
    BUILTIN_ANGLE = 8,   /* takes an angle, in degrees if so set */
    BUILTIN_ARC = 16,    /* gives one */
    BUILTIN_TEXTS = 32,  /* tells texts from numbers; the others get numbers only */
    BUILTIN_TEXT = 64,   /* gives a text; CONFIG_CONTROL */
};

typedef struct builtin {
    char name[CONFIG_CONTROL ? 14 : 8];
    uint8_t min_args, max_args, flags;
    /* Exactly one of the two: a function of one real number, or of n values, args[0] being replaced by the result.
     * The second returns what arith_binary does. */
    num_t (*real1)(num_t a);
    const char *(*any)(lang_t *l, value_t *args, int n);
} builtin_t;

/* In alphabetical order; compiled code holds the index. Those that begin with a blank are operators. */
extern const builtin_t BUILTINS[];
/* Calls f, one of n values. Returns what arith_binary does. */
static inline const char *builtin_call(const builtin_t *f, lang_t *l, value_t *args, int n) {
    for (int i = 0; CONFIG_CONTROL && i < n && !(f->flags & BUILTIN_TEXTS); i++) {
        const char *fault = arith_number(&args[i]);
        if (fault) return fault;
    }
    return f->any(l, args, n);
}
/* The index of a function, or -1. */
int builtins_find(const char *name, size_t len);

#endif
