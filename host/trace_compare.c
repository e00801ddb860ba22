/* trace_compare.c - are two traces the same motion? Both are taken apart into changes of single pins and walked side by
 * side. */
#include "error.h"
#include "hal/hal.h"
#include "host/trace.h"
#include <math.h>
#include <stdlib.h>

#define CONTEXT 3 /* events shown around a difference */

typedef struct edge {
    uint64_t time_ps; /* from the trace's first change */
    size_t event;
    uint8_t pin; /* one bit */
    bool high;
} edge_t;

typedef struct edges {
    edge_t *edge;
    size_t count;
} edges_t;

static bool split(const trace_t *t, edges_t *out) {
    size_t n = 0;
    for (size_t i = 0; i < t->count; i++) n += (size_t)__builtin_popcount(t->events[i].changed);
    out->edge = malloc((n + 1) * sizeof *out->edge);
    out->count = 0;
    if (!out->edge) return false;
    for (size_t i = 0; i < t->count; i++) {
        const trace_event_t *e = &t->events[i];
        for (unsigned changed = e->changed; changed; changed &= changed - 1) {
            uint8_t pin = (uint8_t)(changed & -changed);
            out->edge[out->count++] = (edge_t){e->time_ps - t->events[0].time_ps, i, pin, (e->pins & pin) != 0};
        }
    }
    return true;
}

static double us_between(const edge_t *a, const edge_t *b) {
    return ((double)a->time_ps - (double)b->time_ps) * 1e-6;
}

/* Brings the edge that `want` asks for to place i, if that only swaps edges within the tolerance. */
static bool bring(edges_t *in, size_t i, const edge_t *want, double tolerance_us) {
    for (size_t k = i; k < in->count; k++) {
        edge_t e = in->edge[k];
        if (k > i && us_between(&e, &in->edge[i]) > tolerance_us) return false;
        if (e.pin != want->pin) continue;
        if (e.high != want->high) return false;
        for (; k > i; k--) in->edge[k] = in->edge[k - 1];
        in->edge[i] = e;
        return true;
    }
    return false;
}

/* Has the pen just been lifted? Then nothing moves, and whoever has still to compute may take as long as it likes. */
static bool at_rest(const edges_t *in, size_t i) {
    return i > 0 && in->edge[i - 1].pin == HAL_PEN && !in->edge[i - 1].high;
}

int trace_compare(const trace_t *a, const trace_t *b, double tolerance_us, bool rests, trace_difference_t *out) {
    *out = (trace_difference_t){0};
    edges_t ea = {0}, eb = {0};
    if (!split(a, &ea) || !split(b, &eb)) {
        free(ea.edge);
        free(eb.edge);
        return ERR_FULL;
    }
    size_t n = ea.count < eb.count ? ea.count : eb.count, i;
    double sum = 0;
    for (i = 0; i < n && bring(&eb, i, &ea.edge[i], tolerance_us); i++) {
        double difference = fabs(us_between(&eb.edge[i], &ea.edge[i]) - out->rest_us);
        if (rests && difference > tolerance_us && at_rest(&ea, i)) {
            out->rest_us = us_between(&eb.edge[i], &ea.edge[i]);
            out->rests++;
            difference = 0;
        }
        sum += difference;
        if (difference > out->max_us) {
            out->max_us = difference;
            out->worst = i;
        }
    }
    out->same_sequence = a->initial == b->initial && i == ea.count && i == eb.count;
    out->compared = i;
    out->mean_us = i ? sum / (double)i : 0;
    out->at = out->same_sequence ? out->worst : i;
    out->event_a = out->at < ea.count ? ea.edge[out->at].event : a->count;
    out->event_b = out->at < eb.count ? eb.edge[out->at].event : b->count;
    free(ea.edge);
    free(eb.edge);
    return 0;
}

static void print_around(const trace_t *t, size_t at, const char *name, FILE *out) {
    static const char *const PIN[] = {"x_step", "x_dir", "y_step", "y_dir", "pen", "enable"};
    size_t from = at > CONTEXT ? at - CONTEXT : 0;
    for (size_t i = from; i <= at + CONTEXT && i <= t->count; i++) {
        fprintf(out, "%s %s ", name, i == at ? ">" : " ");
        if (i == t->count) {
            fprintf(out, "end of the trace\n");
            return;
        }
        fprintf(out, "%18.3f us ", (double)(t->events[i].time_ps - t->events[0].time_ps) * 1e-6);
        for (int k = 0; k < 6; k++)
            if (t->events[i].changed >> k & 1) fprintf(out, " %s=%d", PIN[k], t->events[i].pins >> k & 1);
        fputc('\n', out);
    }
}

void trace_print_difference(const trace_t *a, const trace_t *b, const trace_difference_t *d, FILE *out) {
    fprintf(out, "%s: %zu pin changes compared, time difference %.4f us at most, %.4f us on average\n",
            d->same_sequence ? "same sequence" : "DIFFERENT SEQUENCE", d->compared, d->max_us, d->mean_us);
    if (d->rests) fprintf(out, "%zu rests with the pen up differ, %.6f s in all\n", d->rests, d->rest_us * 1e-6);
    if (a->initial != b->initial)
        fprintf(out, "the pins begin at %02x in one and %02x in the other\n", a->initial, b->initial);
    if (d->same_sequence && d->max_us == 0) return;
    fprintf(out, "%s change %zu (times from the first change):\n",
            d->same_sequence ? "largest difference:" : "first difference:", d->at + 1);
    print_around(a, d->event_a, "a", out);
    print_around(b, d->event_b, "b", out);
}
