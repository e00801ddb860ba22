/* Interval sets by sorting and merging: clarity before speed, lists are short. */
#include "tests/oracle/spans.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void span_keep_positive(span_t *v, long double f0, long double f1) {
    if (f0 <= 0 && f1 <= 0) v->b = v->a - 1;
    if (f0 >= 0 || f1 >= 0) {
        if (f0 < 0) v->a = fmaxl(v->a, f0 / (f0 - f1));
        if (f1 < 0) v->b = fminl(v->b, f0 / (f0 - f1));
    }
}

void spans_free(spans_t *s) {
    free(s->s);
    *s = (spans_t){0};
}

void spans_clear(spans_t *s) {
    s->n = 0;
}

void spans_add(spans_t *s, long double a, long double b) {
    if (!(a < b)) return;
    if (s->n == s->cap) {
        s->cap = s->cap ? 2 * s->cap : 8;
        s->s = realloc(s->s, s->cap * sizeof *s->s);
        if (!s->s) abort();
    }
    s->s[s->n++] = (span_t){a, b};
}

static int by_start(const void *p, const void *q) {
    long double a = ((const span_t *)p)->a, b = ((const span_t *)q)->a;
    return (a > b) - (a < b);
}

void spans_tidy(spans_t *s) {
    if (s->n < 2) return;
    qsort(s->s, s->n, sizeof *s->s, by_start);
    size_t k = 0;
    for (size_t i = 1; i < s->n; i++) {
        if (s->s[i].a <= s->s[k].b) {
            if (s->s[i].b > s->s[k].b) s->s[k].b = s->s[i].b;
        } else {
            s->s[++k] = s->s[i];
        }
    }
    s->n = k + 1;
}

void spans_complement(const spans_t *s, long double lo, long double hi, spans_t *out) {
    spans_clear(out);
    long double at = lo;
    for (size_t i = 0; i < s->n && at < hi; i++) {
        spans_add(out, at, s->s[i].a < hi ? s->s[i].a : hi);
        if (s->s[i].b > at) at = s->s[i].b;
    }
    spans_add(out, at, hi);
}

void spans_intersect(const spans_t *p, const spans_t *q, spans_t *out) {
    spans_clear(out);
    for (size_t i = 0, k = 0; i < p->n && k < q->n;) {
        long double a = p->s[i].a > q->s[k].a ? p->s[i].a : q->s[k].a;
        long double b = p->s[i].b < q->s[k].b ? p->s[i].b : q->s[k].b;
        spans_add(out, a, b);
        if (p->s[i].b < q->s[k].b)
            i++;
        else
            k++;
    }
}

void spans_subtract(const spans_t *p, const spans_t *q, spans_t *out) {
    spans_t c = {0};
    if (p->n) spans_complement(q, p->s[0].a, p->s[p->n - 1].b, &c);
    spans_intersect(p, &c, out);
    spans_free(&c);
}

void spans_copy(const spans_t *s, spans_t *out) {
    spans_clear(out);
    for (size_t i = 0; i < s->n; i++) spans_add(out, s->s[i].a, s->s[i].b);
}
