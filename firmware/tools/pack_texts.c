/* pack_texts.c - what a board says to people, packed: its flash is full.
 *
 *     pack_texts learn SOURCE... >PAIRS       which two bytes one byte may stand for (`make pairs`, now and then)
 *     pack_texts help PAIRS >HEADER           the texts of src/lang/help_texts.h for the board that CONFIG_ tells of
 *     pack_texts source PAIRS SOURCE >SOURCE  the same program with its messages packed
 *
 * Again and again the two bytes that most often stand side by side become one, until there is none left or nothing is
 * won: half of the flash. Messages are the literals in the arguments of the functions below, which all end in one that
 * reads them by said.h, and of SAID. */
#include "lang/help_texts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "said.h"

static const char *const SAYING[] = {
    "SAID",      "say",        "refuse",       "refused",         "run_saved",           "lang_error_set",
    "plot_fail", "fail",       "session_fail", "session_string",  "lang_error_set_name", "lang_error_set_number",
    "set_pair",  "set_scaled", "set_integer",  "set_find_option", "lexer_unexpected",
};

#define TOPICS (sizeof topics / sizeof topics[0])
#define WORTH 4 /* times: an entry takes two bytes itself */
#define BYTES 256

static unsigned char text[1 << 17], pair[BYTES][2];
static size_t length;
static int depth[BYTES];
static int count[BYTES][BYTES];

static void fail_with(const char *what, const char *file) {
    fprintf(stderr, "pack_texts: %s: %s\n", file, what);
    exit(1);
}

/* The pair that is met most often, the first of several; 0 if none is worth it. */
static int most(int *a, int *b) {
    int best = 0;
    memset(count, 0, sizeof count);
    for (size_t k = 1; k < length; k++) {
        const int p = text[k - 1], q = text[k];
        if (p == 0 || q == 0 || depth[p] >= PACKED_DEPTH || depth[q] >= PACKED_DEPTH) continue;
        if (++count[p][q] <= best) continue;
        best = count[p][q];
        *a = p;
        *b = q;
    }
    return best >= WORTH ? best : 0;
}

static void replace(int a, int b, int by) {
    size_t to = 0;
    for (size_t k = 0; k < length; k++) {
        const int met = text[k] == a && k + 1 < length && text[k + 1] == b;
        text[to++] = met ? (unsigned char)by : text[k];
        k += (size_t)met;
    }
    length = to;
}

static void put_help(void) {
    for (size_t k = 0; k < TOPICS; k++) {
        const size_t n = strlen(topics[k].text) + 1;
        memcpy(text + length, topics[k].text, n);
        length += n;
    }
}

static void pack(void) {
    for (int by = 0; by < BYTES; by++)
        if (PACKED_STANDS(by) && pair[by][0]) replace(pair[by][0], pair[by][1], by);
}

/* ---- literals of a source ---- */

static int escape(const char **at) {
    const char *const known = "n\nt\tr\ra\a\"\"\\\\''";
    const char c = *(*at)++;
    for (const char *k = known; *k; k += 2)
        if (k[0] == c) return k[1];
    return 0;
}

/* What stands from *at, behind its quote, to its end comes behind the texts. */
static void take_literal(const char **at, const char *file) {
    while (**at != '"') {
        int c = *(*at)++;
        if (c == '\\') c = escape(at);
        if (c <= 0 || c >= 128 || PACKED_STANDS(c)) fail_with("a message has a character that cannot be packed", file);
        text[length++] = (unsigned char)c;
    }
    ++*at;
}

static int is_saying(const char *name, size_t n) {
    for (size_t k = 0; k < sizeof SAYING / sizeof SAYING[0]; k++)
        if (strlen(SAYING[k]) == n && memcmp(SAYING[k], name, n) == 0) return 1;
    return 0;
}

static int is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

static void put_packed(FILE *out) {
    fputc('"', out);
    for (size_t k = 0; k < length; k++)
        if (text[k] < 32 || text[k] > 126 || text[k] == '"' || text[k] == '\\')
            fprintf(out, "\\%03o", text[k]);
        else
            fputc(text[k], out);
    fputc('"', out);
}

/* What a byte stands for, behind what is there already: as said.c reads it, written otherwise. */
static size_t unpack(int c, char *to, size_t n) {
    if (!PACKED_STANDS(c)) {
        to[n] = (char)c;
        return n + 1;
    }
    return unpack(pair[c][1], to, unpack(pair[c][0], to, n));
}

/* Packs the text and looks whether it can be read again. */
static void pack_literal(const char *file) {
    static char was[sizeof text], is[sizeof text];
    const size_t n = length;
    size_t m = 0;
    memcpy(was, text, n);
    pack();
    for (size_t k = 0; k < length; k++) m = unpack(text[k], is, m);
    if (m != n || memcmp(is, was, n) != 0) fail_with("a message is not read as it was written", file);
}

/* Goes through a source. With out it is written there, its messages packed; else they come behind the texts. */
static void go_through(const char *source, const char *file, FILE *out) {
    char says[256] = {0}; /* by depth of brackets: is it the arguments of one that says something? */
    size_t open = 0, word = 0;
    for (const char *at = source; *at;) {
        const char *const from = at;
        if (at[0] == '/' && at[1] == '*') {
            at = strstr(at, "*/");
            if (!at) fail_with("a comment has no end", file);
            at += 2;
        } else if (*at == '\'') {
            for (at++; *at != '\''; at++) at += *at == '\\';
            at++;
        } else if (*at == '"') {
            at++;
            if (says[open]) {
                if (out) length = 0;
                take_literal(&at, file);
                if (out) {
                    pack_literal(file);
                    put_packed(out);
                } else {
                    text[length++] = 0;
                }
                continue;
            }
            for (; *at != '"'; at++) at += *at == '\\';
            at++;
        } else if (is_word(*at)) {
            while (is_word(*at)) at++;
            word = (size_t)(at - from);
        } else if (*at == '(' || *at == '{' || *at == '[') {
            if (++open == sizeof says) fail_with("too many brackets", file);
            says[open] = word ? (char)is_saying(at - word, word) : (char)(*at == '(' && says[open - 1]);
            at++;
        } else {
            if ((*at == ')' || *at == '}' || *at == ']') && open > 0) open--;
            at++;
        }
        if (!is_word(*from)) word = 0;
        if (out) fwrite(from, 1, (size_t)(at - from), out);
    }
}

static char *read_all(const char *path) {
    FILE *f = fopen(path, "r");
    if (!f) fail_with("cannot be read", path);
    char *all = malloc(1 << 20);
    const size_t n = all ? fread(all, 1, (1 << 20) - 1, f) : 0;
    if (n == 0 || n == (1 << 20) - 1) fail_with("is empty, or too long", path);
    all[n] = '\0';
    fclose(f);
    return all;
}

/* ---- what it does ---- */

static void learn(char **files) {
    int a = 0, b = 0;
    put_help();
    for (; *files; files++) {
        char *source = read_all(*files);
        go_through(source, *files, NULL);
        free(source);
    }
    for (int by = 0; by < BYTES; by++) {
        if (!PACKED_STANDS(by)) continue;
        if (!most(&a, &b)) break;
        pair[by][0] = (unsigned char)a;
        pair[by][1] = (unsigned char)b;
        depth[by] = 1 + (depth[a] > depth[b] ? depth[a] : depth[b]);
        replace(a, b, by);
    }
    printf("/* By firmware/tools/pack_texts.c (`make pairs`): for src/said.c. */\n");
    for (int by = 0; by < BYTES; by++)
        if (PACKED_PLACE(by) >= 0) printf("{%d, %d},\n", pair[by][0], pair[by][1]);
}

static void read_pairs(const char *path) {
    FILE *f = fopen(path, "r");
    if (!f) fail_with("cannot be read", path);
    fscanf(f, "/*%*[^*]*/");
    for (int by = 0; by < BYTES; by++)
        if (PACKED_PLACE(by) >= 0 && fscanf(f, " {%hhu, %hhu},", &pair[by][0], &pair[by][1]) != 2)
            fail_with("is no list of pairs", path);
    fclose(f);
}

static void help(void) {
    put_help();
    pack();
    printf("/* By firmware/tools/pack_texts.c from src/lang/help_texts.h. */\n");
    printf("static const struct {\n    const char *pattern;\n} topics[] = {\n");
    for (size_t k = 0; k < TOPICS; k++) printf("    {\"%s\"},\n", topics[k].pattern);
    printf("};\nstatic const char packed[] = {");
    for (size_t k = 0; k < length; k++) printf("%s%d,", k % 24 ? "" : "\n    ", text[k]);
    printf("\n};\n");
}

int main(int argc, char **argv) {
    if (argc > 2 && strcmp(argv[1], "learn") == 0) {
        learn(argv + 2);
        return 0;
    }
    if (argc < 3) fail_with("see its first lines", "usage");
    read_pairs(argv[2]);
    if (strcmp(argv[1], "help") == 0) {
        help();
    } else if (argc == 4) {
        printf("#line 1 \"%s\"\n", argv[3]);
        go_through(read_all(argv[3]), argv[3], stdout);
    }
    return 0;
}
