/* strings.c - the functions of string.h that the program calls now and then, each as small as it can be: newlib's
 * compare words at a time, or search by tables, and take 1.1 KB. Compiled by itself and not as builtins, or they would
 * call themselves. */
#include <stddef.h>
#include <string.h>

size_t strlen(const char *s) {
    size_t n = 0;
    while (s[n] != '\0') n++;
    return n;
}

int memcmp(const void *a, const void *b, size_t n) {
    const unsigned char *p = a, *q = b;
    for (; n > 0; p++, q++, n--) {
        if (*p != *q) return *p - *q;
    }
    return 0;
}

int strncmp(const char *a, const char *b, size_t n) {
    for (; n > 0; a++, b++, n--) {
        if (*a != *b || *a == '\0') return (unsigned char)*a - (unsigned char)*b;
    }
    return 0;
}

int strcmp(const char *a, const char *b) {
    return strncmp(a, b, (size_t)-1);
}

void *memchr(const void *s, int c, size_t n) {
    for (const unsigned char *p = s; n > 0; p++, n--) {
        if (*p == (unsigned char)c) return (void *)(size_t)p;
    }
    return NULL;
}

char *strchr(const char *s, int c) {
    return memchr(s, c, strlen(s) + 1);
}

char *strstr(const char *s, const char *part) {
    const size_t n = strlen(part);
    for (; strncmp(s, part, n) != 0; s++) {
        if (*s == '\0') return NULL;
    }
    return (char *)(size_t)s;
}
