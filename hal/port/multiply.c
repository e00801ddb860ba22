/* multiply.c - the lower 64 bits of a 64 x 64 product on a core whose multiplication has 32 bits, in place of
 * libgcc's: half its time, and geometry and motion ask for it five to ten times for a facet or a piece of motion. */
#ifdef __ARM_ARCH_6M__

long long __aeabi_lmul(long long a, long long b);
long long __muldi3(long long a, long long b) __attribute__((alias("__aeabi_lmul")));

/* a in r1:r0, b in r3:r2. The upper word: a1 b0 + a0 b1 and what a0 b0 carries, which is made of 16-bit halves. */
__attribute__((naked, used)) long long __aeabi_lmul(long long a __attribute__((unused)),
                                                    long long b __attribute__((unused))) {
    __asm volatile(".syntax unified\n"
                   "muls r1, r2\n" /* a1 b0 */
                   "muls r3, r0\n" /* a0 b1 */
                   "adds r1, r3\n"
                   "push {r4, r5}\n"
                   "lsrs r3, r0, #16\n"
                   "lsrs r4, r2, #16\n"
                   "uxth r0, r0\n"
                   "uxth r2, r2\n"
                   "movs r5, r0\n"
                   "muls r5, r4\n" /* low high */
                   "muls r4, r3\n" /* high high */
                   "muls r3, r2\n" /* high low */
                   "muls r0, r2\n" /* low low */
                   "adds r1, r4\n"
                   "movs r4, #0\n"
                   "adds r5, r3\n"
                   "adcs r4, r4\n"
                   "lsls r4, #16\n"
                   "adds r1, r4\n"
                   "lsls r4, r5, #16\n"
                   "lsrs r5, #16\n"
                   "adds r0, r4\n"
                   "adcs r1, r5\n"
                   "pop {r4, r5}\n"
                   "bx lr\n");
}

#else
typedef int multiply_not_needed;
#endif
