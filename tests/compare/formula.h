/* formula.h - random expressions in gnuplot's language, as trees, so that a wrong one can be taken apart. */
#ifndef COMPARE_FORMULA_H
#define COMPARE_FORMULA_H

#include <stddef.h>
#include <stdint.h>

enum { FORMULA_NODES = 64, FORMULA_TEXT = 4096 };

/* A node of `form`, whose %s are its children: `%s + %s`, `atan2(%s,%s)`. Level: how tightly it binds, as gnuplot's
 * manual has it; operands that bind less tightly stand in brackets. */
typedef struct formula_node {
    const char *form;
    int16_t child[8];
    int8_t children, level, right; /* right: groups from the right */
} formula_node_t;

typedef struct formula {
    formula_node_t node[FORMULA_NODES];
    int nodes, root;
} formula_t;

/* The next of a series of random numbers; *rng is not 0. */
uint64_t formula_dice(uint64_t *rng);
/* A random number from 0 to n - 1. */
int formula_below(uint64_t *rng, int n);

/* Commands to be run first: the variables and functions that the formulas use. NULL at the end. */
extern const char *const FORMULA_START[];

/* Draws one of numbers, a short one, or one of texts. */
void formula_draw(formula_t *f, uint64_t *rng);
void formula_draw_small(formula_t *f, uint64_t *rng);
void formula_draw_text(formula_t *f, uint64_t *rng);
/* Writes what stands at a node. */
void formula_write(const formula_t *f, int node, char text[FORMULA_TEXT]);

#endif
