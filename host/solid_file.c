/* solid_file.c - see solid_file.h. A file is read whole, and its text written into another in memory. */
#include "host/solid_file.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "host/progress.h"
#include "scene/obj_reader.h"

typedef struct text {
    const char *name;
    char *bytes;
    size_t n, at;
    int line;              /* 0: of bytes */
    size_t begin, word_at; /* where the line begins, and the word at hand */
    FILE *out;
} text_t;

static bool ends_in(const char *name, const char *suffix) {
    size_t n = strlen(name), m = strlen(suffix);
    return n >= m && strcasecmp(name + n - m, suffix) == 0;
}

bool solid_file_is(const char *name) {
    return ends_in(name, ".stl") || ends_in(name, ".off");
}

static bool complain(const text_t *t, const char *what) {
    progress_wipe();
    if (t->line)
        fprintf(stderr, "\"%s\", line %d, column %zu: %s\n", t->name, t->line, t->word_at - t->begin + 1, what);
    else
        fprintf(stderr, "\"%s\": %s\n", t->name, what);
    return false;
}

/* The next word, of which 63 characters are kept; false at the end. comments: from # to the end of the line. */
static bool word(text_t *t, char out[64], bool comments) {
    for (; t->at < t->n; t->at++) {
        char c = t->bytes[t->at];
        if (comments && c == '#')
            while (t->at < t->n && t->bytes[t->at] != '\n') t->at++;
        if (t->at < t->n && t->bytes[t->at] == '\n') t->line++, t->begin = t->at + 1;
        if (t->at == t->n || !isspace((unsigned char)t->bytes[t->at])) break;
    }
    t->word_at = t->at;
    size_t k = 0;
    for (; t->at < t->n && !isspace((unsigned char)t->bytes[t->at]); t->at++)
        if (k < 63) out[k++] = t->bytes[t->at];
    out[k] = 0;
    return k > 0;
}

static void rest_of_line(text_t *t) {
    while (t->at < t->n && t->bytes[t->at] != '\n') t->at++;
}

/* A number as it is written, as long as the reader of OBJ takes it. */
static bool number(text_t *t, char out[64]) {
    char *end;
    if (!word(t, out, true)) return complain(t, "the file ends where a number should be");
    if (out[strspn(out, "+-.0123456789eE")]) return complain(t, "not a number");
    const double v = strtod(t->bytes + t->word_at, &end);
    if (end != t->bytes + t->at) return complain(t, "not a number");
    if (!isfinite(v)) return complain(t, "this number is too large");
    if (strlen(out) >= OBJ_WORD_MAX) snprintf(out, 64, "%.17g", v);
    return true;
}

static bool vertex(text_t *t) {
    char x[64], y[64], z[64];
    if (!number(t, x) || !number(t, y) || !number(t, z)) return false;
    fprintf(t->out, "v %s %s %s\n", x, y, z);
    return true;
}

/* solid name; facet normal ...; outer loop; vertex x y z, three times; endloop; endfacet; ...; endsolid */
static bool stl_text(text_t *t) {
    char w[64];
    int corners = 0;
    long triangles = 0;
    while (word(t, w, false)) {
        if (strcasecmp(w, "solid") == 0 || strcasecmp(w, "endsolid") == 0) {
            rest_of_line(t); /* a name of any words */
        } else if (strcasecmp(w, "vertex") == 0) {
            if (!vertex(t)) return false;
            corners++;
        } else if (strcasecmp(w, "endloop") == 0) {
            if (corners != 3) return complain(t, "a facet has three vertices");
            fputs("f -3 -2 -1\n", t->out);
            triangles++;
            corners = 0;
        } else if (strcasecmp(w, "normal") == 0) {
            char skip[64];
            for (int k = 0; k < 3; k++) /* many programs write nan here */
                if (!word(t, skip, false)) return complain(t, "the file ends within a facet");
        } else if (strcasecmp(w, "facet") != 0 && strcasecmp(w, "outer") != 0 && strcasecmp(w, "loop") != 0 &&
                   strcasecmp(w, "endfacet") != 0) {
            return complain(t, "this is not STL");
        }
    }
    if (corners) return complain(t, "the file ends within a facet");
    return triangles > 0 || complain(t, "no facets");
}

static uint32_t little(const char *p) {
    const unsigned char *u = (const unsigned char *)p;
    return u[0] | (uint32_t)u[1] << 8 | (uint32_t)u[2] << 16 | (uint32_t)u[3] << 24;
}

#define STL_HEAD 84
#define STL_FACET 50

/* 80 bytes of anything, a count, and for each triangle a normal, three vertices, 2 bytes. */
static bool stl_binary(text_t *t) {
    const uint32_t n = little(t->bytes + 80);
    const size_t facets = (t->n - STL_HEAD) / STL_FACET;
    char what[160];
    if (n == 0) return complain(t, "no facets");
    if (n > facets) {
        snprintf(what, sizeof what,
                 "as a binary STL it should have %lu facets, but ends after %zu; a text begins with `solid` and has no "
                 "zero bytes",
                 (unsigned long)n, facets);
        return complain(t, what);
    }
    if (t->n > STL_HEAD + STL_FACET * (size_t)n) {
        snprintf(what, sizeof what, "warning: %zu bytes behind the last of its %lu facets are left out",
                 t->n - STL_HEAD - STL_FACET * (size_t)n, (unsigned long)n);
        complain(t, what);
    }
    for (uint32_t k = 0; k < n; k++) {
        const char *p = t->bytes + STL_HEAD + STL_FACET * (size_t)k + 12;
        for (int v = 0; v < 3; v++, p += 12) {
            float xyz[3];
            for (int i = 0; i < 3; i++) {
                uint32_t bits = little(p + 4 * i);
                memcpy(&xyz[i], &bits, sizeof bits);
                if (!isfinite(xyz[i])) {
                    snprintf(what, sizeof what, "facet %lu: not a number", (unsigned long)k + 1);
                    return complain(t, what);
                }
            }
            fprintf(t->out, "v %.9g %.9g %.9g\n", (double)xyz[0], (double)xyz[1], (double)xyz[2]);
        }
        fputs("f -3 -2 -1\n", t->out);
    }
    return true;
}

/* OFF, or with texture places, colours or normals behind each vertex STOFF, COFF, NOFF, CNOFF; counts of vertices,
 * faces, edges; vertices; faces as n a b c ..., counted from 0, with colours behind them. */
static bool off(text_t *t) {
    char w[64];
    if (!word(t, w, true)) return complain(t, "no data");
    const char *kind = w + (strncmp(w, "ST", 2) == 0 ? 2 : 0);
    if (*kind == 'C') kind++;
    if (*kind == 'N') kind++;
    const bool headed = strcasecmp(kind, "OFF") == 0;
    if (!headed && !isdigit((unsigned char)w[0])) return complain(t, "not OFF of three dimensions, as text");
    long count[3];
    for (int k = 0; k < 3; k++) {
        char *end;
        if ((headed || k) && !word(t, w, true)) return complain(t, "the counts are missing");
        count[k] = strtol(w, &end, 10);
        if (*end || count[k] < 0 || count[k] > INT32_MAX / 4) return complain(t, "not a count");
    }
    for (long k = 0; k < count[0]; k++) {
        if (!vertex(t)) return false;
        if (headed && kind > w) rest_of_line(t);
    }
    for (long k = 0; k < count[1]; k++) {
        char *end;
        if (!word(t, w, true)) return complain(t, "the file ends before its last face");
        long n = strtol(w, &end, 10);
        if (*end || n < 1 || n > count[0] + 1000000) return complain(t, "not a number of vertices");
        if (n >= 3) fputs("f", t->out);
        for (long i = 0; i < n; i++) {
            if (!word(t, w, true)) return complain(t, "the file ends within a face");
            long v = strtol(w, &end, 10);
            if (*end || v < 0 || v >= count[0]) return complain(t, "there is no vertex of this number");
            if (n >= 3) fprintf(t->out, " %ld", v + 1);
        }
        if (n >= 3) fputc('\n', t->out);
        rest_of_line(t); /* colours */
    }
    if (word(t, w, true)) complain(t, "warning: this and what follows is beyond the counts, and left out");
    return true;
}

static bool read_all(FILE *f, text_t *t) {
    size_t room = 0;
    for (;;) {
        if (room - t->n < 4096) {
            room = room ? 2 * room : 65536;
            char *more = realloc(t->bytes, room);
            if (!more) return complain(t, "no memory");
            t->bytes = more;
        }
        size_t got = fread(t->bytes + t->n, 1, room - t->n, f);
        if (got == 0) break; /* with room for a zero, which ends the last number */
        t->n += got;
    }
    t->bytes[t->n] = '\0';
    return !ferror(f) || complain(t, "cannot be read");
}

/* Lines may end with CR alone. */
static void end_lines(text_t *t) {
    for (size_t k = 0; k < t->n; k++)
        if (t->bytes[k] == '\r' && t->bytes[k + 1] != '\n') t->bytes[k] = '\n';
}

static bool convert(text_t *t) {
    t->line = 1;
    if (t->n >= 3 && memcmp(t->bytes, "\xef\xbb\xbf", 3) == 0) t->at = t->begin = 3; /* the mark of UTF-8 */
    if (ends_in(t->name, ".off")) {
        end_lines(t);
        return off(t);
    }
    size_t at = t->at;
    while (at < t->n && isspace((unsigned char)t->bytes[at])) at++;
    /* Some binary files begin with `solid`, too: their size tells, or a zero byte if that is wrong. */
    const bool solid = t->n - at >= 5 && strncasecmp(t->bytes + at, "solid", 5) == 0,
               sized = t->n >= STL_HEAD && t->n == STL_HEAD + STL_FACET * (size_t)little(t->bytes + 80);
    if (solid && !sized && !memchr(t->bytes, 0, t->n)) {
        end_lines(t);
        return stl_text(t);
    }
    t->line = 0;
    if (t->n == 0) return complain(t, "the file is empty");
    if (t->n < STL_HEAD) return complain(t, "an STL begins with `solid`, as a text, or has 84 bytes at least");
    return stl_binary(t);
}

FILE *solid_file_open(FILE *f, const char *name) {
    text_t t = {.name = name, .out = tmpfile()};
    if (!t.out) complain(&t, "no temporary file");
    bool good = t.out && read_all(f, &t) && convert(&t);
    if (good && (fflush(t.out) || ferror(t.out))) good = complain(&t, "no room for its text");
    fclose(f);
    free(t.bytes);
    if (good) {
        rewind(t.out);
        return t.out;
    }
    if (t.out) fclose(t.out);
    return NULL;
}
