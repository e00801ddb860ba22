/* words.h - numbers of 64 bits for a core whose compiler keeps pairs of registers badly.
 *
 * gcc has eight registers on a Cortex-M0, wants two neighbours for a number of 64 bits, and spends as many instructions
 * on moving pairs to the stack and back as on the arithmetic. Two words that are numbers of their own stay where they
 * are; what passes a carry from one to the next is an instruction. Elsewhere a words_t is an integer of 64 bits, and
 * all of this is what it says. Signed or not is a matter of the operation. Context: any. */
#ifndef WORDS_H
#define WORDS_H

#include <stdint.h>

#include "num/wide.h"

#if defined __ARM_ARCH_6M__ && defined __arm__

typedef struct words {
    uint32_t hi, lo;
} words_t;

static inline words_t words(uint32_t hi, uint32_t lo) {
    return (words_t){hi, lo};
}
static inline uint32_t words_hi(words_t a) {
    return a.hi;
}
static inline uint32_t words_lo(words_t a) {
    return a.lo;
}

static inline words_t words_add(words_t a, words_t b) {
    __asm(".syntax unified\n"
          "adds %[l], %[l], %[bl]\n"
          "adcs %[h], %[bh]\n"
          : [h] "+l"(a.hi), [l] "+&l"(a.lo)
          : [bh] "l"(b.hi), [bl] "l"(b.lo)
          : "cc");
    return a;
}

static inline words_t words_sub(words_t a, words_t b) {
    __asm(".syntax unified\n"
          "subs %[l], %[l], %[bl]\n"
          "sbcs %[h], %[bh]\n"
          : [h] "+l"(a.hi), [l] "+&l"(a.lo)
          : [bh] "l"(b.hi), [bl] "l"(b.lo)
          : "cc");
    return a;
}

/* a * 2^n modulo 2^64, floor(a / 2^n), and the same of a signed a, for 0 < n < 32. */
static inline words_t words_shl(words_t a, int n) {
    return (words_t){a.hi << n | a.lo >> (32 - n), a.lo << n};
}
static inline words_t words_shr(words_t a, int n) {
    return (words_t){a.hi >> n, a.lo >> n | a.hi << (32 - n)};
}
static inline words_t words_sar(words_t a, int n) {
    return (words_t){(uint32_t)((int32_t)a.hi >> n), a.lo >> n | a.hi << (32 - n)};
}

/* u + 0x1ff + bit 10 of u, without its ten lowest bits: 63 bits rounded to 53, ties to even. */
static inline words_t words_round(words_t u) {
    uint32_t half = 0x1ff, t;
    __asm(".syntax unified\n"
          "lsrs %[t], %[l], #11\n" /* bit 10 is the carry */
          "adcs %[l], %[half]\n"
          "movs %[t], #0\n"
          "adcs %[h], %[t]\n"
          "lsrs %[l], %[l], #10\n"
          "lsls %[l], %[l], #10\n"
          : [h] "+l"(u.hi), [l] "+l"(u.lo), [t] "=&l"(t)
          : [half] "l"(half)
          : "cc");
    return u;
}

/* a * a, and the upper word of a * b, which takes less than the whole. */
static inline words_t words_square_s32(int32_t a) {
    uint32_t low, high, t;
    __asm(".syntax unified\n"
          "uxth %[low], %[a]\n"
          "asrs %[high], %[a], #16\n"
          "movs %[t], %[low]\n"
          "muls %[t], %[high]\n"
          "muls %[low], %[low]\n"
          "muls %[high], %[high]\n"
          "lsls %[a], %[t], #17\n"
          "asrs %[t], %[t], #15\n"
          "adds %[low], %[a]\n"
          "adcs %[high], %[t]\n"
          : [a] "+l"(a), [low] "=&l"(low), [high] "=&l"(high), [t] "=&l"(t)
          :
          : "cc");
    return (words_t){high, low};
}
static inline int32_t words_mulhi_s32(int32_t a, int32_t b) {
    int32_t low, t, u;
    __asm(".syntax unified\n" WIDE_M0_MULHI_S32("%[a]", "%[b]", "%[low]", "%[t]", "%[u]")
          : [a] "+l"(a), [b] "+l"(b), [low] "=&l"(low), [t] "=&l"(t), [u] "=&l"(u)
          :
          : "cc");
    return a;
}

#else

typedef uint64_t words_t;

static inline words_t words(uint32_t hi, uint32_t lo) {
    return (uint64_t)hi << 32 | lo;
}
static inline uint32_t words_hi(words_t a) {
    return (uint32_t)(a >> 32);
}
static inline uint32_t words_lo(words_t a) {
    return (uint32_t)a;
}
static inline words_t words_add(words_t a, words_t b) {
    return a + b;
}
static inline words_t words_sub(words_t a, words_t b) {
    return a - b;
}
static inline words_t words_shl(words_t a, int n) {
    return a << n;
}
static inline words_t words_shr(words_t a, int n) {
    return a >> n;
}
static inline words_t words_sar(words_t a, int n) {
    return (uint64_t)((int64_t)a >> n);
}
static inline words_t words_round(words_t u) {
    return (u + 0x1FFu + (u >> 10 & 1)) & ~(uint64_t)0x3FF;
}
static inline words_t words_square_s32(int32_t a) {
    return (uint64_t)((int64_t)a * a);
}
static inline int32_t words_mulhi_s32(int32_t a, int32_t b) {
    return (int32_t)((int64_t)a * b >> 32);
}

#endif

/* Registers of 64 bits: what follows is shorter without words. */
#define WORDS_WIDE (sizeof(void *) >= 8)

static inline words_t words_of(uint64_t a) {
    return words((uint32_t)(a >> 32), (uint32_t)a);
}
static inline uint64_t words_join(words_t a) {
    return (uint64_t)words_hi(a) << 32 | words_lo(a);
}
static inline words_t words_of_s32(int32_t a) {
    if (WORDS_WIDE) return words_of((uint64_t)a);
    return words((uint32_t)(a >> 31), (uint32_t)a);
}
/* The upper word of a, rounded; what is left, the lower one, then has a sign. */
static inline int32_t words_upper(words_t a) {
    if (WORDS_WIDE) return (int32_t)((words_join(a) + 0x80000000u) >> 32);
    return (int32_t)(words_hi(a) + (words_lo(a) >> 31));
}
/* words_sar by any n from 0 on. */
static inline words_t words_sar_far(words_t a, int n) {
    if (WORDS_WIDE) return words_of((uint64_t)((int64_t)words_join(a) >> (n < 63 ? n : 63)));
    if (n >= 32) {
        const int32_t hi = (int32_t)words_hi(a);
        return words_of_s32(hi >> (n < 63 ? n - 32 : 31));
    }
    return n ? words_sar(a, n) : a;
}
/* 0, or ~0 of a negative one. */
static inline uint32_t words_sign(words_t a) {
    return (uint32_t)((int32_t)words_hi(a) >> 31);
}
/* a with the sign of s, which is 0 or ~0: (a ^ s) - s. */
static inline words_t words_with_sign(words_t a, uint32_t s) {
    if (__builtin_constant_p(s) && s == 0) return a;
    if (WORDS_WIDE) return words_of((words_join(a) ^ (uint64_t)(int32_t)s) - (uint64_t)(int32_t)s);
    return words_sub(words(words_hi(a) ^ s, words_lo(a) ^ s), words(s, s));
}
static inline words_t words_mul_s32(int32_t a, int32_t b) {
    return words_of((uint64_t)wide_mul_s32(a, b));
}
static inline words_t words_mul_u32(uint32_t a, uint32_t b) {
    return words_of(wide_mul_u32(a, b));
}
/* a b / 2^64 + more, a and b below 2^63 - 2^31: within 2 units. */
static inline words_t words_scaled(words_t a, words_t b, int32_t more) {
    const int32_t ah = words_upper(a), bh = words_upper(b);
    const int32_t rest = words_mulhi_s32(ah, (int32_t)words_lo(b)) + words_mulhi_s32(bh, (int32_t)words_lo(a));
    return words_add(words_mul_s32(ah, bh), words_of_s32(rest + more));
}

#endif
