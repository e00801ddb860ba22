/* The one operation of wide.h that is too long to be inline. Where there is no 128-bit division it goes by
 * 32-bit words with a reciprocal of the divisor (N. Moller and T. Granlund, "Improved division by invariant
 * integers", IEEE Trans. Computers 60, 2011, algorithms 3 to 5): the only divisions left are two of 32 bits. */
#include "num/wide.h"

#ifdef __SIZEOF_INT128__

uint64_t wide_div_u64(uint64_t hi, uint64_t lo, uint64_t d, uint64_t *rem) {
    wide_native_u_t n = (wide_native_u_t)hi << 64 | lo;
    *rem = (uint64_t)(n % d);
    return (uint64_t)(n / d);
}

#else

/* floor((2^64 - 1) / d) - 2^32 for d >= 2^31: schoolbook division of (2^32 - 1 - d, 2^32 - 1) by 16-bit digits
 * (Knuth, The Art of Computer Programming, volume 2, algorithm 4.3.1 D). */
static uint32_t reciprocal_word(uint32_t d) {
    uint32_t dh = d >> 16, dl = d & 0xffff, u = ~d, q = 0;
    for (int i = 0; i < 2; i++) {
        uint32_t digit = u / dh, r = u - digit * dh;
        while (digit >> 16 || digit * dl > (r << 16 | 0xffff)) {
            digit--;
            r += dh;
            if (r >> 16) break;
        }
        u = (u << 16 | 0xffff) - digit * d;
        q = q << 16 | digit;
    }
    return q;
}

/* floor((2^96 - 1) / d) - 2^32 for d >= 2^63. */
static uint32_t reciprocal(uint64_t d) {
    uint32_t d1 = (uint32_t)(d >> 32), d0 = (uint32_t)d, v = reciprocal_word(d1), p = d1 * v + d0;
    if (p < d0) {
        v--;
        if (p >= d1) {
            v--;
            p -= d1;
        }
        p -= d1;
    }
    uint64_t t = wide_mul_u32(v, d0);
    p += (uint32_t)(t >> 32);
    if (p < (uint32_t)(t >> 32)) {
        v--;
        if (((uint64_t)p << 32 | (uint32_t)t) >= d) v--;
    }
    return v;
}

/* One digit: floor((u * 2^32 + next) / d) for u < d; the remainder replaces *u. */
static uint32_t digit(uint64_t *u, uint32_t next, uint64_t d, uint32_t v) {
    uint64_t q = wide_mul_u32(v, (uint32_t)(*u >> 32)) + *u;
    uint32_t q1 = (uint32_t)(q >> 32), r1 = (uint32_t)*u - q1 * (uint32_t)(d >> 32);
    uint64_t r = ((uint64_t)r1 << 32 | next) - wide_mul_u32((uint32_t)d, q1) - d;
    q1++;
    if ((uint32_t)(r >> 32) >= (uint32_t)q) {
        q1--;
        r += d;
    }
    if (r >= d) {
        q1++;
        r -= d;
    }
    *u = r;
    return q1;
}

uint64_t wide_div_u64(uint64_t hi, uint64_t lo, uint64_t d, uint64_t *rem) {
    int s = __builtin_clzll(d);
    uint64_t u = hi;
    if (s != 0) {
        d <<= s;
        u = hi << s | lo >> (64 - s);
        lo <<= s;
    }
    uint32_t v = reciprocal(d), q1 = digit(&u, (uint32_t)(lo >> 32), d, v), q0 = digit(&u, (uint32_t)lo, d, v);
    *rem = u >> s;
    return (uint64_t)q1 << 32 | q0;
}

#endif

#ifdef WIDE_ROUTINE

/* r3:r2:r1:r0 = r1:r0 * r3:r2; ip and lr hold words meanwhile. About 105 cycles. */
__attribute__((naked, used)) void wide_mul_words(void) {
    __asm(".syntax unified\n"
          "push {r4, r5, r6, r7, lr}\n"
          "mov ip, r0\n"
          "mov lr, r2\n" WIDE_M0_MUL_U32("r0", "r2", "r4", "r5", "r6") /* low low: r0:r4 */
          "mov r2, ip\n"
          "mov ip, r4\n"
          "movs r5, r3\n" WIDE_M0_MUL_U32("r2", "r5", "r4", "r6", "r7") /* low high: r2:r4 */
          "adds r0, r4\n"
          "movs r5, #0\n"
          "adcs r2, r5\n"
          "mov r5, lr\n"
          "mov lr, r1\n" WIDE_M0_MUL_U32("r1", "r5", "r4", "r6", "r7") /* high low: r1:r4 */
          "adds r0, r4\n"
          "adcs r2, r1\n"
          "movs r4, #0\n"
          "adcs r4, r4\n"
          "mov r1, lr\n" WIDE_M0_MUL_U32("r1", "r3", "r5", "r6", "r7") /* high high: r1:r5 */
          "adds r2, r5\n"
          "adcs r4, r1\n"
          "movs r1, r0\n"
          "mov r0, ip\n"
          "movs r3, r4\n"
          "pop {r4, r5, r6, r7, pc}\n");
}

#endif

#ifndef __SIZEOF_INT128__
wide_t wide_dot3_s64(const int64_t a[3], const int64_t b[3]) {
    wide_t sum = {0, 0};
    for (int k = 0; k < 3; k++) sum = wide_add(sum, wide_mul_s64(a[k], b[k]));
    return sum;
}
#endif
