/* wide.h - 128-bit products, sums and comparisons of 64-bit integers.
 *
 * Why: the sign of a*d - b*c for full-width operands decides visibility and must be exact, and the
 * significands of num.h multiply to 126 bits. Every function is exact unless it says otherwise; results are
 * the same bits on every machine.
 *
 * This header is the one place of the core that may look at the compiler: the same product is one instruction
 * where there is a 128-bit integer, made of 32x32->64 ones elsewhere, and those of 16x16->32 ones where the
 * instruction set has nothing longer.
 * Context: any. Cost on a Cortex-M0: a full product about 110 instructions, which is why there are narrower
 * ones. */
#ifndef WIDE_H
#define WIDE_H

#include <stdint.h>

#include "num/wide_m0.h"

/* Members of the structures that travel by value. gcc copies a structure in registers on a Cortex-M0 if it is aligned
 * to 4 and calls memcpy if it is aligned to 8: 70 cycles a copy, and there was a copy for every operand. */
typedef int64_t wide_s64_t __attribute__((aligned(4)));
typedef uint64_t wide_u64_t __attribute__((aligned(4)));

/* Two's complement: value = hi * 2^64 + lo. */
typedef struct wide {
    wide_s64_t hi;
    wide_u64_t lo;
} wide_t;

/* Unsigned: value = hi * 2^64 + lo. */
typedef struct wide_u {
    wide_u64_t hi, lo;
} wide_u_t;

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 wide_native_u_t;
__extension__ typedef __int128 wide_native_t;

static inline wide_native_u_t wide_native(wide_t a) {
    return (wide_native_u_t)(uint64_t)a.hi << 64 | a.lo;
}
static inline wide_t wide_of_native(wide_native_u_t a) {
    return (wide_t){(int64_t)(a >> 64), (uint64_t)a};
}
#endif

/* a * b of 32-bit operands. On a Cortex-M0, whose products have 32 bits, the plain expression would call a library
 * routine that multiplies all 64 bits (45 instructions). Of the halves these make 18 and 20, and everything that is
 * exact here consists of them. */
static inline uint64_t wide_mul_u32(uint32_t a, uint32_t b) {
#if defined __ARM_ARCH_6M__ && defined __arm__
    uint32_t low, t, u;
    __asm(".syntax unified\n" WIDE_M0_MUL_U32("%[a]", "%[b]", "%[low]", "%[t]", "%[u]")
          : [a] "+l"(a), [b] "+l"(b), [low] "=&l"(low), [t] "=&l"(t), [u] "=&l"(u)
          :
          : "cc");
    return (uint64_t)a << 32 | low;
#else
    return (uint64_t)a * b;
#endif
}
static inline int64_t wide_mul_s32(int32_t a, int32_t b) {
#if defined __ARM_ARCH_6M__ && defined __arm__
    int32_t low, t, u;
    __asm(".syntax unified\n" WIDE_M0_MULHI_S32("%[a]", "%[b]", "%[low]", "%[t]", "%[u]") /* and the lower word */
          "lsls %[u], %[u], #16\n uxth %[low], %[low]\n orrs %[low], %[u]\n"
          : [a] "+l"(a), [b] "+l"(b), [low] "=&l"(low), [t] "=&l"(t), [u] "=&l"(u)
          :
          : "cc");
    return (int64_t)((uint64_t)(uint32_t)a << 32 | (uint32_t)low);
#else
    return (int64_t)a * b;
#endif
}

/* The four products of words that make one of 64 bits do not fit into the registers of a Cortex-M0: wide.c has a
 * routine for it, whose operands and results are r0 to r3. Where bytes count most they are calls. */
#if defined __ARM_ARCH_6M__ && defined __arm__ && !defined __OPTIMIZE_SIZE__
#define WIDE_ROUTINE 1
void wide_mul_words(void);
#endif

/* a * b of 64-bit operands. */
static inline wide_u_t wide_mul_u64(uint64_t a, uint64_t b) {
#ifdef __SIZEOF_INT128__
    wide_native_u_t p = (wide_native_u_t)a * b;
    return (wide_u_t){(uint64_t)(p >> 64), (uint64_t)p};
#elif defined WIDE_ROUTINE
    register uint32_t r0 __asm("r0") = (uint32_t)a;
    register uint32_t r1 __asm("r1") = (uint32_t)(a >> 32);
    register uint32_t r2 __asm("r2") = (uint32_t)b;
    register uint32_t r3 __asm("r3") = (uint32_t)(b >> 32);
    __asm("bl wide_mul_words" : "+r"(r0), "+r"(r1), "+r"(r2), "+r"(r3) : : "ip", "lr", "cc");
    return (wide_u_t){(uint64_t)r3 << 32 | r2, (uint64_t)r1 << 32 | r0};
#else
    uint32_t ah = (uint32_t)(a >> 32), al = (uint32_t)a, bh = (uint32_t)(b >> 32), bl = (uint32_t)b;
    uint64_t ll = wide_mul_u32(al, bl), lh = wide_mul_u32(al, bh), hl = wide_mul_u32(ah, bl);
    uint64_t mid = (ll >> 32) + (uint32_t)lh + hl; /* no carry: at most (2^32 - 1)^2 + 2 (2^32 - 1) */
    return (wide_u_t){wide_mul_u32(ah, bh) + (lh >> 32) + (mid >> 32), (mid << 32) | (uint32_t)ll};
#endif
}

/* a * b modulo 2^64; where that is no instruction the compiler calls a routine that takes twice as long. */
static inline uint64_t wide_mul_low_u64(uint64_t a, uint64_t b) {
#if defined __ARM_ARCH_6M__ && defined __arm__
    const uint32_t high = (uint32_t)(a >> 32) * (uint32_t)b + (uint32_t)a * (uint32_t)(b >> 32);
    return wide_mul_u32((uint32_t)a, (uint32_t)b) + ((uint64_t)high << 32);
#else
    return a * b;
#endif
}

/* a * b of 96 bits. */
static inline wide_u_t wide_mul_u64_u32(uint64_t a, uint32_t b) {
    if (sizeof(void *) >= 8) return wide_mul_u64(a, b);
    uint64_t lo = wide_mul_u32((uint32_t)a, b), hi = wide_mul_u32((uint32_t)(a >> 32), b) + (lo >> 32);
    return (wide_u_t){hi >> 32, hi << 32 | (uint32_t)lo};
}

/* The upper 64 bits of a * b, rounded down. */
static inline uint64_t wide_mulhi_u64(uint64_t a, uint64_t b) {
    return wide_mul_u64(a, b).hi;
}

/* a * b, signed. */
static inline wide_t wide_mul_s64(int64_t a, int64_t b) {
#ifdef __SIZEOF_INT128__
    return wide_of_native((wide_native_u_t)((wide_native_t)a * b));
#else
    wide_u_t p = wide_mul_u64((uint64_t)a, (uint64_t)b);
    /* as unsigned operands, a negative one counted 2^64 too much */
    uint64_t excess = ((uint64_t)(a >> 63) & (uint64_t)b) + ((uint64_t)(b >> 63) & (uint64_t)a);
    return (wide_t){(int64_t)(p.hi - excess), p.lo};
#endif
}

/* floor(a * b / 2^64), signed. */
static inline int64_t wide_mulhi_s64(int64_t a, int64_t b) {
    return wide_mul_s64(a, b).hi;
}

/* floor(a * b / 2^32); needs the result to fit. Half the work of a full product on a Cortex-M0. */
static inline int64_t wide_scale(int64_t a, int32_t b) {
    /* a = ah 2^32 + al; as an unsigned operand, a negative b counts 2^32 too much */
    uint64_t low = (wide_mul_u32((uint32_t)a, (uint32_t)b) >> 32) - ((uint64_t)(b >> 31) & (uint32_t)a);
    return (int64_t)((uint64_t)wide_mul_s32((int32_t)(a >> 32), b) + low);
}

static inline wide_t wide_from_s64(int64_t a) {
    return (wide_t){a >> 63, (uint64_t)a};
}

/* a + b, a - b, -a modulo 2^128. */
#ifdef __SIZEOF_INT128__
static inline wide_t wide_add(wide_t a, wide_t b) {
    return wide_of_native(wide_native(a) + wide_native(b));
}
static inline wide_t wide_sub(wide_t a, wide_t b) {
    return wide_of_native(wide_native(a) - wide_native(b));
}
#else
static inline wide_t wide_add(wide_t a, wide_t b) {
    uint64_t lo = a.lo + b.lo;
    return (wide_t){(int64_t)((uint64_t)a.hi + (uint64_t)b.hi + (lo < a.lo)), lo};
}
static inline wide_t wide_sub(wide_t a, wide_t b) {
    return (wide_t){(int64_t)((uint64_t)a.hi - (uint64_t)b.hi - (a.lo < b.lo)), a.lo - b.lo};
}
#endif
static inline wide_t wide_neg(wide_t a) {
    return wide_sub((wide_t){0, 0}, a);
}

/* a * 2^n modulo 2^128; 0 <= n < 128. */
static inline wide_t wide_shl(wide_t a, int n) {
    if (n >= 64) return (wide_t){(int64_t)(a.lo << (n - 64)), 0};
    if (n == 0) return a;
    return (wide_t){(int64_t)(((uint64_t)a.hi << n) | (a.lo >> (64 - n))), a.lo << n};
}

/* floor(a / 2^n); 0 <= n < 128. */
static inline wide_t wide_sar(wide_t a, int n) {
    if (n >= 64) return (wide_t){a.hi >> 63, (uint64_t)(a.hi >> (n - 64))};
    if (n == 0) return a;
    return (wide_t){a.hi >> n, ((uint64_t)a.hi << (64 - n)) | (a.lo >> n)};
}

/* -1, 0, 1 as a <, ==, > b. */
static inline int wide_cmp(wide_t a, wide_t b) {
    if (a.hi != b.hi) return a.hi < b.hi ? -1 : 1;
    return (a.lo > b.lo) - (a.lo < b.lo);
}
static inline int wide_sign(wide_t a) {
    return a.hi < 0 ? -1 : (a.hi | (int64_t)(a.lo != 0)) != 0;
}

/* a * b modulo 2^128. */
static inline wide_t wide_times_s32(wide_t a, int32_t b) {
#ifdef __SIZEOF_INT128__
    wide_native_u_t p = ((wide_native_u_t)(uint64_t)a.hi << 64 | a.lo) * (wide_native_u_t)b;
    return wide_of_native(p);
#else
    wide_t low = wide_mul_s64((int64_t)a.lo, b);
    uint64_t high = (uint64_t)low.hi + (uint64_t)a.hi * (uint64_t)(int64_t)b;
    /* as a signed operand, an upper half of a.lo counted 2^64 too little */
    if (a.lo >> 63) high += (uint64_t)(int64_t)b;
    return (wide_t){(int64_t)high, low.lo};
#endif
}

/* a0 b0 + a1 b1 + a2 b2 modulo 2^128. */
static inline wide_t wide_dot3(const int64_t a[3], const int32_t b[3]) {
#ifdef __SIZEOF_INT128__
    wide_native_t p = (wide_native_t)a[0] * b[0] + (wide_native_t)a[1] * b[1] + (wide_native_t)a[2] * b[2];
    return wide_of_native((wide_native_u_t)p);
#else
    return wide_add(wide_add(wide_mul_s64(a[0], b[0]), wide_mul_s64(a[1], b[1])), wide_mul_s64(a[2], b[2]));
#endif
}

/* The same of 64-bit operands. */
#ifdef __SIZEOF_INT128__
static inline wide_t wide_dot3_s64(const int64_t a[3], const int64_t b[3]) {
    wide_native_t p = (wide_native_t)a[0] * b[0] + (wide_native_t)a[1] * b[1] + (wide_native_t)a[2] * b[2];
    return wide_of_native((wide_native_u_t)p);
}
#else
wide_t wide_dot3_s64(const int64_t a[3], const int64_t b[3]);
#endif

/* The exact sign of a*d - b*c, any operands. */
static inline int wide_det_sign(int64_t a, int64_t b, int64_t c, int64_t d) {
    return wide_cmp(wide_mul_s64(a, d), wide_mul_s64(b, c));
}

/* floor((hi * 2^64 + lo) / d), the remainder in *rem; needs hi < d.
 * Cost: one divide instruction on a desktop, about 450 instructions on a Cortex-M0. */
uint64_t wide_div_u64(uint64_t hi, uint64_t lo, uint64_t d, uint64_t *rem);

#endif
