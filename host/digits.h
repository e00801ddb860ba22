/* digits.h - three digits of a number at a time, by table. */
#ifndef DIGITS_H
#define DIGITS_H

/* A number from 0 to 999 in fields of four bytes, so that one move takes one. */
typedef struct digits {
    char dotted[4]; /* ".042" */
    char padded[4]; /* "042" and a zero byte */
    char whole[4];  /* "42" and, in the fourth byte, how many digits that are */
    char kept[4];   /* in the first byte: how much of dotted is left without zeros at its end */
} digits_t;

extern const digits_t DIGITS[1000];

#endif
