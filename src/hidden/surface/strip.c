/* strip.c - see strip.h. */
#include "hidden/surface/strip.h"

#define ONE_Q30 (INT32_C(1) << 30)

void strip_init(strip_t *s, int32_t lo, int32_t hi, int from, int to) {
    const int32_t width = (int32_t)(((uint32_t)hi - (uint32_t)lo) / HIDDEN_STRIPS);
    s->from = from == 0 ? -ENVELOPE_LIMIT : lo + width * from;
    s->to = to == HIDDEN_STRIPS ? ENVELOPE_LIMIT : lo + width * to;
    s->first = from == 0;
}

static int32_t fraction_at(pencil_t p, pencil_t q, int32_t a) {
    return envelope_fraction_at(p, q, (pencil_t){a, pencil_ordinate(p, q, a)});
}

/* Fractions of p-q, p.a < q.a, between abscissae lo and hi. */
static void fractions(pencil_t p, pencil_t q, int32_t lo, int32_t hi, int32_t out_q30[2]) {
    out_q30[0] = p.a >= lo ? 0 : q.a <= lo ? ONE_Q30 : fraction_at(p, q, lo);
    out_q30[1] = q.a <= hi ? ONE_Q30 : p.a >= hi ? 0 : fraction_at(p, q, hi);
}

static void turn_round(int32_t part_q30[2]) {
    const int32_t from = ONE_Q30 - part_q30[1];
    part_q30[1] = ONE_Q30 - part_q30[0];
    part_q30[0] = from;
}

bool strip_cut(strip_t *s, pencil_t *p0, pencil_t *p1) {
    const bool flip = p1->a < p0->a;
    const pencil_t p = flip ? *p1 : *p0, q = flip ? *p0 : *p1;
    const int32_t lo = s->from - STRIP_MARGIN, hi = s->to + STRIP_MARGIN;
    s->cut_q30[0] = s->keep_q30[0] = 0;
    s->cut_q30[1] = s->keep_q30[1] = ONE_Q30;
    if (envelope_vertical(p, q)) { /* it is drawn as a whole */
        if (p.a < s->from || p.a >= s->to) s->keep_q30[1] = 0;
        return p.a > lo && q.a < hi;
    }
    if (q.a <= lo || p.a >= hi) return false;
    if (p.a >= s->from && q.a <= s->to) return true;
    fractions(p, q, s->from, s->to, s->keep_q30);
    fractions(p, q, lo, hi, s->cut_q30);
    if (flip) {
        turn_round(s->keep_q30);
        turn_round(s->cut_q30);
    }
    if (p.a < lo) *(flip ? p1 : p0) = (pencil_t){lo, pencil_ordinate(p, q, lo)};
    if (q.a > hi) *(flip ? p0 : p1) = (pencil_t){hi, pencil_ordinate(p, q, hi)};
    return true;
}

static int32_t of_whole(const strip_t *s, int32_t at_q30) {
    const int32_t way = s->cut_q30[1] - s->cut_q30[0];
    return s->cut_q30[0] + (int32_t)(((int64_t)way * at_q30) >> 30);
}

bool strip_keep(const strip_t *s, envelope_part_t *part) {
    part->from_q30 = pencil_max(of_whole(s, part->from_q30), s->keep_q30[0]);
    part->to_q30 = pencil_min(of_whole(s, part->to_q30), s->keep_q30[1]);
    return part->from_q30 < part->to_q30;
}
