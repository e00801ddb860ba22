/* complete.c - words from the tables that the language itself reads (lang/words.h). */
#include "host/complete.h"

#include <stdlib.h>
#include <string.h>

#include "lang/words.h"

const char *complete_table(const char *line, size_t start) {
    size_t from = start;
    while (from > 0 && line[from - 1] != ';' && line[from - 1] != '{') from--;
    lexer_t lx;
    lexer_start(&lx, line + from, start - from);
    if (lx.tok.kind == TOKEN_END) return words_command;
    const int command = words_find(words_command, &lx);
    lexer_next(&lx);
    if (command < 0 || lx.tok.kind != TOKEN_END) return NULL; /* more than one word stands before it */
    switch (words_command_id[command]) {
    case CMD_SET:
    case CMD_UNSET:
    case CMD_SHOW:
    case CMD_HELP:
        return words_set;
    default:
        return NULL;
    }
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
