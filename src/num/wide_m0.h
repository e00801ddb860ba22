/* wide_m0.h - products of 32-bit operands as instructions of a Cortex-M0, whose own have 32 bits; private to wide and
 * words.
 *
 * Given the same in C, gcc makes 25 instructions of it. Registers are named by the user; a and b are used up. */
#ifndef WIDE_M0_H
#define WIDE_M0_H

/* The four products of halves, of which `shift` takes the upper ones: a = high high, b = high low, u = low high, low =
 * low low; t is the lower half of a. */
#define WIDE_M0_HALVES(shift, a, b, low, t, u)                                                                         \
    "uxth " t ", " a "\n" shift " " a ", " a ", #16\n" shift " " u ", " b ", #16\n"                                    \
    "uxth " b ", " b "\n"                                                                                              \
    "movs " low ", " t "\n"                                                                                            \
    "muls " low ", " b "\n"                                                                                            \
    "muls " b ", " a "\n"                                                                                              \
    "muls " a ", " u "\n"                                                                                              \
    "muls " u ", " t "\n"

/* a:low = a * b, unsigned. */
#define WIDE_M0_MUL_U32(a, b, low, t, u)                                                                               \
    WIDE_M0_HALVES("lsrs", a, b, low, t, u)                                                                            \
    "adds " u ", " b "\n"                                                                                              \
    "movs " t ", #0\n"                                                                                                 \
    "adcs " t ", " t "\n"                                                                                              \
    "lsls " t ", " t ", #16\n"                                                                                         \
    "adds " a ", " t "\n"                                                                                              \
    "lsls " t ", " u ", #16\n"                                                                                         \
    "lsrs " u ", " u ", #16\n"                                                                                         \
    "adds " low ", " t "\n"                                                                                            \
    "adcs " a ", " u "\n"

/* a = the upper word of a * b, signed; the upper halves have the signs, so no sum leaves 32 bits. Its lower word is
 * then u * 2^16 and the lower half of low. */
#define WIDE_M0_MULHI_S32(a, b, low, t, u)                                                                             \
    WIDE_M0_HALVES("asrs", a, b, low, t, u)                                                                            \
    "lsrs " t ", " low ", #16\n"                                                                                       \
    "adds " b ", " t "\n"                                                                                              \
    "uxth " t ", " b "\n"                                                                                              \
    "adds " u ", " t "\n"                                                                                              \
    "asrs " b ", " b ", #16\n"                                                                                         \
    "adds " a ", " b "\n"                                                                                              \
    "asrs " t ", " u ", #16\n"                                                                                         \
    "adds " a ", " t "\n"

#endif
