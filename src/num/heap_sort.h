/* heap_sort.h - sorting in place, without recursion, the same everywhere: O(n log n) whatever the order was.
 *
 * HEAP_SORT(type_t, is_before) makes `static void heap_sort(type_t *list, int32_t n)` of a file that has
 * `bool is_before(const type_t *a, const type_t *b)`, a strict order. What is_before does not tell apart comes in any
 * order, but always the same. A macro, so that the order is inlined: a call for each comparison would cost more than
 * it. */
#ifndef HEAP_SORT_H
#define HEAP_SORT_H

#include <stdint.h>

#define HEAP_SORT(type, is_before)                                                                                     \
    static void sift(type *list, int32_t k, int32_t n) {                                                               \
        type moved = list[k];                                                                                          \
        for (int32_t child = 2 * k + 1; child < n; child = 2 * k + 1) {                                                \
            if (child + 1 < n && is_before(&list[child], &list[child + 1])) child++;                                   \
            if (!is_before(&moved, &list[child])) break;                                                               \
            list[k] = list[child];                                                                                     \
            k = child;                                                                                                 \
        }                                                                                                              \
        list[k] = moved;                                                                                               \
    }                                                                                                                  \
    static void heap_sort(type *list, int32_t n) {                                                                     \
        for (int32_t k = n / 2; k-- > 0;) sift(list, k, n);                                                            \
        for (int32_t k = n; k-- > 1;) {                                                                                \
            type last = list[k];                                                                                       \
            list[k] = list[0];                                                                                         \
            list[0] = last;                                                                                            \
            sift(list, 0, k);                                                                                          \
        }                                                                                                              \
    }

#endif
