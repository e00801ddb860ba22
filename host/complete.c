/* complete.c - words from the tables that the language itself reads (lang/words.h). */
#include "host/complete.h"

#include <stdlib.h>
#include <string.h>

#include "lang/words.h"

static bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

const char *complete_table(const char *line, size_t start) {
    size_t from = start;
    while (from > 0 && line[from - 1] != ';' && line[from - 1] != '{') from--;
    while (from < start && is_blank(line[from])) from++;
    if (from == start) return words_command;
    size_t word = from;
    while (word < start && !is_blank(line[word])) word++;
    for (size_t k = word; k < start; k++)
        if (!is_blank(line[k])) return NULL; /* more than one word stands before it */
    static const char *const takes_option[] = {"se$t", "uns$et", "sh$ow", "h$elp"};
    for (size_t k = 0; k < sizeof takes_option / sizeof takes_option[0]; k++)
        if (words_match(takes_option[k], line + from, word - from)) return words_set;
    return NULL;
}

char *complete_next(const char *table, const char *text, const char **at) {
    const size_t len = strlen(text);
    for (const char *pattern = *at ? *at : table; *pattern;) {
        char word[32];
        size_t n = 0;
        for (; *pattern; pattern++)
            if (*pattern != '$' && n + 1 < sizeof word) word[n++] = *pattern;
        word[n] = '\0';
        *at = ++pattern;
        if (n >= len && memcmp(word, text, len) == 0) return strdup(word);
    }
    return NULL;
}
